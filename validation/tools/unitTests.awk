# SPDX-License-Identifier: GPL-3.0-or-later
# Reads the output of the GoogleTest program and prints one line for each test, with
# the numbers that it measured (testNumber), and its whole output where it failed:
#
#   awk -v name=LABEL -v number=N -v tally=FILE -v status=EXIT \
#       -f unitTests.awk log
#
# The first rank reports how a test ended. What fails on another one has the name
# of the test before it, "[rank 1] Suite.test: words", since it may come before
# the first rank begins that test or after it has ended it.

function record(verdict, what, words)
{
    if (verdict == "failed") printf "%s", words
    printf "%5d  %-8s %s: %s%s\n", ++number, verdict, name, what, numbers[what]
    print verdict, name ":", what numbers[what] >> tally
    failures += (verdict == "failed")
}

function begin(what)
{
    if (!(what in verdict))
    {
        tests[++n] = what
        verdict[what] = ""
    }
}

function end(how)
{
    # A rank that failed before says more than the first one's end
    if (verdict[test] == "") verdict[test] = how
    test = ""
}

/^\[rank [0-9]+\] [^ ]+: / {
    which = $3
    sub(/:$/, "", which)
    begin(which)
    verdict[which] = "failed"
    output[which] = output[which] $0 "\n"
    next
}

/^\[ RUN      \]/ { begin(test = $4); next }

/^\[  NUMBER  \]/ {
    sub(/^\[  NUMBER  \] /, "")
    numbers[test] = numbers[test] "; " $0
    next
}

test != "" && /^\[       OK \]/ { end("passed"); next }

test != "" && /^\[  SKIPPED \]/ { end("skipped"); next }

test != "" && /^\[  FAILED  \]/ { end("failed"); next }

# Without this line the program did not come to its end
/^\[==========\] .* ran\./ { ended = 1 }

/^\[[-=]+\]|^\[  PASSED  \]|^\[  FAILED  \]/ { next }

{
    output[test] = output[test] $0 "\n"
    all = all $0 "\n"
}

END {
    for (i = 1; i <= n; i++)
        if (verdict[tests[i]] != "")
            record(verdict[tests[i]], tests[i], output[tests[i]])
    if (ended && !n) record("failed", "no test ran")
    if (ended && (failures || status == 0)) exit
    if (test == "")
        record("failed", "the program broke off with status " status, all)
    else
        record("failed", test " broke off with status " status, output[test] output[""])
}
