# SPDX-License-Identifier: GPL-3.0-or-later
# Curves for the page of surgePage, from the tables of function objects, as a JSON list:
#
#   awk -v points=N -f curves.awk TABLE...
#
# Of each kind of table the first object alone; of its lines at most about N.

BEGIN {
    add("porePressureProbes", ":p$", "Pore pressure", "Pa")
    add("surgeFront", "^xFront$", "Front of the grains, x", "m")
    add("surgeFront", "^U$", "Velocity of the front", "m/s")
    add("wallLoad", "^(both|grains):F$", "Force on the wall", "N")
    add("overflow", "^runUp$", "Run-up", "m")
    add("bedErosion", "^H$", "Erosion depth", "m")
    add("bedErosion", "^rate$", "Erosion rate", "m/s")
}

function add(table, column, title, unit)
{
    kinds++
    ofTable[kinds] = table; ofColumn[kinds] = column; titles[kinds] = title; units[kinds] = unit
}

FNR == 1 {
    m = split(FILENAME, part, "/")
    kind = part[m]
    sub(/\.dat$/, "", kind)
    object = part[m - 2]
    if (!(kind in first)) first[kind] = object
    isFirst = first[kind] == object
}
!isFirst { next }
/^# Probe/ {
    place = $0
    sub(/.*\(/, "", place); sub(/\).*/, "", place)
    gsub(/ /, ", ", place)
    probe[$3] = place
    next
}
/^# Time/ {
    for (i = 3; i <= NF; i++) heading[kind, i - 1] = $i
    columns[kind] = NF - 1
    next
}
/^#/ { next }
{
    # A run that went on from before its end has these times again
    while (rows[kind] && value[kind, rows[kind], 1] + 0 >= $1 + 0) rows[kind]--
    r = ++rows[kind]
    for (i = 1; i <= columns[kind]; i++) value[kind, r, i] = $i
}

function number(x) { return x ~ /^[-+]?[0-9.]+([eE][-+]?[0-9]+)?$/ ? sprintf("%.4g", x) : "null" }

function list(kind, column,    r, step, s)
{
    step = int(rows[kind]/points) + 1
    for (r = 1; r <= rows[kind]; r += step)
        s = s (s == "" ? "" : ",") number(value[kind, r, column])
    return "[" s "]"
}

function label(heading,    parts)
{
    split(heading, parts, ":")
    if (heading ~ /^both:/) return "grains and water"
    if (heading ~ /^grains:/) return "grains"
    return heading ~ /^[0-9]+:/ ? "probe " (parts[1] + 1) : ""
}

function series(k,    i, h, s, parts)
{
    for (i = 2; i <= columns[ofTable[k]]; i++)
    {
        h = heading[ofTable[k], i]
        if (h !~ ofColumn[k]) continue
        split(h, parts, ":")
        s = s (s == "" ? "" : ",\n") "{\"label\": \"" label(h) "\", " \
            (h ~ /^[0-9]+:/ && parts[1] in probe ? "\"at\": [" probe[parts[1]] "], " : "") \
            "\"y\": " list(ofTable[k], i) "}"
    }
    return s
}

END {
    printf "["
    for (k = 1; k <= kinds; k++)
    {
        if (!rows[ofTable[k]] || (found = series(k)) == "") continue
        printf "%s{\"title\": \"%s\", \"unit\": \"%s\", \"t\": %s,\n\"series\": [%s]}", \
            (any++ ? ",\n" : ""), titles[k], units[k], list(ofTable[k], 1), found
    }
    print "]"
}
