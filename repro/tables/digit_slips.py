"""One slip in a printed number: a digit changed, lost or added, or two digits exchanged."""

import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import combinations

from repro.tables.markup import plain
from repro.tables.published import Printed

DIGITS = "0123456789"
_WHOLE = re.compile(r"[-+]?\d+(\.\d+)?")  # what a mantissa looks like; a multiple of π has none


@dataclass(frozen=True, slots=True)
class Slip:
    """What may have been meant, and what would have gone wrong."""

    meant: Printed
    words: str


def slips(printed: Printed) -> Iterator[Slip]:
    """Yield every number that one slip turns into the printed one, each once."""
    body, mantissa = plain(printed.text), printed.mantissa
    power = "" if printed.power is None else f"e{printed.power}"
    rest = body.removeprefix(mantissa) if body.startswith(mantissa) else power
    seen = {mantissa}
    for text, words in (
        *_changed(mantissa),
        *_exchanged(mantissa),
        *_lost(mantissa),
        *_added(mantissa),
    ):
        if text not in seen and _WHOLE.fullmatch(text):
            seen.add(text)
            yield Slip(replace(printed, text=text + rest), words)


def _changed(mantissa: str) -> Iterator[tuple[str, str]]:
    for i, mark in enumerate(mantissa):
        if mark.isdigit():
            for digit in DIGITS:
                yield mantissa[:i] + digit + mantissa[i + 1 :], "one digit changed"


def _exchanged(mantissa: str) -> Iterator[tuple[str, str]]:
    places = [i for i, mark in enumerate(mantissa) if mark.isdigit()]
    for (k, i), (m, j) in combinations(enumerate(places), 2):
        marks = list(mantissa)
        marks[i], marks[j] = marks[j], marks[i]
        yield "".join(marks), f"two {'neighbouring ' if m == k + 1 else ''}digits exchanged"


def _lost(mantissa: str) -> Iterator[tuple[str, str]]:
    """Yield what loses a decimal on the way to the print; a lost digit before the point shows."""
    point = mantissa.find(".")
    for i in range(point + 1, len(mantissa) + 1) if point >= 0 else ():
        for digit in DIGITS:
            yield mantissa[:i] + digit + mantissa[i:], "one digit lost"


def _added(mantissa: str) -> Iterator[tuple[str, str]]:
    for i, mark in enumerate(mantissa):
        if mark.isdigit():
            yield mantissa[:i] + mantissa[i + 1 :], "one digit too many"
