// Succeeds where a WebAssembly module imports nothing and exports the draw: imports.mjs MODULE
import { readFile } from 'node:fs/promises';

const module = await WebAssembly.compile(await readFile(process.argv[2]));
const imports = WebAssembly.Module.imports(module).map((i) => i.name);
const exported = WebAssembly.Module.exports(module).some((e) => e.name === 'gn_draw');

if (imports.length > 0 || !exported) {
    console.error(`imports: ${imports.join(' ') || 'none'}; gn_draw exported: ${exported}`);
    process.exitCode = 1;
}
