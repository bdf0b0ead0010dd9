"""What a paper is called in a sentence: first author and year, or the head of its title."""

import re

from repro.model.paper import Source

_TWO = 2
_LONG = 42  # characters of a title, which fit beside a room's in the bar of a page
_LEADS_ON = {"a", "an", "and", "based", "by", "for", "in", "of", "on", "the", "to", "using", "with"}


def cited(key: str, source: Source) -> str:
    """Return "Liang et al. (2026)"; the key's year where the copy at hand prints none.

    A source that names nobody is called by the first words of its title, in quotes.
    """
    own = re.search(r"(\d{4})\D*$", key)
    year = source.year or (own and own[1])
    called = _first_authors(source) or f"“{_head(source.title)}”"
    return f"{called} ({year})" if year else called


def _first_authors(source: Source) -> str:
    """Return "Liang et al." or "Doe and Roe"; nothing where nobody is named."""
    authors = re.split(r",|;|\band\b|\bet\b|&", source.authors)
    names = [name.split()[-1] for name in authors if name.split()]
    if not names or not names[0][0].isupper():  # "authors not on the copy" names nobody
        return ""
    others = len(names) > _TWO or names[-1] == "al."
    return f"{names[0]} et al." if others else " and ".join(names)


def _head(title: str) -> str:
    """Return a title up to where it is long, cut before a word and behind none that leads on."""
    if len(title) <= _LONG:
        return title
    words = (title[:_LONG].rpartition(" ")[0] or title).split()
    while len(words) > 1 and words[-1].lower() in _LEADS_ON:
        words.pop()
    head = " ".join(words).rstrip(",;:")
    return head if head == title else f"{head} …"
