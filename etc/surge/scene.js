// SPDX-License-Identifier: GPL-3.0-or-later
// The scene: axes, light, grains as spheres, walls and floor.

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
