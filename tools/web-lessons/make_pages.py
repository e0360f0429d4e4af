#!/usr/bin/env python3
"""Writes the lessons as web pages: for each lesson its text, its picture, which is drawn in place, its sliders
and its source. lessons.js makes them live.
usage: make_pages.py MODELS MODULES TO   (from the root of the project)
  MODELS   where the build puts the models that lessons read, build/examples
  MODULES  where lessons.wasm and lessons-simd.wasm are
  TO       where the pages go; what is there is replaced"""

import json
import pathlib
import re
import shutil
import struct
import sys
from html import escape

sys.path.insert(0, "tools/docs")
import render  # noqa: E402

EXAMPLES = pathlib.Path("tools/examples")
OWN = pathlib.Path("tools/web-lessons")
sources = set()  # files that pages link to


def read(name):
    return (EXAMPLES / name).read_text(encoding="utf-8")


def link_from(lesson):
    """Returns where the links of a lesson's page lead: to a page, to the shown source, or nowhere (None)."""
    def link(target, _):
        if target == "README.md":
            return "index.html"
        if target == f"{lesson}.c":
            return "#source"
        if re.fullmatch(r"\w+\.md", target):
            return target.replace(".md", ".html")
        if re.fullmatch(r"[a-z_]+\.[ch]", target):
            sources.add(target)
            return f"{target}.html"
        return target if re.fullmatch(r"pictures/\w+\.png|drawings/\w+\.svg", target) else None
    return link


def blocks_of(name, lesson=""):
    return render.blocks(render.parse(read(name), link_from(lesson)))


def html(blocks):
    text = "".join(render.html(block) for block in blocks)
    for tag, marked in {"<pre>": '<pre class="block" tabindex="0" role="region" aria-label="Code">',
                        "<table>": '<div class="wide"><table>', "</table>": "</table></div>"}.items():
        text = text.replace(tag, marked)
    return text


def page(title, description, main, script="", navigation=""):
    """Scripts, styles and pictures come from this site alone, and the browser is told so."""
    again = navigation.replace('"Lessons"', '"Lessons, again"')
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; img-src 'self' data:">
<title>{escape(title)} - Gnomon</title>
<meta name="description" content="{escape(description)}">
<link rel="icon" href="data:,">
<link rel="stylesheet" href="lessons.css">
{script}</head>
<body>
<a class="skip" href="#main">To the lesson</a>
<header>
<nav aria-label="Site"><a href="../index.html">Gnomon</a> <a href="index.html">Lessons</a></nav>
{navigation}</header>
<main id="main">
{main}
</main>
{f"<footer>{again}</footer>" if navigation else ""}
</body>
</html>
"""


def slider_lines(source):
    """The sliders of a lesson, with the numbers of the lines that ask for them."""
    found = ((re.search(r'lesson_slider(?:_int)?\(\s*"([^"]+)"', line), i) for i, line in enumerate(source.split("\n"), 1))
    return {match[1]: i for match, i in found if match}


def source_html(source):
    """One element for each line, which can be linked to. Lines that ask for a slider are marked."""
    marked = slider_lines(source).values()
    lines = render.source(source, "c").rstrip("\n").split("\n")
    return "".join(f'<span class="line{" slider" if i in marked else ""}" id="L{i}">{line}\n</span>' for i, line in enumerate(lines, 1))


def stage(name, source, picture):
    """What the reader sees of a run: the picture or the text, the sliders, what the lesson printed."""
    files = [file for file in re.findall(r'"build/examples/([^"]+)"', source) if file != f"{name}.tga"]
    shown = setup = ""
    if picture:
        # PNG says its width and height in bytes 16 to 23. A page's picture is half as large as the drawn one.
        width, height = struct.unpack(">II", (EXAMPLES / "pictures" / f"{name}.png").read_bytes()[16:24])
        words = escape(picture.content)
        shown = f"""<canvas id="picture" width="{2 * width}" height="{2 * height}" role="img" aria-label="{words}"></canvas>
<noscript><img src="{picture.attrGet('src')}" alt="{words}"></noscript>
"""
    if re.search(r"\bstdin\b", source):
        setup = """<p class="input"><label for="input">Setup, one statement a line</label>
<textarea id="input" rows="4" spellcheck="false" placeholder="point 1 0.5 0.25"></textarea></p>
"""
    return f"""<section class="stage" aria-label="The lesson, running" data-number="{int(name[:2])}" data-files="{' '.join(files)}"
    data-lines="{escape(json.dumps(slider_lines(source)))}">
<p id="state">The lesson starts here. (It needs JavaScript and a web server: a page that is opened as a file cannot load it.)</p>
<p id="error" role="alert"></p>
{shown}<form id="sliders" aria-label="Sliders"></form>
{setup}<pre id="printed" class="block" tabindex="0" role="region" aria-label="What the program prints"></pre>
</section>"""


def lesson_page(name, navigation):
    source = read(f"{name}.c")
    title, *rest = blocks_of(f"{name}.md", name)
    first = next(i for i, block in enumerate(rest) if block[0].tag == "h2")
    picture = next((part for block in rest if len(block) > 1 for part in block[1].children or []
                    if part.type == "image" and part.attrGet("src").endswith(".png")), None)
    # The run stands in place of the picture, or of the printed text, and the links before and after it
    # stand in the page's own.
    intro = [block for block in rest[:first] if block[0].info != "text" and
             not (len(block) > 1 and (picture in block[1].children or block[1].content.startswith("Before: ")))]
    main = f"""<h1>{render.html(title[1:2])}</h1>
{html(intro)}<div class="beside{'' if picture else ' of-text'}">
{stage(name, source, picture)}
<section class="source" id="source" aria-labelledby="source-title">
<h2 id="source-title">The source: {name}.c</h2>
<pre tabindex="0" role="region" aria-label="C source, {source.count(chr(10))} lines"><code>{source_html(source)}</code></pre>
</section>
</div>
<div class="text">
{html(rest[first:])}</div>"""
    return page(render.words(title[1]), render.words(intro[0][1]), main,
                '<script type="module" src="lessons.js"></script>\n', navigation)


def index_page():
    """The first paragraph of README.md, the list of lessons from its table, then its other blocks."""
    title, first, *rest = blocks_of("README.md")
    table = next(block for block in rest if block[0].type == "table_open")
    cells = [token for token in table if token.type == "inline"][3:]
    items = []
    for number, lesson, about in zip(cells[0::3], cells[1::3], cells[2::3]):
        target = lesson.children[0].attrGet("href")
        picture = f"pictures/{target.replace('.html', '.png')}"
        small = f'<img src="{picture}" alt="" loading="lazy">' if (EXAMPLES / picture).is_file() else \
            '<span class="numbers" aria-hidden="true">1.0 0.5<br>0.0 2.4</span>'
        items.append(f"""<li><a href="{target}">{small}<span class="name">{number.content}. {escape(render.words(lesson))}</span></a>
<span class="about">{render.html([about])}</span></li>
""")
    return page("Lessons", "From a line of pixels to a textured head with shadows, each a small C program that runs in the page.",
                f'{html([title, first])}<ol class="lessons">{"".join(items)}</ol>\n{html(block for block in rest if block is not table)}')


def main():
    models, modules, to = map(pathlib.Path, sys.argv[1:])
    shutil.rmtree(to, ignore_errors=True)
    (to / "models").mkdir(parents=True)
    for folder in ("pictures", "drawings"):
        shutil.copytree(EXAMPLES / folder, to / folder)
    pages = {"index": index_page()}
    names = sorted(path.stem for path in EXAMPLES.glob("[0-9][0-9]_*.md"))
    titles = [escape(render.words(blocks_of(f"{name}.md")[0][1])) for name in names]
    for i, name in enumerate(names):
        back = f'<a rel="prev" href="{names[i - 1]}.html">&larr; {titles[i - 1]}</a>' if i else ""
        on = f'<a rel="next" href="{names[i + 1]}.html">{titles[i + 1]} &rarr;</a>' if i + 1 < len(names) else ""
        pages[name] = lesson_page(name, f'<nav class="steps" aria-label="Lessons">{back}{on}</nav>\n')
    for path in EXAMPLES.glob("[a-z]*.md"):
        blocks = blocks_of(path.name)
        pages[path.stem] = page(*2 * [render.words(blocks[0][1])], html(blocks))
    for file in sources:
        pages[file] = page(file, f"The source of {file}", f"""<h1>{file}</h1>
<section class="source whole"><pre tabindex="0" role="region" aria-label="C source"><code>{source_html(read(file))}</code></pre></section>""")
    for name, text in pages.items():
        (to / f"{name}.html").write_text(text, encoding="utf-8")
    for file in {file for name in names for file in re.findall(r'"build/examples/([a-z_]+\.(?:obj|tga))"', read(f"{name}.c"))}:
        shutil.copy(models / file, to / "models")
    for file in [*(OWN / name for name in ("lessons.js", "lesson_run.js", "lessons.css")), *modules.glob("lessons*.wasm")]:
        shutil.copy(file, to)
    print(to / "index.html")


if __name__ == "__main__":
    main()
