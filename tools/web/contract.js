// The committed hashes of pictures, pictures.txt: lines "HASH STATE", comments behind "#".

export async function loadContract(url) {
    const response = await fetch(url);
    if (!response.ok)
        throw new Error(`${url} cannot be loaded: ${response.status} ${response.statusText}`);
    const hashes = new Map();
    for (const line of (await response.text()).split("\n")) {
        const [, hash, state] = /^([0-9a-f]{16})(?:\s+(\S*))?\s*$/.exec(line) ?? [];
        if (hash)
            hashes.set(state ?? "", hash);
    }
    if (hashes.size === 0)
        throw new Error(`${url} has no hashes`);
    return hashes;
}

// Says whether a picture's hash is the contract's, in a word and a sentence.
export function judge(contract, state, hash) {
    if (!contract)
        return { verdict: "none", text: "The contract is not loaded." };
    const expected = contract.get(state);
    if (expected === undefined)
        return {
            verdict: "unlisted",
            text: `Not one of the ${contract.size} pictures of the contract. Every machine should have this hash, too.`,
        };
    if (expected === hash)
        return { verdict: "same", text: "It is the contract’s: the same on every machine." };
    return {
        verdict: "different",
        text: `It should be ${expected}. Gnomon’s picture is wrong here: please report your browser and machine.`,
    };
}
