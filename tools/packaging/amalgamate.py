#!/usr/bin/env python3
"""Writes the library as two files, DIRECTORY/gnomon.h and DIRECTORY/gnomon.c.

usage: amalgamate.py DIRECTORY   (from the root of the project; CC names the preprocessor, else cc)

gnomon.c is compiled once and holds every back end. What depends on lanes is compiled once for each
form of lanes: gnomon.c includes itself, and a pass gives the names of that text another ending.
"""

import functools
import itertools
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

LANES = "src/lanes/lanes.h"
COUNT = "src/lanes/count.h"
FAULTS = "src/config/faults.h"
TARGET = ("src/lanes/target_begin.inl", "src/lanes/target_end.inl")
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]+(["<])([^">]+)[">][^\n]*\n', re.M)
GUARD = re.compile(r"#ifndef (GN\w+_(?:H|INL))\n#define \1\n")
DEFINE = re.compile(r"^[ \t]*#[ \t]*define[ \t]+(\w+)", re.M)
KEYWORDS = set("if else for while do switch case return sizeof static inline const extern typedef struct "
               "enum union void char short int long float double signed unsigned bool volatile "
               "register restrict _Pragma defined".split())


def text_of(path):
    return Path(path).read_text()


def without_comments(text):
    return re.sub(r"/\*.*?\*/", lambda m: "\n" * m[0].count("\n"), text, flags=re.S)


def included(path, text):
    """The project's files that a file includes, in order."""
    return [resolved(path, m[2]) for m in INCLUDE.finditer(text) if m[1] == '"']


def resolved(path, name):
    return os.path.normpath(os.path.join(os.path.dirname(path), name))


class Sources:
    """All files of src/, and what they include."""

    def __init__(self):
        self.text = {str(p): text_of(p) for p in sorted(p for p in Path("src").rglob("*.*") if p.suffix in (".c", ".h", ".inl"))}
        # Operations of lanes as calls make several objects of little code smaller, not one.
        for path in ("src/lanes/calls.c", "src/lanes/calls.h"):
            del self.text[path]
        self.text[LANES] = re.sub(r"#if GN_LANES_CALLED && LANES > 1\n.*?#endif\n", "", self.text[LANES], flags=re.S)
        self.uses = {p: included(p, t) for p, t in self.text.items()}
        self.units = [p for p in self.text if p.endswith(".c")]
        self.has_lanes = {p for p in self.text if {p, *self.closure(p)} & {LANES, COUNT, FAULTS}
                          or p.startswith("src/lanes/")}

    @functools.lru_cache(maxsize=None)
    def closure(self, path):
        """All headers that a file includes, each after those that it includes itself."""
        order = []

        def visit(p):
            for used in self.uses[p]:
                if used not in order:
                    visit(used)
                    if used not in order:
                        order.append(used)

        visit(path)
        return order

    def roots(self, path):
        """The guarded headers that a file includes itself or through the text of a form."""
        for used in self.uses[path]:
            if self.is_guarded(used):
                yield used
            elif used not in TARGET:
                yield from self.roots(used)

    def is_guarded(self, path):
        return GUARD.search(self.text[path]) is not None

    def form(self, unit):
        """The form of lanes that a .c file chooses, "texts" for texts of faults, or "usual"."""
        if "#define GN_FAULT_TEXTS" in self.text[unit]:
            return "texts"
        chosen = re.search(r"^#define GN_LANES_(\w+)$", self.text[unit], re.M)
        return chosen[1].lower() if chosen else "usual"

    def conditions(self, unit):
        """The condition under which a .c file has code, as it stands in its first #if."""
        found = re.search(r"^#if (.*)$", self.text[unit], re.M)
        return found[1] if found else "1"


def file_scope_names(text):
    """The names that a text declares at file scope: functions, objects, types, tags, constants."""
    text = without_comments(text)
    text = re.sub(r"\\\n", " ", text)
    text = re.sub(r"^[ \t]*#.*$", "", text, flags=re.M)
    text = re.sub(r"__attribute__\s*\(\((?:[^()]|\([^()]*\))*\)\)", "", text)
    names = set()
    declaration = ""
    depth = 0
    body = ""
    for c in text:
        if c == "{":
            if depth == 0:
                body = ""
            depth += 1
        elif c == "}":
            depth -= 1
            if depth == 0:
                names |= names_of_block(declaration, body)
                is_type = re.search(r"\b(struct|enum|union)\b", declaration) and "(" not in declaration
                declaration = declaration + " {} " if is_type or "=" in declaration else ""
        elif depth > 0:
            body += c
        elif c == ";":
            names |= names_of_declaration(declaration)
            declaration = ""
        else:
            declaration += c
    return {n for n in names if n not in KEYWORDS}


def names_of_block(declaration, body):
    tag = re.search(r"\b(struct|enum|union)\s+(\w+)?\s*$", declaration)
    if tag:
        names = {tag[2]} if tag[2] else set()
        if tag[1] == "enum":
            names |= set(re.findall(r"(?:^|,)\s*(\w+)", re.sub(r"\([^()]*\)", "", body)))
        return names
    return {m for m in re.findall(r"(\w+)\s*\(", declaration)[:1]}


def names_of_declaration(declaration):
    declaration = re.sub(r"\[[^\]]*\]", "", declaration.replace("{}", " ")).split("=")[0].strip()
    if not declaration or declaration.startswith("extern"):
        return set()
    pointer = re.search(r"\(\s*\*\s*(\w+)\s*\)\s*\(", declaration)
    if pointer:
        return {pointer[1]}
    function = re.search(r"(\w+)\s*\(", declaration)
    if function:
        return {function[1]}
    last = re.search(r"(\w+)\s*$", declaration)
    return {last[1]} if last else set()


def conditions_at(text, place):
    """How many #if are open at a place."""
    found = re.findall(r"^[ \t]*#[ \t]*(if|endif)", text[:place], re.M)
    return found.count("if") - found.count("endif")


def macros(text):
    return list(dict.fromkeys(DEFINE.findall(without_comments(text))))


# What the preprocessor is told of each target: the output must not depend on the machine.
GNU = ["-D__GNUC__=12", "-D__BYTE_ORDER__=1234", "-D__ORDER_LITTLE_ENDIAN__=1234"]
X86 = [*GNU, "-D__x86_64__", "-D__SSE2__", "-D__SSE2_MATH__"]
TARGETS = ([], GNU, X86, [*X86, "-DGN_SMALL"], [*GNU, "-DGN_SMALL", "-DGN_BASIC", "-DGN_LANES=1"],
           [*GNU, "-D__aarch64__", "-D__ARM_NEON"], [*GNU, "-D__wasm__", "-D__wasm_simd128__"])


def made_names(sources, units):
    """The names at file scope of headers with lanes that macros make, as the preprocessor sees them."""
    names = set()
    compiler = os.environ.get("CC", "cc").split()
    with tempfile.TemporaryDirectory() as empty:
        for path in [*sources.text, *map(str, Path("include").rglob("*.h"))]:
            for found in INCLUDE.finditer(text_of(path)):
                if found[1] == "<" and not found[2].startswith("gnomon"):
                    (Path(empty) / found[2]).touch()
        for target, unit in itertools.product(TARGETS, units):
            made = subprocess.run([*compiler, "-E", "-std=c99", "-undef", "-nostdinc", "-isystem", empty,
                                   "-Iinclude", *target, unit], check=True, capture_output=True, text=True)
            names |= file_scope_names("\n".join(lines_of_lanes(sources, made.stdout)))
    return names


def lines_of_lanes(sources, preprocessed):
    """The preprocessed lines that stand in headers with lanes."""
    is_ours = False
    for line in preprocessed.splitlines():
        mark = re.match(r'# \d+ "([^"]*)"', line)
        if mark:
            path = os.path.normpath(mark[1])
            is_ours = path in sources.has_lanes and path.endswith((".h", ".inl"))
        elif is_ours:
            yield line


class Writer:
    def __init__(self, sources):
        self.sources = sources
        self.done = set()
        self.system = []
        self.parts = []

    def file(self, path, skip=()):
        """Appends a file in which the files it includes stand in place of their #include lines."""
        self.parts.append(self.expanded(path, skip))

    def expanded(self, path, skip=()):
        def replace(match):
            if match[1] == "<":
                if not match[2].startswith("gnomon"):
                    self.system.append(match[2])
                return ""
            used = resolved(path, match[2])
            if used in skip or used in self.done:
                return ""
            before = set(self.done)
            if self.sources.is_guarded(used):
                self.done.add(used)
            expanded = self.expanded(used, skip)
            if conditions_at(text, match.start()) > int(self.sources.is_guarded(path)):
                self.done = before  # Another branch may need the same file.
            return expanded

        text = self.sources.text[path]
        if "GN_LANES_INTRINSICS_HEADER" in text:
            # Emulated intrinsics are for tests of the library's own tree.
            text = text.replace("#include GN_LANES_INTRINSICS_HEADER\n", "")
        return re.sub(r"\n{3,}", "\n\n", INCLUDE.sub(replace, text)).strip("\n") + "\n"

    def take(self):
        text = "\n".join(self.parts)
        self.parts = []
        return text


def licence():
    """The licence as lines of a comment."""
    return "\n".join(f" * {line}".rstrip() for line in text_of("LICENSE").strip().splitlines())


def public_header():
    done = set()

    def expanded(path):
        def replace(match):
            if match[1] == "<":
                return match[0]
            used = resolved(path, match[2])
            if used in done:
                return ""
            done.add(used)
            return expanded(used) + "\n"

        return re.sub(r"\n{3,}", "\n\n", INCLUDE.sub(replace, text_of(path)))

    text = expanded("include/gnomon.h")
    return HEADER.format(version=version(text), licence=licence()) + text


def undefine(names):
    return "".join(f"#undef {n}\n" for n in names)


def rename_ambiguous(sources, header):
    """Gives each name of file scope that two headers declare, and no file includes both, two names.

    So it does with a name that is also a word of the public header: a member there, perhaps.
    """
    first = {}
    renamed = set()
    known = set(re.findall(r"\w+", without_comments(header)))
    for path in [p for p in sources.text if p.endswith((".h", ".inl"))]:
        own = file_scope_names(sources.text[path]) - set(macros(sources.text[path]))
        for name in sorted(n for n in own if not n.startswith(("gn_", "gni_", "GN_"))):
            other = first.setdefault(name, path)
            together = any({path, other} <= set(sources.closure(p)) for p in sources.text)
            if name not in known and (other == path or together):
                continue
            for user in sources.text:
                if user == path or path in sources.closure(user):
                    rename(sources, user, name, path, name in known)
            renamed |= {name} & known
    return renamed


def rename(sources, path, name, declared, is_called=False):
    """Gives a name another ending in a file: the name of the file that declares it."""
    call = r"(?=\()" if is_called else ""
    word = re.compile(rf'(?<![.>\w"/]){name}\b(?!\.(?:h|inl)){call}')
    sources.text[path] = word.sub(f"{name}_of_{Path(declared).stem}", sources.text[path])


def library(header):
    sources = Sources()
    writer = Writer(sources)
    plain = [u for u in sources.units if u not in sources.has_lanes]
    forms = {}
    for unit in sources.units:
        if unit in sources.has_lanes:
            forms.setdefault(sources.form(unit), []).append(unit)

    renamed = rename_ambiguous(sources, header)

    # What does not depend on lanes stands once.
    shared = [h for u in sources.units for h in sources.closure(u) if h not in sources.has_lanes]
    for path in dict.fromkeys(shared):
        if path not in writer.done:
            writer.done.add(path)
            writer.file(path)
    shared_text = re.sub(r"^static inline ", "GN_STANDS_ONCE ", writer.take(), flags=re.M)

    # Names of one .c file that another file has too.
    taken = set().union(*(file_scope_names(t) for p, t in sources.text.items() if p.endswith((".h", ".inl"))))
    for unit in sources.units:
        own = file_scope_names(sources.text[unit]) - set(macros(sources.text[unit]))
        own = {n for n in own if not n.startswith(("gn_", "gni_", "GN_"))}
        for name in sorted(own & taken):
            rename(sources, unit, name, unit)
        taken |= own

    def unit_text(unit, skip=()):
        return writer.expanded(unit, skip) + undefine(macros(sources.text[unit]))

    plain_text = "\n".join(unit_text(u) for u in plain)

    # What depends on lanes: first what the forms of all back ends need.
    skip = TARGET
    for form, units in forms.items():
        if form == "usual":
            continue
        for unit in units:
            for path in sources.roots(unit):
                if path in sources.has_lanes and path not in writer.done:
                    writer.done.add(path)
                    writer.file(path, skip)
    lanes_text = writer.take()
    pieces = []
    for form, units in forms.items():
        body = "\n".join(unit_text(u, skip) for u in units)
        pieces.append(f"#if defined(GN_PASS_{form.upper()})\n{body}#endif\n")
    unit_pieces = "\n".join(pieces)
    pass_text = lanes_text + unit_pieces

    used_headers = [h for h in sources.has_lanes if h.endswith((".h", ".inl"))]
    names = set()
    header_macros = []
    for path in sorted(used_headers):
        names |= file_scope_names(sources.text[path])
        header_macros += macros(sources.text[path])
    names |= made_names(sources, [u for units in forms.values() for u in units])
    names -= set(header_macros)
    names = {n for n in names if not n.startswith(("gn_", "gni_", "GN_")) and re.fullmatch(r"[A-Za-z_]\w*", n)}
    known = set(re.findall(r"\w+", without_comments(header + shared_text)))
    names -= file_scope_names(shared_text) | renamed
    return COMPOSED.format(
        version=version(header), flags=FLAGS, licence=licence(), shared=shared_text, plain=plain_text,
        both=undefine(n for n in macros(shared_text) if n in header_macros),
        renames="".join(f"#define {n} GN_PASS_NAME({n}_)\n" for n in sorted(names)),
        passes="".join(pass_of(form, units, sources) for form, units in forms.items()),
        begin=writer_text(sources, TARGET[0]), lanes=pass_text, end=writer_text(sources, TARGET[1]),
        undefine=undefine(dict.fromkeys(header_macros)))


def writer_text(sources, path):
    return sources.text[path]


def version(header):
    return ".".join(re.findall(r"#define GN_VERSION_[A-Z]+ (\d+)", header))


def pass_of(form, units, sources):
    conditions = " || ".join(dict.fromkeys(f"({sources.conditions(u)})" for u in units))
    begin, end = ("", "") if form in ("usual", "texts") else (f"#if {conditions}\n", "#endif\n")
    lanes = {"usual": "", "texts": "#define GN_FAULT_TEXTS\n"}
    chosen = lanes.get(form, f"#define GN_LANES_{form.upper()}\n")
    undefined = undefine(macro.split()[1] for macro in chosen.splitlines())
    return (f"\n{begin}#define GN_PASS_{form.upper()}\n{chosen}#define GN_PASS_NAME(name) name##{form}\n"
            f'#include "gnomon.c"\n#undef GN_PASS_NAME\n#undef GN_PASS_{form.upper()}\n{undefined}{end}')


FLAGS = "-std=c99 -O3 -ffreestanding -fno-math-errno -fno-stack-protector -fno-fast-math -ffp-contract=off"

HEADER = """\
/* Gnomon {version}: all public headers as one file, which tools/packaging/amalgamate.py made. gnomon.c
 * says how to compile the library.
 *
{licence}
 */

"""

COMPOSED = """\
/* Gnomon {version}: 3D mathematics and software rendering in freestanding C99, the whole library in
 * one file. tools/packaging/amalgamate.py made it from the files of src/. It needs gnomon.h beside it
 * and nothing else:
 *
 *   cc {flags} -c gnomon.c
 *
 * -ffp-contract=off and -fno-fast-math stand after all other flags. Without them a compiler may fuse
 * or reorder operations on floats, and results no longer have the documented bits. With
 * -ffreestanding, -fno-math-errno and -fno-stack-protector the object calls nothing outside it.
 * With gcc, -O3 draws up to 1.8 times as fast as -O2, since it unrolls loops over lanes. Options of
 * the library: -DGN_ONLY_PORTABLE, -DGN_NO_VECTORS, -DGN_SMALL (then -Os), -DGN_BASIC and
 * -DGN_LANES=1. The last three must be the same for every file that includes gnomon.h.
 *
 * The file includes itself once for each form of lanes (src/lanes/lanes.h): GN_PASS_NAME is defined
 * then, and gives the names of that text another ending, such as clip_triangle_avx2.
 *
{licence}
 */
#if !defined(GN_PASS_NAME)

#include "gnomon.h"

#include <float.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__) && defined(__OPTIMIZE__) && !defined(GN_SMALL)
#define GN_STANDS_ONCE static inline __attribute__((always_inline))
#else
#define GN_STANDS_ONCE static inline
#endif

/* A pass holds all functions of its headers, and no pass needs them all. */
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
/* g++ warns of the undefined operands in its own header of AVX-512 (GCC's bug 105593). */
#if defined(__GNUC__) && defined(__cplusplus) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

{shared}
#if GN_HAVE_AVX2
#include <cpuid.h>
#endif
#if defined(__SSE2__)
/* Its functions that call malloc do not compile as freestanding C++ with GCC 14. */
#if defined(__cplusplus) && !__STDC_HOSTED__
#define _MM_MALLOC_H_INCLUDED
#endif
#include <immintrin.h>
#endif
#if GN_HAVE_NEON
#include <arm_neon.h>
#endif
#if defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif

{plain}
/* What depends on lanes, once for each form. */

{both}{renames}{passes}
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#else

{begin}
{lanes}
{end}
{undefine}#endif
"""


def refuse(why):
    print(f"amalgamate.py: {why}", file=sys.stderr)
    sys.exit(2)


def main():
    if sys.argv[1:] == ["--help"]:
        print(__doc__.strip())
        return
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        refuse("one DIRECTORY is needed, and no option but --help")
    if not Path("include/gnomon.h").exists():
        refuse("include/gnomon.h is not there: run it from the root of the project")
    directory = Path(sys.argv[1])
    header = public_header()
    source = library(header)
    directory.mkdir(parents=True, exist_ok=True)
    (directory / "gnomon.h").write_text(header)
    (directory / "gnomon.c").write_text(source)


if __name__ == "__main__":
    main()
