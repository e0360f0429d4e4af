"""Finds the places of C sources that `make mutants` changes, and changes one. It reads tokens, not
syntax, and relies on the layout of .clang-format: a binary operator has white space on both sides, a
pointer's star only before it. What does not compile is drawn again.

usage: mutate.py --list SEED FILE...
       mutate.py --apply FILE PLACE LENGTH REPLACEMENT
--list prints every mutation of the files, one a line, with tabs between: a number that depends on the
seed (sorted by it, mutations stand in a random order), file, line, function, place, length,
replacement, the line before, the line after. --apply prints the file with one of them."""

import re
import sys

TOKENS = re.compile(
    r"(?P<skip>\s+|/\*.*?\*/|//[^\n]*|^[ \t]*#(?:[^\n\\]|\\.)*)|(?P<name>[A-Za-z_]\w*)"
    r"|(?P<number>\.?[0-9](?:[eEpP][+-]|[\w.])*)|(?P<text>\"(?:[^\"\\]|\\.)*\"|'(?:[^'\\]|\\.)*')"
    r"|(?P<sign><<=|>>=|\.\.\.|->|\+\+|--|<<|>>|[<>=!+\-*/%&|^]=|&&|\|\||.)", re.S | re.M)

BINARY = {"+": "-", "-": "+", "*": "+", "/": "*", "%": "/", "<<": ">>", ">>": "<<", "&": "|", "|": "&",
          "^": "|", "&&": "||", "||": "&&", "==": "!=", "!=": "==", "+=": "-=", "-=": "+=", "*=": "+=",
          "/=": "*=", "%=": "/=", "<<=": ">>=", ">>=": "<<=", "|=": "&=", "&=": "|=", "^=": "|=",
          "<": "<= >=", ">": ">= <=", "<=": "< >", ">=": "> <"}
UNARY = {"!": "", "-": "", "~": "", "++": "--", "--": "++"}
TYPES = set("const static struct union enum unsigned int float uint32_t char bool double volatile void "
            "size_t typedef".split())
KEYWORDS = set("if for while switch do else case default goto".split())
MASK = (1 << 64) - 1


def spread(x):
    """Spreads the bits of a number (David Stafford's variant 13 of MurmurHash3's finaliser)."""
    x = (x ^ x >> 30) * 0xBF58476D1CE4E5B9 & MASK
    x = (x ^ x >> 27) * 0x94D049BB133111EB & MASK
    return x ^ x >> 31


def hashed(number, text):
    for c in text:
        number = (number ^ ord(c)) * 0x100000001B3 & MASK
    return number


def read(file):
    try:
        with open(file, encoding="latin-1", newline="") as f:
            return f.read()
    except OSError:
        sys.exit("mutate: %s cannot be read" % file)


class Source:
    seen = {}  # how often a mutation's text has stood in a function

    def __init__(self, file, seed):
        self.file, self.seed, self.function = file, seed, "-"
        self.text = read(file)
        found = [t for t in TOKENS.finditer(self.text) if t.lastgroup != "skip"]
        self.at = [t.start() for t in found]
        self.end = [t.end() for t in found]
        self.kind = [t.lastgroup for t in found]
        # Beyond the last token there are empty ones.
        self.word = [t.group() for t in found] + [""] * 4
        self.partner = [0] * len(self.word)
        opened = []
        for i, word in enumerate(self.word):
            if word and word in "([{":
                opened.append(i)
            elif word and word in ")]}" and opened:
                self.partner[i] = opened.pop()
                self.partner[self.partner[i]] = i

    def mutation(self, at, end, replacement):
        """Prints a mutation. Its number depends on the seed and on the texts alone, so that changes
        elsewhere change no other mutation's turn."""
        begin = self.text.rfind("\n", 0, at) + 1
        last = (self.text + "\n").find("\n", end)
        before = " ".join(self.text[begin:last].split())
        after = " ".join((self.text[begin:at] + replacement + self.text[end:last]).split())
        key = "%s %s %s %s" % (self.file, self.function, before, after)
        times = self.seen[key] = self.seen.get(key, 0) + 1
        if times > 1:
            after += " /* %d */" % times
        number = spread(hashed(spread(self.seed), key) + times & MASK)
        line = self.text.count("\n", 0, at) + 1
        print("%016x" % number, self.file, line, self.function, at, end - at, replacement, before, after,
              sep="\t")

    def replace(self, i, replacement):
        self.mutation(self.at[i], self.end[i], replacement)

    def mutate_sign(self, i):
        word = self.word[i]
        if self.text[self.at[i] - 1].isspace() and self.text[self.end[i]].isspace():
            for other in BINARY.get(word, "").split():
                self.replace(i, other)
        elif word in UNARY:
            self.replace(i, UNARY[word])

    def mutate_number(self, i):
        word = self.word[i]
        is_hexadecimal = word.startswith("0x")
        if "." in word or any(c in word for c in ("pP" if is_hexadecimal else "eE")):
            suffix = "f" if word.endswith("f") else ""
            value = word.rstrip("fF")
            if (float.fromhex(value) if is_hexadecimal else float(value)) == 0:
                self.replace(i, "1.0" + suffix)
            else:
                self.replace(i, "0.0" + suffix)
                self.replace(i, "(%s * 1.001%s)" % (word, suffix))
        else:
            self.replace(i, "(%s + 1)" % word)
            if word.strip("0xXuUlL"):
                self.replace(i, "(%s - 1)" % word)

    def is_declaration(self, i):
        if self.word[i] in TYPES:
            return True
        if self.kind[i] != "name" or self.word[i] == "return":
            return False
        return self.kind[i + 1] == "name" or (
            self.word[i + 1] == "*" and not self.text[self.end[i + 1]].isspace())

    def end_of_statement(self, i):
        while i < len(self.at) and self.word[i] != ";":
            if self.word[i] in ")]}":
                return 0
            i = (self.partner[i] if self.word[i] in "([{" else i) + 1
        return i if i < len(self.at) else 0

    def leave_out(self, i):
        """Leaves a statement out. A function's last `return` stays: without it the result is
        undefined."""
        end = self.end_of_statement(i)
        is_cast_to_void = self.word[i] == "(" and self.word[i + 1] == "void"
        if end in (0, i) or self.word[i] in KEYWORDS or self.is_declaration(i) or is_cast_to_void:
            return
        if self.word[i] == "return" and self.word[end + 1] in ("}", "case", "default"):
            return
        self.mutation(self.at[i], self.at[end], "")

    def begins_statement(self, i):
        if self.kind[i] != "name" and self.word[i] not in ("*", "(", "++", "--"):
            return False
        before = self.word[i - 1]
        if before in (";", "{", "}", "else", "do"):
            return True
        if before == ":":  # after `case X:`, not in a choice `a ? b : c`
            return self.word[i - 2] == "default" or self.word[i - 3] == "case"
        opened = self.partner[i - 1]
        return before == ")" and opened > 0 and self.word[opened - 1] in ("if", "for", "while", "switch")

    def kind_of_braces(self, i, outer):
        """Tells what the braces hold that open here, inside those of the kinds `outer`."""
        before = self.word[i - 1]
        if outer and outer[-1] != "block":
            return outer[-1]
        if before == "=":
            return "initialiser"
        if before == ")":
            opened = self.partner[i - 1]
            is_block = opened > 0 and self.kind[opened - 1] == "name" and self.word[opened - 1] != "return"
            return "block" if is_block else "initialiser"
        if outer:
            return "block" if before in ("else", "do", "{", "}", ";", ":") else "initialiser"
        return "type"

    def name_of_object(self, i):
        """The identifier before `=` or before the dimensions."""
        while self.word[i - 1] == "]":
            i = self.partner[i - 1]
        return self.word[i - 1]

    def mutate_token(self, i, in_dimensions):
        word, kind = self.word[i], self.kind[i]
        if kind == "number" and not in_dimensions:
            self.mutate_number(i)
        elif kind == "sign":
            self.mutate_sign(i)
        elif word in ("true", "false"):
            self.replace(i, "false" if word == "true" else "true")
        elif word in ("if", "while") and self.word[i + 1] == "(":
            begin, end = self.end[i + 1], self.at[self.partner[i + 1]]
            self.mutation(begin, end, "!(%s)" % " ".join(self.text[begin:end].split()))

    def list(self):
        outer, parentheses, dimensions_end, is_declared = [], 0, 0, False
        i = 1
        while i < len(self.at):
            word = self.word[i]
            is_code = outer and outer[-1] != "type"
            if "static_assert" in word.lower() and self.word[i + 1] == "(":
                i = self.partner[i + 1] + 1
                continue
            if is_code and outer[-1] == "block" and parentheses == 0 and self.begins_statement(i):
                is_declared = self.is_declaration(i)
                self.leave_out(i)
            if word == "=" and parentheses == 0:
                is_declared = False
            if word == "[" and is_declared and parentheses == 0:
                dimensions_end = self.partner[i]
            if word == "(":
                parentheses += 1
            elif word == ")":
                parentheses -= 1
            elif word == "{":
                kind = self.kind_of_braces(i, outer)
                if not outer and kind == "block":
                    self.function = self.word[self.partner[i - 1] - 1]
                elif not outer and kind == "initialiser":
                    self.function = self.name_of_object(i - 1)
                outer.append(kind)
            elif word == "}" and outer:
                outer.pop()
            elif is_code:
                self.mutate_token(i, i < dimensions_end)
            i += 1


def main(arguments):
    if arguments == ["--help"]:
        print(__doc__)
    elif len(arguments) >= 3 and arguments[0] == "--list":
        for file in arguments[2:]:
            Source(file, int(arguments[1]) & MASK).list()
    elif len(arguments) == 5 and arguments[0] == "--apply":
        text, at, length = read(arguments[1]), int(arguments[2]), int(arguments[3])
        changed = text[:at] + arguments[4] + text[at + length:]
        sys.stdout.buffer.write(changed.encode("latin-1"))
    else:
        sys.exit(__doc__)


main(sys.argv[1:])
