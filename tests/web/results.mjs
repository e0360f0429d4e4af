// Counts the results of tests: each is a name and a function that throws if something is wrong.
const tests = [];

export function test(name, body) {
    tests.push({ name, body });
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
            await body();
            ++passed;
        } catch (error) {
            ++failed;
            console.log(`FAILED: ${name}\n    ${String(error.stack ?? error).split("\n").slice(0, 12).join("\n    ")}`);
        }
    }
    console.log(`${passed} passed, ${failed} failed`);
    process.exitCode = failed > 0 || passed === 0 ? 1 : 0;
}
