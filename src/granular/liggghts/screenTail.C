// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the last lines that LIGGGHTS prints to its screen.

#include "screenTail.H"

Foam::screenTail::screenTail()
:
    lines_(1),
    screen_
    (
        fopencookie
        (
            this,
            "w",
            cookie_io_functions_t{nullptr, write, nullptr, nullptr}
        )
    )
{
    // Nothing may wait in a buffer when the program is ended
    if (screen_)
    {
        std::setvbuf(screen_, nullptr, _IONBF, 0);
    }
}


Foam::screenTail::~screenTail()
{
    if (screen_)
    {
        std::fclose(screen_);
    }
}


ssize_t Foam::screenTail::write(void* self, const char* text, size_t n)
{
    std::deque<std::string>& lines = static_cast<screenTail*>(self)->lines_;

    for (size_t i = 0; i < n; ++i)
    {
        if (text[i] != '\n')
        {
            lines.back() += text[i];
        }
        else if (!lines.back().empty())
        {
            lines.emplace_back();
            if (lines.size() > nLines_ + 1)
            {
                lines.pop_front();
            }
        }
    }

    return n;
}
