// SPDX-License-Identifier: GPL-3.0-or-later
// What the page of surgePage does: reads grains and water of all times from its own text and
// draws them with three.js, with the curves of the run beside them.

(function ()
{
'use strict';

const byId = (id) => document.getElementById(id);
const about = JSON.parse(byId('about').textContent);
const rows = (id) => byId(id).textContent.trim().split('\n');
const times = about.times, n = about.grains, last = times.length - 1;
const asked = new URLSearchParams(location.hash.slice(1));


// Text to numbers: base64, six bits a digit

const six = new Uint8Array(128);
'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/'.split('')
    .forEach((digit, i) => { six[digit.charCodeAt(0)] = i; });

const bits6 = (s, i) => six[s.charCodeAt(i)];
const bits12 = (s, i) => 64*bits6(s, i) + bits6(s, i + 1);

// Diameter and type of each grain, and its place and speed at each time. A grain that has not
// moved keeps those of the time before; one that is not in view yet is at 65535
function readGrains()
{
    const lines = rows('frames');
    const radius = new Float32Array(n), type = new Uint8Array(n), frames = [];
    for (let i = 0; i < n; i++)
    {
        radius[i] = 0.5*about.largest*bits12(lines[0], 3*i)/4095;
        type[i] = bits6(lines[0], 3*i + 2);
    }
    for (let t = 0; t <= last; t++)
    {
        const line = lines[t + 1];
        const place = t ? frames[t - 1].place.slice() : new Uint16Array(3*n).fill(65535);
        const speed = t ? frames[t - 1].speed.slice() : new Uint8Array(n);
        let at = Math.ceil(n/6);
        for (let i = 0; i < n; i++)
        {
            if (!(bits6(line, (i/6) | 0) & (32 >> (i % 6)))) continue;
            const a = bits12(line, at), b = bits12(line, at + 2);
            const c = bits12(line, at + 4), d = bits12(line, at + 6);
            place[3*i] = (a << 4) | (b >> 8);
            place[3*i + 1] = ((b & 255) << 8) | (c >> 4);
            place[3*i + 2] = ((c & 15) << 12) | d;
            speed[i] = bits6(line, at + 8);
            at += 9;
        }
        frames.push({place, speed});
    }
    return {radius, type, frames};
}

const grains = readGrains();
const span = about.hi.map((h, c) => h - about.lo[c]);
const absent = (place, i) => place[3*i] === 65535 && place[3*i + 2] === 65535;
const speedOf = (code) => about.fastest*(code/63)**2;

// Depth of each grain below the surface when it first was there
function depthAtStart()
{
    const depth = new Float32Array(n), top = new Map(), first = new Int32Array(n).fill(-1);
    const width = 3*grains.radius.reduce((a, r) => Math.min(a, r), 1e9);
    for (let t = 0; t <= last; t++)
        for (let i = 0; i < n; i++)
            if (first[i] < 0 && !absent(grains.frames[t].place, i)) first[i] = t;
    const metre = (i, c) => about.lo[c]
        + span[c]*grains.frames[Math.max(first[i], 0)].place[3*i + c]/65534;
    const key = (i) => first[i] + ':' + Math.floor(metre(i, 0)/width) + ':' + Math.floor(metre(i, 1)/width);
    for (let i = 0; i < n; i++) top.set(key(i), Math.max(top.get(key(i)) ?? -1e9, metre(i, 2) + grains.radius[i]));
    for (let i = 0; i < n; i++) depth[i] = top.get(key(i)) - metre(i, 2);
    return depth;
}


// Colours

const ramps =
{
    speed: ['#938d82', '#7d5f92', '#b24c7c', '#dd6054', '#f19b3e', '#f9e25c'],
    size: ['#c9b38c', '#b5825a', '#8f4f3c', '#4d2a35'],
    depth: ['#f2d9a0', '#d99a5b', '#a85a4a', '#65365c', '#2c2450']
};
const typeColours = ['#c8a36a', '#8492a6', '#b5573f', '#4f8a6b', '#8a6bb0', '#d0b53f'];

const mixed = (list, f) =>
{
    const g = Math.min(Math.max(f, 0), 1)*(list.length - 1), i = Math.min(Math.floor(g), list.length - 2);
    return new THREE.Color(list[i]).lerp(new THREE.Color(list[i + 1]), g - i);
};

function rounded(x)     // up to 1, 2 or 5 times a power of ten
{
    const p = 10**Math.floor(Math.log10(x || 1));
    return [1, 1.5, 2, 3, 4, 5, 7.5, 10].map((f) => f*p).find((f) => f >= 0.999*x);
}

// The speed that 995 of 1000 moving grains of all times have not
function usualTop()
{
    const count = new Array(64).fill(0);
    for (const frame of grains.frames) for (let i = 0; i < n; i++) count[frame.speed[i]]++;
    const moving = count.slice(1).reduce((a, b) => a + b, 0);
    let sum = 0, code = 0;
    while (code < 63 && sum < 0.995*moving) sum += count[++code];
    return rounded(speedOf(code)) || 1;
}

const kinds = Array.from(new Set(grains.type)).sort((a, b) => a - b);
let smallest = 1e9, largest = 0;
for (const r of grains.radius)
{
    smallest = Math.min(smallest, r);
    largest = Math.max(largest, r);
}
const sizes = Array.from(new Set(Array.from(grains.radius, (r) => (2000*r).toPrecision(3))));
const depth = depthAtStart();
const deepest = rounded(depth.reduce((a, d) => Math.max(a, d), 0)) || 1;
const top = usualTop();

// Fractions of the colour bar
const sizeOf = (i) => largest > smallest ? (grains.radius[i] - smallest)/(largest - smallest) : 0;
const typeOf = (i) => (kinds.indexOf(grains.type[i]) % typeColours.length + 0.5)/typeColours.length;

function bar(colour)
{
    const data = new Uint8Array(4*256);
    for (let i = 0; i < 256; i++)
    {
        const c = colour === 'type' ? new THREE.Color(typeColours[Math.floor(i/256*typeColours.length)])
            : mixed(ramps[colour], i/255);
        data.set([255*c.r, 255*c.g, 255*c.b, 255], 4*i);
    }
    return data;
}


// The scene

const canvas = byId('view');
const context = canvas.getContext('webgl2', {antialias: true}) || canvas.getContext('webgl', {antialias: true});
if (!context)
{
    byId('missing').style.display = 'grid';
    return;
}
const renderer = new THREE.WebGLRenderer({canvas, context, antialias: true});
const scene = new THREE.Scene(), camera = new THREE.PerspectiveCamera(28, 1, 0.001, 1000);

// Gravity points down on the screen; x to the right
const up = new THREE.Vector3(...about.gravity).multiplyScalar(-1).normalize();
const flume = new THREE.Group();
flume.quaternion.setFromUnitVectors(up, new THREE.Vector3(0, 0, 1));
scene.add(flume);
scene.add(new THREE.HemisphereLight(0xffffff, 0xb0a898, 0.95));
const sun = new THREE.DirectionalLight(0xffffff, 0.45);
sun.position.set(-1, -2, 3);
scene.add(sun);

const box = {lo: about.lo.slice(), hi: about.hi.slice()};
for (let c = 0; c < 3; c++)
{
    box.lo[c] -= c < 2 ? largest : smallest;
    box.hi[c] += largest;
}
if (about.water)
{
    const w = about.water;
    box.lo = [w.x - w.dx/2, w.y - w.dy/2, Math.min(box.lo[2], 0)];
    box.hi = [w.x + (w.nx - 0.5)*w.dx, w.y + (w.ny - 0.5)*w.dy, box.hi[2]];
}
const middle = 0.5*(box.lo[1] + box.hi[1]);

function grainMesh()
{
    const geometry = new THREE.InstancedBufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]), 3));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    const each = (name, array, size, whole) =>
    {
        const attribute = new THREE.InstancedBufferAttribute(array, size, whole);
        attribute.setUsage ? attribute.setUsage(THREE.DynamicDrawUsage) : attribute.setDynamic(true);
        geometry.setAttribute(name, attribute);
    };
    each('from', new Uint16Array(3*n), 3, true);
    each('to', new Uint16Array(3*n), 3, true);
    each('values', new Float32Array(2*n), 2, false);
    each('radius', grains.radius, 1, false);
    each('shade', Float32Array.from({length: n}, (_, i) => 0.88 + 0.24*((i*7919 % 1009)/1009)), 1, false);
    geometry.maxInstancedCount = n;
    const material = new THREE.ShaderMaterial({
        uniforms: {
            lo: {value: new THREE.Vector3(...about.lo)},
            span: {value: new THREE.Vector3(...span).multiplyScalar(65535/65534)},
            f: {value: 0}, pixels: {value: 1}, least: {value: n < 200 ? 4 : 0}, cutAt: {value: -1e9}, bar: {value: null},
            upward: {value: new THREE.Vector3()}, light: {value: new THREE.Vector3()}
        },
        vertexShader: `
            attribute vec3 from, to; attribute vec2 values; attribute float radius, shade;
            uniform vec3 lo, span; uniform float f, cutAt, pixels, least;
            varying vec3 ray, centre; varying float r, value, tint, near;
            bool there(vec3 p) { return p.x + p.y + p.z < 2.99999; }
            void main()
            {
                bool jump = any(greaterThan(abs(to - from), vec3(0.5)));
                bool a = there(from), b = there(to);
                vec3 p = a && b && !jump ? mix(from, to, f) : f < 0.5 ? from : to;
                vec3 place = lo + span*p;
                value = a && b ? mix(values.x, values.y, f) : f < 0.5 ? values.x : values.y;
                tint = shade;
                centre = (modelViewMatrix*vec4(place, 1.0)).xyz;
                float far = length(centre);
                // Where a grain is but a few pixels wide it is drawn a little larger and flat
                near = smoothstep(1.0, 5.0, radius/far*pixels);
                r = max(radius*mix(1.25, 1.0, near), least*far/pixels);
                if (!there(p) || place.y < cutAt || far <= r)
                {
                    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
                    return;
                }
                vec3 eye = centre/far, side = normalize(cross(eye, vec3(0.0, 1.0, 0.0001)));
                float wide = r*far/sqrt(far*far - r*r);
                ray = centre + wide*(position.x*side + position.y*cross(side, eye));
                gl_Position = projectionMatrix*vec4(ray, 1.0);
            }`,
        fragmentShader: `
            uniform sampler2D bar; uniform vec3 upward, light; uniform mat4 projectionMatrix;
            varying vec3 ray, centre; varying float r, value, tint, near;
            void main()
            {
                vec3 eye = normalize(ray);
                float along = dot(eye, centre), h = r*r - dot(centre, centre) + along*along;
                if (h < 0.0) discard;
                vec3 p = eye*(along - sqrt(h)), normal = normalize(mix(normalize(0.6*upward - eye), (p - centre)/r, 0.15 + 0.85*near));
                vec3 colour = texture2D(bar, vec2(value, 0.5)).rgb*mix(1.0, tint, 0.4 + 0.6*near);
                float sky = 0.5 + 0.5*dot(normal, upward);
                float facing = max(-dot(normal, eye), 0.0);
                float shine = pow(max(dot(reflect(-light, normal), -eye), 0.0), 24.0);
                float bright = (0.34 + 0.36*sky + 0.5*max(dot(normal, light), 0.0))*(1.0 - 0.5*(1.0 - facing)*near);
                gl_FragColor = vec4(colour*bright + 0.07*shine, 1.0);
                vec4 clip = projectionMatrix*vec4(p, 1.0);
                gl_FragDepthEXT = 0.5*clip.z/clip.w + 0.5;
            }`,
        extensions: {fragDepth: true}
    });
    const mesh = new THREE.Mesh(geometry, material);
    mesh.frustumCulled = false;
    return mesh;
}

const balls = grainMesh();
flume.add(balls);

// Walls, floor and the edges of the box
const wallMaterial = new THREE.MeshLambertMaterial({color: 0x9aa0a8, transparent: true, opacity: 0.55, side: THREE.DoubleSide, depthWrite: false});
const wallGeometry = about.walls.length ? new THREE.BufferGeometry() : null;
if (wallGeometry)
{
    wallGeometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(about.walls), 3));
    wallGeometry.computeVertexNormals();
    flume.add(new THREE.Mesh(wallGeometry, wallMaterial));
}
const floorMaterial = new THREE.MeshBasicMaterial({side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 2});
const edgeMaterial = new THREE.LineBasicMaterial();

// True where a wall is not at right angles to the axes: then the floor is among the walls
function sloping()
{
    const normals = wallGeometry ? wallGeometry.attributes.normal.array : [];
    return Array.from(normals).some((v) => Math.abs(v) > 0.02 && Math.abs(v) < 0.98);
}

function boxLines()
{
    const [x0, y0, z0] = box.lo, [x1, y1, z1] = box.hi;
    const corner = [[x0, y0, z0], [x1, y0, z0], [x1, y1, z0], [x0, y1, z0], [x0, y0, z1], [x1, y0, z1], [x1, y1, z1], [x0, y1, z1]];
    const pairs = [0, 1, 1, 2, 2, 3, 3, 0, 0, 4, 3, 7, 1, 5, 2, 6, 7, 6, 4, 7, 5, 6];
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(pairs.flatMap((i) => corner[i])), 3));
    flume.add(new THREE.LineSegments(geometry, edgeMaterial));
    if (sloping()) return;
    const floor = new THREE.BufferGeometry();
    floor.setAttribute('position', new THREE.BufferAttribute(new Float32Array([0, 1, 2, 0, 2, 3].flatMap((i) => corner[i])), 3));
    flume.add(new THREE.Mesh(floor, floorMaterial));
}


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


// The moment shown

let time = times[0], frame = -1, playing = false, dirty = true;

function interval(t)
{
    let i = 0;
    while (i < last - 1 && times[i + 1] <= t) i++;
    return {i, f: last ? Math.min(Math.max((t - times[i])/(times[i + 1] - times[i]), 0), 1) : 0};
}

function valuesOf(i)
{
    const how = byId('colour').value, array = balls.geometry.attributes.values.array;
    const a = grains.frames[i].speed, b = grains.frames[Math.min(i + 1, last)].speed;
    for (let k = 0; k < n; k++)
    {
        if (how === 'speed')
        {
            array[2*k] = Math.min(speedOf(a[k])/top, 0.998);
            array[2*k + 1] = Math.min(speedOf(b[k])/top, 0.998);
        }
        else
            array[2*k] = array[2*k + 1] = how === 'size' ? 0.998*sizeOf(k)
                : how === 'type' ? typeOf(k) : Math.min(depth[k]/deepest, 0.998);
    }
    balls.geometry.attributes.values.needsUpdate = true;
}

function load(i)
{
    if (i === frame) return;
    frame = i;
    const attributes = balls.geometry.attributes;
    attributes.from.array.set(grains.frames[i].place);
    attributes.to.array.set(grains.frames[Math.min(i + 1, last)].place);
    attributes.from.needsUpdate = attributes.to.needsUpdate = true;
    valuesOf(i);
}

function show(t)
{
    time = Math.min(Math.max(t, times[0]), times[last]);
    const {i, f} = interval(time);
    load(i);
    balls.material.uniforms.f.value = f;
    waterMesh.visible = Boolean(water) && byId('water').checked;
    if (waterMesh.visible) fillWater(i, f);
    byId('slider').value = time;
    byId('clock').textContent = 't = ' + time.toFixed(decimals) + ' s';
    moveLines();
    if (byId('follow').checked) follow();
    dirty = true;
}

let decimals = 2;
while (decimals < 5 && last && (times[last] - times[0])/last < 2*10**-decimals) decimals++;


// The front of the grains, where the run has measured it
const front = about.curves.find((curve) => /^Front/.test(curve.title));

// Looks at the front
function follow()
{
    const x = at(front, front.series[0].y, time);
    if (x === null) return;
    const level = box.lo[2] + 0.12*(box.hi[2] - box.lo[2]);
    view.target.copy(flume.localToWorld(new THREE.Vector3(x - 0.05*(box.hi[0] - box.lo[0]), middle, level)));
    aim();
}

function turnFollow()
{
    moved = byId('follow').checked;
    fit();
    if (!moved) return;
    zoom(1/3);
    follow();
}


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


// Curves, with a line at the moment shown

const lineColours = ['#2f7ed8', '#d9722e', '#3a9a5b', '#9a5fc0', '#c0392b', '#7a8794'];
const plots = [];
const written = (v) => v === 0 ? '0' : Math.abs(v) >= 1e5 || Math.abs(v) < 1e-3 ? v.toExponential(1)
    : String(Number(v.toPrecision(3)));

function element(name, attributes, parent)
{
    const e = document.createElementNS('http://www.w3.org/2000/svg', name);
    for (const key in attributes) e.setAttribute(key, attributes[key]);
    if (parent) parent.appendChild(e);
    return e;
}

function addPlots()
{
    for (const curve of about.curves)
    {
        const figure = document.createElement('figure');
        figure.innerHTML = '<figcaption><span></span><span class="now"></span></figcaption><svg></svg>';
        figure.querySelector('span').textContent = curve.title + ' [' + curve.unit + ']';
        byId('curves').appendChild(figure);
        const plot = {curve, svg: figure.querySelector('svg'), now: figure.querySelector('.now')};
        const jump = (e) =>
        {
            if (e.type === 'pointermove' && !e.buttons) return;
            stop();
            show(plot.time(e.clientX - plot.svg.getBoundingClientRect().left));
        };
        plot.svg.addEventListener('pointerdown', jump);
        plot.svg.addEventListener('pointermove', jump);
        plots.push(plot);
    }
}

function drawPlot(plot)
{
    const {curve, svg} = plot, wide = svg.clientWidth, high = svg.clientHeight;
    if (wide < 50 || high < 40) return;
    svg.textContent = '';
    svg.setAttribute('viewBox', `0 0 ${wide} ${high}`);
    const left = 46, right = wide - 10, upper = 8, lower = high - 18;
    const values = curve.series.flatMap((s) => s.y).filter((v) => v !== null);
    let lo = Math.min(0, ...values), hi = Math.max(...values, lo + 1e-12);
    const ys = ticked(lo, hi, 4);
    hi = Math.max(hi, ys[ys.length - 1]);
    const t0 = Math.min(times[0], curve.t[0]), t1 = Math.max(times[last], curve.t[curve.t.length - 1]);
    const x = (t) => left + (right - left)*(t - t0)/(t1 - t0 || 1);
    const y = (v) => lower - (lower - upper)*(v - lo)/(hi - lo);
    plot.time = (px) => t0 + (t1 - t0)*(px - left)/(right - left);
    for (const v of ys)
    {
        element('line', {class: 'grid', x1: left, x2: right, y1: y(v), y2: y(v)}, svg);
        element('text', {x: left - 5, y: y(v) + 4, 'text-anchor': 'end'}, svg).textContent = written(v);
    }
    for (const t of ticked(t0, t1, 5)) if (x(t) < right - 36)
        element('text', {x: x(t), y: high - 4, 'text-anchor': 'middle'}, svg).textContent = t;
    element('text', {x: right, y: high - 4, 'text-anchor': 'end'}, svg).textContent = 't [s]';
    element('line', {class: 'axis', x1: left, x2: right, y1: y(lo), y2: y(lo)}, svg);
    curve.series.forEach((s, k) =>
    {
        let d = '', pen = 'M';
        s.y.forEach((v, i) =>
        {
            if (v === null) { pen = 'M'; return; }
            d += pen + x(curve.t[i]).toFixed(1) + ' ' + y(v).toFixed(1);
            pen = 'L';
        });
        element('path', {d, stroke: lineColours[k % lineColours.length]}, svg);
    });
    plot.line = element('line', {class: 'moment', y1: upper, y2: lower}, svg);
    plot.dots = curve.series.map((s, k) => element('circle', {r: 3.5, fill: lineColours[k % lineColours.length]}, svg));
    plot.x = x;
    plot.y = y;
}

function at(curve, y, t)
{
    const ts = curve.t;
    let i = 0;
    while (i < ts.length - 1 && ts[i + 1] < t) i++;
    if (t < ts[0] || i >= ts.length - 1) return t < ts[0] ? null : y[ts.length - 1];
    const a = y[i], b = y[i + 1];
    return a === null || b === null ? null : a + (b - a)*(t - ts[i])/(ts[i + 1] - ts[i]);
}

function moveLines()
{
    for (const plot of plots)
    {
        if (!plot.line) continue;
        plot.line.setAttribute('x1', plot.x(time));
        plot.line.setAttribute('x2', plot.x(time));
        plot.now.textContent = '';
        plot.curve.series.forEach((s, k) =>
        {
            const v = at(plot.curve, s.y, time), dot = plot.dots[k];
            dot.style.display = v === null ? 'none' : '';
            const note = document.createElement('em');
            note.style.color = plot.curve.series.length > 1 ? lineColours[k % lineColours.length] : '';
            note.textContent = (s.label ? s.label + ': ' : '') + (v === null ? '–' : written(v));
            plot.now.appendChild(note);
            if (v === null) return;
            dot.setAttribute('cx', plot.x(time));
            dot.setAttribute('cy', plot.y(v));
        });
    }
}


// Legend, notes and controls

function legend()
{
    const how = byId('colour').value, data = bar(how);
    const texture = new THREE.DataTexture(data, 256, 1, THREE.RGBAFormat);
    texture.magFilter = texture.minFilter = how === 'type' ? THREE.NearestFilter : THREE.LinearFilter;
    texture.needsUpdate = true;
    balls.material.uniforms.bar.value = texture;
    const scale = (title, from, to) =>
        `<b>${title}</b><canvas width="256" height="1"></canvas><div class="scale">${
            [0, 0.5, 1].map((f) => `<span>${written(from + f*(to - from))}</span>`).join('')}</div>`;
    const place = byId('legend');
    if (how === 'speed') place.innerHTML = scale('Speed of the grains [m/s]', 0, top);
    else if (how === 'size' && sizes.length > 6) place.innerHTML = scale('Diameter [mm]', 2000*smallest, 2000*largest);
    else if (how === 'depth') place.innerHTML = scale('Depth below the surface at the start [m]', 0, deepest);
    else if (how === 'size')
        place.innerHTML = '<b>Diameter</b>' + sizes.map(Number).sort((a, b) => a - b).map((s) =>
            `<div class="kind"><i style="background:#${mixed(ramps.size, largest > smallest
                ? (s/2000 - smallest)/(largest - smallest) : 0).getHexString()}"></i>${s} mm</div>`).join('');
    else
        place.innerHTML = '<b>Type of grain</b>' + kinds.map((k, i) => `<div class="kind"><i style="background:${
            typeColours[i % typeColours.length]}"></i>type ${k}</div>`).join('');
    const strip = place.querySelector('canvas');
    if (strip) strip.getContext('2d').putImageData(new ImageData(new Uint8ClampedArray(data), 256, 1), 0, 0);
    if (water && byId('water').checked) place.insertAdjacentHTML('beforeend', '<div class="water"><i></i>water</div>');
    frame = -1;
    show(time);
}

const count = (m) => m.toLocaleString('en-US');

function words()
{
    byId('title').textContent = document.title;
    byId('what').textContent = `${count(about.all)} grain${about.all > 1 ? 's' : ''}${water ? ' and water' : ''}, ${times[0]} to ${times[last]} s, `
        + `${times.length} written times`;
    const notes = [];
    if (about.drawn < about.all) notes.push(`Grains below others are left out while they are hidden: the page draws`
        + ` ${count(about.drawn)} of ${count(about.all)} on average.`);
    if (about.every > 1) notes.push(`To stay small, the page holds one of ${about.every} written times.`);
    notes.push(`Positions are rounded to ${written(1e3*Math.max(...span)/65534)} mm; between written times they are`
        + ' interpolated.');
    if (water) notes.push(`The water surface is drawn by columns of cells, ${written(about.water.dx)} m long.`);
    if (n < 200) notes.push('A grain less than 8 pixels wide is drawn larger.');
    notes.push('Drag turns, the wheel zooms, Shift and drag (or two fingers) moves; Space plays, arrows step.');
    byId('notes').textContent = notes.join(' ');
    byId('following').style.display = front ? '' : 'none';
    byId('wetting').style.display = water ? '' : 'none';
}

function paint()
{
    const style = getComputedStyle(document.documentElement), colour = (name) => new THREE.Color(style.getPropertyValue(name).trim());
    renderer.setClearColor(colour('--scene'));
    edgeMaterial.color = colour('--edge');
    floorMaterial.color = colour('--floor');
    dirty = true;
}

function resize()
{
    const {clientWidth: wide, clientHeight: high} = byId('scene');
    renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    renderer.setSize(wide, high, false);
    camera.aspect = wide/high;
    aim();
    if (!moved) fit();
    plots.forEach(drawPlot);
    moveLines();
}

function stop()
{
    playing = false;
    byId('play').textContent = '▶ Play';
}

function play()
{
    if (time >= times[last] - 1e-9) show(times[0]);
    playing = performance.now();
    byId('play').textContent = '❚❚ Pause';
}

function step(by)
{
    stop();
    const eps = 1e-6*(times[last] - times[0]);
    const next = by > 0 ? times.find((t) => t > time + eps) : times.slice().reverse().find((t) => t < time - eps);
    if (next !== undefined) show(next);
}

function paces()
{
    const duration = times[last] - times[0] || 1;
    const list = [0.02, 0.05, 0.1, 0.25, 0.5, 1, 2];
    const usual = list.reduce((a, b) => Math.abs(Math.log(b*12/duration)) < Math.abs(Math.log(a*12/duration)) ? b : a);
    for (const p of list) byId('pace').add(new Option(p === 1 ? 'as it was' : '× ' + p, p, p === usual, p === usual));
}

function turnCut()
{
    balls.material.uniforms.cutAt.value = byId('cut').checked ? middle : -1e9;
    show(time);
}

byId('play').onclick = () => playing ? stop() : play();
byId('back').onclick = () => step(-1);
byId('on').onclick = () => step(1);
byId('slider').oninput = () => { stop(); show(Number(byId('slider').value)); };
byId('colour').onchange = legend;
byId('water').onchange = legend;
byId('cut').onchange = turnCut;
byId('follow').onchange = turnFollow;
byId('theme').onclick = () =>
{
    const root = document.documentElement;
    root.dataset.theme = root.dataset.theme === 'dark' ? 'light' : 'dark';
    paint();
};
for (const button of document.querySelectorAll('[data-from]')) button.onclick = () =>
{
    [view.azimuth, view.elevation] = button.dataset.from.split(',').map(Number);
    turnFollow();
};
document.addEventListener('keydown', (e) =>
{
    if (/INPUT|SELECT|BUTTON|SUMMARY/.test(e.target.tagName)) return;
    if (e.key === ' ') playing ? stop() : play();
    else if (e.key === 'ArrowLeft') step(-1);
    else if (e.key === 'ArrowRight') step(1);
    else return;
    e.preventDefault();
});
window.addEventListener('resize', resize);


// What a test reads from the page: the place of the highest grain, and how much of
// the picture is not background (#check)
function report()
{
    const {i, f} = interval(time), a = grains.frames[i].place, b = grains.frames[Math.min(i + 1, last)].place;
    let m = 0, highest = [0, 0, -1e9];
    for (let k = 0; k < n; k++)
    {
        if (absent(a, k) || absent(b, k)) continue;
        m++;
        const p = span.map((s, c) => about.lo[c] + s*((1 - f)*a[3*k + c] + f*b[3*k + c])/65534);
        if (p[2] > highest[2]) highest = p;
    }
    const wide = renderer.domElement.width, high = renderer.domElement.height, pixels = new Uint8Array(4*wide*high);
    context.readPixels(0, 0, wide, high, context.RGBA, context.UNSIGNED_BYTE, pixels);
    let drawn = 0, sign = 0;
    for (let k = 0; k < pixels.length; k += 4)
    {
        if (Math.abs(pixels[k] - pixels[0]) + Math.abs(pixels[k + 1] - pixels[1]) + Math.abs(pixels[k + 2] - pixels[2]) > 24) drawn++;
        sign = (31*sign + pixels[k] + 7*pixels[k + 1] + 13*pixels[k + 2]) | 0;
    }
    const data = document.documentElement.dataset;
    data.time = time;
    data.grains = m;
    data.highest = highest.map((p) => p.toFixed(5)).join(' ');
    data.drawn = (4*drawn/pixels.length).toFixed(4);
    data.picture = sign;
}

let before = performance.now();
function loop(now)
{
    requestAnimationFrame(loop);
    if (playing)
    {
        const next = time + Math.min(now - before, 100)/1000*Number(byId('pace').value);
        show(next >= times[last] ? times[last] : next);
        if (next >= times[last]) stop();
    }
    before = now;
    if (dirty) draw();
}

function draw()
{
    dirty = false;
    const turned = new THREE.Matrix3().getNormalMatrix(camera.matrixWorldInverse);
    balls.material.uniforms.pixels.value = 0.5*renderer.domElement.height/Math.tan(0.5*camera.fov*Math.PI/180);
    balls.material.uniforms.upward.value.set(0, 0, 1).applyMatrix3(turned).normalize();
    balls.material.uniforms.light.value.set(-0.35, 0.75, 0.55).normalize();
    renderer.render(scene, camera);
    placeTicks();
    if (asked.has('check')) report();
}

const dark = matchMedia('(prefers-color-scheme: dark)');
document.documentElement.dataset.theme = asked.get('theme') || (dark.matches ? 'dark' : 'light');
words();
paces();
byId('slider').min = times[0];
byId('slider').max = times[last];
for (const [id, value] of asked) if (/^(colour|water|cut|follow)$/.test(id))
{
    if (id === 'colour') byId(id).value = value;
    else byId(id).checked = value === '1';
}
if (asked.has('from')) [view.azimuth, view.elevation] = asked.get('from').split(',').map(Number);
flume.updateMatrixWorld(true);
addTicks();
addPlots();
paint();
resize();
legend();
turnCut();
turnFollow();
if (asked.has('zoom'))
{
    moved = true;
    zoom(1/Number(asked.get('zoom')));
}
if (asked.has('t'))
{
    byId('slider').value = asked.get('t');
    byId('slider').dispatchEvent(new Event('input'));
}
draw();
requestAnimationFrame(loop);
})();
