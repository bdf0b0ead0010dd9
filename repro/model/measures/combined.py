"""Measures made of others, which vary with them: ratios, means, formulas, equality."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from repro.errors import DeclarationError
from repro.model.evidence import Cell, Evidence
from repro.model.measures.measure import Measure, Measured, fewest_repeats
from repro.tables.formulas import check_formula, worked_out

Vector = NDArray[np.float64]


@dataclass(frozen=True, slots=True, kw_only=True)
class Ratio:
    """How many times `of` is as large as `to`."""

    of: Measure
    to: Measure

    @property
    def words(self) -> str:
        """What is measured, as a phrase."""
        return f"{self.of.words}, over {self.to.words}"

    @property
    def follows(self) -> bool:
        """Whether either side does."""
        return self.of.follows or self.to.follows

    def cells(self) -> tuple[Cell, ...]:
        """Return the cells of both sides."""
        return self.of.cells() + self.to.cells()

    def measure(self, evidence: Evidence) -> Measured:
        """Return the ratio in the first repeat and in tables to come; equal numbers give 1."""
        return _made_of((self.of, self.to), evidence, _ratio)


@dataclass(frozen=True, slots=True, kw_only=True)
class MeanOf:
    """The average of several measures, such as one algorithm's means over all problems."""

    parts: tuple[Measure, ...]

    def __post_init__(self) -> None:
        """Raise DeclarationError where nothing is averaged."""
        if not self.parts:
            message = "a mean of no measures"
            raise DeclarationError(message)

    @property
    def words(self) -> str:
        """What is measured, as a phrase."""
        return f"mean of {'; '.join(part.words for part in self.parts)}"

    @property
    def follows(self) -> bool:
        """Whether any part does."""
        return any(part.follows for part in self.parts)

    def cells(self) -> tuple[Cell, ...]:
        """Return the cells of all parts."""
        return tuple(cell for part in self.parts for cell in part.cells())

    def measure(self, evidence: Evidence) -> Measured:
        """Return the mean in the first repeat and in tables that may come next."""
        return _made_of(self.parts, evidence, lambda values: np.mean(values, axis=0))


@dataclass(frozen=True, slots=True, kw_only=True)
class EqualTo:
    """Whether two measures are one number: 1 where they are `within` of each other, else 0."""

    one: Measure
    other: Measure
    within: float = 0.0

    @property
    def words(self) -> str:
        """What is measured, as a phrase."""
        apart = f" within {self.within:g}" if self.within else ""
        return f"1 where {self.one.words} equals {self.other.words}{apart}, else 0"

    @property
    def follows(self) -> bool:
        """Whether either side does."""
        return self.one.follows or self.other.follows

    def cells(self) -> tuple[Cell, ...]:
        """Return the cells of both sides."""
        return self.one.cells() + self.other.cells()

    def measure(self, evidence: Evidence) -> Measured:
        """Return 1 or 0 in the first repeat and in tables that may come next."""
        return _made_of((self.one, self.other), evidence, self._equal)

    def _equal(self, values: Sequence[Vector]) -> Vector:
        one, other = values  # two infinite costs are equal, and their difference is no number
        return np.where((one == other) | (np.abs(one - other) <= self.within), 1.0, 0.0)


@dataclass(frozen=True, slots=True, kw_only=True)
class Combined:
    """What a formula makes of several measures, in SI units: "100 * (old - new) / old".

    The formula has + - * / ( ) sqrt, numbers, and the names of its `parts`, (name, measure) each;
    `combined` makes one of keywords. Where a table gives no number, as from the root of one below
    0, it is taken as infinite, on either side in turn.
    """

    formula: str
    parts: tuple[tuple[str, Measure], ...]

    def __post_init__(self) -> None:
        """Raise DeclarationError where the text is no formula of these names."""
        check_formula(self.formula, (name for name, _ in self.parts))

    @property
    def words(self) -> str:
        """What is measured, as a phrase."""
        named = "; ".join(f"{name} is {part.words}" for name, part in self.parts)
        return f"{self.formula}, where {named}"

    @property
    def follows(self) -> bool:
        """Whether any part does."""
        return any(part.follows for _, part in self.parts)

    def cells(self) -> tuple[Cell, ...]:
        """Return the cells of all parts."""
        return tuple(cell for _, part in self.parts for cell in part.cells())

    def measure(self, evidence: Evidence) -> Measured:
        """Return the value in the first repeat and in tables that may come next."""
        return _made_of([part for _, part in self.parts], evidence, self._value)

    def _value(self, values: Sequence[Vector]) -> Vector:
        names: Mapping[str, Vector] = dict(zip((n for n, _ in self.parts), values, strict=True))
        return worked_out(self.formula, names, number=_constant, root=np.sqrt)


def combined(formula: str, **parts: Measure) -> Combined:
    """Return what a formula makes of measures, each under its name."""
    return Combined(formula=formula, parts=tuple(parts.items()))


def _ratio(values: Sequence[Vector]) -> Vector:
    of, to = values
    return np.where(of == to, 1.0, of / to)  # also of two zeros, and of two infinite costs


def _constant(number: Fraction) -> Vector:
    return np.array(float(number))


def _made_of(
    parts: Sequence[Measure], evidence: Evidence, make: Callable[[Sequence[Vector]], Vector]
) -> Measured:
    """Return what `make` gives of the values, and of the draws of all parts table by table."""
    found = [part.measure(evidence) for part in parts]
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        value = make([np.array([part.value]) for part in found])
        draws = make(_side_by_side([part.draws for part in found]))
    return Measured(
        value=float(_known(value)[0]),
        draws=_known(draws),
        repeats=fewest_repeats(*found),
        thin=any(part.thin for part in found),
    )


def _known(values: Vector) -> Vector:
    """Return the values; one that is no number is as far off as can be, on either side in turn."""
    ends = np.where(np.arange(values.size) % 2, -np.inf, np.inf)
    return np.where(np.isnan(values), ends, values)


def _side_by_side(draws: Sequence[Vector]) -> list[Vector]:
    """Return as many draws of each part as all of them have; a part that does not vary has one."""
    fewest = min((len(each) for each in draws if len(each) > 1), default=1)
    return [each[:fewest] if len(each) > 1 else np.repeat(each, fewest) for each in draws]
