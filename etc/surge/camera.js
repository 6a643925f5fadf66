// SPDX-License-Identifier: GPL-3.0-or-later
// The camera, and the numbers along the edges of the box.

// The camera circles a point: azimuth and elevation in degrees, as in etc/rayTrace

// Until the user moves the camera, all stays in the picture
let moved = false;
const view = {azimuth: -28, elevation: 20, distance: 1, target: new THREE.Vector3()};

function fit()
{
    const corners = [];
    for (const x of [box.lo[0], box.hi[0]]) for (const y of [box.lo[1], box.hi[1]]) for (const z of [box.lo[2], box.hi[2]])
        corners.push(flume.localToWorld(new THREE.Vector3(x, y, z)));
    const bounds = new THREE.Box3().setFromPoints(corners);
    bounds.getCenter(view.target);
    for (let k = 0; k < 3; k++)
    {
        fitDistance(corners);
        centreOn(corners);
    }
    fitDistance(corners);
}

// Moves the camera so that the corners lie around the middle of the picture
function centreOn(corners)
{
    const seen = corners.map((p) => p.clone().project(camera));
    const middleOf = (c) => 0.5*(Math.max(...seen.map((p) => p[c])) + Math.min(...seen.map((p) => p[c])));
    shift(-0.5*middleOf('x')*canvas.clientWidth, 0.5*middleOf('y')*canvas.clientHeight);
}

// Doubles the distance until all corners are in the picture, then narrows it
function fitDistance(corners)
{
    const inside = (distance) =>
    {
        view.distance = distance;
        aim();
        return corners.every((p) =>
        {
            const q = p.clone().project(camera);
            return q.z < 1 && Math.abs(q.x) < 1 - 96/canvas.clientWidth && Math.abs(q.y) < 0.8;
        });
    };
    let near = 0.001, far = 0.01;
    while (!inside(far) && far < 1e5) far *= 2;
    for (let k = 0; k < 24; k++)
    {
        const half = 0.5*(near + far);
        if (inside(half)) far = half; else near = half;
    }
    inside(far);
}

function aim()
{
    const a = view.azimuth*Math.PI/180, e = view.elevation*Math.PI/180;
    camera.position.set(Math.sin(a)*Math.cos(e), -Math.cos(a)*Math.cos(e), Math.sin(e)).multiplyScalar(view.distance).add(view.target);
    camera.up.set(0, 0, 1);
    camera.near = view.distance/200;
    camera.far = view.distance*50;
    camera.updateProjectionMatrix();
    camera.lookAt(view.target);
    camera.updateMatrixWorld();
    dirty = true;
}

function turn(dx, dy)
{
    view.azimuth -= 0.35*dx;
    view.elevation = Math.min(Math.max(view.elevation + 0.35*dy, -5), 89);
    aim();
}

function shift(dx, dy)
{
    const scale = 2*view.distance*Math.tan(0.5*camera.fov*Math.PI/180)/canvas.clientHeight;
    const right = new THREE.Vector3().setFromMatrixColumn(camera.matrixWorld, 0);
    const above = new THREE.Vector3().setFromMatrixColumn(camera.matrixWorld, 1);
    view.target.addScaledVector(right, -dx*scale).addScaledVector(above, dy*scale);
    aim();
}

function zoom(factor)
{
    view.distance *= factor;
    aim();
}

const fingers = new Map();
canvas.addEventListener('pointerdown', (e) =>
{
    canvas.setPointerCapture(e.pointerId);
    fingers.set(e.pointerId, [e.clientX, e.clientY]);
});
const lift = (e) => fingers.delete(e.pointerId);
canvas.addEventListener('pointerup', lift);
canvas.addEventListener('pointercancel', lift);
canvas.addEventListener('pointermove', (e) =>
{
    const before = fingers.get(e.pointerId);
    if (!before) return;
    moved = true;
    const dx = e.clientX - before[0], dy = e.clientY - before[1];
    const other = Array.from(fingers).find(([id]) => id !== e.pointerId);
    if (other)
    {
        const apart = (p) => Math.hypot(p[0] - other[1][0], p[1] - other[1][1]) || 1;
        zoom(apart(before)/apart([e.clientX, e.clientY]));
        shift(dx/2, dy/2);
    }
    else if (e.shiftKey || e.buttons & 6) shift(dx, dy);
    else turn(dx, dy);
    fingers.set(e.pointerId, [e.clientX, e.clientY]);
});
canvas.addEventListener('wheel', (e) =>
{
    e.preventDefault();
    moved = true;
    zoom(Math.exp(0.0012*e.deltaY));
}, {passive: false});
canvas.addEventListener('contextmenu', (e) => e.preventDefault());


// Numbers along the edges of the box, and the probes

const ticks = [];

function ticked(from, to, about5)
{
    const step = rounded((to - from)/about5), list = [];
    for (let v = Math.ceil(from/step - 1e-6)*step; v <= to + 1e-9; v += step) list.push(Number(v.toPrecision(6)));
    return list;
}

function addTick(text, place, kind, aside, colour)
{
    const span = document.createElement('span');
    span.textContent = text;
    span.className = kind;
    if (colour) span.style.setProperty('--probe', colour);
    byId('ticks').appendChild(span);
    ticks.push({span, place: new THREE.Vector3(...place), aside});
}

function addTicks()
{
    const [x0, y0, z0] = box.lo, [x1, y1, z1] = box.hi;
    for (const x of ticked(x0, x1, 6)) addTick(x, [x, y0, z0], '', [0, 17]);
    addTick('x [m]', [0.5*(x0 + x1), y0, z0], 'name', [28, 36]);
    const zs = ticked(z0, z1, 2.5).filter((z) => z > z0 + 0.2*(z1 - z0));
    for (const z of zs) addTick(z + ' m', [x0, y1, z], '', [-22, 0]);
    for (const curve of about.curves) curve.series.forEach((one, k) =>
    {
        if (one.at) addTick(k + 1, one.at, 'probe', [0, 0], lineColours[k % lineColours.length]);
    });
}

function placeTicks()
{
    const wide = canvas.clientWidth, high = canvas.clientHeight;
    let before = null;      // of the numbers; one too near to it is left out
    for (const {span, place, aside} of ticks)
    {
        const p = flume.localToWorld(place.clone()).project(camera);
        const at = [0.5*p.x*wide, 0.5*p.y*high];
        const near = span.className === '' && before && Math.hypot(at[0] - before[0], at[1] - before[1]) < 32;
        const shows = p.z < 1 && Math.abs(p.x) < 0.98 && Math.abs(p.y) < 0.97 && !near;
        span.style.display = shows ? '' : 'none';
        if (shows && span.className === '') before = at;
        span.style.left = 0.5*(p.x + 1)*wide + aside[0] + 'px';
        span.style.top = 0.5*(1 - p.y)*high + aside[1] + 'px';
    }
}
