"""What a caller tells of a table, and what is guessed where nothing is told."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Literal

from repro.tables.blocks import FunctionBounds

SPREADS = ("std", "variance", "sem")
TESTS = ("ranksum", "signedrank")
TIES = ("average", "min", "max", "dense", "ordinal")
PRECISIONS = ("single", "double")


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
    """What is taken for granted: a line, and the option that overrides it with its value now."""

    says: str
    option: str = ""
    value: str = ""
    choices: tuple[str, ...] = ()
