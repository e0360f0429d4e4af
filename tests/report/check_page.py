"""Checks the page of `make report`, and reads its numbers.
usage: check_page.py PAGE form                     well-formed, self-contained, named, with captions
       check_page.py PAGE classes                  prints the table of classes, as build/parity does
       check_page.py PAGE pictures                 prints of each picture: class, number, pixels in
                                                   which the first two parts differ, pixels of the
                                                   third part that are not black
       check_page.py PAGE accuracy                 prints the table of functions, without spaces
       check_page.py PAGE claims CLAIMS TEXT RECORDS...
                                                   figures, dates and stars of all claims are those
                                                   of the last records; TEXT is the library's hash
Exit status 1 if something is wrong."""

import base64
import html.parser
import re
import struct
import sys
import zlib

VOID = {"meta", "link", "img", "br", "hr", "input"}
LOADED = {"src", "srcset", "data", "poster", "action"}


class Page(html.parser.HTMLParser):
    """The elements of a page, and what is wrong with it."""

    def __init__(self, text):
        super().__init__()
        self.open, self.faults, self.ids, self.links, self.images, self.levels = [], [], [], [], [], []
        self.tables, self.row, self.cell, self.captions, self.figure = [], None, None, [], None
        self.feed(text)
        self.close()
        for tag in self.open:
            self.fault(f"<{tag}> is not closed")
        for name in set(self.ids):
            if self.ids.count(name) > 1:
                self.fault(f"two elements have the id {name}")
        for link in self.links:
            if link.startswith("#") and link[1:] not in self.ids:
                self.fault(f"{link} leads nowhere")
            elif not link.startswith(("#", "data:")):
                self.fault(f"{link} is another file")

    def fault(self, what):
        self.faults.append(f"line {self.getpos()[0]}: {what}")

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if tag not in VOID:
            self.open.append(tag)
        self.ids += [attributes["id"]] if "id" in attributes else []
        for name, value in attributes.items():
            if name in LOADED and not value.startswith("data:"):
                self.fault(f"loads {value}")
            if name.startswith("on"):
                self.fault(f"<{tag}> has a script: {name}")
            if name == "href":
                self.links.append(value)
            if re.search(r"https?:|//", value or "") and not value.startswith("data:"):
                self.fault(f"<{tag} {name}> names an address: {value}")
        if tag in ("script", "iframe", "object", "embed", "base"):
            self.fault(f"<{tag}>")
        if tag == "img":
            if not attributes.get("alt"):
                self.fault("a picture without a text")
            self.images.append((attributes.get("alt", ""), attributes.get("src", "")))
        if re.fullmatch("h[1-6]", tag):
            if int(tag[1]) > (self.levels[-1] if self.levels else 0) + 1:
                self.fault(f"<{tag}> leaves out a level")
            self.levels.append(int(tag[1]))
        if tag == "table":
            self.tables.append({"caption": "", "rows": []})
        if tag == "tr" and self.tables:
            self.row = []
        if tag in ("td", "th") and self.row is not None or tag == "caption":
            self.cell = ""

    def handle_startendtag(self, tag, attributes):
        self.handle_starttag(tag, attributes)
        if tag not in VOID:
            self.handle_endtag(tag)

    def handle_endtag(self, tag):
        if not self.open or self.open[-1] != tag:
            self.fault(f"</{tag}> does not close {self.open[-1:]}")
            return
        self.open.pop()
        if tag == "caption":
            self.tables[-1]["caption"] = self.cell.strip()
        if tag in ("td", "th") and self.row is not None:
            self.row.append(" ".join(self.cell.split()))
        if tag == "tr" and self.row is not None:
            self.tables[-1]["rows"].append(self.row)
            self.row = None
        if tag == "table" and not self.tables[-1]["caption"]:
            self.fault("a table without a caption")

    def handle_data(self, data):
        if self.cell is not None:
            self.cell += data
        if self.open and self.open[-1] == "style":
            for found in re.findall(r"@import|url\([^)]*\)", data):
                self.fault(f"the style loads {found}")

    def table(self, caption):
        found = [table for table in self.tables if table["caption"].startswith(caption)]
        if len(found) != 1:
            sys.exit(f"{len(found)} tables '{caption}'")
        return found[0]["rows"]


def pixels(png):
    """Width, height and rows of a PNG of 8-bit RGBA."""
    assert png[:8] == b"\x89PNG\r\n\x1a\n"
    at, data = 8, b""
    while at < len(png):
        length, kind = struct.unpack(">I4s", png[at:at + 8])
        chunk = png[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, color = struct.unpack(">IIBB", chunk[:10])
            assert (depth, color) == (8, 6)
        data += chunk if kind == b"IDAT" else b""
        at += length + 12
    data, size = zlib.decompress(data), 4 * width
    rows, last = [], bytearray(size)
    for y in range(height):
        way, row = data[y * (size + 1)], bytearray(data[y * (size + 1) + 1:(y + 1) * (size + 1)])
        for x in range(size):
            left, up, corner = (row[x - 4], last[x], last[x - 4]) if x >= 4 else (0, last[x], 0)
            guess = left + up - corner
            paeth = min((left, up, corner), key=lambda value, guess=guess: abs(guess - value))
            row[x] = row[x] + (0, left, up, (left + up) // 2, paeth)[way] & 255
        rows.append(row)
        last = row
    return width, height, rows


def print_pictures(page):
    for alt, source in page.images:
        named = re.match(r"Scene (\d+) of the class ([a-z-]+),", alt)
        width, _, rows = pixels(base64.b64decode(source.partition("base64,")[2]))
        part = (width - 2 * 4) // 3
        first, second, third = ([[bytes(row[4 * x:4 * x + 4]) for x in range(i * (part + 4), i * (part + 4) + part)]
                                 for row in rows] for i in range(3))
        differ = sum(a != b for p, q in zip(first, second) for a, b in zip(p, q))
        lit = sum(pixel != b"\x00\x00\x00\xff" for row in third for pixel in row)
        print(named[2], named[1], differ, lit)


def check_claims(page, claims, text, records):
    """Reads the claims and the records by itself, and compares."""
    last = {}
    for name in records:
        with open(name, encoding="utf-8") as file:
            for line in file:
                fields = line.rstrip("\n").split("\t")
                last[fields[0]] = fields
    with open(claims, encoding="utf-8") as file:
        runs = re.findall(r"^run: (.*)$", file.read(), re.M)
    rows = [row for table in page.tables if table["caption"].startswith("Claims") for row in table["rows"][1:]]
    faults = [] if len(rows) == len(runs) else [f"{len(rows)} claims on the page, not {len(runs)}"]
    for run, row in zip(runs, rows):
        step = re.fullmatch("test / (.*)", run)
        command = f"make test, step {step[1]}" if step else f"make {run}"
        record = last.get(f"test/{step[1]}" if step else f"make {run}")
        figures, when = "not run yet", ""
        if record:
            figures = ("" if record[5] == "held" else "FAILED: ") + " ".join(record[6].split())
            when = rf"{record[1]} [A-Z]{re.escape('' if record[4] == text else '*')}"
        figures = figures.replace("**", "").replace("`", "")
        if row[2] != command or row[3] != figures or not re.fullmatch(when, row[4]):
            faults.append(f"{command}: {row[2:]}, not {figures}, {when}")
    print(f"{len(runs)} claims, {len(last)} records")
    return faults


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    with open(sys.argv[1], encoding="utf-8") as file:
        page = Page(file.read())
    faults = []
    if sys.argv[2] == "form":
        faults = page.faults
    elif sys.argv[2] == "classes":
        for name, _, *numbers in page.table("Scenes of every class")[1:]:
            print(name, *(number.replace(",", "") for number in numbers))
    elif sys.argv[2] == "pictures":
        print_pictures(page)
    elif sys.argv[2] == "accuracy":
        for row in page.table("Errors of functions")[2:]:
            print("".join(row).replace(" ", ""))
    elif sys.argv[2] == "claims":
        faults = check_claims(page, sys.argv[3], sys.argv[4], sys.argv[5:])
    else:
        sys.exit(__doc__)
    for fault in faults:
        print(fault)
    return 1 if faults else 0


sys.exit(main())
