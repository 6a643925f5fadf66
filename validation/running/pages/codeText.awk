# SPDX-License-Identifier: GPL-3.0-or-later
# What a reader sees of sources and scripts: comments, and the messages of programs.
#
#   awk -f codeText.awk FILE...
#
# Prints "file:line: text". A comment begins with # or // at the begin of a line or behind a
# space; lines of a longer one in C++ begin with *. Strings are taken of C++ only: in
# scripts they are code, too.

# strings(line): the texts in quotation marks; text is the line without them
function strings(line,    found)
{
    while (match(line, /"([^"\\]|\\.)*"/))
    {
        found = found " " substr(line, RSTART + 1, RLENGTH - 2)
        line = substr(line, 1, RSTART - 1) substr(line, RSTART + RLENGTH)
    }
    text = line
    return found
}

{
    text = $0
    shown = FILENAME ~ /\.[CH]$/ ? strings($0) : ""
    if (match(text, /(^|[ \t])(#|\/\/|\*)[- ].*/)) shown = shown " " substr(text, RSTART)
    if (shown != "") print FILENAME ":" FNR ": " shown
}
