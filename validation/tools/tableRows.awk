# SPDX-License-Identifier: GPL-3.0-or-later
# Reads kept rows, for the program that tableProgram.awk makes: number, cell, smallPrint

BEGIN { FS = "," }
FNR == 1 { split($0, heading, ","); next }
FNR == 2 {
    run = runOf(FILENAME, $1)
    if (run in file)
        stop("rows of the run " run " are " file[run] " and " FILENAME \
            "; remove the one whose case is gone")
    file[run] = FILENAME
    all[++nRows] = run
    for (i = 1; i <= NF; i++) row[run, heading[i]] = $i
}

# runOf path name: with the folder before it, where that is not rows
function runOf(path, name)
{
    path = substr(path, length(study) + 2)
    sub(/[^\/]*$/, "", path)
    return (path == "rows/" ? "" : path) name
}

function stop(why)
{
    print "pageTables: " study "/tables, table " table ": " why > "/dev/stderr"
    failed = 1
    exit 1
}

# number run what: of its row, a little larger, so that 3.385 becomes 3.39
function number(run, what,    value)
{
    if (!(run in file))
        stop("looked for a kept row of the run " run \
            "; run it (" study "/Allrun " run ") or correct its name")
    if (!((run, what) in row))
        stop("looked for the column " what " in " file[run] "; correct its name")
    value = row[run, what]
    if (value !~ /^[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?$/)
        stop(what " in " file[run] " is \"" value "\", which is no number; " \
            "write text in its place")
    count(run)
    return value*(1 + 1e-12)
}

# countAll: for what a table has of all rows at once
function countAll(    i) { for (i = 1; i <= nRows; i++) count(all[i]) }

# count run: its age and its commits, once
function count(run,    version, code, i, n)
{
    if (run in used) return
    used[run]
    rows++
    version = (run, "version") in row ? row[run, "version"] : 0
    if (version < present) older++
    n = split(row[run, "code"], code, "+")
    for (i = 1; i <= n; i++)
    {
        if (code[i] in commit) continue
        commit[code[i]]
        commits = commits (nCommits++ ? ", " : "") code[i]
    }
}

# cell format value: with the sign of print, and without one at 0
function cell(format, value,    text)
{
    text = sprintf(format, value)
    if (text ~ /^-0\.?0*([^.0-9]|$)/) sub(/^-/, "", text)
    sub(/^-/, "−", text)
    return text
}

function smallPrint()
{
    print ""
    print "*" (older ? older " of " rows " rows predate results version " present \
        : rows (rows == 1 ? " row" : " rows") " of results version " present) \
        "; " (nCommits > 12 ? nCommits " commits, see `code` in the rows" \
            : "commit" (nCommits > 1 ? "s " : " ") commits) ".*"
}
