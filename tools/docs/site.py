#!/usr/bin/env python3
"""Writes the documentation as one site of plain HTML that opens from disk: BUILD/docs/html/index.html. It has
the guide, the lessons, the documents and the reference of the public headers. Doxygen makes it from the
headers and from pages that render.py has turned into HTML. A source text that a document links to is a page
too. Whatever Doxygen warns of is an error.
usage: site.py BUILD-DIRECTORY   (from the root of the project)"""

import html
import os
import pathlib
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree

import render

SECTIONS = {"Guide": "tools/guide", "Lessons": "tools/examples"}
MORE = ["tools/python/README.md", "tools/gnomon/TRANSFORM.md", "reference/RULES.md", "VERIFICATION.md", "tests/README.md",
        "CONTRIBUTING.md", "CHANGELOG.md"]
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


def write_page(output, path, title, body):
    """Writes a page for Doxygen, which gives it head and menu and makes its title known to the search. A
    number right before a full stop would begin a list; a character without width stands between."""
    name = page_name(path)
    command = "mainpage" if name == "index" else f"page {name}"
    title = re.sub(r"^([0-9]+)\.", "\\1\u2060.", title)
    (output / f"{name}.html").write_text(body, encoding="utf-8")
    with open(output / "pages.dox", "a", encoding="utf-8") as pages:
        pages.write(f"/** \\{command} {title}\n\\htmlinclude[block] {name}.html */\n")


def write_pages(output, documents):
    """Writes the pages of documents. Returns their titles and the pictures that they show."""
    titles, pictures, sources, faults = {}, set(), set(), []
    for document in documents:
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

        tokens = render.parse(read(document), link)
        titles[document] = render.words(tokens[1])
        write_page(output, document, titles[document], render.html(tokens[3:]))
    for path in sorted(sources):
        write_page(output, path, path, f"<pre>{render.source(read(path), path.rpartition('.')[2].replace('h', 'c'))}</pre>")
    if faults:
        sys.exit("\n".join(faults))
    return titles, pictures


def menu(parts, titles):
    def entries(pages):
        return "".join(f'<li><a href="{name}.html">{words}</a></li>\n' for name, words in pages)

    def section(title, pages):
        return f"<details open><summary>{title}</summary><ul>\n{entries(pages)}</ul></details>\n"

    def documents(paths):
        return [(page_name(path), html.escape(titles[path], quote=False)) for path in paths]

    headers = re.findall(r"^ \*     ([a-z_]+\.h) +(.*)$", read("include/gnomon.h"), re.M)
    return "".join([
        '<a href="index.html">Gnomon</a>\n',
        *(section(title, [(page_name(first), "Contents"), *documents(rest)]) for title, (first, *rest) in parts.items()),
        section("Reference", [
            ("gnomon_8h", "gnomon.h: all headers"),
            *((page_name(f"include/{name}"), f"<code>{name}</code> {html.escape(about)}") for name, about in headers),
            ("globals_func", "All functions"), ("annotated", "All structs"), ("globals", "All names")]),
        section("More", documents(MORE))])


def link_names(output):
    """Makes the library's names links to the reference, in every page. Doxygen takes words in small letters
    for no names."""
    places = {}
    for item in xml.etree.ElementTree.parse(output / "names.xml").iter():
        place = item.findtext("filename") or f"{item.findtext('anchorfile')}#{item.findtext('anchor')}"
        if item.tag == "member" or item.get("kind") in ("struct", "file"):
            places[item.findtext("name")] = place

    def linked(found):
        name = found[0].rpartition("/")[2]
        known = re.fullmatch(r"(gn|GN)_\w+|\w+\.h", name) and places.get(name)
        return f'<a class="el" href="{known}">{found[0]}</a>' if known else found[0]

    for path in output.glob("html/*.html"):
        head, start, main = read(path).partition("<main>")
        if not path.name.endswith("_source.html"):
            path.write_text(head + start + re.sub(f"{UNLINKED}|{NAME}", linked, main, flags=re.S), encoding="utf-8")


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
    titles, pictures = write_pages(output, ["README.md", *sum(parts.values(), []), *MORE])
    (output / "header.html").write_text(read("tools/docs/header.html").replace("@MENU@\n", menu(parts, titles)), encoding="utf-8")
    said = subprocess.run(["doxygen", "tools/docs/Doxyfile"], env={**os.environ, "GN_DOCS": str(output)}, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if said.returncode or said.stdout:
        sys.exit(f"{said.stdout}docs: Doxygen is not content")
    for picture in pictures:
        shutil.copy(picture, output / "html")
    link_names(output)
    print(output / "html/index.html")


if __name__ == "__main__":
    main()
