#!/usr/bin/env python3
"""Writes the report: one HTML page that needs no other file, with pictures of every class of parity
scenes, the figures of VERIFICATION.md, the tables of accuracy and the picture of the state matrix.

usage: report.py BUILD [OPTION...]   (from the root of the project; make report builds the programs)

  --output FILE    the page (BUILD/report.html); also copied to BUILD/web if that is there
  --seed S         seed of scenes and of inputs (1)
  --scenes N       scenes of each class that are compared (24)
  --shown K        scenes of each class whose pictures are shown (3)
  --class NAME     only this class; may be given several times
  --inputs N       inputs of each function whose error is measured (20000)
  --lookups N      lookups behind each error of textures (2000)
  --states FILE    results of build/bench-states --json (BUILD/bench-states.json, if it is there)
  --break          for tests: changes one pixel of Gnomon's first picture

The last line on stdout has the figures. Exit status: 0 if no pixel differs and every bound of
accuracy holds, 1 if not or if something is missing (then nothing is written), 2 for a wrong command
line."""

import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True  # no files in the folder of sources
import page  # noqa: E402


class Missing(Exception):
    """Why there can be no report, in one line; nothing, if a program has said it."""


def progress(text):
    print(f"report: {text}", file=sys.stderr, flush=True)


def run(command, accepted=(0,)):
    """What a program prints; raises Missing if it ends with another status than those accepted."""
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=False)
    except OSError as fault:
        raise Missing(f"{command[0]} cannot be run: {fault.strerror}; 'make report' builds it") from fault
    if done.returncode not in accepted:
        raise Missing(f"{' '.join(command)} failed with status {done.returncode}")
    return done.stdout, done.returncode


def fields(line):
    """'kind', {'name': 'value'} of a line of report-pictures."""
    kind, *rest = line.split("\t")
    return kind, dict(field.split("=", 1) for field in rest)


def read_descriptions():
    """What each class of scenes is, from the comments of the enumeration, in its order."""
    text = pathlib.Path("tests/parity/generate.h").read_text(encoding="utf-8")
    return [" ".join(found.split()) for found in re.findall(r"^ +CLASS_\w+,\s*/\* (.*?) \*/", text, re.M | re.S)]


def draw(options, folder):
    """Runs report-pictures; returns what it printed, by kind, each scene with the bytes of its file."""
    command = [f"{options.build}/report-pictures", "--seed", str(options.seed), "--scenes", str(options.scenes),
               "--shown", str(options.shown)]
    for name in options.classes:
        command += ["--class", name]
    output, status = run(command + (["--break"] if options.breaks else []) + [folder], accepted=(0, 1, 2))
    if status == 2:
        raise SystemExit(2)
    drawn = {"reference": [], "backend": [], "class": [], "scene": [], "end": []}
    for line in output.splitlines():
        kind, values = fields(line)
        drawn[kind].append(values)
    if not drawn["reference"]:
        raise Missing()  # report-pictures has said why
    if not drawn["end"]:
        raise Missing("the pictures are incomplete; nothing is written")
    descriptions = read_descriptions()
    if len(descriptions) != int(drawn["reference"][0]["classes"]):
        raise Missing("tests/parity/generate.h does not describe every class of scenes in a comment")
    for values in drawn["class"]:
        values["description"] = descriptions[int(values["number"])]
    for values in drawn["scene"]:
        values["png"] = pathlib.Path(folder, f"{values['class']}-{values['number']}.png").read_bytes()
    return drawn


def machine():
    """The processor's name and number, as tests/assurance/record.sh writes them."""
    try:
        found = re.search(r"^model name[^:]*: (.*)$", pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8"), re.M)
    except OSError:
        found = None
    return f"{found[1] if found else os.uname().machine}, {os.cpu_count()} processors"


def version():
    parts = re.findall(r"^#define GN_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)$",
                       pathlib.Path("include/gnomon/version.h").read_text(encoding="utf-8"), re.M)
    return ".".join(parts)


def plot_states(options):
    """The results of the benchmark of states: the file's text, date and picture; None without a file."""
    path = pathlib.Path(options.states or f"{options.build}/bench-states.json")
    if not path.is_file():
        return None
    with tempfile.TemporaryDirectory() as folder:
        picture = pathlib.Path(folder, "states.svg")
        run([f"{options.build}/bench-states", "--plot", str(path), "--svg", str(picture)])
        return {"json": path.read_text(encoding="utf-8"), "svg": picture.read_text(encoding="utf-8"),
                "date": time.strftime("%Y-%m-%d", time.localtime(path.stat().st_mtime))}


def gather(options):
    """Everything that the page shows."""
    with tempfile.TemporaryDirectory() as folder:
        found = draw(options, folder)
    progress("figures of VERIFICATION.md")
    found["verification"] = run(["tests/assurance/assurance.sh", options.build, "--print"])[0]
    progress("accuracy of functions")
    found["accuracy"], worse = run([f"{options.build}/accuracy", "--seed", str(options.seed),
                                    "--inputs", str(options.inputs)], accepted=(0, 1))
    progress("accuracy of lookups in textures")
    found["textures"], above = run([f"{options.build}/texture-accuracy", "--seed", str(options.seed),
                                    "--lookups", str(options.lookups)], accepted=(0, 1))
    found["rules"] = pathlib.Path("reference/RULES.md").read_text(encoding="utf-8")
    found["readme"] = pathlib.Path("README.md").read_text(encoding="utf-8")
    found["states"] = plot_states(options)
    found["fails"] = found["end"][0]["fails"] == "yes" or worse > 0 or above > 0
    found.update(seed=options.seed, shown=options.shown, version=version(), machine=machine(),
                 date=time.strftime("%Y-%m-%d"), count=options.scenes)
    return found


def write(path, text):
    """Writes a file that appears complete or not at all."""
    partial = path.with_name(path.name + ".partial")
    try:
        partial.write_text(text, encoding="utf-8")
        os.replace(partial, path)
    except OSError as fault:
        raise Missing(f"{path} cannot be written: {fault.strerror}") from fault


def number(least):
    """A parser of whole numbers from `least` on."""
    def parse(text):
        if not re.fullmatch(r"\d+", text) or int(text) < least:
            raise argparse.ArgumentTypeError(f"a whole number from {least} on, not '{text}'")
        return int(text)
    return parse


def parse_options():
    parser = argparse.ArgumentParser(prog="report.py", usage="report.py BUILD [OPTION...]", add_help=False)
    parser.add_argument("build")
    parser.add_argument("--output")
    parser.add_argument("--seed", type=number(0), default=1)
    parser.add_argument("--scenes", type=number(1), default=24)
    parser.add_argument("--shown", type=number(0), default=3)
    parser.add_argument("--class", dest="classes", action="append", default=[])
    parser.add_argument("--inputs", type=number(1), default=20000)
    parser.add_argument("--lookups", type=number(1), default=2000)
    parser.add_argument("--states")
    parser.add_argument("--break", dest="breaks", action="store_true")
    return parser.parse_args()


def main():
    if "--help" in sys.argv[1:]:
        print(__doc__)
        return 0
    options = parse_options()
    output = pathlib.Path(options.output or f"{options.build}/report.html")
    try:
        if options.states and not pathlib.Path(options.states).is_file():
            raise Missing(f"{options.states} is missing; nothing is written")
        if not output.parent.is_dir():
            raise Missing(f"{output} cannot be written: there is no directory {output.parent}")
        found = gather(options)
        text = page.page(found)
        write(output, text)
        web = pathlib.Path(options.build, "web")
        if not options.output and web.is_dir():
            write(web / "report.html", text)
    except Missing as fault:
        if fault.args:
            progress(fault)
        return 1
    differ = page.total(found, "differ")
    print(f"report: {page.counted(len(found['class']), 'class', 'classes')}, {page.total(found, 'scenes')} scenes, "
          f"{len(found['scene'])} shown, {differ} pixel{'s differ' if differ != 1 else ' differs'}, "
          f"{len(text.encode()) / 1e6:.1f} MB: {output}")
    return 1 if found["fails"] else 0


if __name__ == "__main__":
    sys.exit(main())
