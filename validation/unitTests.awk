# SPDX-License-Identifier: GPL-3.0-or-later
# Reads what the GoogleTest program said and tells one line for each test, with
# the numbers that it measured (testNumber), and all its words where it failed:
#
#   awk -v name=LABEL -v number=N -v tally=FILE -v status=EXIT \
#       -f unitTests.awk log

function count(verdict)
{
    if (verdict == "failed") printf "%s", said
    printf "%5d  %-8s %s: %s%s\n", ++number, verdict, name, test, numbers
    print verdict, name ":", test numbers >> tally
    failures += (verdict == "failed")
    running = 0
}

/^\[ RUN      \]/ { test = $4; numbers = said = ""; running = 1; next }

/^\[  NUMBER  \]/ {
    sub(/^\[  NUMBER  \] /, "")
    numbers = numbers "; " $0
    next
}

running && /^\[       OK \]/ { count("passed"); next }

running && /^\[  SKIPPED \]/ { count("skipped"); next }

running && /^\[  FAILED  \]/ { count("failed"); next }

{ said = said $0 "\n" }

# Without this line the program did not come to its end
/^\[==========\] .* ran\./ { ended = 1 }

END {
    if (ended && (failures || status == 0)) exit
    test = (running ? test : "the program") " broke off with status " status
    count("failed")
}
