// Tests the page's WebAssembly modules in Node: that they import nothing and export what page.h says,
// how large they are, and that each draws the contract's pictures, whole and in bands, says what is
// wrong with a wrong state or model and then stays as it was.
// usage: modules.mjs BUILD [PICTURES [MODULE...]]
import { gzipSync } from 'node:zlib';
import { readdir, readFile } from 'node:fs/promises';
import { Page, readPictures } from './module.mjs';

const web = `${process.argv[2]}/web`;
const pictures = await readPictures(process.argv[3] ?? 'tests/contract/pictures.txt');
const backends = { 'gnomon-simd.wasm': 'wasm-simd128', 'gnomon.wasm': 'portable' };
const names = process.argv.length > 4 ? process.argv.slice(4) : Object.keys(backends);
const largestSum = 400000; // bytes compressed, with the readers of models: what the page may cost to load
let passed = 0;
let failed = 0;

function check(what, good, detail = '') {
    if (good) {
        passed += 1;
        return;
    }
    failed += 1;
    if (failed <= 20)
        console.log(`FAILED: ${what}${detail === '' ? '' : `: ${detail}`}`);
}

// Runs part of the tests; an error in it is a failure, and the other parts run.
async function part(what, run) {
    try {
        await run();
    } catch (error) {
        check(what, false, error.message);
    }
}

// The fault of a call, or '' if there is none.
function faultOf(call) {
    try {
        call();
    } catch (error) {
        return error.message;
    }
    return '';
}

async function checkSizes() {
    let sum = 0;
    for (const file of (await readdir(web)).filter((name) => name.endsWith('.wasm'))) {
        const size = gzipSync(await readFile(`${web}/${file}`), { level: 9 }).length;
        console.log(`${file}: ${size} bytes compressed`);
        sum += size;
    }
    check('the modules are at most 400,000 bytes compressed', sum > 0 && sum <= largestSum, `${sum} bytes`);
}

async function checkInterface(page, name) {
    const header = await readFile('tools/web/page.h', 'utf8');
    const native = ['page_scene', 'page_camera', 'page_use_backend'];
    const wanted = [...header.matchAll(/^[a-z][^\n]*?[ *](page_[a-z_]+)\(/gm)]
        .map((match) => match[1])
        .filter((text) => !native.includes(text))
        .concat('memory', name === 'gnomon.wasm' ? ['page_explain'] : [])
        .sort();
    const imports = WebAssembly.Module.imports(page.module).map((entry) => entry.name);
    const exported = WebAssembly.Module.exports(page.module)
        .map((entry) => entry.name)
        .sort();
    check(`${name} imports nothing`, imports.length === 0, imports.join(' '));
    check(`${name} exports what page.h says`, exported.join() === wanted.join(), exported.join(' '));
}

function checkPictures(page, name) {
    check('the contract has its pictures', pictures.length >= 150, `${pictures.length}`);
    for (const { state, hash } of pictures) {
        page.setState(state);
        page.build();
        page.draw();
        const drawn = page.hash(page.picture());
        check(`${name}: "${state}" is drawn as by the reference`, drawn === hash, drawn);
        check(`${name}: "${state}" is canonical`, page.state === state, page.state);
    }
}

// Several instances draw one picture in bands.
async function checkBands(path, name) {
    const states = ['', 'samples=4&shadows=on', 'convention=vulkan&size=333x211', 'model=cube&size=64x7'];
    const workers = await Promise.all([1, 2, 3].map(() => Page.load(path)));
    const one = await Page.load(path);
    for (const state of states) {
        one.setState(state);
        one.build();
        one.draw();
        const height = one.exports.page_height();
        const bands = workers.map((worker, i) => {
            const from = Math.floor((height * i) / workers.length);
            const end = Math.floor((height * (i + 1)) / workers.length);
            worker.setState(state);
            worker.build();
            worker.draw(from, end);
            return worker.picture(from, end);
        });
        const whole = Buffer.from(one.picture());
        check(`${name}: bands of "${state}" are the whole`, Buffer.concat(bands).equals(whole));
    }
}

function checkFaults(page, name) {
    const before = 'model=cube&size=64x48&samples=4';
    page.setState(before);
    const wrong = [
        'model=kettle', 'size=0x5', 'size=5000x5', 'size=5', 'size=5x5x5', 'shader=rough', 'maps=maybe',
        'filter=', 'samples=2', 'polygons=triangles', 'cull=all', 'bands=0', 'bands=1', 'bands=256', 'exponent=1025',
        'convention=metal', 'fov=0', 'fov=180', 'fov=wide', 'near=0', 'near=-1', 'far=1e40', 'eye=1,2',
        'eye=1,2,3,4', 'eye=nan,0,0', 'target=1e19,0,0', 'colour=red', 'model', '=', '\u{1f600}=1',
        `${'x'.repeat(100000)}=1`, `model=${'y'.repeat(100000)}`,
    ];
    for (const state of wrong) {
        if (state === 'filter=' || state === 'model')
            continue; // An empty value means the default.
        const fault = faultOf(() => page.setState(`size=32x32&${state}`));
        check(`${name}: "${state.slice(0, 40)}" is refused in words`, fault.length > 10, fault);
        check(`${name}: a state stays after "${state.slice(0, 40)}"`, page.state === before, page.state);
    }
    const impossible = ['near=5&far=3', 'eye=1,2,3&target=1,2,3', 'model=dropped'];
    for (const state of impossible) {
        page.setState(state);
        const fault = faultOf(() => page.build());
        check(`${name}: "${state}" is not built, and the message says why`, fault.length > 10, fault);
        check(`${name}: "${state}" is not drawn`, faultOf(() => page.draw()).length > 10);
    }
    page.setState('size=64x48');
    check(`${name}: nothing is drawn before it is built`, /page_build/.test(faultOf(() => page.draw())));
    page.build();
    check(`${name}: rows must be the picture's`, faultOf(() => page.draw(40, 49)).length > 10);
    check(`${name}: no message stays`, page.message.length > 0 && page.exports.page_build() === 0 && page.message === '');
}

// A square of two parts, one with a map, as files. Other formats are those of models.mjs.
const square = 'mtllib q.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 1\nvt 0 1\n' +
    'usemtl plain\nf 1 2 3\nusemtl mapped\nf 1/1 3/2 4/3\n';
const materials = 'newmtl plain\nKd 1 0.5 0.25\nnewmtl mapped\nKd 1 1 1\nmap_Kd map.png\n';

function addFiles(page, files) {
    page.exports.page_model_begin();
    for (const [name, text] of files) {
        const encoded = new TextEncoder().encode(text);
        const at = page.withTexts('page_model_file', name, encoded.length);
        page.bytes(at, encoded.length).set(encoded);
    }
}

function checkDropped(page, name) {
    const e = page.exports;
    addFiles(page, [['q.obj', square], ['q.mtl', materials], ['map.png', '']]);
    page.must(e.page_model_read());
    const { images } = JSON.parse(page.text(e.page_model_describe()));
    check(`${name}: a dropped model wants its image`, images.length === 1 && images[0].file === 2, JSON.stringify(images));
    // The upper row is red, the lower one blue.
    page.bytes(e.page_model_image(images[0].number, 2, 2), 16)
        .set([255, 0, 0, 255, 255, 0, 0, 255, 0, 0, 255, 255, 0, 0, 255, 255]);
    page.must(e.page_model_end());
    page.setState('model=dropped&size=90x90&shader=unlit&filter=nearest&eye=0,0,4&target=0,0,0');
    page.build();
    page.draw();
    const pixel = (x, y) => [...page.bytes(e.page_color() + 4 * (90 * y + x), 3)].join();
    check(`${name}: a dropped model has its colour`, pixel(60, 30) === '255,128,64', pixel(60, 30));
    check(`${name}: the map's upper row is above`, pixel(30, 60) === '255,0,0', pixel(30, 60));
    check(`${name}: the map's lower row is below`, pixel(28, 34) === '0,0,255', pixel(28, 34));

    addFiles(page, [['q.obj', square.replace('f 1 2 3', 'f 1 2 5')]]);
    check(`${name}: a wrong model is refused`, e.page_model_read() === 1 && /^q\.obj: line 10: /.test(page.message), page.message);
    check(`${name}: a wrong model is not kept`, faultOf(() => page.build()).length > 10);
    for (const call of [() => e.page_model_end(), () => e.page_model_read()])
        check(`${name}: ${call} fails in words`, call() === 1 && page.message.length > 10, page.message);
    check(`${name}: no image without a model`, e.page_model_image(0, 4, 4) === 0 && page.message.length > 10);
}

function checkDescription(page, name) {
    page.setState('shadows=on&size=64x48');
    page.build();
    const before = page.describe();
    page.exports.page_turn(30, 10);
    page.build();
    const turned = page.describe();
    const buffer = page.exports.memory.buffer;
    const [ground, teapot] = before.draws;
    check(`${name}: the description has ground and teapot`, before.draws.length === 2 && ground.vertices < teapot.vertices);
    check(`${name}: maps of the teapot`, Object.keys(teapot.maps).sort().join() === 'diffuse,glow,normal,shadow,specular');
    check(`${name}: a turn moves no array`, turned.contents === before.contents &&
        turned.draws[1].attributes.position.at === teapot.attributes.position.at &&
        turned.draws[1].maps.diffuse.at === teapot.maps.diffuse.at);
    check(`${name}: a turn moves the camera`, turned.draws[1].clipFromModel.join() !== teapot.clipFromModel.join());
    const indices = new Uint32Array(buffer, teapot.indices.at, teapot.indices.count);
    check(`${name}: indices are those of vertices`, indices.reduce((a, b) => Math.max(a, b)) === teapot.vertices - 1);
    page.set('shader', 'toon');
    page.build();
    check(`${name}: another shader is said to be other contents`, page.describe().contents !== before.contents);
}

for (const name of names) {
    const path = `${web}/${name}`;
    const start = performance.now();
    const page = await Page.load(path);
    page.build();
    page.draw();
    console.log(`${name}: first picture after ${Math.round(performance.now() - start)} ms`);
    check(`${name} draws with its back end`, page.text(page.exports.page_backend()) === backends[name]);
    await part(`${name}: interface`, () => checkInterface(page, name));
    await part(`${name}: pictures`, () => checkPictures(page, name));
    await part(`${name}: bands`, () => checkBands(path, name));
    await part(`${name}: faults`, () => checkFaults(page, name));
    await part(`${name}: dropped models`, () => checkDropped(page, name));
    await part(`${name}: description`, () => checkDescription(page, name));
}
await part('sizes', checkSizes);
console.log(`modules: ${passed} passed, ${failed} failed`);
process.exitCode = failed === 0 ? 0 : 1;
