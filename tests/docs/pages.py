"""Checks the pages of a documentation site: the title of a document's page is the document's heading; the menu
marks one page, the one that is read; long pages have contents, of all their headings; the search knows every
document, each of its headings, and every name of the library. Prints what is wrong.
usage: pages.py FOLDER   (from the root of the project)"""

import html
import json
import pathlib
import re
import sys

LONG = 100  # lines

folder = pathlib.Path(sys.argv[1])
index = json.loads((folder / "search_index.js").read_text(encoding="utf-8").partition(" = ")[2].rstrip(";\n"))
known = {address for _, _, address, _ in index["pages"]}
menu = re.findall(r'<a href="([^"]+)"', (folder / "index.html").read_text(encoding="utf-8").partition("<main>")[0])
documents = [pathlib.Path("README.md"), *pathlib.Path("tools/guide").glob("*.md"), *pathlib.Path("tools/examples").glob("*.md"),
             pathlib.Path("reference/RULES.md")]


def faults(document):
    text = document.read_text(encoding="utf-8")
    name = "index.html" if str(document) == "README.md" else re.sub(r"\W", "_", str(document.with_suffix(""))) + ".html"
    head, _, main = (folder / name).read_text(encoding="utf-8").partition("<main>")
    heading = re.match("# (.*)", text)[1].replace("`", "")
    titles = [html.unescape(re.search(pattern, part)[1]) for part, pattern in
              ((head, "<title>(.*)</title>"), (main, '<div class="title">(.*)</div>'))]
    if titles != [heading, heading]:
        yield f"{name}: titles {titles}, not {heading}"
    marked = re.findall(r'<a href="([^"]+)" aria-current="page"', head)
    if marked != [name for place in menu if place == name]:
        yield f"{name}: menu marks {marked}"
    anchors = re.findall(r'<h[23] id="([^"]+)"', main)
    listed = re.search(r'<nav class="contents".*?</nav>', main, re.S)
    linked = re.findall(r'href="#([^"]+)"', listed[0]) if listed else []
    if linked != (anchors if text.count("\n") > LONG else []):
        yield f"{name}: contents {linked}, not {anchors}"
    if absent := {name, *(f"{name}#{anchor}" for anchor in anchors)} - known:
        yield f"{name}: search lacks {sorted(absent)}"


print("\n".join(fault for document in documents for fault in faults(document)), end="")
names = {name for name, _, _ in index["names"]}
functions = set(re.findall(r"^GN_API .*?\b(gn_\w+)\(", "".join(
    path.read_text(encoding="utf-8") for path in pathlib.Path("include/gnomon").glob("*.h")), re.M))
if not len(functions) > 200 or functions - names:
    print("search lacks", sorted(functions - names), len(functions))
