// SPDX-License-Identifier: GPL-3.0-or-later
// The water of all times: surface and underside of columns of cells, or nothing.

// Water: surface and underside of each column of cells, and two sides

function readWater()
{
    return rows('waterFrames').map((line) =>
    {
        const m = about.water.nx*about.water.ny, surface = new Float32Array(m), under = new Float32Array(m);
        for (let k = 0; k < m; k++)
        {
            const wet = line.substr(4*k, 4) !== '////';
            surface[k] = wet ? about.water.height*bits12(line, 4*k)/4094 : NaN;
            under[k] = wet ? about.water.height*bits12(line, 4*k + 2)/4094 : NaN;
        }
        return {surface, under};
    });
}

// None where all columns are dry at all times
const levelsRead = about.water ? readWater() : [];
const water = levelsRead.some((frame) => frame.surface.some((h) => !isNaN(h))) ? levelsRead : null;
if (water)
    for (const frame of water) for (const h of frame.surface) if (h > box.hi[2]) box.hi[2] = h;

boxLines();

const waterMaterial = new THREE.MeshPhongMaterial({color: 0x3f8fdb, specular: 0x99bbdd, shininess: 60, transparent: true,
    opacity: 0.5, side: THREE.DoubleSide, depthWrite: false});
const waterMesh = new THREE.Mesh(new THREE.BufferGeometry(), waterMaterial);
waterMesh.frustumCulled = false;
flume.add(waterMesh);

// A dry column beside wet ones has the mean of their undersides; NaN far from water
function withMargin(frame)
{
    const {nx, ny} = about.water, surface = frame.surface.slice(), under = frame.under.slice();
    for (let j = 0; j < ny; j++) for (let i = 0; i < nx; i++)
    {
        if (!isNaN(frame.surface[j*nx + i])) continue;
        let sum = 0, m = 0;
        for (let b = Math.max(j - 1, 0); b <= Math.min(j + 1, ny - 1); b++)
            for (let a = Math.max(i - 1, 0); a <= Math.min(i + 1, nx - 1); a++)
                if (!isNaN(frame.under[b*nx + a]))
                {
                    sum += frame.under[b*nx + a];
                    m++;
                }
        if (m) surface[j*nx + i] = under[j*nx + i] = sum/m;
    }
    return {surface, under};
}

function levels(i, f)
{
    const a = water[i], b = water[Math.min(i + 1, last)], m = a.surface.length;
    const both = {surface: new Float32Array(m), under: new Float32Array(m)};
    for (let k = 0; k < m; k++)
    {
        const inA = !isNaN(a.surface[k]), inB = !isNaN(b.surface[k]);
        for (const side of ['surface', 'under'])
            both[side][k] = inA && inB ? (1 - f)*a[side][k] + f*b[side][k] : (f < 0.5 ? a : b)[side][k];
    }
    return withMargin(both);
}

function fillWater(i, f)
{
    const {nx, ny, x, y, dx, dy} = about.water, level = levels(i, f), points = [], index = [];
    const inside = (k, m) => Math.min(Math.max(k, 0), m - 1);
    // Corners: centres of the columns, and one more at each end
    // The outer ones a little beyond the walls, into which grains are pressed
    const beyond = 0.1*smallest, xs = [x - dx/2 - beyond], ys = [y - dy/2 - beyond];
    for (let a = 0; a < nx; a++) xs.push(x + a*dx);
    for (let b = 0; b < ny; b++) ys.push(y + b*dy);
    xs.push(x + (nx - 0.5)*dx + beyond);
    ys.push(y + (ny - 0.5)*dy + beyond);
    const column = (a, b) => inside(b - 1, ny)*nx + inside(a - 1, nx);
    const add = (px, py, pz) => points.push(px, py, pz)/3 - 1;
    const cut = byId('cut').checked;
    const sheet = (side, rowsY) =>
        rowsY.map((py) =>
        {
            let b = 0;
            while (b < ys.length - 2 && ys[b + 1] < py) b++;
            const g = (py - ys[b])/(ys[b + 1] - ys[b]);
            return xs.map((px, a) =>
            {
                const p = level[side][column(a, b)], q = level[side][column(a, b + 1)];
                const h = isNaN(p) ? q : isNaN(q) ? p : (1 - g)*p + g*q;
                return isNaN(h) ? -1 : add(px, py, h);
            });
        });
    const join = (one, two) =>
    {
        for (let a = 0; a + 1 < one.length; a++)
        {
            const q = [one[a], one[a + 1], two[a + 1], two[a]];
            if (q.every((k) => k >= 0)) index.push(q[0], q[1], q[2], q[0], q[2], q[3]);
        }
    };
    const rowsY = cut ? [middle].concat(ys.filter((v) => v > middle + 1e-9)) : ys;
    const surface = sheet('surface', rowsY);
    for (let b = 0; b + 1 < rowsY.length; b++) join(surface[b], surface[b + 1]);
    const ends = [rowsY[0], rowsY[rowsY.length - 1]];
    const upper = sheet('surface', ends), lower = sheet('under', ends);
    join(upper[0], lower[0]);
    join(upper[1], lower[1]);
    const bottom = sheet('under', rowsY), end = xs.length - 1;
    for (const a of [0, end]) join(surface.map((row) => row[a]), bottom.map((row) => row[a]));
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(points), 3));
    geometry.setIndex(index);
    geometry.computeVertexNormals();
    waterMesh.geometry.dispose();
    waterMesh.geometry = geometry;
}
