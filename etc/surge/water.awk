# SPDX-License-Identifier: GPL-3.0-or-later
# The water of one moment for the page of surgePage, after gridded.awk and
# waterColumns.awk:
#
#   awk -v about=FILE -f ../picture/waterColumns.awk -f water.awk cells.dat
#
# prints a line: surface and underside of each column as 12-bit parts of the height, in
# base64, //// where the column is dry. about: the grid of columns as a JSON object.

BEGIN {
    digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"
    for (i = 0; i < 64; i++) six[i] = substr(digits, i + 1, 1)
}

function twelve(h)
{
    h = int(4094*h/height + 0.5)
    h = h < 0 ? 0 : h > 4094 ? 4094 : h
    return six[int(h/64)] six[h%64]
}

END {
    if (!n || n != nx*ny*nz) exit
    for (j = 1; j <= ny; j++)
        for (i = 1; i <= nx; i++)
            printf "%s", (i, j) in top ? twelve(top[i, j]) twelve(low[i, j]) : "////"
    print ""
    printf "{\"nx\": %d, \"ny\": %d, \"x\": %.9g, \"y\": %.9g, \"dx\": %.9g, \"dy\": %.9g, " \
        "\"height\": %.9g}\n", nx, ny, x[1], y[1], dx, dy, height > about
}
