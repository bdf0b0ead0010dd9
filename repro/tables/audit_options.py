"""What a caller tells of a table, and what is guessed where nothing is told."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from types import MappingProxyType
from typing import Any, Literal

from repro.tables.blocks import FunctionBounds

SPREADS = ("std", "variance", "sem")
TESTS = ("ranksum", "signedrank")
TIES = ("average", "min", "max", "dense", "ordinal")
PRECISIONS = ("single", "double")
CHOICES: Mapping[str, Sequence[str]] = MappingProxyType(
    {"precision": PRECISIONS, "spread": SPREADS, "test": TESTS, "ties": TIES}
)
FLAGS = ("maximise", "errors", "integers")
NUMBERS = ("runs", "significant", "sided", "alpha")
_WHOLE = (("runs", 1, 10**9), ("significant", 1, 17), ("sided", 1, 2))


@dataclass(frozen=True, slots=True, kw_only=True)
class AuditOptions:
    """What is told of a table; None where it is left to a guess.

    `minimum` and `functions` are by name of a problem, "" for every one. `runs` is the number of
    runs behind each statistic, `errors` says that no value is below 0, `integers` that values are
    whole, `significant` how many digits every printed number was rounded to.
    """

    runs: int | None = None
    maximise: bool | None = None
    minimum: Mapping[str, Fraction] = field(default_factory=dict)
    functions: Mapping[str, FunctionBounds] = field(default_factory=dict)
    errors: bool = False
    integers: bool = False
    precision: Literal["single", "double"] | None = None
    significant: int | None = None
    spread: Literal["std", "variance", "sem"] | None = None
    test: Literal["ranksum", "signedrank"] | None = None
    sided: Literal[1, 2] | None = None
    alpha: float | None = None
    ties: Literal["average", "min", "max", "dense", "ordinal"] | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Guess:
    """What is taken for granted: a line, and the option that overrides it with its value now.

    What was `told` is no guess; it stands in the list for the option that changes it.
    """

    says: str
    option: str = ""
    value: str = ""
    choices: tuple[str, ...] = ()
    told: bool = False

    @property
    def kind(self) -> str:
        """What the line is, in a word."""
        return "told" if self.told else "guess"


def option_faults(given: Mapping[str, Any]) -> Iterator[str]:
    """Yield what is told by name and cannot be, with what can; None is not told."""
    told = {key: value for key, value in given.items() if value is not None}
    for key, choices in CHOICES.items():
        if key in told and told[key] not in choices:
            yield f"{key} {told[key]!r} is none of {', '.join(choices)}"
    for key, least, most in _WHOLE:
        if key in told and (type(told[key]) is not int or not least <= told[key] <= most):
            yield f"{key} {told[key]!r} is no whole number from {least} to {most}"
    alpha = told.get("alpha", 0.5)
    if isinstance(alpha, bool) or not (isinstance(alpha, int | float) and 0 < alpha < 1):
        yield f"alpha {alpha!r} does not lie between 0 and 1"
    for key in FLAGS:
        if key in told and not isinstance(told[key], bool):
            yield f"{key} {told[key]!r} is neither true nor false"
