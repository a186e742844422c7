// Checks a glb recording with the Khronos validator and with three.js, against the NumPy arrays of
// the same run:
//     node check_glb.js DIRECTORY/NAME [TOLERANCE]
// NAME.glb must have no error and no warning; at every keyframe, and half-way between neighbours,
// every vertex must stand within TOLERANCE (default 1e-6) metres of a particle's position.
import { readFileSync } from 'node:fs';
import validator from 'gltf-validator';
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { readNpy } from './npy.js';

/// Node has no pictures: three.js gets one that is loaded and empty.
function provideEmptyPictures() {
    globalThis.self = globalThis;
    globalThis.createImageBitmap = async () => ({ width: 1, height: 1, close() {} });
}

async function validate(path) {
    const report = await validator.validateBytes(new Uint8Array(readFileSync(path)),
                                                 { maxIssues: 20 });
    const { numErrors, numWarnings, numInfos, numHints, messages } = report.issues;
    console.log(`${path}: ${numErrors} errors, ${numWarnings} warnings, ${numInfos} notes, ` +
                `${numHints} hints`);
    for (const { code, pointer, message } of messages)
        console.log(`  ${code} ${pointer}: ${message}`);
    return numErrors + numWarnings === 0;
}

async function load(path) {
    provideEmptyPictures();
    const bytes = readFileSync(path);
    const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
    const gltf = await new GLTFLoader().parseAsync(buffer, '');
    let mesh;
    gltf.scene.traverse((object) => { if (object.isMesh) mesh = object; });
    return { gltf, mesh };
}

/// For each vertex the particle it stands for: the one at its place in the first frame.
function particlesOfVertices(mesh, positions, particles) {
    const point = new THREE.Vector3();
    return Array.from({ length: mesh.geometry.attributes.position.count }, (_, vertex) => {
        mesh.getVertexPosition(vertex, point);
        let nearest = 0, least = Infinity;
        for (let p = 0; p < particles; ++p) {
            const distance = Math.hypot(point.x - positions[3 * p], point.y - positions[3 * p + 1],
                                        point.z - positions[3 * p + 2]);
            if (distance < least) [nearest, least] = [p, distance];
        }
        return nearest;
    });
}

/// Greatest distance along any axis between the mesh as it is posed and frames a, b of the run,
/// blended half and half (a = b: the frame itself).
function difference(mesh, particleOf, positions, particles, a, b) {
    const point = new THREE.Vector3();
    let greatest = 0;
    particleOf.forEach((particle, vertex) => {
        mesh.getVertexPosition(vertex, point);
        const inA = 3 * (a * particles + particle), inB = 3 * (b * particles + particle);
        [point.x, point.y, point.z].forEach((value, axis) => {
            const expected = 0.5 * (positions[inA + axis] + positions[inB + axis]);
            greatest = Math.max(greatest, Math.abs(value - expected));
        });
    });
    return greatest;
}

function nearestFrame(times, time) {
    let nearest = 0;
    for (let i = 1; i < times.length; ++i)
        if (Math.abs(times[i] - time) < Math.abs(times[nearest] - time)) nearest = i;
    return nearest;
}

async function compare(stem) {
    const { gltf, mesh } = await load(`${stem}.glb`);
    const { shape, data: positions } = readNpy(`${stem}.positions.npy`);
    const times = readNpy(`${stem}.times.npy`).data;
    const particles = shape[1];
    const mixer = new THREE.AnimationMixer(gltf.scene);
    const action = mixer.clipAction(gltf.animations[0]);
    action.setLoop(THREE.LoopOnce);
    action.clampWhenFinished = true;
    action.play();
    const keys = gltf.animations[0].tracks[0].times;
    const pose = (time) => mixer.setTime(time);
    pose(keys[0]);
    const particleOf = particlesOfVertices(mesh, positions, particles);

    let atKeys = 0, between = 0;
    keys.forEach((time, key) => {
        const frame = nearestFrame(times, time);
        if (Math.abs(times[frame] - time) > 1e-6) throw new Error(`no frame at ${time} s`);
        pose(time);
        const compareWith = (a, b) => difference(mesh, particleOf, positions, particles, a, b);
        atKeys = Math.max(atKeys, compareWith(frame, frame));
        if (key + 1 === keys.length) return;
        pose(0.5 * (time + keys[key + 1]));
        const next = nearestFrame(times, keys[key + 1]);
        between = Math.max(between, compareWith(frame, next));
    });
    console.log(`${stem}.glb in three.js ${THREE.REVISION}: ${particleOf.length} vertices, ` +
                `${keys.length} keyframes of ${shape[0]} frames, ` +
                `greatest difference ${atKeys} m, half-way ${between} m`);
    const covers = nearestFrame(times, keys[0]) === 0 &&
                   nearestFrame(times, keys[keys.length - 1]) === shape[0] - 1;
    if (!covers) console.log('  the keyframes do not reach from the first to the last frame');
    return { atKeys, between, covers };
}

const [stem, tolerance = '1e-6'] = process.argv.slice(2);
const valid = await validate(`${stem}.glb`);
const { atKeys, between, covers } = await compare(stem);
// Half-way the time itself is rounded to float, so a moving vertex may be off by a little more.
const good = valid && covers && atKeys <= Number(tolerance) && between <= 100 * Number(tolerance);
console.log(good ? 'good' : 'NOT GOOD');
process.exit(good ? 0 : 1);
