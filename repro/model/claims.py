"""Claims: one printed number or one sentence, what to measure for it, and what is accepted."""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import TypeVar

from repro.errors import DeclarationError
from repro.model.experiment import Experiment
from repro.model.measures.measure import Measure, Rank, Statistic
from repro.model.measures.ranks import Contest
from repro.model.open_points import Gap
from repro.model.tolerances import Between, Tolerance
from repro.tables.published import Printed, PublishedTable
from repro.tables.relations import TableCell


@dataclass(frozen=True, slots=True, kw_only=True)
class CellClaim:
    """One cell of a printed table.

    One with a `gap` is not run: its measure only says what is printed there. What has one `group`
    counts once in every summary; what does not count (`counts`) is an input, or true by definition.
    """

    table: PublishedTable
    row: str
    column: str
    measure: Measure | None
    accepted: Tolerance
    gap: Gap | None = None
    group: str = ""
    counts: bool = True

    @property
    def printed(self) -> Printed:
        """The number as it stands in the table."""
        return self.table[self.row, self.column]

    @property
    def where(self) -> str:
        """The place on the page."""
        return self.table.where

    @property
    def cell(self) -> TableCell:
        """The cell as relations and the audit name it."""
        return TableCell(table=self.table, row=self.row, column=self.column)

    @property
    def place(self) -> tuple[str, str, str] | None:
        """Table, row and column."""
        return self.table.label, self.row, self.column


@dataclass(frozen=True, slots=True, kw_only=True)
class Sentence:
    """One statement of the text, in our words; `measure` is None where a Gap says why.

    A statement that is made `in_words` prints no number: `printed` then holds the unit and the
    number that its declared reading comes closest to, and the pages do not show it as printed.
    `group` and `counts` are as of a cell.
    """

    claim: str
    where: str
    printed: Printed
    measure: Measure | None
    accepted: Tolerance
    gap: Gap | None = None
    in_words: bool = False
    group: str = ""
    counts: bool = True

    def __post_init__(self) -> None:
        """Raise DeclarationError unless there is either a measure or a gap."""
        if (self.measure is None) == (self.gap is None):
            message = f"claim {self.claim!r} needs either a measure or a Gap that says why not"
            raise DeclarationError(message)

    @property
    def place(self) -> tuple[str, str, str] | None:
        """Nothing: a sentence stands in no table."""
        return None


Claim = CellClaim | Sentence
AnyClaim = TypeVar("AnyClaim", CellClaim, Sentence, Claim)


def as_one(group: str, claims: Iterable[AnyClaim]) -> tuple[AnyClaim, ...]:
    """Return the claims as one result: every summary counts them once, under that name."""
    return tuple(replace(claim, group=group) for claim in claims)


def not_counted(claims: Iterable[AnyClaim]) -> tuple[AnyClaim, ...]:
    """Return the claims as ones that are shown only: inputs, and what is true by definition."""
    return tuple(replace(claim, counts=False) for claim in claims)


def says(
    claim: str, where: str, printed: Printed, measure: Measure | Gap, *, within: Tolerance
) -> Sentence:
    """Return the claim of a sentence that prints a number; a Gap where it cannot be measured."""
    gap = measure if isinstance(measure, Gap) else None
    return Sentence(
        claim=claim,
        where=where,
        printed=printed,
        measure=None if isinstance(measure, Gap) else measure,
        accepted=within,
        gap=gap,
    )


def says_in_words(
    claim: str, where: str, nearest: str, measure: Measure | Gap, *, within: Tolerance
) -> Sentence:
    """Return the claim of a sentence without a number; `nearest` is what it comes closest to.

    That is a number and its unit, as "1 rank" or "100 %".
    """
    return replace(
        says(claim, where, Printed(*nearest.split()), measure, within=within), in_words=True
    )


def left_open(gap: Gap) -> Sentence:
    """Return what a gap says as a sentence of which nothing is measured."""
    anything = Between(-math.inf, math.inf)
    return says_in_words(gap.what, gap.where, "0 rank", gap, within=anything)


def lowest_everywhere(
    of: Experiment,
    *,
    algorithm: str,
    statistic: str,
    claim: str,
    where: str,
    quantity: str = "cost",
) -> tuple[Sentence, ...]:
    """Return one claim per problem: the algorithm's statistic is the lowest, or shares that place.

    `claim` is the sentence in our words; the problem is added to it. Where the experiment has left
    an algorithm out, nothing is measured and its gap says why.
    """
    gap = next(iter(of.left_out.values()), None)
    return tuple(
        Sentence(
            claim=f"{claim}, on {problem}",
            group=claim,
            where=where,
            printed=Printed("1", "rank"),
            gap=gap,
            measure=None
            if gap
            else Rank(
                of=Statistic(
                    experiment=of.name,
                    problem=problem,
                    algorithm=algorithm,
                    statistic=statistic,
                    quantity=quantity,
                ),
                among=tuple(of.algorithms),
            ),
            accepted=Between(1, 1),
            in_words=True,
        )
        for problem in of.problems
    )


def ranked(
    of: Contest, *, algorithm: str, places: Mapping[str, int], claim: str, where: str
) -> tuple[Sentence, ...]:
    """Return one claim per problem named in `places`: the algorithm has that place there."""
    return tuple(
        Sentence(
            claim=f"{claim}, on {problem}: place {place}",
            group=claim,
            where=where,
            printed=Printed(f"{place}", "rank"),
            measure=Rank(
                of=of.statistics(problem)[of.of(algorithm)],
                among=of.algorithms,
            ),
            accepted=Between(place, place),
            in_words=True,
        )
        for problem, place in places.items()
    )
