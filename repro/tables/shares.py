"""Headings that mean something together: 25 % and 0.75 among statistics, better beside worse."""

import re
from collections.abc import Iterable
from fractions import Fraction

from repro.tables.headings import statistics_in

_SHARE = re.compile(
    r"(?:(?P<percent>[0-9]{1,2}(?:\.[0-9])?)\s?%|0?(?P<part>\.[0-9]{1,3}))"
    r"(?:\s?(?:quantile|percentile))?",
    re.IGNORECASE,
)
_NAMED = {Fraction(1, 4): "q1", Fraction(1, 2): "median", Fraction(3, 4): "q3"}
_TALLIES = {
    "wins": re.compile(r"\(?\+\)?|w|wins?|won|better|superior|胜", re.IGNORECASE),
    "ties": re.compile(
        r"\(?[=≈~]\)?|[td]|ties?|tied|draws?|equals?|similar|same|no\sdifference|平", re.IGNORECASE
    ),
    "losses": re.compile(r"\(?-\)?|l|loss(?:es)?|lost|worse|inferior|负", re.IGNORECASE),
}
_HALF = Fraction(1, 2)


def quantile_words(labels: Iterable[str]) -> dict[str, str]:
    """Return which labels are quantiles: shares below and above a half, beside other statistics.

    As pandas describes a frame: mean, std, min, 25%, 50%, 75%, max.
    """
    distinct = dict.fromkeys(labels)
    shares = {label: share for label in distinct if (share := share_of(label)) is not None}
    beside = any(statistics_in(label)[0] for label in distinct if label not in shares)
    around = any(share < _HALF for share in shares.values()) and max(shares.values()) > _HALF
    return {label: _word(share) for label, share in shares.items()} if beside and around else {}


def tally_words(labels: Iterable[str]) -> dict[str, str]:
    """Return which labels head wins, ties and losses: words or signs that stand side by side."""
    found = {
        label: name
        for label in dict.fromkeys(labels)
        for name, pattern in _TALLIES.items()
        if pattern.fullmatch(label.strip())
    }
    names = sorted(found.values())
    words = any(len(label) > 1 for label in found)  # W and L alone may be a width and a length
    is_whole = names == ["losses", "ties", "wins"] or (words and names == ["losses", "wins"])
    return found if is_whole else {}


def share_of(label: str) -> Fraction | None:
    """Return the share that a heading is, above 0 and below 1; None where it is none."""
    match = _SHARE.fullmatch(label.strip())
    if match is None:
        return None
    share = Fraction(match["percent"]) / 100 if match["percent"] else Fraction("0" + match["part"])
    return share if 0 < share < 1 else None


def _word(share: Fraction) -> str:
    return _NAMED.get(share) or f"q{float(100 * share):04.1f}".removesuffix(".0")
