#!/usr/bin/env python3
"""Writes C from gl.xml, Khronos' registry of OpenGL (Debian's package khronos-api).

usage: registry.py GL_XML header              the enumerations and prototypes of OpenGL
       registry.py GL_XML entries OBJECT...   the functions that the objects lack, and the table of all
       registry.py GL_XML list OBJECT...      the names of all functions, "yes" or "no" before each

A function that the objects define is supported. One that is only another name of it (ARB_ and EXT_
suffixes) calls it. Every other one of OpenGL 1.0 to 4.6 and its extensions reports
GL_INVALID_OPERATION by unsupported(), so that programs that were linked with another libOSMesa find
all its symbols.
"""
import re
import subprocess
import sys
import xml.etree.ElementTree

class Command:
    """One function: its name, result, parameters, and the function that it is another name of."""

    def __init__(self, element):
        prototype = element.find("proto")
        self.name = prototype.find("name").text
        text = "".join(prototype.itertext()).strip()
        self.result = text[: -len(self.name)].strip()
        self.parameters = [" ".join("".join(p.itertext()).split()) for p in element.findall("param")]
        self.arguments = [p.find("name").text for p in element.findall("param")]
        alias = element.find("alias")
        self.alias = alias.get("name") if alias is not None else None

    def declaration(self):
        return f"{self.result} {self.name}({', '.join(self.parameters) or 'void'})"


def read_commands(root):
    """The functions of OpenGL, which the registry keeps together with those of OpenGL ES."""
    wanted = set()
    for feature in root.iter("feature"):
        if feature.get("api") == "gl":
            wanted |= {command.get("name") for command in feature.findall("require/command")}
    for extension in root.iter("extension"):
        if "gl" in extension.get("supported", "").split("|"):
            wanted |= {command.get("name") for require in extension.findall("require")
                       if require.get("api") in (None, "gl") for command in require.findall("command")}
    commands = [Command(element) for element in root.find("commands").findall("command")]
    return sorted((c for c in commands if c.name in wanted), key=lambda c: c.name)


def write_header(root, commands):
    print("/* OpenGL's enumerations and functions, written by registry.py. */")
    print("#ifndef GL_REGISTRY_H\n#define GL_REGISTRY_H\n\n#include \"gl_types.h\"\n")
    print("#define GLAPI extern __attribute__((visibility(\"default\")))\n#define GLAPIENTRY")
    for feature in root.iter("feature"):
        if feature.get("api") == "gl":
            print(f"#define {feature.get('name')} 1")
    seen = set()
    for enum in root.iter("enum"):
        name, value = enum.get("name"), enum.get("value")
        if value is None or name in seen or enum.get("api") not in (None, "gl"):
            continue
        seen.add(name)
        print(f"#define {name} {value}{(enum.get('type') or '').upper()}")
    print("\n#pragma GCC visibility push(default)")
    for command in commands:
        print(command.declaration() + ";")
    print("#pragma GCC visibility pop\n\n#endif")


def supported_names(objects):
    symbols = subprocess.run(["nm", "-P", "-g", "--defined-only"] + objects, check=True, text=True,
                             stdout=subprocess.PIPE).stdout
    return set(re.findall(r"^(gl[A-Z]\w*) T", symbols, re.M))


def find_calls(commands, supported):
    """For each name that only calls another, the supported function that it calls."""
    same = {}
    for command in commands:
        same.setdefault(command.alias or command.name, set()).add(command.name)
    calls = {}
    for root, names in same.items():
        target = sorted((names | {root}) & supported, key=len)
        if target:
            calls.update({name: target[0] for name in names - supported})
    return calls


def write_entries(commands, supported):
    calls = find_calls(commands, supported)
    print('/* What the library does not implement, written by registry.py. */')
    print('#include <gl_registry.h>\n\n#include "entries.h"\n')
    print("#pragma GCC diagnostic ignored \"-Wunused-parameter\"\n")
    for command in commands:
        if command.name in supported:
            continue
        returns = command.result != "void"
        print(command.declaration() + "\n{")
        if command.name in calls:
            target = calls[command.name]
            by_name = next(c for c in commands if c.name == target)
            # Some names differ in the types of handles and pointers alone.
            arguments = ", ".join(argument if theirs == own else f"({re.sub(r'[ ]*[A-Za-z_0-9]+$', '', own)}){argument}"
                                  for argument, theirs, own in zip(command.arguments, command.parameters, by_name.parameters))
            print(f"    {'return ' if returns else ''}{target}({arguments});")
        else:
            print("    static unsigned char is_known;\n")
            print(f'    unsupported("{command.name}", &is_known);')
            if returns:
                print("    return 0;")
        print("}\n")
    print(f"const unsigned entry_count = {len(commands)};\n")
    print("const entry_point entries[] = {")
    for command in commands:
        print(f'    {{"{command.name}", (entry_function *){command.name}}},')
    print("};")


def main():
    if len(sys.argv) < 3 or sys.argv[2] not in ("header", "entries", "list"):
        sys.exit(__doc__)
    try:
        root = xml.etree.ElementTree.parse(sys.argv[1]).getroot()
    except OSError as error:
        sys.exit(f"{error.strerror}: {sys.argv[1]}, which Debian's package khronos-api has: 'make setup' installs it")
    commands = read_commands(root)
    if sys.argv[2] == "header":
        write_header(root, commands)
        return
    supported = supported_names(sys.argv[3:])
    if sys.argv[2] == "entries":
        write_entries(commands, supported)
        return
    found = supported | set(find_calls(commands, supported))
    for command in commands:
        print("yes" if command.name in found else "no", command.name)


main()
