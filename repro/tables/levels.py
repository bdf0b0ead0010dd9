"""The level and the sides of tests, as options or a caption tell them."""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Literal

from repro.tables.audit_options import AuditOptions, Guess

USUAL = Fraction(1, 20)
_LEVEL = re.compile(
    r"(?:α|\balpha\b|\bsignifican\w*|\blevels?\b)[^0-9;.]{0,25}?(?:(?P<share>0?\.[0-9]+)|(?P<percent>[0-9.]+)\s?\\?%)"
    r"|(?P<before>[0-9.]+)\s?\\?%\s(?:significance\s)?level"
    r"|\bp\s?[<>≤≥]=?\s?(?P<bound>0?\.[0-9]+)",
    re.IGNORECASE,
)
_SIDES = re.compile(r"\b(?P<word>one|two|1|2)[-\s](?:sided|tailed)", re.IGNORECASE)


@dataclass(frozen=True, slots=True, kw_only=True)
class Level:
    """The level of the tests of a table, None where several are told, and the sides of p."""

    alpha: Fraction | None
    sides: Literal[1, 2] | None
    guesses: tuple[Guess, ...] = ()


def level_of(text: str, options: AuditOptions) -> Level:
    """Return at which level the tests of a table are, by its options, else by its caption."""
    guesses = []
    levels = set(_levels(text))
    if options.alpha is not None:
        alpha: Fraction | None = Fraction(str(options.alpha))
    elif len(levels) > 1:
        alpha = None
        guesses.append(Guess(says="the caption tells several levels of tests", option="alpha"))
    else:
        alpha = next(iter(levels), USUAL)
        origin = "from the caption" if levels else "as is usual"
        says = f"tests are at the level {float(alpha):g} {origin}"
        guesses.append(Guess(says=says, option="alpha", value=f"{float(alpha):g}"))
    sides = options.sided
    words = {match["word"].lower() for match in _SIDES.finditer(text)}
    if sides is None and len(words) == 1:
        sides = 1 if words <= {"one", "1"} else 2
        says = f"p is {'one' if sides == 1 else 'two'}-sided from the caption"
        guesses.append(Guess(says=says, option="sided", value=str(sides), choices=("1", "2")))
    return Level(alpha=alpha, sides=sides, guesses=tuple(guesses))


def _levels(text: str) -> Iterator[Fraction]:
    for match in _LEVEL.finditer(text):
        share = match["share"] or match["bound"]
        percent = match["percent"] or match["before"]
        try:
            level = Fraction(share) if share else Fraction(percent.strip(".")) / 100
        except ValueError:  # two points, as in a number of a section
            continue
        if 0 < level < 1:
            yield min(level, 1 - level)  # a level of 95 % is one of confidence
