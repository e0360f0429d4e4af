"""HTML of the part of Markdown that the project's documents use: headings, paragraphs, lists, tables,
code, bold text. Links become their text, since the report stands alone."""

import html
import re


def inline(text):
    """HTML of a line of text."""
    parts = re.split(r"`([^`]*)`", text)
    for i, part in enumerate(parts):
        part = html.escape(part.replace("\\|", "|") if i % 2 else part, quote=False)
        if i % 2:
            parts[i] = f"<code>{part}</code>"
            continue
        part = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", part)
        part = re.sub(r"\*\*([^*]+)\*\*", r"<strong>\1</strong>", part)
        parts[i] = re.sub(r"\\([\\*|_`])", r"\1", part)
    return "".join(parts)


def cells(line):
    """The cells of a line of a table."""
    return [cell.strip() for cell in re.split(r"(?<!\\)\|", line.strip())[1:-1]]


def table(head, rows, caption, kind="numbers"):
    """A table: cells are HTML. One of kind `words` is stacked on narrow screens; another scrolls. The
    roles keep it a table for screen readers where the style makes blocks of rows."""
    first = "".join(f'<th scope="col" role="columnheader">{cell}</th>' for cell in head)
    body = []
    for row in rows:
        labelled = [f'<td role="cell" data-label="{html.escape(re.sub("<[^>]*>", "", name))}">{cell}</td>'
                    for name, cell in zip(head[1:], row[1:])]
        body.append(f'<tr role="row"><th scope="row" role="rowheader">{row[0]}</th>{"".join(labelled)}</tr>')
    text = (f'<table class="{kind}" role="table"><caption>{caption}</caption>\n'
            f'<thead role="rowgroup"><tr role="row">{first}</tr></thead>\n'
            f'<tbody role="rowgroup">\n' + "\n".join(body) + "\n</tbody></table>")
    return text if kind == "words" else scrolled(text, caption)


def scrolled(text, caption):
    """A part that scrolls sideways if the screen is narrower; the keyboard reaches it."""
    label = html.escape(re.sub("<[^>]*>", "", caption))
    return f'<div class="wide" role="region" tabindex="0" aria-label="{label}">{text}</div>'


def section(text, heading):
    """The lines of a document below a heading, up to the next heading of its level or of one above."""
    level = len(heading) - len(heading.lstrip("#"))
    lines = text.splitlines()
    if heading not in lines:
        raise ValueError(f"no heading '{heading}'")
    start = lines.index(heading) + 1
    for end in range(start, len(lines)):
        if re.match(f"#{{1,{level}}} ", lines[end]):
            return lines[start:end]
    return lines[start:]


def blocks(lines):
    """Splits lines into blocks: tables, headings, items of lists, paragraphs."""
    found = []
    for line in lines:
        kind = ("empty" if not line.strip() else "table" if line.startswith("|") else
                "heading" if line.startswith("#") else "item" if re.match(r"(-|\d+\.) ", line) else "text")
        if kind == "text" and found and found[-1][0] in ("text", "item"):
            found[-1][1].append(line.strip())
        elif kind == "table" and found and found[-1][0] == "table":
            found[-1][1].append(line)
        else:
            found.append((kind, [line.strip()]))
    return [block for block in found if block[0] != "empty"]


def convert(lines, caption, kind="numbers", shift=1):
    """HTML of lines. A table's caption is the caption given, with the last heading of the lines;
    headings go down by `shift` levels."""
    made, listed, below = [], None, ""
    for what, content in blocks(lines):
        mark = None
        if what == "item":
            mark = "ul" if content[0].startswith("-") else "ol"
        if listed and listed != mark:
            made.append(f"</{listed}>")
        if mark and listed != mark:
            made.append(f"<{mark}>")
        listed = mark
        if what == "heading":
            level = len(content[0].split()[0])
            below = inline(content[0][level:].strip())
            made.append(f"<h{level + shift}>{below}</h{level + shift}>")
        elif what == "table":
            head, rows = cells(content[0]), [cells(line) for line in content[2:]]
            made.append(table([inline(cell) for cell in head],
                              [[inline(cell) for cell in row] for row in rows],
                              f"{caption}: {below}" if below else caption, kind))
        elif what == "item":
            made.append(f"<li>{inline(re.sub(r'^(-|[0-9]+[.]) ', '', ' '.join(content)))}</li>")
        else:
            made.append(f"<p>{inline(' '.join(content))}</p>")
    if listed:
        made.append(f"</{listed}>")
    return "\n".join(made)
