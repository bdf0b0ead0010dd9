"""Printed numbers recomputed from the printed numbers that they follow from."""

import itertools
import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from fractions import Fraction
from operator import itemgetter

from repro.tables.arithmetic import IN_DOUBLES
from repro.tables.digit_slips import slips
from repro.tables.formulas import worked_out
from repro.tables.published import UNITS, Printed
from repro.tables.relations import ByFormula, Equal, Number, Times
from repro.tables.rows import AuditRow, Grade, audit_row
from repro.tables.true_numbers import DOUBLES, SINGLES, Span, exact, root, span, unit

Formula = Callable[[Sequence[Span]], Span]
_NAME = re.compile(r"[A-Za-z_]\w*")
_WHOLE = re.compile(r"[-+]?\d+")
_ROOT_ERROR = Fraction(1, 10**25)  # of a root to 28 digits


@dataclass(frozen=True, slots=True, kw_only=True)
class Derivation:
    """How one printed number follows from others.

    `formula` may raise ZeroDivisionError, where nothing can be said; `written` is the arithmetic
    with a {} for each part. Where it is `exact`, whole numbers are not rounded; nor are counts and
    ranks ever, as parts, or as a result that is `whole` as they are. `alike` says that all are of
    one kind, so that ms and s may be mixed.
    """

    check: str
    result: Number
    parts: tuple[Number, ...]
    formula: Formula
    written: str
    exact: bool = False
    whole: bool = False
    alike: bool = False

    @property
    def mixed(self) -> bool:
        """Whether numbers of one kind are printed in several units."""
        units = {each.printed.unit for each in (self.result, *self.parts)}
        return self.alike and len(units) > 1 and "" not in units

    def span(self, printed: Printed, *, share: Fraction = DOUBLES, result: bool = False) -> Span:
        """Return what can stand behind a number: itself alone, where it is whole and exact."""
        counted = printed.unit == "count" or (printed.unit == "rank" and (self.whole or not result))
        around = number_span(printed, share=share, whole=self.exact or counted)
        return self._of_one_unit(around, printed)

    def point(self, printed: Printed) -> Span:
        """Return the number as if it were exact."""
        value = exact(printed.value)
        return self._of_one_unit(Span(value, value), printed)

    def agrees(self, share: Fraction) -> bool:
        """Say whether numbers behind the parts give one behind the result."""
        possible = self.formula([self.span(part.printed, share=share) for part in self.parts])
        return possible.meets(self.span(self.result.printed, share=share, result=True))

    def half_unit(self, printed: Printed) -> Fraction:
        """Return half a unit of the last digit of the result."""
        half = unit(printed) / 2
        return self._of_one_unit(Span(half, half), printed).high

    def _of_one_unit(self, around: Span, printed: Printed) -> Span:
        if not self.mixed:
            return around
        factor = exact(UNITS[printed.unit]) / exact(UNITS[self.result.printed.unit])
        return around * Span(factor, factor)


def number_span(printed: Printed, *, share: Fraction = DOUBLES, whole: bool = False) -> Span:
    """Return what can stand behind a number; where whole ones are `whole`, such a one alone."""
    if whole and printed.power is None and _WHOLE.fullmatch(printed.mantissa):
        value = exact(printed.value)
        return Span(value, value)
    return span(printed, share=share)


def derived_rows(paper: str, derivation: Derivation) -> Iterator[AuditRow]:
    """Yield a row where no numbers behind the printed parts give one behind the printed result."""
    result, parts = derivation.result, derivation.parts
    try:
        if derivation.agrees(DOUBLES):
            return
        possible = derivation.formula([derivation.span(part.printed) for part in parts])
        value = derivation.formula([derivation.point(part.printed) for part in parts]).low
        in_singles = derivation.agrees(SINGLES)
        slipped = _explained(derivation)
    except ZeroDivisionError:
        return
    texts = [_text(part.printed, with_unit=derivation.mixed) for part in parts]
    printed = _text(result.printed, with_unit=derivation.mixed)
    yield audit_row(
        paper,
        (result, *parts),
        check=derivation.check,
        grade=Grade.INCONSISTENT,
        explanation=(
            f"{derivation.written.format(*texts)} = {in_full(value)}, {_range(possible)}; printed "
            f"is {printed} ({result.where}), off by "
            f"{in_full(derivation.point(result.printed).low - value)}. {slipped}"
        ),
        condition=IN_DOUBLES if in_singles else None,
    )


def ratio_rows(paper: str, relation: Times) -> Iterator[AuditRow]:
    """Yield a row where one number is not so many times the other."""
    of, to = (number.printed.unit for number in (relation.of, relation.to))
    mixed = of != to and "" not in (of, to)
    factor = exact(UNITS[of]) / exact(UNITS[to]) if mixed else Fraction(1)
    return derived_rows(
        paper,
        Derivation(
            check="ratio",
            result=relation.printed,
            parts=(relation.of, relation.to),
            formula=lambda parts: parts[0] / parts[1] * Span(factor, factor),
            written=f"({{}} {of})/({{}} {to})" if mixed else "{}/{}",
            exact=relation.exact,
        ),
    )


def formula_rows(paper: str, relation: ByFormula) -> Iterator[AuditRow]:
    """Yield a row where a number does not follow from the others by its formula."""
    names, formula = tuple(relation.numbers), relation.formula

    def spans(parts: Sequence[Span]) -> Span:
        values = dict(zip(names, parts, strict=True))
        if not isinstance(formula, str):
            return formula(**values)
        return worked_out(formula, values, number=lambda each: Span(each, each), root=_root)

    return derived_rows(
        paper,
        Derivation(
            check="formula",
            result=relation.printed,
            parts=tuple(relation.numbers.values()),
            formula=spans,
            written=_written(formula, names),
            exact=relation.exact,
        ),
    )


def equal_rows(paper: str, relation: Equal) -> Iterator[AuditRow]:
    """Yield a row per number that cannot be one before it."""
    for i, number in enumerate(relation.numbers):
        rows = (_unequal(paper, number, other, relation) for other in relation.numbers[:i])
        yield from itertools.islice(itertools.chain.from_iterable(rows), 1)


def _unequal(paper: str, one: Number, other: Number, relation: Equal) -> Iterator[AuditRow]:
    return derived_rows(
        paper,
        Derivation(
            check="equal",
            result=one,
            parts=(other,),
            formula=itemgetter(0),
            written=f"{{}} ({other.where})",
            exact=relation.exact,
            whole=True,
            alike=True,
        ),
    )


def _written(formula: str | Callable[..., Span], names: Sequence[str]) -> str:
    """Return the formula with a mark for each number in the place of its name."""
    if not isinstance(formula, str):
        return f"the formula of {', '.join(f'{name} = {{}}' for name in names)}"
    place = {name: f"{{{i}}}" for i, name in enumerate(names)}
    return _NAME.sub(lambda match: place.get(match[0], match[0]), formula)


def _range(possible: Span) -> str:
    if possible.low == possible.high:
        return "and no number in it is rounded"
    low, high = in_full(possible.low), in_full(possible.high)
    return f"between {low} and {high} with every rounding"


def _text(printed: Printed, *, with_unit: bool) -> str:
    return f"{printed.text} {printed.unit}".strip() if with_unit else printed.text


def _root(around: Span) -> Span:
    """Return from the least to the greatest root; ZeroDivisionError where there is none."""
    if around.high < 0:
        raise ZeroDivisionError
    low, high = (Fraction(root(max(end, Fraction(0)))) for end in (around.low, around.high))
    return Span(low * (1 - _ROOT_ERROR), high * (1 + _ROOT_ERROR))


def _explained(derivation: Derivation) -> str:
    """Say which single slips in one of the numbers would close the sum, and how many they are."""
    printed = [*(part.printed for part in derivation.parts), derivation.result.printed]
    exactly, within = [], []
    for i, number in enumerate(printed):
        for slip in slips(number):
            meant = [*printed[:i], slip.meant, *printed[i + 1 :]]
            parts, result = meant[:-1], meant[-1]
            words = f"{slip.meant.text} for {number.text} ({slip.words})"
            with suppress(ZeroDivisionError):
                value = derivation.formula(list(map(derivation.point, parts))).low
                if abs(value - derivation.point(result).low) <= derivation.half_unit(result):
                    exactly.append(words)
                elif derivation.formula(list(map(derivation.span, parts))).meets(
                    derivation.span(result, result=True)
                ):
                    within.append(words)
    if not exactly and not within:
        return "No single slip in one of the numbers explains it"
    return ". ".join(
        f"{_counted(len(found))} would close it {how}: {', '.join(found)}"
        for found, how in (
            (exactly, "with the other numbers as they are printed"),
            (within, "only with the rounding of the others"),
        )
        if found
    )


def _counted(count: int) -> str:
    return "1 single slip" if count == 1 else f"{count} single slips, any one of them,"


def in_full(number: Fraction) -> str:
    """Return a sum of printed numbers without loss."""
    return f"{float(number):.10g}"
