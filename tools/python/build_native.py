"""Builds the module gnomon._native: all functions of the public headers, views.h and load.h.

cffi needs the declarations as plain text. They are taken from the headers: the C compiler expands
the macros, with empty system headers, and what remains apart from declarations is removed here.
"""

import os
import re
import shlex
import subprocess
import tempfile
from pathlib import Path

from cffi import FFI

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
INCLUDED = [ROOT / "include", HERE / "src/gnomon", ROOT / "tools/models"]
HEADERS = '#include "views.h"\n#include "load.h"\n'
SYSTEM_HEADERS = ("stdint.h", "stddef.h", "stdbool.h", "limits.h", "float.h", "math.h", "string.h")


def without_bodies(text: str) -> str:
    """Removes functions with bodies: inline functions of the headers."""
    kept, at = [], 0
    for start in re.finditer(r"static inline[^;{]*\{", text):
        if start.start() < at:
            continue
        kept.append(text[at : start.start()])
        depth, at = 1, start.end()
        while depth:
            depth += {"{": 1, "}": -1}.get(text[at], 0)
            at += 1
    return "".join(kept) + text[at:]


def declarations() -> str:
    """Returns the declarations of the headers and of those that they include."""
    with tempfile.TemporaryDirectory() as empty:
        for name in SYSTEM_HEADERS:
            Path(empty, name).touch()
        text = subprocess.run(
            [*shlex.split(os.environ.get("CC", "cc")), "-E", "-P", "-nostdinc", f"-I{empty}"]
            + [f"-I{directory}" for directory in INCLUDED]
            + ["-xc", "-"],
            input=HEADERS,
            check=True,
            capture_output=True,
            text=True,
        ).stdout
    text = re.sub(r"__attribute__\s*\(\((?:[^()]|\([^()]*\))*\)\)", "", text)
    text = re.sub(r"\b_Bool\b", "bool", text)
    text = re.sub(r"^.*\b__builtin_.*$", "", text, flags=re.MULTILINE)
    return without_array_pointers(without_bodies(text))


def without_array_pointers(text: str) -> str:
    """Leaves out members of structures that are pointers to arrays, which cffi cannot write in C. The
    compiler then says where the other members are.
    """

    def shortened(structure: re.Match[str]) -> str:
        members = [member.strip() for member in structure[2].split(";")]
        kept = "; ".join(member for member in members if member and "(*" not in member)
        return f"typedef struct {structure[1]} {{ {kept + '; ' if kept else ''}...; }} {structure[1]};"

    structure = re.compile(r"typedef struct (\w+) \{([^{}]*)\} \1;")
    return structure.sub(lambda s: shortened(s) if "(*" in s[2] else s[0], text)


SOURCES = [
    *sorted((HERE / "src/gnomon").glob("*.c")),
    ROOT / "tools/threads/pool.c",
    *sorted((ROOT / "tools/models").glob("*.c")),
]

ffibuilder = FFI()
ffibuilder.cdef(declarations())
ffibuilder.set_source("gnomon._native", HEADERS)

if __name__ == "__main__":
    print(declarations())
