#!/usr/bin/env python3
"""Writes C from gl.xml, Khronos' registry of OpenGL (Debian's package khronos-api).

usage: registry.py GL_XML header              the enumerations and prototypes of OpenGL
       registry.py GL_XML entries OBJECT...   the functions that the objects lack, those that display
                                              lists record, and the table of all
       registry.py GL_XML list OBJECT...      the names of all functions, "yes" or "no" before each
       registry.py GL_XML recorded OBJECT...  how lists record each function that the objects define

A function that the objects define is supported. One that is only another name of it (ARB_ and EXT_
suffixes) calls it. Every other one of OpenGL 1.0 to 4.6 and its extensions reports
GL_INVALID_OPERATION by unsupported(), so that programs that were linked with another libOSMesa find
all its symbols.

Display lists record every function but those of NOT_LISTED (OpenGL 2.1 section 5.4): glNAME, which
programs call, records the call or passes it on to execute_glNAME, which is what the objects define
under the C name glNAME (gl_registry.h names the symbol). What a pointer refers to is copied if the
registry or SIZES says how long it is. Otherwise an object must define compile_glNAME, which records
the call by hand (list_record.h); if it does not, the function is executed and not recorded, which
"recorded" prints as "unknown".
"""
import re
import subprocess
import sys
import xml.etree.ElementTree

# What is executed at once while a list is compiled.
NOT_LISTED = re.compile(
    r"gl(Get\w+|Is\w+|Gen(?!erate)\w+|Delete\w+|Are\w+|NewList|EndList|RenderMode|FeedbackBuffer|SelectBuffer|"
    r"\w+Pointer(EXT)?|InterleavedArrays|(Push|Pop)ClientAttrib|ClientActiveTexture|(Enable|Disable)ClientState|"
    r"PixelStore\w+|ReadPixels|Finish|Flush|(Bind|Map|Unmap|Flush|Copy)\w*Buffer\w*|Buffer\w*Data|"
    r"\w*Framebuffer\w*|\w*Renderbuffer\w*|GenerateMipmap|Debug\w+|\w+DebugGroup|ObjectLabel)(ARB|EXT)?")
LISTED_ANYWAY = ("glBlitFramebuffer",)

# Other names that the registry does not call aliases, because GLX sends them by other numbers, or, those
# of framebuffers, because core profiles bind reserved names only.
SAME_AS = {name + "EXT": name for name in ("glAreTexturesResident", "glBindFramebuffer", "glBindRenderbuffer",
                                           "glDeleteTextures", "glGenTextures", "glIsTexture")}

# Functions that are recorded as vertices, of which lists make meshes.
VERTEX_CALL = re.compile(
    r"gl(Vertex|Color[34]|SecondaryColor3|Normal3|TexCoord|MultiTexCoord|FogCoord|EdgeFlag|Index)(?!Mask|Pointer)\w*")

# How long what a pointer refers to is, by the registry's words.
SIZES = {
    "COMPSIZE(pname)": "parameter_count(pname) * sizeof *{0}",
    "COMPSIZE(target,pname)": "parameter_count(pname) * sizeof *{0}",
    "COMPSIZE(n,type)": "name_bytes(n, type)",
    "COMPSIZE(width,height)": "bitmap_bytes(width, height)",
    "COMPSIZE()": "bitmap_bytes(32, 32)",
    "COMPSIZE(format,type,width)": "image_bytes(width, 1, 1, format, type)",
    "COMPSIZE(format,type,width,height)": "image_bytes(width, height, 1, format, type)",
    "COMPSIZE(format,type,width,height,depth)": "image_bytes(width, height, depth, format, type)",
}


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
        self.alias = alias.get("name") if alias is not None else SAME_AS.get(self.name)
        self.lengths = [p.get("len") for p in element.findall("param")]
        self.is_listed = self.result == "void" and (self.name in LISTED_ANYWAY or not NOT_LISTED.fullmatch(self.name))

    def declaration(self):
        return self.named(self.name)

    def named(self, name):
        return f"{self.result} {name}({', '.join(self.parameters) or 'void'})"

    def pointers(self):
        return [(a, n) for p, a, n in zip(self.parameters, self.arguments, self.lengths) if "*" in p]

    def size_of(self, argument, length):
        """The bytes that a pointer refers to, as C; None if it is not known."""
        if length and (length.isdigit() or length in self.arguments):
            count = length if length.isdigit() else f"(size_t)({length} < 0 ? 0 : {length})"
            return f"{count} * sizeof *{argument}"
        return SIZES[length].format(argument) if length in SIZES else None

    def kind(self):
        return {"glBegin": "CALL_BEGIN", "glEnd": "CALL_END", "glCallList": "CALL_OF_LIST", "glCallLists": "CALL_OF_LIST"}.get(
            self.name, "CALL_VERTEX" if VERTEX_CALL.fullmatch(self.name) else "CALL_OTHER")

    def recording(self, symbols):
        """How a list records the function, one of the objects' own."""
        if not self.is_listed:
            return "executed"
        if "compile_" + self.name in symbols:
            return "by hand"
        known = all(self.size_of(*pointer) for pointer in self.pointers())
        return "recorded" if known else "unknown"


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
    print("#ifndef GL_REGISTRY_H\n#define GL_REGISTRY_H\n\n#include \"context/gl_types.h\"\n")
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
    print("\n/* What lists record is defined in the library as another symbol. */")
    print("#ifdef OSMESA_EXECUTES")
    print('#define LISTED(name) __asm__("execute_" #name) __attribute__((visibility("hidden")))')
    print('#else\n#define LISTED(name) __attribute__((visibility("default")))\n#endif')
    print("\n#pragma GCC visibility push(default)")
    for command in commands:
        print(command.declaration() + (f" LISTED({command.name});" if command.is_listed else ";"))
    print("#pragma GCC visibility pop\n\n#endif")


def symbols_of(objects):
    symbols = subprocess.run(["nm", "-P", "-g", "--defined-only"] + objects, check=True, text=True,
                             stdout=subprocess.PIPE).stdout
    return set(re.findall(r"^(\w+) T", symbols, re.M))


def supported_names(symbols):
    names = {name[len("execute_"):] if name.startswith("execute_gl") else name for name in symbols}
    return {name for name in names if re.match(r"gl[A-Z]", name)}


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


def write_listed(command, recording):
    """Writes a function that records its call, or executes it, or both."""
    arguments = ", ".join(command.arguments)
    name = command.name
    sizes = {argument: command.size_of(argument, length) or "" for argument, length in command.pointers()}
    has_image = any("_bytes(" in size and "name" not in size for size in sizes.values())
    print(command.named("execute_" + name) + ";")
    if recording == "by hand":
        print(command.named("compile_" + name) + ";")
    if recording == "recorded" and command.parameters:
        print("typedef struct arguments_of_" + name + " {")
        for parameter in command.parameters:
            print(f"    {parameter};")
        print(("    recorded_unpack unpack;\n" if has_image else "") + "} arguments_of_" + name + ";\n")
    if recording == "recorded":
        print(f"static void replay_{name}(void *arguments)\n{{")
        if command.parameters:
            print(f"    arguments_of_{name} *const a = arguments;\n")
        swap = "    swap_unpack(&a->unpack);\n" if has_image else ""
        print(f"{swap}    execute_{name}({', '.join('a->' + argument for argument in command.arguments)});\n{swap}}}\n")
    print(command.declaration() + "\n{")
    if recording == "unknown":
        print(f'    if (compiled_mode())\n        not_recorded("{name}");')
    else:
        proxy = " && !is_proxy(target)" if re.fullmatch(r"glTexImage\dD", name) else ""
        print(f"    const GLenum compiled = compiled_mode();\n\n    if (compiled{proxy}) {{")
        if recording == "by hand":
            print(f"        compile_{name}({arguments});")
        else:
            size = f"sizeof(arguments_of_{name})" if command.parameters else "0"
            variable = f"arguments_of_{name} *const a = " if command.parameters else ""
            print(f"        {variable}record_call(replay_{name}, {size}, {command.kind()});\n")
            if command.parameters:
                print("        if (a) {")
                copied = "record_image" if has_image else "record_memory"
                for argument in command.arguments:
                    value = f"{copied}({argument}, {sizes[argument]})" if argument in sizes else argument
                    print(f"            a->{argument} = {value};")
                if has_image:
                    print("            a->unpack = current_unpack();")
                print("        }")
        print("        if (compiled == GL_COMPILE)\n            return;\n    }")
    print(f"    execute_{name}({arguments});\n}}\n")


def write_entries(commands, symbols):
    supported = supported_names(symbols)
    calls = find_calls(commands, supported)
    print('/* What the library does not implement, and what display lists record, written by registry.py. */')
    print('#include <gl_registry.h>\n\n#include "context/entries.h"\n#include "lists/list_record.h"\n')
    print("#pragma GCC diagnostic ignored \"-Wunused-parameter\"\n#pragma GCC diagnostic ignored \"-Wshadow\"\n")
    for command in commands:
        if command.name in supported:
            if command.is_listed:
                write_listed(command, command.recording(symbols))
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
    if len(sys.argv) < 3 or sys.argv[2] not in ("header", "entries", "list", "recorded"):
        sys.exit(__doc__)
    try:
        root = xml.etree.ElementTree.parse(sys.argv[1]).getroot()
    except OSError as error:
        sys.exit(f"{error.strerror}: {sys.argv[1]}, which Debian's package khronos-api has: 'make setup' installs it")
    commands = read_commands(root)
    if sys.argv[2] == "header":
        write_header(root, commands)
        return
    symbols = symbols_of(sys.argv[3:])
    supported = supported_names(symbols)
    if sys.argv[2] == "entries":
        write_entries(commands, symbols)
        return
    if sys.argv[2] == "recorded":
        for command in commands:
            if command.name in supported:
                print(command.recording(symbols), command.name)
        return
    found = supported | set(find_calls(commands, supported))
    for command in commands:
        print("yes" if command.name in found else "no", command.name)


main()
