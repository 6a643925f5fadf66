# SPDX-License-Identifier: GPL-3.0-or-later
# Of a table whose first column is the run: its heading and the runs that judge, without
# those that choose the free parameters:
#
#   awk -F, -f judged.awk design/choosing table.csv

FNR == NR { chooses[$1]; next }
FNR == 1 || !($1 in chooses)
