"""Mathematics on the pages: MathML for browsers, LaTeX between dollars for Markdown."""

import re
from collections.abc import Iterable
from html import unescape
from xml.etree.ElementTree import Element, tostring

from jinja2 import pass_eval_context
from jinja2.nodes import EvalContext
from latex2mathml.converter import convert_to_element
from markupsafe import Markup, escape

from repro.errors import DeclarationError
from repro.model.identifiers import anchor
from repro.model.paper import Formula
from repro.report.escapes import markdown_text
from repro.report.words import raised

_ELEMENTS = {
    *("math", "mrow", "mi", "mn", "mo", "mtext", "mspace", "mstyle", "mtable", "mtr", "mtd"),
    *("msup", "msub", "msubsup", "mover", "munder", "munderover", "mfrac", "msqrt", "mroot"),
}
_ATTRIBUTES = {
    *("display", "displaystyle", "scriptlevel", "mathvariant", "width", "linethickness"),
    *("stretchy", "fence", "form", "separator", "movablelimits", "accent", "lspace", "rspace"),
    *("minsize", "maxsize", "columnalign", "rowspacing", "columnspacing"),
}
_PARTS = {  # how many parts an element must have
    **dict.fromkeys(("mfrac", "msup", "msub", "mover", "munder", "mroot"), 2),
    **dict.fromkeys(("msubsup", "munderover"), 3),
}
_PLAIN = re.compile(r"[\w.%+ -]*", re.ASCII)  # a value of an attribute that says only how to draw
_NUMBER = re.compile(r"\((\d+)\)(?:(?: to |-)(?=\((\d+)\)))?")  # (7), or (7) to before (9)
_POWER = re.compile(r"(?:(\d[\d.]*)×)?10\^(-?)(\d+)")
# What Markdown would take for its own, or for HTML, in words of LaTeX.
_IN_WORDS = {
    r"\\": r"\cr ",
    r"\{": r"\lbrace ",
    r"\}": r"\rbrace ",
    r"\|": r"\Vert ",
    "<": r"\lt ",
    ">": r"\gt ",
    "[": r"\lbrack ",
    "]": r"\rbrack ",
    "*": r"\ast ",
    "`": r"\text{'}",
}
_FOREIGN = re.compile(r"\\\\|\\[{}|]|[<>\[\]*`]")


def mathml(latex: str) -> Markup:
    """Return LaTeX as one MathML element that draws and does nothing else.

    Raises DeclarationError for what is not LaTeX, or would become more than a drawing: a link,
    a style, an identifier, an element that is not MathML's.
    """
    try:
        # the converter knows `aligned` under the name of what stands outside a formula alone
        tree = convert_to_element(latex.replace("{aligned}", "{align*}"), display="block")
    except Exception as error:  # noqa: BLE001 (the converter's errors share no class of their own)
        message = f"{latex!r} is no formula: {type(error).__name__} {error}".rstrip()
        raise DeclarationError(message) from None
    del tree.attrib["xmlns"]  # HTML knows the element by its name
    for element in tree.iter():
        _refuse_more_than_a_drawing(latex, element)
        # the converter leaves references to characters in the text; ElementTree escapes it anew
        element.text = unescape(element.text) if element.text else None
        if element.text == "|":  # a bar about a value, which is neither stretched nor set apart
            element.attrib |= {"stretchy": "false", "lspace": "0", "rspace": "0"}
    return Markup(tostring(tree, encoding="unicode"))  # noqa: S704 (escaped by ElementTree)


def _refuse_more_than_a_drawing(latex: str, element: Element) -> None:
    if element.tag not in _ELEMENTS:
        message = f"{latex!r} would make an element {element.tag!r}, which is not drawn here"
        raise DeclarationError(message)
    if len(element) != _PARTS.get(element.tag, len(element)):
        message = f"{latex!r}: {element.tag} has {len(element)} parts, not {_PARTS[element.tag]}"
        raise DeclarationError(message)
    for name, value in element.attrib.items():
        if name not in _ATTRIBUTES or not _PLAIN.fullmatch(value):
            message = f"{latex!r} would set {name}={value!r}, which only draws what a formula says"
            raise DeclarationError(message)
    if element.text and element.text.startswith("\\"):
        message = f"{latex!r}: {element.text} is no command of the converter"
        raise DeclarationError(message)


def dollars(latex: str) -> str:
    """Return LaTeX between dollars, on one line, in which Markdown and HTML find nothing.

    Raises DeclarationError where the formula holds a dollar itself.
    """
    if "$" in latex:
        message = f"{latex!r}: a dollar would end the formula"
        raise DeclarationError(message)
    text = _FOREIGN.sub(lambda match: _IN_WORDS[match[0]], " ".join(latex.split()))
    return f"${' '.join(text.split())}$"


def formula_anchor(formula: Formula) -> str:
    """Return the identifier of a formula on its page."""
    return anchor("equation", formula.label)


def equation_links(text: str, formulas: Iterable[Formula], page: str = "#") -> Markup:
    """Return text, safe for HTML, whose numbers of equations lead to the formulas on a page."""
    if not re.search(r"\bEqs?\. ", text):
        return escape(text)
    places = {number: formula_anchor(f) for f in formulas for number in _numbers(f.label)}

    def linked(match: re.Match[str]) -> str:
        place = places.get(int(match[1]))
        return f'<a href="{escape(page)}{place}">({match[1]})</a>' if place else match[0]

    return Markup(re.sub(r"\((\d+)\)", linked, str(escape(text))))  # noqa: S704 (escaped)


def _numbers(label: str) -> Iterable[int]:
    """Yield the numbers that a label names, those between the ends of a range among them."""
    for match in _NUMBER.finditer(label):
        first = int(match[1])
        yield from range(first, int(match[2] or first) + 1)


def powers(text: object) -> Markup:
    """Return text, safe for HTML, with its powers of ten as MathML."""
    return Markup(_POWER.sub(_power, str(escape(text))))  # noqa: S704 (escaped)


@pass_eval_context
def powers_of_ten(context: EvalContext, text: object) -> Markup:
    """Return text with its powers of ten raised: by MathML in HTML, by a tag in Markdown."""
    if context.autoescape:
        return powers(text)
    return raised(Markup(markdown_text(str(escape(text)))))  # noqa: S704 (escaped)


def _power(match: re.Match[str]) -> str:
    mantissa, minus, exponent = match.groups()
    before = f"<mn>{mantissa}</mn><mo>×</mo>" if mantissa else ""
    sign = "−" if minus else ""
    return f'<math class="power">{before}<msup><mn>10</mn><mn>{sign}{exponent}</mn></msup></math>'
