# SPDX-License-Identifier: GPL-3.0-or-later
# blockMeshDict of a slope with none, one or two barriers left out of it:
#   -v start, end, top   of the mesh along the bed and normal to it [m]
#   -v face1, face2      upstream faces of the barriers; none where empty [m]
#   -v thick, height     of a barrier [m]
#   -v width             of the slice [m]
#   -v cell              of the mesh, about [m]

function cells(length_) { n = int(length_/cell + 0.5); return n < 1 ? 1 : n }

function vertex(i, k, side) { return i + nx*k + nx*nz*side }

# A face between two vertices of the side of y = 0 and those behind them
function across(i, k, i2, k2)
{
    return " (" vertex(i, k, 0) " " vertex(i, k, 1) " " vertex(i2, k2, 1) " " \
        vertex(i2, k2, 0) ")"
}

function patch(name, type, faces)
{
    printf "    %s { type %s; faces (%s ); }\n", name, type, faces
}

BEGIN {
    x[0] = start; nx = 1; barriers = 0
    if (face1 != "") { hole[nx] = ++barriers; x[nx++] = face1; x[nx++] = face1 + thick }
    if (face2 != "") { hole[nx] = ++barriers; x[nx++] = face2; x[nx++] = face2 + thick }
    x[nx++] = end
    z[0] = 0; nz = 1
    if (barriers) z[nz++] = height
    z[nz++] = top

    print "FoamFile { version 2.0; format ascii; class dictionary; object blockMeshDict; }"
    print "scale 1;\nvertices\n("
    for (side = 0; side < 2; side++)
        for (k = 0; k < nz; k++)
            for (i = 0; i < nx; i++)
                printf "    (%.10g %.10g %.10g)\n", x[i], side*width, z[k]
    print ");\nblocks\n("
    for (k = 0; k < nz - 1; k++)
        for (i = 0; i < nx - 1; i++)
        {
            if (k == 0 && hole[i]) continue
            printf "    hex (%d %d %d %d %d %d %d %d) (%d 1 %d) simpleGrading (1 1 1)\n", \
                vertex(i, k, 0), vertex(i + 1, k, 0), vertex(i + 1, k, 1), \
                vertex(i, k, 1), vertex(i, k + 1, 0), vertex(i + 1, k + 1, 0), \
                vertex(i + 1, k + 1, 1), vertex(i, k + 1, 1), \
                cells(x[i + 1] - x[i]), cells(z[k + 1] - z[k])
            for (side = 0; side < 2; side++)
                sides = sides " (" vertex(i, k, side) " " vertex(i + 1, k, side) " " \
                    vertex(i + 1, k + 1, side) " " vertex(i, k + 1, side) ")"
        }
    print ");\nboundary\n("
    for (i = 0; i < nx - 1; i++)
    {
        if (hole[i])
            wall[hole[i]] = across(i, 0, i, 1) across(i, 1, i + 1, 1) \
                across(i + 1, 0, i + 1, 1)
        else
            base = base across(i, 0, i + 1, 0)
        upper = upper across(i, nz - 1, i + 1, nz - 1)
    }
    for (k = 0; k < nz - 1; k++)
    {
        back = back across(0, k, 0, k + 1)
        outlet = outlet across(nx - 1, k, nx - 1, k + 1)
    }
    patch("base", "wall", base)
    for (b = 1; b <= barriers; b++)
        patch("barrier" b, "wall", wall[b])
    patch("back", "wall", back)
    patch("outlet", "patch", outlet)
    patch("top", "patch", upper)
    patch("sides", "empty", sides)
    print ");"
}
