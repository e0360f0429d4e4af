// Counts the results of tests: each is a name and a function that throws if something is wrong.
import { setTimeout as after } from "node:timers/promises";

const tests = [];

// Milliseconds after which a test has failed because it hangs; a hundred times what the longest one takes.
const LIMIT = 45 * 60 * 1000;

export function test(name, body) {
    tests.push({ name, body });
}

// Says what a test leaves out, as tests/skip.sh does: under GN_NO_SKIP this counts as a failure.
const skipped = new Set();
export function skip(what) {
    skipped.add(what);
}

async function withinLimit(work) {
    const control = new AbortController();
    const late = after(LIMIT, null, { signal: control.signal }).then(() => {
        throw new Error(`it has not ended after ${LIMIT / 60000} minutes`);
    });
    try {
        await Promise.race([work, late]);
    } finally {
        late.catch(() => {});
        control.abort();
    }
}

// Runs all tests, or those whose name contains an argument of the command, and prints the counts.
export async function run() {
    const only = process.argv.slice(2).filter((argument) => !argument.startsWith("-"));
    let passed = 0;
    let failed = 0;
    for (const { name, body } of tests) {
        if (only.length > 0 && !only.some((part) => name.includes(part)))
            continue;
        try {
            await withinLimit(body());
            ++passed;
        } catch (error) {
            ++failed;
            console.log(`FAILED: ${name}\n    ${String(error.stack ?? error).split("\n").slice(0, 12).join("\n    ")}`);
        }
    }
    for (const what of skipped) {
        console.log(`skipped: ${what}`);
        if (process.env.GN_NO_SKIP)
            ++failed;
    }
    console.log(`${passed} passed, ${failed} failed`);
    process.exitCode = failed > 0 || passed === 0 ? 1 : 0;
}
