"""Checks a site of HTML pages that is opened from disk: every relative link leads to a file that
exists, and to an anchor that the page has; nothing is loaded from a network.
usage: links.py FOLDER [NAME...]    every NAME must have an entry of its own in a page of a header
"""

import html.parser
import pathlib
import re
import sys
import urllib.parse

LOADED = {"img", "script", "link", "iframe", "source", "object", "embed", "video", "audio"}


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


def faults(folder):
    """Yields one line for each fault of the site's links."""
    pages = {path: Page(path) for path in sorted(folder.rglob("*.html"))}
    for path, page in pages.items():
        for tag, target, line in page.links:
            where = f"{path.relative_to(folder)}:{line}: {target}"
            parts = urllib.parse.urlsplit(target)
            if parts.scheme in ("http", "https") or parts.netloc:
                if tag in LOADED:
                    yield f"{where}: loaded from a network"
                continue
            if parts.scheme in ("javascript", "data", "mailto"):
                continue
            file = path.parent / urllib.parse.unquote(parts.path) if parts.path else path
            file = pathlib.Path(file).resolve()
            if not file.is_file():
                yield f"{where}: no such file"
            elif parts.fragment and file in pages and urllib.parse.unquote(parts.fragment) not in pages[file].anchors:
                yield f"{where}: no such anchor"
    if not pages:
        yield "no pages"
    yield from (f"{path.name}: loads {found}" for path in sorted(folder.glob("*.css"))
                for found in re.findall(r"(?:url\(|@import)[ \"']*https?:[^)\"']*", path.read_text()))


def entries(folder):
    """The names that have an entry, with text, in a page of a header."""
    found = set()
    for path in folder.glob("*_8h.html"):
        text = path.read_text(encoding="utf-8")
        for part in text.split('<h2 class="memtitle">')[1:]:
            title = re.search(r"</a></span>([^<]*)</h2>", part)
            contract = re.search(r'<div class="memdoc">(.*?)</div>', part, re.S)
            if title and contract and re.sub(r"<[^>]*>|\s", "", contract[1]):
                found.add(title[1].rstrip("()"))
    return found


def main():
    folder = pathlib.Path(sys.argv[1]).resolve()
    have = entries(folder)
    lines = [f"{name}: has no entry" for name in sys.argv[2:] if name not in have] + list(faults(folder))
    print("\n".join(lines))
    print(f"links: {len(list(folder.rglob('*.html')))} pages, {len(have)} entries, {len(lines)} faults")
    return bool(lines)


if __name__ == "__main__":
    sys.exit(main())
