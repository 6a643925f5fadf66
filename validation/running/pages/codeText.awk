# SPDX-License-Identifier: GPL-3.0-or-later
# Words of a list in what a reader sees of sources and scripts: comments, and the messages
# of C++.
#
#   awk -v words=LIST -f codeText.awk FILE...
#
# Prints "file:line: text" of each line with one of them. A comment begins with # or // at
# the begin of a line or behind a space; lines of a longer one in C++ begin with *. Strings
# of scripts are code, too, and not looked at.

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

BEGIN {
    while ((getline word < words) > 0)
        if (word !~ /^#/) any = any (any ? "|" : "") word
    any = "(^|[^[:alnum:]_])(" any ")([^[:alnum:]_]|$)"
}

{
    text = $0
    shown = FILENAME ~ /\.[CHc]$/ ? strings($0) : ""
    if (match(text, /(^|[ \t])(#|\/\/|\*)[- ].*/)) shown = shown " " substr(text, RSTART)
    if (tolower(shown) ~ any) print FILENAME ":" FNR ": " shown
}
