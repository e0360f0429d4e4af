// Tests that the page's module explains pixels as the command does: the same fragments, and the same
// values and bits. Steps (t1, t2, ...) may be others, since C leaves the order of operands to the
// compiler.
// usage: explained.mjs BUILD
import { execFileSync } from 'node:child_process';
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
    return `${a.slice(at - 20, at + 60)} / ${b.slice(at - 20, at + 60)}`;
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
        const command = execFileSync(
            `${build}/gnomon`,
            ['explain', '--state', state, '--pixel', `${x},${height - 1 - y}`, '--json'],
            { encoding: 'utf8', maxBuffer: 1 << 28 },
        );
        check(
            `${state} at ${x},${y}`,
            at !== 0 && essence(ours) === essence(command),
            at === 0 ? ours : difference(essence(ours), essence(command)),
        );
        fragments += JSON.parse(ours).fragments.length;
    }
}
check('pixels have fragments', fragments > 20, `${fragments}`);
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
