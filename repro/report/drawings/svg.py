"""From a matplotlib figure to an SVG element that a page can hold inline."""

import io
import re
from html import escape

from matplotlib.figure import Figure

from repro.errors import InputError

POINTS_PER_INCH = 72
WIDEST = "42rem"  # the text in a drawing then stands at about the size of the page's text
INK = "#1a1a1a"
_UNWANTED = re.compile(r"<metadata>.*?</metadata>|<!--.*?-->|<style.*?</style>", re.DOTALL)
_COORDINATES = re.compile(r'(?<= )(d|x|y|width|height|transform)="([^"]*)"')
_LONG_DECIMAL = re.compile(r"-?\d+\.\d{2,}")


def inline_svg(canvas: Figure, *, identifier: str, title: str, description: str) -> str:
    """Return the figure as one `<svg>` element that takes its text colour from the page.

    Every id starts with `identifier`, so that several drawings fit in one page; black becomes
    `currentColor`. InputError where the identifier is not a letter followed by letters, digits,
    hyphens, dots or underscores.
    """
    if not re.fullmatch(r"[A-Za-z][\w.-]*", identifier, re.ASCII):
        message = f"{identifier!r} cannot be an identifier: give a letter, then letters or digits"
        raise InputError(message)
    text = io.StringIO()
    canvas.savefig(
        text, format="svg", metadata=dict.fromkeys(("Creator", "Date", "Format", "Type"))
    )
    body = text.getvalue().partition("<svg ")[2].partition(">")[2]
    width, height = canvas.get_size_inches() * POINTS_PER_INCH
    body = _prefixed(_rounded(_UNWANTED.sub("", body)), identifier)
    body = body.replace("#000000", "currentColor").replace("xlink:href", "href")
    body = re.sub(r"font: (\S+) [^;\"]*", r"font-size: \1", body)
    body = re.sub(r"\s*\n\s*", "\n", body)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:g} {height:g}" '
        f'width="100%" style="max-width: {WIDEST}" role="img" '
        f'aria-labelledby="{identifier}-title {identifier}-desc" fill="currentColor" '
        'font-family="sans-serif" stroke-linejoin="round" stroke-linecap="butt">\n'
        f'<title id="{identifier}-title">{escape(title)}</title>\n'
        f'<desc id="{identifier}-desc">{escape(description)}</desc>{body}'
    )


def standalone(svg: str) -> str:
    """Return an inline drawing as a file of its own, in dark ink on white whatever the page."""
    width, height = (1.6 * float(n) for n in re.findall(r'viewBox="0 0 (\S+) (\S+)"', svg)[0])
    return svg.replace(
        f'width="100%" style="max-width: {WIDEST}"',
        f'width="{width:g}" height="{height:g}" style="color: {INK}; background: #fff"',
        1,
    )


def _rounded(body: str) -> str:
    """Return the body with coordinates in tenths of a point: a sixth of a pixel, at its widest."""

    def short(decimal: re.Match[str]) -> str:
        return f"{float(decimal[0]):.1f}".rstrip("0").rstrip(".")

    def attribute(match: re.Match[str]) -> str:
        numbers = _LONG_DECIMAL.sub(short, match[2])
        return f'{match[1]}="{" ".join(numbers.split())}"'

    return _COORDINATES.sub(attribute, body)


def _prefixed(body: str, identifier: str) -> str:
    """Return the body with prefixed ids; an id to which nothing refers is dropped."""
    wanted = set(re.findall(r'(?:href="|url\()#([^")]+)', body))

    def identity(match: re.Match[str]) -> str:
        return f' id="{identifier}-{match[1]}"' if match[1] in wanted else ""

    body = re.sub(r' id="([^"]+)"', identity, body)
    return re.sub(r'(href="|url\()#', rf"\g<1>#{identifier}-", body)
