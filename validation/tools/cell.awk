# SPDX-License-Identifier: GPL-3.0-or-later
# A cell of a table with one row, by its heading; nothing where there is none:
#
#   awk -F, -v heading=ranks -f ../../tools/cell.awk row.csv

NR == 1 { for (i = 1; i <= NF; i++) if ($i == heading) c = i }
NR == 2 && c { print $c }
