// The search of the documentation's site: which sections of its pages, and which names of the library, have
// all words of a query. The index is search_index.js, which site.py writes.

// What it counts that a word is found in a text: more at the beginning of a word than within one.
function placeOf(text, word, atStart, within) {
    const at = text.indexOf(word);
    if (at < 0)
        return 0;
    const start = new RegExp(`(^|[^a-z0-9])${word.replace(/[.*+?^${}()|[\]\\]/g, "\\$&")}`);
    return start.test(text) ? atStart : within;
}

// Scores an entry of the index: [title, heading, address, text]. 0 means that a word is absent.
function scoreOf([title, heading, , text = ""], words) {
    const [t, h, x] = [title, heading, text].map((part) => part.toLowerCase());
    let sum = t === words.join(" ") ? 100 : 0;
    for (const word of words) {
        // A heading says more about its section than the title of the page.
        const points = placeOf(t, word, 10, 6) + placeOf(h, word, 12, 8) + placeOf(x, word, 3, 1);
        if (points === 0)
            return 0;
        sum += points;
    }
    return sum;
}

function best(entries, words, count) {
    return entries
        .map((entry) => ({ entry, score: scoreOf(entry, words) }))
        .filter(({ score }) => score > 0)
        .sort((a, b) => b.score - a.score)
        .slice(0, count)
        .map(({ entry }) => entry);
}

// Returns the entries that have all words of a query, the best first: { words, pages, names }.
function searchSite({ pages, names }, query) {
    const words = query.toLowerCase().split(/\s+/).filter((word) => word !== "");
    if (words.length === 0)
        return { words, pages: [], names: [] };
    // Among equals, pages stay in the order of the menu, and short names come first.
    const sorted = names.map(([name, kind, address]) => [name, kind, address, ""]).sort((a, b) => a[0].length - b[0].length);
    return { words, pages: best(pages, words, 12), names: best(sorted, words, 20) };
}

// The part of a text around the first word that is found in it.
function excerpt(text, words) {
    const lower = text.toLowerCase();
    const places = words.map((word) => lower.indexOf(word)).filter((at) => at >= 0);
    if (places.length === 0)
        return "";
    const from = Math.max(0, lower.lastIndexOf(" ", Math.max(0, Math.min(...places) - 30)) + 1);
    const end = text.indexOf(" ", from + 110);
    return (from > 0 ? "… " : "") + text.slice(from, end < 0 ? undefined : end) + (end < 0 ? "" : " …");
}
