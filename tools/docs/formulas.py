"""Sets formulas: TeX, as GitHub shows it in blocks of ```math, becomes MathML, which browsers show without help. A
small part of TeX is known; anything else is an error that names it."""

import re
from html import escape

TOKEN = re.compile(r"\\begin\{\w+\}|\\end\{\w+\}|\\[A-Za-z]+|\\.|\d+(?:\.\d+)?|\s+|.", re.DOTALL)

LETTERS = dict(alpha="α", beta="β", gamma="γ", theta="θ", lambda_="λ", Delta="Δ", pi="π", ell="ℓ")
OPERATORS = dict(cdot="⋅", times="×", le="≤", ge="≥", ne="≠", approx="≈", to="→", pm="±", lfloor="⌊", rfloor="⌋", vert="|",
                 dots="…", top="⊤", sum="∑", quad=" ")
FUNCTIONS = {"max", "min", "tan", "sin", "cos", "log", "det"}
TABLES = {"aligned": ("", ""), "cases": ("{", ""), "bmatrix": ("[", "]"), "pmatrix": ("(", ")")}


class Formula:
    """What is left of a formula's tokens, and the functions that turn it into MathML."""

    def __init__(self, tex):
        self.tokens = TOKEN.findall(tex)
        self.tex = tex

    def skip_space(self):
        while self.tokens and self.tokens[0].isspace():
            self.tokens.pop(0)

    def peek(self):
        self.skip_space()
        return self.tokens[0] if self.tokens else ""

    def take(self):
        self.skip_space()
        if not self.tokens:
            raise ValueError(f"the formula ends too early: {self.tex}")
        return self.tokens.pop(0)

    def raw_group(self):
        """The text of a group in braces, as it stands."""
        if self.take() != "{":
            raise ValueError(f"an opening brace is missing: {self.tex}")
        text = ""
        while self.tokens and self.tokens[0] != "}":
            text += self.tokens.pop(0)
        self.take()
        return text

    def row(self, ends):
        """Everything up to a token of `ends`, which stays."""
        parts = []
        while self.peek() and self.peek() not in ends:
            parts.append(self.scripted())
        return f"<mrow>{''.join(parts)}</mrow>"

    def argument(self):
        if self.peek() != "{":
            return self.atom()
        self.take()
        inner = self.row("}")
        self.take()
        return inner

    def scripted(self):
        base = self.atom()
        scripts = {}
        while self.peek() in ("^", "_"):
            mark = self.take()
            scripts[mark] = self.argument()
        if len(scripts) == 2:
            return f"<msubsup>{base}{scripts['_']}{scripts['^']}</msubsup>"
        if "^" in scripts:
            return f"<msup>{base}{scripts['^']}</msup>"
        return f"<msub>{base}{scripts['_']}</msub>" if scripts else base

    def table(self, kind):
        opening, closing = TABLES[kind]
        ends = ("&", "\\\\", "\\end{" + kind + "}")
        rows, cells = [], []
        while True:
            cells.append(f"<mtd>{self.row(ends)}</mtd>")
            end = self.take()
            if end != "&":
                rows.append(f"<mtr>{''.join(cells)}</mtr>")
                cells = []
            if end.startswith("\\end"):
                break
        fence = [f"<mo>{mark}</mo>" if mark else "" for mark in (opening, closing)]
        return f'<mrow>{fence[0]}<mtable class="{kind}">{"".join(rows)}</mtable>{fence[1]}</mrow>'

    def command(self, name):
        if name in LETTERS:
            return f"<mi>{LETTERS[name]}</mi>"
        if name == "quad":
            return '<mspace width="2em"></mspace>'
        if name in OPERATORS:
            return f"<mo>{OPERATORS[name]}</mo>"
        if name in FUNCTIONS:
            return f"<mi>{name}</mi>"
        if name == "frac":
            return f"<mfrac>{self.argument()}{self.argument()}</mfrac>"
        if name == "sqrt":
            return f"<msqrt>{self.argument()}</msqrt>"
        if name == "text":
            return f"<mtext>{escape(self.raw_group())}</mtext>"
        if name == "mathbf":
            return f'<mi mathvariant="bold">{escape(self.raw_group())}</mi>'
        raise ValueError(f"\\{name} is not known: {self.tex}")

    def atom(self):
        token = self.take()
        if token == "{":
            inner = self.row("}")
            self.take()
            return inner
        if token.startswith("\\begin"):
            return self.table(token[7:-1])
        if re.fullmatch(r"\\[A-Za-z]+", token):
            return self.command(token[1:])
        if token in ("\\,", "\\;", "\\ "):
            return '<mspace width="0.3em"></mspace>'
        if token[0].isdigit():
            return f"<mn>{token}</mn>"
        if token.isalpha():
            return f"<mi>{token}</mi>"
        if token.startswith("\\") or token in "}^_&":
            raise ValueError(f"{token} stands in a wrong place: {self.tex}")
        return f"<mo>{escape('−' if token == '-' else token)}</mo>"


def mathml(tex):
    """A formula as an element of its own."""
    formula = Formula(tex.strip())
    inner = formula.row(())
    return f'<math display="block">{inner}</math>\n'
