"""Prints the names of the public headers that have no documentation in Doxygen's XML. A member or enumerator
without a comment is documented if the comment of its line, its type or its header is for it. Also prints rows
of tables that Doxygen takes for text, by their indentation or by what is before them.
usage: undocumented.py FOLDER   (from the root of the project)"""

import pathlib
import re
import sys
import xml.etree.ElementTree

LOST = re.compile(r"/\*\* [^@](?:(?!\*/).)*\n \*     +\S[^\n]*|\n \* \S[^\n]*\n \*     +\S[^\n]*|\n \*\n \* {2,4}\S[^\n]*", re.S)


def words(item):
    return "".join(text for name in ("briefdescription", "detaileddescription") for text in item.find(name).itertext()).strip()


def undocumented(compounds):
    headers = {item.find("location").get("file"): words(item) for item in compounds if item.get("kind") == "file"}
    for compound in compounds:
        file = compound.find("location").get("file")
        members = list(compound.iter("memberdef"))
        lines = {member.find("location").get("line") for member in members if words(member)}
        yield from [compound.findtext("compoundname")] * (not words(compound))
        for member in members:
            parts = [(value, words(member)) for value in member.iter("enumvalue")]
            if compound.get("kind") == "struct" and member.find("location").get("line") not in lines:
                parts.append((member, words(compound)))
            elif compound.get("kind") == "file" and not words(member):
                yield member.findtext("name")
            yield from (part.findtext("name") for part, comment in parts
                        if not words(part) and not re.search(rf"\b{part.findtext('name')}\b", comment + headers[file]))


found = [item for path in pathlib.Path(sys.argv[1]).glob("*.xml") for item in xml.etree.ElementTree.parse(path).iter("compounddef")
         if item.get("kind") in ("struct", "file") and item.find("location").get("file").endswith(".h")]
lost = [match[0] for path in pathlib.Path("include").rglob("*.h") for match in LOST.finditer(path.read_text(encoding="utf-8"))]
print("\n".join([*undocumented(found), *lost]) if len(found) > 30 else "there are no headers")
