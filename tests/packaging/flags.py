#!/usr/bin/env python3
"""Compares the options with which make, CMake and Meson compile each file of the library where nobody asks for any.
What a user has in CPPFLAGS, make must take, as Meson does.

What decides about bits and speed must be equal: language, -f options in their order, macros, and the level. Left
out are -fPIC, colours of messages, NDEBUG and _FILE_OFFSET_BITS, which mean nothing to the library.
usage: flags.py BUILD-DIRECTORY    (from the root of the project)"""
import json
import os
import pathlib
import shlex
import shutil
import subprocess
import sys

PLAIN = {k: v for k, v in os.environ.items() if k not in ("CFLAGS", "CPPFLAGS", "LDFLAGS", "MAKEFLAGS")}
IGNORED = {"-fPIC", "-fdiagnostics-color=always", "-DNDEBUG", "-D_FILE_OFFSET_BITS=64"}


def options(command):
    words = [w for w in shlex.split(command) if w not in IGNORED]
    level = [w for w in words if w.startswith("-O")][-1:]
    flags = [w for w in words if w.startswith(("-f", "-std=", "-D", "-m"))]
    return level + sorted(w for w in flags if "contract" not in w and "fast-math" not in w) + \
        [w for w in flags if "contract" in w or "fast-math" in w]


def of_make(*more):
    printed = subprocess.run(["make", "-n", "-B", "BUILD=/nowhere", "CFLAGS=-O3", "MAKEFLAGS=", *more, "static"], check=True,
                             capture_output=True, text=True, env=PLAIN).stdout
    lines = [line for line in printed.splitlines() if " -c src/" in line]
    return {word: options(line) for line in lines for word in shlex.split(line)
            if word.startswith("src/") and word.endswith(".c")}


def of_database(folder):
    root = pathlib.Path.cwd()
    found = {}
    for entry in json.loads((folder / "compile_commands.json").read_text()):
        file = (pathlib.Path(entry["directory"]) / entry["file"]).resolve().relative_to(root)
        found[str(file)] = options(entry["command"])
    return found


def main():
    for tool in ("cmake", "meson"):
        if not shutil.which(tool):
            print(f"skipped: flags of make, CMake and Meson: needs {tool}: 'make setup' installs it")
            return False
    folder = pathlib.Path(sys.argv[1]).resolve() / "embed/flags"
    shutil.rmtree(folder, ignore_errors=True)
    quiet = {"check": True, "stdout": subprocess.DEVNULL, "env": PLAIN}
    subprocess.run(["cmake", "-S", ".", "-B", folder / "cmake", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON"], **quiet)
    subprocess.run(["meson", "setup", folder / "meson", "."], **quiet)
    make = of_make()
    failed = 0
    for name in ("cmake", "meson"):
        other = of_database(folder / name)
        for file in sorted(make.keys() | other.keys()):
            if make.get(file) != other.get(file):
                failed += 1
                print(f"FAILED: {file}: make {make.get(file)}, {name} {other.get(file)}")
    for file, found in of_make("CPPFLAGS=-DOF_THE_USER").items():
        if "-DOF_THE_USER" not in found:
            failed += 1
            print(f"FAILED: {file}: make leaves CPPFLAGS out")
    print(f"flags of make, CMake and Meson: {3 * len(make) - failed} passed, {failed} failed")
    return failed > 0 or not make


sys.exit(main())
