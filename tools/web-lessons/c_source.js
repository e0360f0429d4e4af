// Turns C source text into HTML: one element for each line, which can be linked to, with comments,
// strings and keywords marked. Lines that ask for a slider are marked too.

import {escape} from "./markdown.js";

const keywords = new Set(("bool break case char const continue default do double else enum extern float for if inline int " +
    "long return short signed sizeof static struct switch typedef union unsigned void while uint8_t uint16_t uint32_t " +
    "size_t true false NULL").split(" "));
const token = /\/\*[^]*?\*\/|\/\/[^\n]*|"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)*'|^#[a-z]+|[A-Za-z_]\w*|[^]/gm;

function kindOf(text) {
    if (text.startsWith("/*") || text.startsWith("//"))
        return "comment";
    if (/^["']/.test(text))
        return "string";
    if (text.startsWith("#"))
        return "directive";
    return keywords.has(text) ? "keyword" : "";
}

// The sliders of a lesson, with the lines that ask for them: name -> number of the line.
export function sliderLines(source) {
    const result = new Map();
    source.split("\n").forEach((line, i) => {
        const match = /lesson_slider(?:_int)?\(\s*"([^"]+)"/.exec(line);
        if (match)
            result.set(match[1], i + 1);
    });
    return result;
}

export function sourceHtml(source) {
    let lines = [""];
    for (const [text] of source.replace(/\n$/, "").matchAll(token)) {
        const kind = kindOf(text);
        text.split("\n").forEach((part, i) => {
            if (i > 0)
                lines.push("");
            if (part)
                lines[lines.length - 1] += kind ? `<span class="${kind}">${escape(part)}</span>` : escape(part);
        });
    }
    const marked = new Set(sliderLines(source).values());
    lines = lines.map((line, i) => {
        const slider = marked.has(i + 1) ? " slider" : "";
        return `<span class="line${slider}" id="L${i + 1}">${line}\n</span>`;
    });
    return lines.join("");
}
