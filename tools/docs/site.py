#!/usr/bin/env python3
"""Writes the documentation as one site of plain HTML that opens from disk: BUILD/docs/html/index.html. It has
the guide, the lessons, the documents and the reference of the public headers. Doxygen makes the reference;
render.py turns documents into HTML, which gets the head and the menu of Doxygen's pages. A source text that a
document links to is a page too. Whatever Doxygen warns of is an error.
usage: site.py BUILD-DIRECTORY   (from the root of the project)"""

import html
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree

import render

SECTIONS = {"Guide": "tools/guide", "Lessons": "tools/examples"}
MORE = ["tools/python/README.md", "tools/firmware/README.md", "tools/gnomon/TRANSFORM.md", "reference/RULES.md", "VERIFICATION.md", "tests/README.md",
        "CONTRIBUTING.md", "CHANGELOG.md"]
LONG = 100  # lines of a document from which on its page has contents
# Where names of the library become no links: in links, in titles, where they are declared, in tags.
UNLINKED = r'<(a|h1|h2|script)\b.*?</\1>|<div class="title">.*?</div>|<td class="(?:memname|fieldname)".*?</td>|<[^>]*>'
NAME = r"(?<![\w./])(?:(?:include/)?gnomon/)?\w+(?:\.h\b)?"


def read(path):
    return pathlib.Path(path).read_text(encoding="utf-8")


def page_name(path):
    """The name of a file's page, without .html: its path; of a header, Doxygen's."""
    if path.startswith("include/"):
        return os.path.basename(path).replace("_", "__").replace(".", "_8")
    return "index" if path == "README.md" else re.sub(r"\W", "_", path.removesuffix(".md"))


def sections(tokens):
    """The sections of a document, as pairs of a heading's tokens (None: what stands before the first) and its
    text. Only headings of the second and third level begin one."""
    result = [(None, [])]
    for block in render.blocks(tokens):
        if block[0].type == "heading_open" and block[0].tag in ("h2", "h3"):
            result.append((block, []))
        else:
            result[-1][1].extend(render.words(token) if token.children else token.content for token in block)
    return [(heading, re.sub(r"\s+", " ", " ".join(text)).strip()) for heading, text in result]


def contents(found):
    """The list of the sections of a page."""
    items = "".join(f'<li class="{heading[0].tag}"><a href="#{heading[0].attrGet("id")}">'
                    f"{html.escape(render.words(heading[1]), quote=False)}</a></li>\n" for heading, _ in found if heading)
    return f'<nav class="contents" aria-label="Contents of this page"><ul>\n{items}</ul></nav>\n'


def read_document(document, documents, pictures, sources, faults):
    """Returns the title of a document, its page's HTML, and what the search knows of it. Adds the pictures that
    it shows, the source texts that it links to, and its links that lead nowhere."""
    def link(target, line):
        address, _, anchor = target.partition("#")
        path = os.path.normpath(os.path.join(os.path.dirname(document), address)) if address else document
        if re.match(r"[a-z]+:", target):
            return target
        if os.path.isdir(path):
            path += "/README.md"
            if path not in documents:
                return None  # a folder without a page
        if path.endswith((".png", ".svg")):
            pictures.add(path)
            return os.path.basename(path)
        if not os.path.isfile(path) or path.endswith(".md") and path not in documents:
            faults.append(f"{document}:{line}: {target} is no page of the site")
        elif not path.endswith(".md") and not path.startswith("include/"):
            sources.add(path)
        return f"{page_name(path)}.html" + (anchor and "#" + anchor)

    text = read(document)
    tokens = render.parse(text, link)
    title = render.words(tokens[1])
    found = sections(tokens[3:])
    body = (contents(found) if text.count("\n") > LONG else "") + render.html(tokens[3:])
    address = f"{page_name(document)}.html"
    index = [[title, "", address, found[0][1]]]
    index += [[title, render.words(heading[1]), f'{address}#{heading[0].attrGet("id")}', said] for heading, said in found[1:]]
    return title, body, index


def write_page(output, path, title, body):
    """Writes a page with the head and the menu that Doxygen's pages have."""
    title = html.escape(title, quote=False)
    head = read(output / "header.html").replace("$title", title).replace("$relpath^", "")
    (output / f"html/{page_name(path)}.html").write_text(
        f'{head}</div>\n<div class="title">{title}</div>\n<div class="textblock">\n{body}</div>\n'
        f'{read("tools/docs/footer.html")}', encoding="utf-8")


def menu(parts, titles):
    def entries(pages):
        return "".join(f'<li><a href="{name}.html">{words}</a></li>\n' for name, words in pages)

    def section(title, pages):
        return f"<details open><summary>{title}</summary><ul>\n{entries(pages)}</ul></details>\n"

    def documents(paths):
        return [(page_name(path), html.escape(titles[path], quote=False)) for path in paths]

    headers = re.findall(r"^ \*     ([a-z_]+\.h) +(.*)$", read("include/gnomon.h"), re.M)
    return "".join([
        '<a class="home" href="index.html">Gnomon</a>\n',
        *(section(title, [(page_name(first), "Contents"), *documents(rest)]) for title, (first, *rest) in parts.items()),
        section("Reference", [
            ("gnomon_8h", "gnomon.h: all headers"),
            *((page_name(f"include/{name}"), f"<code>{name}</code> {html.escape(about)}") for name, about in headers),
            ("globals_func", "All functions"), ("annotated", "All structs"), ("globals", "All names")]),
        section("More", documents(MORE))])


def names(output):
    """The names of the library, from Doxygen's list: name, what it is, page and anchor. Doxygen takes words in
    small letters for no names."""
    for compound in xml.etree.ElementTree.parse(output / "names.xml").findall("compound"):
        name, page = compound.findtext("name"), compound.findtext("filename")
        if compound.get("kind") in ("struct", "file"):
            yield name, compound.get("kind"), page if page.endswith(".html") else f"{page}.html"
            for member in compound.findall("member"):
                kind = {"variable": "member"}.get(member.get("kind"), member.get("kind"))
                yield (member.findtext("name"), f"{kind} of {name}" if kind == "member" else f"{kind} in {name}",
                       f"{member.findtext('anchorfile')}#{member.findtext('anchor')}")


def menu_page(page):
    """The page of the menu that a page of the reference belongs to; the page itself if it is there."""
    for pattern, place in (("struct.*", "annotated.html"), ("(.*_8h)_source.html", r"\1.html"), ("(globals_func|globals)_.*", r"\1.html")):
        if re.fullmatch(pattern, page) and page != "globals_func.html":
            return re.sub(pattern, place, page)
    return page


def finish_pages(output, places):
    """Makes the library's names links to the reference, in every page, and marks the page in the menu."""
    def linked(found):
        name = found[0].rpartition("/")[2]
        known = re.fullmatch(r"(gn|GN)_\w+|\w+\.h", name) and places.get(name)
        return f'<a class="el" href="{known}">{found[0]}</a>' if known else found[0]

    for path in output.glob("html/*.html"):
        head, start, main = read(path).partition("<main>")
        here = f'<a href="{menu_page(path.name)}"'
        head = head.replace(here, f'{here} aria-current="page"')
        if not path.name.endswith("_source.html"):
            main = re.sub(f"{UNLINKED}|{NAME}", linked, main, flags=re.S)
        path.write_text(head + start + main, encoding="utf-8")


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    if not shutil.which("doxygen"):
        sys.exit("docs: Doxygen is absent: 'make setup' installs it")
    output = pathlib.Path(sys.argv[1], "docs")
    shutil.rmtree(output, ignore_errors=True)
    output.mkdir(parents=True)
    # In the order in which the contents of a folder link to its documents.
    parts = {title: [f"{folder}/README.md", *(f"{folder}/{name}" for name in dict.fromkeys(
        re.findall(r"\]\(([a-z0-9_-]+\.md)\)", read(f"{folder}/README.md"))))] for title, folder in SECTIONS.items()}
    documents = ["README.md", *sum(parts.values(), []), *MORE]
    pictures, sources, faults = set(), set(), []
    pages = {path: read_document(path, documents, pictures, sources, faults) for path in documents}
    if faults:
        sys.exit("\n".join(faults))
    titles = {path: title for path, (title, _, _) in pages.items()}
    (output / "header.html").write_text(read("tools/docs/header.html").replace("@MENU@\n", menu(parts, titles)), encoding="utf-8")
    said = subprocess.run(["doxygen", "tools/docs/Doxyfile"], env={**os.environ, "GN_DOCS": str(output)}, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if said.returncode or said.stdout:
        sys.exit(f"{said.stdout}docs: Doxygen is not content")
    for path, (title, body, _) in pages.items():
        write_page(output, path, title, body)
    for path in sorted(sources):
        write_page(output, path, path, f"<pre>{render.source(read(path), path.rpartition('.')[2].replace('h', 'c'))}</pre>")
    for file in [*pictures, "tools/docs/search.js", "tools/docs/site.js"]:
        shutil.copy(file, output / "html")
    found = list(names(output))
    finish_pages(output, {name: place for name, _, place in found})
    index = {"pages": sum((entries for _, _, entries in pages.values()), []), "names": found}
    # A script and not JSON: a page that is opened from disk may not fetch a file.
    (output / "html/search_index.js").write_text(f"globalThis.searchIndex = {json.dumps(index, ensure_ascii=False)};\n", encoding="utf-8")
    print(output / "html/index.html")


if __name__ == "__main__":
    main()
