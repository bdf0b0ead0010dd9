"""The first use of each word of the glossary on a page, and sources named there, as links."""

import re
from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from typing import NamedTuple
from urllib.parse import quote

from markupsafe import Markup

from repro.report.glossary import Term, glossary

_ASIDE = (
    "a|h[1-6]|code|pre|math|svg|script|style|head|header|nav|button|summary|label|select|legend|th"
)
# what is no running text, whole; then every other tag
_TAG = re.compile(
    rf'<(?P<name>{_ASIDE})\b.*?</(?P=name)>|<(?:td class="claim"|p class="panel-title").*?</'
    r"|<(?P<close>/?)(?P<kind>details|div)\b(?P<own>[^>]*)>|<[^>]*>",
    re.DOTALL,
)
# fenced and inline code, formulas, headings, heads of tables, pictures, links and tags
_MARKDOWN = re.compile(
    r"^```.*?^```|`[^`\n]*`|\$\$.*?\$\$|\$[^$\n]*\$|^#[^\n]*|^\|[^\n]*\|\n(?=\|(?: --- \|)+\n)"
    r"|!?\[[^\]\n]*\]\([^)\n]*\)|<[^>\n]*>",
    re.DOTALL | re.MULTILINE,
)
_SOURCE = re.compile(
    r"doi:(10\.\d{4,9}/(?:\([\w.]*\)|[\w:./-])*(?:\([\w.]*\)|\w))|arXiv:(\d{4}\.\d{4,5})"
)
Links = dict[tuple[int, int], tuple[str, str]]
"""Where a link goes and its class, by start and end of its text."""


class Explained(NamedTuple):
    """A page with its links, and the words that it links to."""

    page: Markup
    terms: tuple[Term, ...]


class _Piece(NamedTuple):
    """Running text of a page from `start` on; `folded` where it is not in sight at once."""

    start: int
    text: str
    folded: bool


def first_uses(page: str, *, markdown: bool, place: str | None = None) -> Explained:
    """Return a page with a link at the first use of each word of the glossary, and at each source.

    What is in sight goes before what is folded. `place` is where the words are explained, with what
    stands before their names there; None is the glossary's own page.
    """
    where = f"glossary.{'md' if markdown else 'html'}#" if place is None else place
    pieces = tuple(_pieces_of_markdown(page) if markdown else _pieces_of_html(page))
    sources = _sources(pieces)
    uses = _uses(pieces)
    words = {span: (f"{where}{term.anchor}", "term") for term, span in uses.items()}
    terms = tuple(term for term in glossary().terms if term in uses)
    return Explained(Markup(_linked(page, sources | words, markdown=markdown)), terms)  # noqa: S704


def with_sources(page: str, *, markdown: bool) -> str:
    """Return a page with a link at each source, without those of the glossary."""
    pieces = _pieces_of_markdown(page) if markdown else _pieces_of_html(page)
    return _linked(page, _sources(pieces), markdown=markdown)


def _linked(page: str, links: Links, *, markdown: bool) -> str:
    parts, end = [], 0
    for span, (address, kind) in sorted(links.items()):
        text = page[slice(*span)]
        named = f' class="{kind}"' if kind else ""
        link = f"[{text}]({address})" if markdown else f'<a{named} href="{address}">{text}</a>'
        parts += [page[end : span[0]], link]
        end = span[1]
    return "".join((*parts, page[end:]))


def _uses(pieces: Iterable[_Piece]) -> Mapping[Term, tuple[int, int]]:
    """Return where each word that is used is used first."""
    pattern, terms = _forms()
    found: dict[Term, tuple[int, int]] = {}
    for piece in sorted(pieces, key=lambda piece: piece.folded):
        for use in pattern.finditer(piece.text):
            words = " ".join(use[0].lower().split())
            span = (piece.start + use.start(), piece.start + use.end())
            found.setdefault(terms[words], span)
    return found


@cache
def _forms() -> tuple[re.Pattern[str], Mapping[str, Term]]:
    """Return what finds any written form of a word, and the word of each form."""
    terms = {form.lower(): term for term in glossary().terms for form in term.written}
    longest_first = sorted(terms, key=len, reverse=True)
    either = "|".join(re.escape(form).replace(r"\ ", r"\s+") for form in longest_first)
    return re.compile(rf"(?<![\w/.#-])(?:{either})(?![\w-])", re.IGNORECASE), terms


def _sources(pieces: Iterable[_Piece]) -> Links:
    return {
        (piece.start + named.start(), piece.start + named.end()): (_address(named), "")
        for piece in pieces
        for named in _SOURCE.finditer(piece.text)
    }


def _address(named: re.Match[str]) -> str:
    doi, arxiv = named.groups()
    # brackets are escaped, so that they end no link of Markdown
    return f"https://doi.org/{quote(doi, safe='/:')}" if doi else f"https://arxiv.org/abs/{arxiv}"


def _pieces_of_markdown(page: str) -> Iterator[_Piece]:
    end = 0
    for other in _MARKDOWN.finditer(page):
        yield _Piece(end, page[end : other.start()], folded=False)
        end = other.end()
    yield _Piece(end, page[end:], folded=False)


def _pieces_of_html(page: str) -> Iterator[_Piece]:
    """Yield running text; nothing of a part that waits for its script."""
    folds = hidden = end = 0
    for tag in _TAG.finditer(page):
        if not hidden:
            yield _Piece(end, page[end : tag.start()], folded=folds > 0)
        end = tag.end()
        step = -1 if tag["close"] else 1
        if tag["kind"] == "details":
            folds += step
        elif tag["kind"] == "div" and (hidden or re.search(r"\shidden\b", tag["own"])):
            hidden += step
    yield _Piece(end, page[end:], folded=False)
