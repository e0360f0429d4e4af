"""The page of the report, from what report.py gathered."""

import base64
import html
import json
import math
import pathlib
import re

import markdown

PANELS, GAP = 3, 4  # as pictures.c places them


def total(found, name):
    """The sum of a count over all classes."""
    return sum(int(values[name]) for values in found["class"])


def counted(number, one, several):
    return f"{number:,} {one if number == 1 else several}"


def spaced(number):
    return f"{int(number):,}"


def difference(count, what="pixel"):
    """'0 pixels differ', marked."""
    count = int(count)
    words = f"{count:,} {what}{'s differ' if count != 1 else ' differs'}"
    return f'<span class="{"bad" if count else "good"}">{words}</span>'


def head(found):
    facts = [("library", f"Gnomon {found['version']}"),
             ("reference", html.escape(found["reference"][0]["name"])),
             ("back ends", ", ".join(values["name"] for values in found["backend"])),
             ("seed", f"<code>{found['seed']}</code>"),
             ("date, machine", f"{found['date']}, {html.escape(found['machine'])}")]
    return f"""<h1>Gnomon: the report</h1>
<p class="result">{difference(total(found, 'differ'))} in {total(found, 'scenes'):,} random scenes of
{counted(len(found['class']), 'class', 'classes')}, {total(found, 'pixels'):,} pixels and samples.</p>
<p>Gnomon is a software renderer in freestanding C99. Its colours, depths and stencils are meant to be the same bits
as those of OSMesa (Mesa 25.0.7, llvmpipe). This page shows the evidence: pictures of both beside each other, the
figures of every claim, and how exact the mathematics is.</p>
<dl>{''.join(f'<dt>{name}</dt><dd>{value}</dd>' for name, value in facts)}</dl>
<nav aria-label="Contents"><ul>
<li><a href="#pixels">Pixels beside the reference's</a></li>
<li><a href="#claims">What is verified</a></li>
<li><a href="#accuracy">Accuracy</a></li>
<li><a href="#states">Speed in every state</a></li>
</ul></nav>"""


def scene_caption(values):
    """What a scene is, in a line of text."""
    colors = values["color"].split(", ")
    shown = int(values["shown"])
    names = [name for name in colors if name != "none"]
    parts = [f"{values['width']} × {values['height']} pixels" +
             (f" of {values['samples']} samples" if values["samples"] != "1" else ""),
             "no colour" if not names else names[0] if len(names) == 1 else
             f"{len(names)} colours: {', '.join(names)}", f"depth {values['depth']}" if values["depth"] != "none" else "no depth",
             f"{counted(int(values['triangles']), 'primitive', 'primitives')} in "
             f"{counted(int(values['draws']), 'draw', 'draws')}"]
    if shown < 0:
        parts.append("the depth is shown")
    elif len(names) > 1:
        parts.append("the first colour is shown")
    unit = "sample" if values["samples"] != "1" else "pixel"
    text = f"<strong>Scene {values['number']}</strong>: {html.escape('; '.join(parts))}. " \
           f"{difference(values['differ'], unit)} of {spaced(values['pixels'])}"
    if int(values["differ"]):
        text += f": colours of {spaced(values['color_pixels'])} by at most {values['color_largest']}, depths or " \
                f"stencils of {spaced(values['depth_pixels'])} by at most {values['depth_largest']}"
    return text + "."


def scene_figure(values):
    width, height = int(values["width"]), int(values["height"])
    across = PANELS * width + (PANELS - 1) * GAP
    scale = min(360 / across, 200 / height, 8)
    shown = max(round(across * scale), 190)
    differ = int(values["differ"])
    alt = f"Scene {values['number']} of the class {values['class']}, drawn by Gnomon and by the reference, and the " \
          f"difference, " + ("which is black." if not differ else "which is not black everywhere.")
    data = base64.b64encode(values["png"]).decode()
    return f"""<li><figure>
<div class="sides" style="width:{shown}px" aria-hidden="true"><span>Gnomon</span><span>reference</span><span>difference</span></div>
<img src="data:image/png;base64,{data}" width="{shown}" height="{round(shown * height / across)}" alt="{alt}">
<figcaption>{scene_caption(values)}</figcaption></figure></li>"""


def class_part(found, values):
    scenes = [scene for scene in found["scene"] if scene["class"] == values["name"]]
    repeat = f"build/parity --class {values['name']} --seed {found['seed']} --scenes {values['scenes']}"
    text = f"""<h3 id="class-{values['name']}">{values['name']}</h3>
<p>{html.escape(values['description'][0].upper() + values['description'][1:])}.
{difference(values['differ'])} in {counted(int(values['scenes']), 'scene', 'scenes')}, {spaced(values['pixels'])} pixels and
samples.</p>
<p class="quiet">To repeat: <code>{repeat}</code></p>"""
    if not scenes:
        return text + f"<p>No scene is shown: each of the {values['scenes']} has one colour, or none was asked for.</p>"
    return text + f'\n<ul class="scenes">{"".join(scene_figure(scene) for scene in scenes)}</ul>'


def pixels(found):
    rows = [[f'<a href="#class-{values["name"]}">{values["name"]}</a>', html.escape(values["description"]),
             *(spaced(values[name]) for name in ("scenes", "triangles", "pixels", "drawn")),
             f'<span class="{"bad" if int(values["differ"]) else "good"}">{spaced(values["differ"])}</span>']
            for values in found["class"]]
    overview = markdown.table(["class", "scenes of", "scenes", "primitives", "pixels, samples", "drawn on", "differ"], rows,
                              "Scenes of every class, compared with the reference's bit for bit")
    overview = re.sub(r'(<th scope="col" role="columnheader")(>scenes of<)', r'\1 class="text"\2', overview)
    overview = overview.replace('<td role="cell" data-label="scenes of">', '<td class="text" role="cell">')
    return f"""<h2 id="pixels">Pixels beside the reference's</h2>
<p>Of each class the first {counted(found['count'], 'scene', 'scenes')} are drawn with every back end, with several
sizes of workspace and numbers of threads, and by the reference. All colours, depths, stencils and samples are
compared, and the counts of primitives and of samples that passed. Five differences are allowed;
<code>tools/guide/verification.md</code> lists them.</p>
<p>Up to {found['shown']} scenes of each class are shown: those that differ first, then those with the most different
colours; a scene of one colour is not shown. Each picture has three parts: Gnomon's picture, the reference's, and the
difference. The difference is black where both are equal. Elsewhere it shows the differences of red, green and blue,
amplified so that one step is a clear grey, or magenta if only something differs that the picture does not show, such
as alpha, depth or another attachment.</p>
<p>Channels of integers are scaled to 0 to 255, those of sRGB are shown as stored, those of floats are clamped to 0 to 1
(NaN is 0). One channel is grey, two are red and green. Of several samples the mean is shown; of several attachments
the first. Small pictures are enlarged.</p>
{overview}
{''.join(class_part(found, values) for values in found['class'])}"""


def claims(found):
    """VERIFICATION.md as `make assurance` would write it now."""
    lines = found["verification"].splitlines()
    first = next(i for i, line in enumerate(lines) if line.startswith("## "))
    return f"""<h2 id="claims">What is verified</h2>
<p>Every claim has a command that shows it. Figures are the last line that the command printed when it last ran. A star
marks figures of an earlier text of the library (<code>include/</code> and <code>src/</code>) than this one.
<code>make assurance</code> runs every command that has no figures of this text, and writes
<code>VERIFICATION.md</code>.</p>
{markdown.convert(lines[first:], "Claims and their evidence", "words")}"""


def functions(found):
    """The table of build/accuracy."""
    lines = found["accuracy"].splitlines()
    libraries = ["Gnomon"]
    rows = []
    for line in lines[1:-1]:
        if line.startswith("compared with "):
            libraries += line[len("compared with "):].split(", ")
        elif len(libraries) > 1 and not line.startswith("error in units"):
            numbers, _, note = line[28:].partition("  closer: ")
            values = numbers.split()
            if len(values) != 2 * len(libraries):
                raise ValueError(f"a line of build/accuracy has other columns: {line}")
            rows.append((line[:28].strip(), values, note))
    notes = [f"<li>{html.escape(name)}: closer: {html.escape(note)}</li>" for name, _, note in rows if note]
    first = "".join(f'<th scope="colgroup" colspan="2">{html.escape(name)}</th>' for name in libraries)
    second = '<th scope="col">largest</th><th scope="col">mean</th>' * len(libraries)
    body = "".join(f'<tr><th scope="row">{html.escape(name)}</th>' + "".join(f"<td>{value}</td>" for value in values) +
                   "</tr>\n" for name, values, _ in rows)
    caption = "Errors of functions, in units of 2<sup>-24</sup> of the quantity in which the bound is stated"
    table = markdown.scrolled(f"""<table class="numbers"><caption>{caption}</caption>
<thead><tr><th scope="col" rowspan="2" class="text">function</th>{first}</tr><tr>{second}</tr></thead>
<tbody>{body}</tbody></table>""", caption)
    skipped = "".join(f"<p class=\"quiet\">{html.escape(line)}</p>" for line in lines if line.startswith("skipped: "))
    return f"""<h3>Functions</h3>
<p>{html.escape(lines[-1])}: <code>{html.escape(lines[0])}</code>. Each library gets the same inputs; results are
compared with long double. For scalar functions the unit is one unit in the last place, so 0.5 is the least that is
possible. A dash: the library has no such function.</p>{skipped}
{table}
{'<p>Where another library is closer, and what in Gnomon&#39;s contract is the reason:</p><ul>' + ''.join(notes) + '</ul>' if notes else ''}"""


def lookups(found):
    """The table of build/texture-accuracy, which is Markdown."""
    lines = found["textures"].splitlines()
    text = markdown.convert(lines[1:-1], "Errors of lookups in textures against long double; channels are from 0 to 1")
    return f"<h3>Lookups in textures</h3>\n<p>{html.escape(lines[-1])}: <code>{html.escape(lines[0])}</code></p>\n{text}"


def accuracy(found):
    parts = [functions(found), lookups(found)]
    for document, name, heading in (("rules", "reference/RULES.md", "### Errors of lookups"),
                                    ("rules", "reference/RULES.md", "### Anisotropic filtering"),
                                    ("rules", "reference/RULES.md", "## Exact oracles"),
                                    ("readme", "README.md", "## An llvmpipe that is not pinned")):
        title = heading.lstrip("# ")
        parts.append(f"<h3>{title}</h3>\n<p class=\"quiet\">As measured and written down in <code>{name}</code>.</p>\n" +
                     markdown.convert(markdown.section(found[document], heading), title))
    return '<h2 id="accuracy">Accuracy</h2>\n' + "\n".join(parts)


def states(found):
    title = '<h2 id="states">Speed in every state</h2>\n'
    if not found["states"]:
        return title + """<p>The speed in every state was not measured for this report. <code>make bench-states</code>
measures it beside llvmpipe's, which takes 5 to 10 minutes; <code>make report</code> then shows the picture here.
<code>make report STATES=yes</code> measures one frame of each state first, in one to four minutes and less exactly.</p>"""
    results = json.loads(found["states"]["json"])
    backends = sorted({result["backend"] for result in results},
                      key=[values["name"] for values in found["backend"]].index)
    groups = list(dict.fromkeys(result["group"] for result in results))

    def mean(chosen):
        ratios = [math.log(result["ratio"]) for result in chosen if result["ratio"] > 0]
        return f"{math.exp(sum(ratios) / len(ratios)):.2f}" if ratios else "-"

    rows = [[group, str(len({result["row"] for result in results if result["group"] == group})),
             *(mean([result for result in results if result["group"] == group and result["backend"] == backend])
               for backend in backends)] for group in groups]
    rows.append(["all, without fixed", str(len({result["row"] for result in results if result["group"] != "fixed"})),
                 *(mean([result for result in results if result["group"] != "fixed" and result["backend"] == backend])
                   for backend in backends)])
    svg = found["states"]["svg"]
    svg = svg[svg.index("<svg"):].replace(' xmlns="http://www.w3.org/2000/svg"', ' role="img"', 1)
    differing = sum(result.get("differing") or 0 for result in results)
    return title + f"""<p>Each row is one state, drawn by Gnomon and by llvmpipe with the same formats, samples and
state, in one thread. Ratios are llvmpipe's time divided by Gnomon's: above 1, Gnomon is faster. llvmpipe uses the
processor's own instruction set. Measured on {found['states']['date']}, the date of the file of results.
{difference(differing)} from the pinned reference, beyond what <code>build/bench-states --help</code> allows.</p>
{markdown.table(["group of states", "rows", *backends], rows, "Geometric means of the ratios, by back end")}
<div class="states">{markdown.scrolled(svg, "Picture: the ratio of every state")}</div>"""


def page(found):
    """The whole page."""
    style = pathlib.Path(__file__).with_name("style.css").read_text(encoding="utf-8")
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Gnomon: the report</title>
<link rel="icon" href="data:,">
<style>
{style}</style>
</head>
<body>
<header>
{head(found)}
</header>
<main>
{pixels(found)}
{claims(found)}
{accuracy(found)}
{states(found)}
</main>
</body>
</html>
"""
