# SPDX-License-Identifier: GPL-3.0-or-later
# The program, for awk after tableRows.awk, that prints a table
# of a study; see pageTables.
#
#   awk -v table=NAME -v study=FOLDER -f tableProgram.awk tables

function literal(text)
{
    gsub(/\\/, "\\\\", text)
    gsub(/"/, "\\\"", text)
    return "\"" text "\""
}

# numbersOf expression: with RUN:NUMBER made a call
function numbersOf(expression,    made, at)
{
    while (match(expression, /[A-Za-z][A-Za-z0-9._-]*:[A-Za-z][A-Za-z0-9._]*/))
    {
        at = substr(expression, RSTART, RLENGTH)
        made = made substr(expression, 1, RSTART - 1)
        expression = substr(expression, RSTART + RLENGTH)
        sub(/:/, "\", \"", at)
        made = made "number(\"" at "\")"
    }
    return made expression
}

# cellOf format expression: of each run, where the expression has an @
function cellOf(format, expression,    i, one, made)
{
    if (expression !~ /@/)
        return "cell(" literal(format) ", " numbersOf(expression) ")"
    for (i = 1; i <= nRuns; i++)
    {
        one = expression
        gsub(/@/, runs[i], one)
        made = made (i > 1 ? " \" | \" " : "") cellOf(format, one)
    }
    return made
}

function programOf(line,    made, inner, blank, rest)
{
    while (match(line, /\{%[^{}]*\}/))
    {
        inner = substr(line, RSTART + 1, RLENGTH - 2)
        rest = substr(line, RSTART + RLENGTH)
        blank = index(inner, " ")
        made = made literal(substr(line, 1, RSTART - 1)) " " \
            cellOf(substr(inner, 1, blank - 1), substr(inner, blank + 1)) " "
        line = rest
    }
    return made literal(line)
}

/^function /, /^}/ { print; next }
/^table / { inside = $2 == table; found = found || inside; nRuns = 0; next }
/^$/ { inside = 0 }
!inside { next }
/^runs / { nRuns = split(substr($0, 6), runs, " "); next }
{ lines[++n] = programOf($0) }
END {
    if (!found)
    {
        print "pageTables: " study "/tables: looked for the line \"table " table \
            "\", which a page names; add it, or correct the page" > "/dev/stderr"
        exit 1
    }
    print "END {"
    print "    if (failed) exit 1"
    for (i = 1; i <= n; i++) print "    print " lines[i]
    print "    smallPrint()"
    print "}"
}
