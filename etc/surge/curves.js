// SPDX-License-Identifier: GPL-3.0-or-later
// Curves of the function objects, with a line at the moment shown.

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
