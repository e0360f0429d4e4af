"""Checks a site of HTML pages that is opened from disk: every relative link leads to a file that exists, and to
an anchor that the page has; nothing is loaded from a network.
usage: links.py FOLDER"""

import html.parser
import pathlib
import re
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    """The links and the anchors of a page."""

    def __init__(self, path):
        super().__init__()
        self.anchors = set()
        self.links = []  # (tag, target, line)
        self.feed(path.read_text(encoding="utf-8", errors="replace"))

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("id", "name") and tag != "meta":
                self.anchors.add(value)
            if name in ("href", "src", "data") and value:
                self.links.append((tag, value, self.getpos()[0]))


def fault(pages, path, tag, target):
    """What is wrong with a link; None if nothing is."""
    parts = urllib.parse.urlsplit(target)
    if parts.scheme in ("http", "https") or parts.netloc:
        return None if tag == "a" else "loaded from a network"
    if parts.scheme in ("javascript", "data", "mailto"):
        return None
    file = (path.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else path
    if not file.is_file():
        return "no such file"
    if parts.fragment and file in pages and urllib.parse.unquote(parts.fragment) not in pages[file].anchors:
        return "no such anchor"
    return None


folder = pathlib.Path(sys.argv[1]).resolve()
site = {file: Page(file) for file in sorted(folder.rglob("*.html"))}
faults = [f"{file.relative_to(folder)}:{line}: {target}: {fault(site, file, tag, target)}"
          for file, page in site.items() for tag, target, line in page.links if fault(site, file, tag, target)]
faults += [f"{file.name}: loads {found}" for file in folder.glob("*.css")
           for found in re.findall(r"(?:url\(|@import)[ \"']*https?:[^)\"']*", file.read_text(encoding="utf-8"))]
print("\n".join([*faults, f"links: {len(site)} pages, {len(faults)} faults"]))
sys.exit(len(site) < 100 or len(faults) > 0)
