// Tests that the page's module explains pixels as the command does: the same fragments, and the same
// values and bits. Steps (t1, t2, ...) may be others, since C leaves the order of operands to the
// compiler. The same of models that are dropped on the page, and given to the command as files.
// usage: explained.mjs BUILD
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import * as models from './explained_models.mjs';
import { Page } from './module.mjs';

const build = process.argv[2];
const states = [
    ['size=80x60', [[20, 20], [40, 30], [41, 12], [79, 59], [0, 0]]],
    ['size=64x48&shadows=on&filter=linear', [[30, 20], [12, 9]]],
    ['size=60x40&samples=4&shader=toon', [[30, 20], [22, 11]]],
    ['size=64x48&polygons=line&shader=gouraud', [[30, 20], [31, 21], [32, 22]]],
    ['size=64x48&polygons=point&shader=normals', [[30, 20], [31, 21], [32, 22]]],
    ['model=cube&size=33x27&convention=vulkan&shader=unlit', [[16, 13], [10, 20]]],
    ['model=cube&size=33x27&convention=direct3d&eye=1.5,0.4,0.9', [[16, 13], [30, 2]]],
    ['model=triangle&size=64x64&shader=vertex-color', [[32, 32]]],
    ['model=square&size=64x64&shader=depth&cull=back', [[32, 32]]],
];
let passed = 0;
let failed = 0;

function check(what, good, detail = '') {
    passed += good ? 1 : 0;
    failed += good ? 0 : 1;
    if (!good)
        console.log(`FAILED: ${what}${detail === '' ? '' : `: ${detail}`}`);
}

// What does not depend on the compiler, as text.
function essence(json) {
    const told = JSON.parse(json);
    const fragments = told.fragments.map((fragment) => ({
        ...fragment,
        stages: fragment.stages.map((stage) => [
            stage.name,
            ...stage.values
                .filter((value) => !/^t\d+$/.test(value.name))
                .map((value) => `${value.name} ${value.value} ${value.bits}`)
                .sort(),
        ]),
    }));
    return JSON.stringify([told.pixel, told.size, told.color, fragments]);
}

// The place at which two texts differ first, with what stands there.
function difference(a, b) {
    let at = 0;
    while (at < a.length && a[at] === b[at])
        at += 1;
    const from = Math.max(0, at - 20);
    return `${a.slice(from, at + 60)} / ${b.slice(from, at + 60)}`;
}

// What `gnomon explain` says of a pixel, y from the bottom, as JSON.
function explainedByCommand(what, x, y, height) {
    const place = ['--pixel', `${x},${height - 1 - y}`, '--json'];
    return execFileSync(`${build}/gnomon`, ['explain', ...what, ...place], { encoding: 'utf8', maxBuffer: 1 << 28 });
}

let fragments = 0;
for (const [state, pixels] of states) {
    const page = await Page.load(`${build}/web/gnomon.wasm`);
    page.setState(state);
    page.build();
    for (const [x, y] of pixels) {
        const at = page.exports.page_explain(x, y);
        const ours = at === 0 ? page.message : page.text(at);
        const height = Number(/size=\d+x(\d+)/.exec(state)[1]);
        const command = explainedByCommand(['--state', state], x, y, height);
        check(
            `${state} at ${x},${y}`,
            at !== 0 && essence(ours) === essence(command),
            at === 0 ? ours : difference(essence(ours), essence(command)),
        );
        fragments += JSON.parse(ours).fragments.length;
    }
}
check('pixels have fragments', fragments > 20, `${fragments}`);

// Compares a dropped model's pixels, with every shader. Returns the number of fragments and of values compared.
async function compareModel(folder, { model, camera, pixels }) {
    const file = join(folder, `${model.name}.obj`);
    writeFileSync(file, model.obj);
    writeFileSync(join(folder, `${model.name}.mtl`), model.mtl);
    const engine = await models.load(`${build}/web/gnomon.wasm`, model);
    const keys = Object.entries(camera);
    const options = keys.flatMap(([key, value]) => [`--${key}`, value]);
    let found = 0;
    for (const shader of models.shaders) {
        engine.setState(['model=dropped', 'size=64x48', `shader=${shader}`, ...keys.map((pair) => pair.join('='))].join('&'));
        engine.build();
        for (const [x, y] of pixels) {
            const ours = engine.explain(x, y);
            const command = explainedByCommand([file, '--size', '64x48', '--samples', '1', '--background', models.background, '--shader', shader, ...options], x, y, 48);
            const [a, b] = [ours, JSON.parse(command)].map((told) => models.essence(told, model, shader));
            check(`${model.name}.obj, ${engine.state()} at ${x},${y}`, a === b, difference(a, b));
            found += ours.fragments.length;
        }
    }
    return found;
}

const folder = mkdtempSync(join(tmpdir(), 'explained-'));
try {
    for (const one of models.cases) {
        const found = await compareModel(folder, one);
        check(`${one.model.name}.obj: pixels have fragments`, found >= one.pixels.length * models.shaders.length, `${found}`);
    }
} finally {
    rmSync(folder, { recursive: true });
}

const page = await Page.load(`${build}/web/gnomon.wasm`);
page.setState('model=cube&size=64x64');
page.build();
check('a pixel outside is refused', page.exports.page_explain(64, 0) === 0);
check('and the message says so', page.message.includes('outside the picture'), page.message);
page.setState('model=cube');
check('a scene must be built', page.exports.page_explain(0, 0) === 0);
check('and the message says so', page.message.includes('page_build'), page.message);
console.log(`explained: ${passed} passed, ${failed} failed`);
process.exitCode = failed === 0 ? 0 : 1;
