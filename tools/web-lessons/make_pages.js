// Writes the lessons as web pages: for each lesson its text, its picture, which is drawn in place, its
// sliders and its source. lessons.js makes them live.
// usage: node make_pages.js MODELS MODULES TO   (from the root of the project)
//   MODELS   where the build puts the models that lessons read, build/examples
//   MODULES  where lessons.wasm and lessons-simd.wasm are
//   TO       where the pages go; what is there is replaced

import * as fs from "node:fs";
import * as path from "node:path";

import {blocks, escape, html, inline} from "./markdown.js";
import {sliderLines, sourceHtml} from "./c_source.js";

const [models, modules, to] = process.argv.slice(2);
const examples = "tools/examples";
const own = "tools/web-lessons";

const read = (name) => fs.readFileSync(path.join(examples, name), "utf8");
const write = (name, text) => fs.writeFileSync(path.join(to, name), text);
const isLesson = (name) => /^\d\d_.*\.md$/.test(name);
const sources = new Set(); // files that pages link to

// Where a link of a document leads: to a page, to the shown source, or nowhere (null).
function linkFrom(lesson) {
    return (target) => {
        if (target === "README.md")
            return "index.html";
        if (lesson && target === `${lesson}.c`)
            return "#source";
        if (target.endsWith(".md") && fs.existsSync(path.join(examples, target)))
            return target.replace(/\.md$/, ".html");
        if (/^[a-z_]+\.[ch]$/.test(target)) {
            sources.add(target);
            return `${target}.html`;
        }
        if (/^pictures\/\w+\.png$/.test(target))
            return target;
        return null;
    };
}

// Scripts, styles and pictures come from this site alone, and the browser is told so.
function page(title, description, main, {script = false, navigation = ""} = {}) {
    return `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; img-src 'self' data:">
<title>${escape(title)} - Gnomon</title>
<meta name="description" content="${escape(description)}">
<link rel="icon" href="data:,">
<link rel="stylesheet" href="lessons.css">
${script ? '<script type="module" src="lessons.js"></script>\n' : ''}</head>
<body>
<a class="skip" href="#main">To the lesson</a>
<header>
<nav aria-label="Site"><a href="../index.html">Gnomon</a> <a href="index.html">Lessons</a></nav>
${navigation}</header>
<main id="main">
${main}
</main>
${navigation && `<footer>\n${navigation.replace('"Lessons"', '"Lessons, again"')}</footer>\n`}</body>
</html>
`;
}

// PNG says its width and height in bytes 16 to 23. A page's picture is half as large as the drawn one.
function pictureSize(name) {
    const png = fs.readFileSync(path.join(examples, "pictures", `${name}.png`));
    return {width: 2 * png.readUInt32BE(16), height: 2 * png.readUInt32BE(20)};
}

const plain = (text) => inline(text, () => null).replace(/<[^>]*>/g, "");

// What the reader sees of a run: the picture or the text, the sliders, what the lesson printed.
function stage(name, source, picture) {
    const files = [...source.matchAll(/"build\/examples\/([^"]+)"/g)].map((m) => m[1]).filter((f) => f !== `${name}.tga`);
    const readsInput = /\bstdin\b/.test(source);
    let shown = "";
    if (picture) {
        const {width, height} = pictureSize(name);
        shown = `<canvas id="picture" width="${width}" height="${height}" role="img" aria-label="${escape(picture.text)}"></canvas>
<noscript><img src="${picture.target}" alt="${escape(picture.text)}"></noscript>
`;
    }
    const input = readsInput ? `<p class="input"><label for="input">Setup, one statement a line</label>
<textarea id="input" rows="4" spellcheck="false" placeholder="point 1 0.5 0.25"></textarea></p>
` : "";
    return `<section class="stage" aria-label="The lesson, running" data-number="${parseInt(name, 10)}" data-files="${files.join(' ')}"
    data-lines="${escape(JSON.stringify(Object.fromEntries(sliderLines(source))))}">
<p id="state">The lesson starts here. (It needs JavaScript and a web server: a page that is opened as a file cannot load it.)</p>
<p id="error" role="alert"></p>
${shown}<form id="sliders" aria-label="Sliders"></form>
${input}<pre id="printed" class="block" tabindex="0" role="region" aria-label="What the program prints"></pre>
</section>`;
}

function lessonPage(name, before, next) {
    const source = read(`${name}.c`);
    const link = linkFrom(name);
    const all = blocks(read(`${name}.md`));
    const title = all[0].text;
    const picture = all.find((block) => block.kind === "picture");
    const firstPart = all.findIndex((block) => block.kind === "heading" && block.level === 2);
    // The run stands in place of the picture, or of the printed text, and the links before and after it
    // stand in the page's own.
    const intro = all.slice(1, firstPart).filter((block) => block.kind !== "picture" &&
        block.language !== "text" && !block.text.startsWith("Before: "));
    const rest = all.slice(firstPart);
    const back = before ? `<a rel="prev" href="${before.name}.html">&larr; ${plain(before.title)}</a>` : "";
    const on = next ? `<a rel="next" href="${next.name}.html">${plain(next.title)} &rarr;</a>` : "";
    const navigation = `<nav class="steps" aria-label="Lessons">${back}${on}</nav>\n`;
    const main = `<h1>${inline(title, link)}</h1>
${intro.map((block) => html(block, link)).join("\n")}
<div class="beside${picture ? "" : " of-text"}">
${stage(name, source, picture)}
<section class="source" id="source" aria-labelledby="source-title">
<h2 id="source-title">The source: ${name}.c</h2>
<pre tabindex="0" role="region" aria-label="C source, ${source.split('\n').length - 1} lines"><code>${sourceHtml(source)}</code></pre>
</section>
</div>
<div class="text">
${rest.map((block) => html(block, link)).join("\n")}
</div>`;
    write(`${name}.html`, page(title, plain(intro[0].text.replace(/\n/g, " ")), main, {script: true, navigation}));
}

// The first paragraph of README.md, the list of lessons from its table, then its other blocks.
function indexPage() {
    const link = linkFrom("");
    const all = blocks(read("README.md"));
    const list = all.findIndex((block) => block.kind === "table");
    const parts = [...all.slice(0, 2), all[list], ...all.slice(2, list), ...all.slice(list + 1)].map((block) => {
        if (block.kind !== "table")
            return html(block, link);
        const items = block.text.split("\n").slice(2).map((row) => {
            const [, number, words, target, about] = /^\| (\d+) \| \[([^\]]+)\]\(([^)]+)\) \| (.*) \|$/.exec(row);
            const picture = `pictures/${target.replace(/\.md$/, '.png')}`;
            const small = fs.existsSync(path.join(examples, picture)) ?
                `<img src="${picture}" alt="" loading="lazy">` : '<span class="numbers" aria-hidden="true">1.0 0.5<br>0.0 2.4</span>';
            return `<li><a href="${link(target)}">${small}<span class="name">${number}. ${inline(words, link)}</span></a>
<span class="about">${inline(about, link)}</span></li>`;
        });
        return `<ol class="lessons">${items.join("\n")}</ol>`;
    });
    write("index.html", page("Lessons", "From a line of pixels to a textured head with shadows, each a small C program that runs in the page.",
        parts.join("\n")));
}

function copy(from, name) {
    fs.copyFileSync(path.join(from, name), path.join(to, name));
}

fs.rmSync(to, {recursive: true, force: true});
fs.mkdirSync(path.join(to, "pictures"), {recursive: true});
fs.mkdirSync(path.join(to, "models"));

const names = fs.readdirSync(examples).filter(isLesson).map((file) => file.replace(/\.md$/, "")).sort();
const lessons = names.map((name) => ({name, title: blocks(read(`${name}.md`))[0].text}));
lessons.forEach((lesson, i) => lessonPage(lesson.name, lessons[i - 1], lessons[i + 1]));
indexPage();
for (const file of fs.readdirSync(examples).filter((name) => name.endsWith(".md") && !isLesson(name) && name !== "README.md")) {
    const all = blocks(read(file));
    write(file.replace(/\.md$/, ".html"), page(all[0].text, all[0].text, all.map((block) => html(block, linkFrom(""))).join("\n")));
}
for (const file of sources)
    write(`${file}.html`, page(file, `The source of ${file}`,
        `<h1>${file}</h1>\n<section class="source whole"><pre tabindex="0" role="region" aria-label="C source"><code>${sourceHtml(read(file))}</code></pre></section>`));

for (const picture of fs.readdirSync(path.join(examples, "pictures")))
    fs.copyFileSync(path.join(examples, "pictures", picture), path.join(to, "pictures", picture));
const needed = new Set(names.flatMap((name) =>
    [...read(`${name}.c`).matchAll(/"build\/examples\/([a-z_]+\.(?:obj|tga))"/g)].map((m) => m[1])));
for (const file of needed)
    fs.copyFileSync(path.join(models, file), path.join(to, "models", file));
for (const file of ["lessons.js", "lesson_run.js", "lessons.css"])
    copy(own, file);
for (const file of ["lessons.wasm", "lessons-simd.wasm"])
    copy(modules, file);
console.log(path.join(to, "index.html"));
