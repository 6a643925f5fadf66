// SPDX-License-Identifier: GPL-3.0-or-later
// Independent work in several processes of this machine.

#include "parallelWork.H"
#include "temporaryFolder.H"

#include "error.H"

#include <algorithm>
#include <fstream>
#include <sys/wait.h>
#include <unistd.h>

namespace
{

using namespace Foam;

//- The share of one process, into its file; it never returns
[[noreturn]] void workAlone
(
    const std::string& file,
    const label first,
    const label n,
    const label step,
    const std::function<std::string(const label)>& work
)
{
    int status = 1;
    try
    {
        std::ofstream os(file);
        for (label i = first; i < n; i += step)
        {
            os << work(i) << '\n';
        }
        os.flush();
        status = os ? 0 : 1;
    }
    catch (const Foam::error& e)
    {
        std::fprintf(stderr, "%s\n", e.message().c_str());
    }
    catch (const std::exception& e)
    {
        std::fprintf(stderr, "%s\n", e.what());
    }
    std::fflush(nullptr);
    ::_exit(status);
}


//- Waits; true if it ended well
bool endsWell(const pid_t process)
{
    int status = 1;
    while (::waitpid(process, &status, 0) < 0 && errno == EINTR)
    {}
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

} // End anonymous namespace


std::vector<std::string> Foam::misfit::inProcesses
(
    const label n,
    const label jobs,
    const std::function<std::string(const label)>& work
)
{
    std::vector<std::string> all(n);
    const label processes = std::min(jobs, n);
    if (processes < 2)
    {
        for (label i = 0; i < n; ++i)
        {
            all[i] = work(i);
        }
        return all;
    }

    const temporaryFolder scratch;
    const fileName folder(scratch);
    std::vector<pid_t> children;
    const auto fileOf = [&](const label p) { return folder/std::to_string(p); };
    std::fflush(nullptr);
    for (label p = 0; p < processes; ++p)
    {
        const pid_t child = ::fork();
        if (child == 0)
        {
            workAlone(fileOf(p), p, n, processes, work);
        }
        children.push_back(child);
    }
    bool well = true;
    for (const pid_t child : children)
    {
        well = child > 0 && endsWell(child) && well;
    }
    if (!well)
    {
        FatalErrorInFunction
            << "One of " << processes
            << " processes ended early; its reason stands above."
            << " Was it killed, or is memory or disk full? Start again with a smaller"
            << " jobs" << exit(FatalError);
    }
    for (label p = 0; p < processes; ++p)
    {
        std::ifstream is(fileOf(p));
        for (label i = p; i < n; i += processes)
        {
            std::getline(is, all[i]);
        }
    }
    return all;
}
