// The state of the page as text: keys of the picture, which the module knows (page.h), and keys of
// the page alone. Together they are the URL's hash.

// The page's own keys, with their defaults.
export const OWN_DEFAULTS = { threads: "auto", simd: "auto", magnify: "64", pixel: "" };

const OWN_FORMS = {
    threads: /^(auto|[1-9]|[1-5]\d|6[0-4])$/,
    simd: /^(auto|on|off)$/,
    magnify: /^([1-9]\d?|1\d\d|2[0-4]\d|25[0-5])$/,
    pixel: /^(\d{1,4},\d{1,4})?$/,
};

export function pairsOf(text) {
    return text
        .split("&")
        .filter((pair) => pair !== "")
        .map((pair) => {
            const at = pair.indexOf("=");
            return at < 0 ? [pair, ""] : [pair.slice(0, at), pair.slice(at + 1)];
        });
}

// Splits the URL's hash into the picture's state and the page's own. `faults` says what is wrong
// with the latter.
export function splitHash(hash) {
    const own = { ...OWN_DEFAULTS };
    const picture = [];
    const faults = [];
    let text = hash.replace(/^#/, "");
    try {
        text = decodeURIComponent(text);
    } catch {
        faults.push(`the address ends in "${text}", which is not encoded as addresses are`);
    }
    for (const [key, value] of pairsOf(text)) {
        if (!Object.hasOwn(OWN_DEFAULTS, key))
            picture.push(`${key}=${value}`);
        else if (OWN_FORMS[key].test(value))
            own[key] = value;
        else
            faults.push(`${key}=${value} in the address is not a value that ${key} can have`);
    }
    return { picture: picture.join("&"), own, faults };
}

// What is behind the "#" of an address. Nothing there stands for the picture that the page begins with, which depends
// on the window; so the state without any key is written as one of its keys with its default.
export function joinHash(picture, own) {
    const changed = Object.entries(own).filter(([key, value]) => value !== OWN_DEFAULTS[key]);
    const all = [picture, ...changed.map(([key, value]) => `${key}=${value}`)].filter((s) => s !== "");
    return all.length === 0 ? "model=teapot" : all.join("&");
}

// The state of a lesson, in the size of the picture that is shown; with four samples if it does not say how many.
export function withFrame(lesson, state) {
    const [size] = pairsOf(state).filter(([key]) => key === "size");
    const hasSamples = pairsOf(lesson).some(([key]) => key === "samples");
    return [lesson, size && size.join("="), hasSamples ? "" : "samples=4"].filter(Boolean).join("&");
}
