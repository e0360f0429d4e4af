// Models for explained.mjs, as texts of OBJ and MTL, with pixels: what the page draws of a dropped OBJ is what
// `gnomon explain` draws of the file.
import { readFile } from 'node:fs/promises';
import { readModel } from '../../tools/web/model.js';
import { Engine } from '../../tools/web/engine.js';

// Two materials, a polygon, indices from the end, corners without normals or texture coordinates, and a triangle
// that reaches behind the eye of the camera below.
const mixed = {
    name: 'mixed',
    obj: `mtllib mixed.mtl
v -0.7 -0.5 0.1
v 0.8 -0.4 -0.2
v 0.6 0.7 0.3
v -0.5 0.6 -0.1
v 0.1 0.2 0.9
v 0.15 0.1 6
vt 0 0
vt 1 0.1
vt 0.9 1
vt 0 1
vn 0 0 1
usemtl red
f 1/1 2/2 3/3 4/4
usemtl blue
f 1//1 2//1 5//1
f -5 -4 -2
f 3 4 6
`,
    mtl: 'newmtl red\nKd 0.8 0.1 0.2\nKs 0.5 0.5 0.5\nNs 20\nnewmtl blue\nKd 0.1 0.2 0.9\n',
    hasNormals: false,
};

// Every corner has a normal. The faces share corners, and the ends of the file's lines are those of another system.
const roof = {
    name: 'roof',
    obj: [
        'v -1 0 1', 'v 1 0 1', 'v 1 0 -1', 'v -1 0 -1', 'v -1 0.8 0', 'v 1 0.8 0', 'vn 0 0.78 0.62',
        'vn 0 0.78 -0.62', 'vn -1 0 0', 'vn 1 0 0', 'f 1//1 2//1 6//1 5//1', 'f 3//2 4//2 5//2 6//2',
        'f 4//3 1//3 5//3', 'f 2//4 3//4 6//4', '',
    ].join('\r\n'),
    mtl: '',
    hasNormals: true,
};

// `camera` is given to both. Where it lacks something, both choose it; only the angle has different defaults (page.h).
export const cases = [
    { model: mixed, camera: { eye: '1,1.5,3', target: '0,0.1,0', near: '1', far: '10', fov: '40' },
        pixels: [[30, 23], [34, 28], [20, 18], [40, 12], [28, 36]] },
    { model: mixed, camera: { eye: '1,1.5,3', target: '0,0.1,0', fov: '35' }, pixels: [[30, 23], [34, 28]] },
    { model: mixed, camera: { fov: '35' }, pixels: [[34, 28], [33, 27], [32, 26]] },
    { model: roof, camera: { eye: '2,1,3', target: '0,0.3,0', near: '0.5', far: '20', fov: '50' },
        pixels: [[30, 26], [36, 24], [40, 28], [24, 22]] },
    { model: roof, camera: { fov: '35' }, pixels: [[30, 26], [36, 24], [40, 28], [24, 22]] },
];

// Lit by nothing, and lit.
export const shaders = ['vertex-color', 'normals', 'flat', 'gouraud'];

// The page's background, for the command.
export const background = 'eeece7';

// The module with a model that was dropped, read as the page reads it.
export async function load(path, { name, obj, mtl }) {
    const files = [[`${name}.obj`, obj], [`${name}.mtl`, mtl]].map(([file, text]) => new File([text], file));
    const engine = await Engine.create(await WebAssembly.compile(await readFile(path)));
    await readModel(engine, files);
    return engine;
}

// What must be equal, as text: of each fragment all values of all stages, but for
// - steps (t1, t2, ...): C leaves the order of operands to the compiler;
// - the light, and with a lit shader the colours from it: the page's light and the command's shine from other
//   directions with other strengths;
// - normals, and colours from them, if the file has none for some corner: they are weighted by angles, which come
//   from the C library, and the page has another one;
// - tangents: the page always makes them, the command only for maps.
export function essence({ pixel, size, color, fragments }, model, shader) {
    const hasOtherColors =
        shader === 'flat' || shader === 'gouraud' || (shader === 'normals' && !model.hasNormals);
    const leftOut = [/^t\d+$/, /^light\./, /\btangent\b/];
    if (hasOtherColors)
        leftOut.push(/\b(red|green|blue)/, /word$/);
    if (!model.hasNormals)
        leftOut.push(/\bnormal\.[xyz]/);
    const isKept = ({ name }) => !leftOut.some((pattern) => pattern.test(name));
    return JSON.stringify([
        pixel,
        size,
        hasOtherColors && fragments.length > 0 ? '' : color,
        fragments.map((fragment) => ({
            ...fragment,
            stages: fragment.stages.map((stage) => [
                stage.name,
                ...stage.values.filter(isKept).map(({ name, value, bits }) => `${name} ${value} ${bits}`).sort(),
            ]),
        })),
    ]);
}
