"""Claims: one printed number or one sentence, what to measure for it, and what is accepted."""

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Literal, TypeVar, get_args

from repro.errors import DeclarationError
from repro.model.cell_measures import WORDS, is_printable, measure_of
from repro.model.experiment import Experiment
from repro.model.measures.measure import Measure, Rank, Statistic
from repro.model.measures.ranks import Contest
from repro.model.open_points import Gap
from repro.model.tolerances import Between, FromMinimum, Tolerance
from repro.statistics.named import is_spread
from repro.tables.published import Printed, PublishedTable
from repro.tables.relations import TableCell

Role = Literal["problem", "algorithm", "statistic", "quantity"]


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


def every_cell(
    table: PublishedTable,
    *,
    of: Experiment,
    rows: tuple[Role, ...],
    columns: Role,
    within: Tolerance,
    std_within: Tolerance | None = None,
    given: Mapping[Role, str] | None = None,
    names: Mapping[str, str] | None = None,
    only: tuple[str, ...] | None = None,
    without: Mapping[str, Gap] | None = None,
) -> tuple[CellClaim, ...]:
    """Return a claim on the statistic that each cell prints.

    `rows` says what each row heading names, `columns` what the column heading names, `given` what
    neither names, `names` translates a printed heading; `only` keeps some row names. A statistic
    is a word of `repro.statistics.named` or of `cell_measures`; `std_within` is for all measures
    of spread. A cell where any of its names is in `without` is left to that gap. Raises
    DeclarationError where a heading names nothing that the experiment has.
    """
    _check_roles(table, rows, (columns, *(given or {})))
    claims = []
    left = without or {}
    headings_of = dict(zip(table.row_names, table.rows, strict=True))
    for row, column in table.places():
        if only is None or row in only:
            words = dict(given or {})
            for role, word in zip((*rows, columns), (*headings_of[row], column), strict=True):
                words[role] = (names or {}).get(word, word)
            place = f"{table.label}, row {row!r}, column {column!r}"
            own = _statistic(place, of, words, left=tuple(left))
            gap = next((left[word] for word in words.values() if word in left), None)
            accepted = std_within if is_spread(own.statistic) and std_within else within
            cell = TableCell(table=table, row=row, column=column)
            claims.append(_measured_cell(cell, own, of, accepted=accepted, gap=gap))
    return tuple(claims)


def _check_roles(table: PublishedTable, rows: tuple[Role, ...], others: tuple[Role, ...]) -> None:
    if unknown := [role for role in (*rows, *others) if role not in get_args(Role)]:
        message = f"{table.label}: no role {unknown[0]!r}; there is {', '.join(get_args(Role))}"
        raise DeclarationError(message)
    if len(rows) != len(table.headings):
        message = f"{table.label} has the row headings {table.headings}, not one per {rows}"
        raise DeclarationError(message)


def _cell_claim(cell: TableCell, measure: Measure, accepted: Tolerance) -> CellClaim:
    return CellClaim(
        table=cell.table, row=cell.row, column=cell.column, measure=measure, accepted=accepted
    )


def _measured_cell(
    cell: TableCell, own: Statistic, of: Experiment, *, accepted: Tolerance, gap: Gap | None
) -> CellClaim:
    """Return the claim with its tolerance set to the problem, and left to the gap, if any."""
    measure = own if gap else measure_of(own, of)
    if isinstance(accepted, FromMinimum) and isinstance(measure, Statistic):
        accepted = accepted.on(of.problems.get(own.problem), own.statistic)
    claim = _cell_claim(cell, measure, accepted)
    return replace(claim, gap=gap, group=gap.what) if gap else claim


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


def computed_cells(
    table: PublishedTable,
    *,
    measure: Callable[[str, str], Measure],
    within: Tolerance,
    only: tuple[str, ...] | None = None,
) -> tuple[CellClaim, ...]:
    """Return a claim per cell, measured by what `measure` makes of its (row, column)."""
    return tuple(
        _cell_claim(TableCell(table=table, row=row, column=column), measure(row, column), within)
        for row, column in table.places()
        if only is None or row in only
    )


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

    `claim` is the sentence in our words; the problem is added to it.
    """
    return tuple(
        Sentence(
            claim=f"{claim}, on {problem}",
            group=claim,
            where=where,
            printed=Printed("1", "rank"),
            measure=Rank(
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


def _statistic(
    place: str, of: Experiment, words: Mapping[Role, str], *, left: tuple[str, ...] = ()
) -> Statistic:
    known: dict[Role, tuple[str, ...]] = {
        "problem": (*of.problems, *left),
        "algorithm": (*of.algorithms, *left),
    }
    if not is_printable(words.get("statistic", "")):
        known["statistic"] = WORDS
    for role, names in known.items():
        if words.get(role) not in names:
            message = f"{place}: {role} {words.get(role)!r} is none of {', '.join(names)}"
            raise DeclarationError(message)
    return Statistic(
        experiment=of.name,
        problem=words["problem"],
        algorithm=words["algorithm"],
        statistic=words["statistic"],
        quantity=words.get("quantity", "cost"),
    )
