// SPDX-License-Identifier: GPL-3.0-or-later
// Legend, notes and controls; what a test reads from the page.

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
    if (query.has('check')) report();
}

const dark = matchMedia('(prefers-color-scheme: dark)');
document.documentElement.dataset.theme = query.get('theme') || (dark.matches ? 'dark' : 'light');
words();
paces();
byId('slider').min = times[0];
byId('slider').max = times[last];
for (const [id, value] of query) if (/^(colour|water|cut|follow)$/.test(id))
{
    if (id === 'colour') byId(id).value = value;
    else byId(id).checked = value === '1';
}
if (query.has('from')) [view.azimuth, view.elevation] = query.get('from').split(',').map(Number);
flume.updateMatrixWorld(true);
addTicks();
addPlots();
paint();
resize();
legend();
turnCut();
turnFollow();
if (query.has('zoom'))
{
    moved = true;
    zoom(1/Number(query.get('zoom')));
}
if (query.has('t'))
{
    byId('slider').value = query.get('t');
    byId('slider').dispatchEvent(new Event('input'));
}
draw();
requestAnimationFrame(loop);
