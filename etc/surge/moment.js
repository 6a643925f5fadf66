// SPDX-License-Identifier: GPL-3.0-or-later
// The moment shown, between two written times, and the front of the grains.

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
