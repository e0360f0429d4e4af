"""HTML of the project's documents, for the site of `make docs` and for the lessons' web pages: Markdown by
markdown-it, colours of source text by Pygments."""

import re
import sys

sys.dont_write_bytecode = True  # no files in the folder of sources
import formulas  # noqa: E402

try:
    import pygments
    from markdown_it import MarkdownIt
    from markdown_it.renderer import RendererHTML
    from pygments.formatters import HtmlFormatter
    from pygments.lexers import get_lexer_by_name
except ImportError as absent:
    sys.exit(f"{absent}: 'make setup' installs Debian's packages python3-markdown-it and python3-pygments")


def source(text, language):
    """Source text with its tokens marked, none over the end of a line; plain in a language without colours here."""
    lexer = get_lexer_by_name(language if language in ("c", "glsl", "python") else "text", stripnl=False)
    return pygments.highlight(text, lexer, HtmlFormatter(nowrap=True))


MARKDOWN = MarkdownIt("commonmark", {"html": False, "highlight": lambda text, language, _: source(text, language)})
MARKDOWN.enable("table")


def fence(self, tokens, i, options, env):
    """A fenced block: a formula if it says math, otherwise source text."""
    return formulas.mathml(tokens[i].content) if tokens[i].info == "math" else RendererHTML.fence(self, tokens, i, options, env)


MARKDOWN.add_render_rule("fence", fence)


def anchor(heading):
    """The name of a heading in links, as GitHub has it."""
    return re.sub(r"[^a-z0-9 _-]", "", heading.lower()).replace(" ", "-")


def parse(text, link):
    """The tokens of a document. Headings have their anchors. Links and pictures lead to link(target, line),
    or are text if that is None."""
    tokens = MARKDOWN.parse(text)
    for before, token in zip([None, *tokens], tokens):
        parts = token.children or []
        if before and before.type == "heading_open":
            before.attrSet("id", anchor(token.content))
        for i, part in enumerate(parts):
            name = {"link_open": "href", "image": "src"}.get(part.type)
            target = link(part.attrGet(name), (token.map or [0])[0] + 1) if name else None
            if target:
                part.attrSet(name, target)
            elif name:
                end = next((other for other in parts[i:] if other.type == "link_close"), part)
                part.type = end.type = "text"
    return tokens


def blocks(tokens):
    """The tokens of each heading, paragraph, list and so on of a document, as lists."""
    result = []
    for token in tokens:
        if token.level == 0 and token.nesting >= 0:
            result.append([])
        result[-1].append(token)
    return result


def words(token):
    """The text of a heading or a paragraph, without marks."""
    return "".join(" " if part.type == "softbreak" else part.content for part in token.children)


def html(tokens):
    return MARKDOWN.renderer.render(tokens, MARKDOWN.options, {})
