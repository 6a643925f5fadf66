// SPDX-License-Identifier: GPL-3.0-or-later
// Grains of all times, read from the text of the page, and the colours they can have.

const byId = (id) => document.getElementById(id);
const about = JSON.parse(byId('about').textContent);
const rows = (id) => byId(id).textContent.trim().split('\n');
const times = about.times, n = about.grains, last = times.length - 1;
const query = new URLSearchParams(location.hash.slice(1));


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
