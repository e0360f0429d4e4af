#!/usr/bin/env python3
"""Adds up what llvm-cov shows of several builds: `llvm-cov show -show-branches=count -show-mcdc
-show-instantiations=false`, one file for each build. A line, a way of a branch or a condition is reached if one
build reaches it in one copy of its function.
usage: merge.py LIST SHOWN...   (from the root of the project)
LIST names the functions that are not wholly reached, with the reason (unreached.txt).
Prints unreached places without a reason, a table of the folders of src/, and the line of figures."""

import os
import re
import sys

KINDS = ("line", "branch", "condition")


def reasons_of(path):
    """The functions of the list, as pairs of file and function, with their reasons."""
    reasons = {}
    entry = None
    for text in open(path, encoding="utf-8"):
        if text.startswith("    "):
            reasons[entry] = reasons[entry] or text.strip()
        elif text.strip() and not text.startswith("#"):
            entry = tuple(text.split())
            reasons[entry] = ""
    return reasons


def source_of(path):
    """Each line's text and function. The layout (.clang-format) shows where a function begins."""
    lines = [("", "-")]
    name = "-"
    for text in open(path, encoding="utf-8"):
        text = text.rstrip("\n")
        if re.match(r"[A-Za-z_].*\w\(", text) and not text.endswith(";"):
            name = re.match(r"[^(]*?(\w+)\(", text).group(1)
        elif re.match(r"GN_[A-Z_]+ .*[a-z0-9_]$", text) or re.match(r"static [^(]*[^;(]$", text):
            name = "-"
        lines.append((text.strip(), name))
    return lines


def is_measured(path):
    # Lanes in the vectors of a processor are no part of the plain form.
    return path.startswith("src/") and not re.match(r"src/lanes/(lanes_)?registers", path)


def read_shown(path, places):
    """Adds the places of one build: places[kind, file, line, detail] says whether it is reached."""

    def add(kind, line, detail, reached):
        key = (kind, file, int(line), detail)
        places[key] = places.get(key, False) or reached

    file = None
    for text in open(path, encoding="utf-8", errors="replace"):
        if re.match(r"/.*:$", text):
            file = os.path.relpath(text.rstrip()[:-1])
            continue
        if file is None or not is_measured(file):
            continue
        # llvm-cov counts empty lines in some regions.
        if found := re.match(r" *(\d+)\| *([\d.]+)[kMGTPE]?\| *\S", text):
            add("line", found[1], "", float(found[2]) > 0)
        elif found := re.match(r" *\| *Branch \((\d+)(:\d+)\): \[(True: .*)\]", text):
            for way, count in re.findall(r"(True|False): ([^,\]]*)", found[3]):
                if not count.startswith("Folded"):
                    reached = float(re.match(r"[\d.]+", count)[0]) > 0
                    add("branch", found[1], f"{found[2]} is never {way.lower()}", reached)
        elif found := re.search(r"MC/DC Decision Region (\((\d+):.*)", text):
            line, region = found[2], found[1]
        elif (found := re.search(r"C(\d+)-Pair: (.*)", text)) and "constant folded" not in text:
            add("condition", line, (region, found[1]), found[2].startswith("covered"))


def share(counts):
    """A percentage, rounded down, so that 100 means all."""
    good, every = counts
    return int(1000 * good / every) / 10 if every else 100.0


def main(list_path, *shown):
    reasons = reasons_of(list_path)
    places = {}
    for path in shown:
        read_shown(path, places)
    sources = {file: source_of(file) for file in {key[1] for key in places}}
    table = {}
    used = set()
    named = unnamed = 0
    for (kind, file, line, detail), reached in places.items():
        for folder in (file.split("/")[1], "total"):
            counts = table.setdefault(folder, {each: [0, 0] for each in KINDS})[kind]
            counts[0] += reached
            counts[1] += 1
        # A branch on a line that is not reached is no place of its own.
        if reached or kind == "condition" or kind == "branch" and places.get(("line", file, line, "")) is False:
            continue
        text, function = sources[file][line]
        if (file, function) in reasons:
            used.add((file, function))
            named += 1
            continue
        unnamed += 1
        what = detail or " is not reached"
        print(f"{file}:{line}{what}: {function}: no reason in unreached.txt\n    {text}")
    stale = [entry for entry in reasons if entry not in used]
    for entry in stale:
        print(f"unreached.txt: {entry[0]} {entry[1]}: wholly reached")
    print(f"{'src/':<12} {'lines':>15} {'branches':>15} {'MC/DC':>15}")
    table["total"] = table.pop("total")
    for folder, counts in table.items():
        print(f"{folder:<12} " + " ".join(f"{counts[kind][1]:6} {share(counts[kind]):6} %" for kind in KINDS))
    lines, branches, conditions = (share(table["total"][kind]) for kind in KINDS)
    rest = f"{unnamed} without a reason" if unnamed else "each with its reason"
    print(f"coverage: lines {lines} %, branches {branches} %, MC/DC {conditions} %, "
          f"{named + unnamed} places unreached, {rest}")
    return lines < 99 or branches < 95 or unnamed > 0 or bool(stale)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
