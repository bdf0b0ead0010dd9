"""Claims on the cells of a printed table, by what its headings name."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any, Literal, get_args

from repro.errors import DeclarationError
from repro.model.cell_measures import WORDS, compared_with, is_printable, measure_of
from repro.model.claims import CellClaim
from repro.model.experiment import Experiment
from repro.model.known_words import known_words, shown_value
from repro.model.measures.measure import Measure, Statistic
from repro.model.open_points import Gap
from repro.model.tolerances import FromMinimum, Tolerance
from repro.statistics.named import is_spread
from repro.tables.published import Column, PublishedTable
from repro.tables.relations import TableCell

Role = Literal["problem", "algorithm", "statistic", "quantity"]
Words = Mapping[Role, str]
Left = Mapping[Any, Gap]  # by name, or by (row, column)


@dataclass(frozen=True, slots=True, kw_only=True)
class _CellOf:
    """A cell, what it is of by role, and the headings that it stands under."""

    cell: TableCell
    words: Words
    headings: tuple[str, ...]

    @property
    def place(self) -> str:
        """Where it stands, in a message."""
        return f"{self.cell.label}, row {self.cell.row!r}, column {self.cell.column!r}"

    @property
    def names(self) -> tuple[str | tuple[str, str], ...]:
        """Whatever may be left to a gap, the narrowest first."""
        row, column = self.cell.row, self.cell.column
        return ((row, column), *self.words.values(), *self.headings, row, column)


def every_cell(
    table: PublishedTable,
    *,
    of: Experiment,
    rows: tuple[Role, ...],
    columns: Role | tuple[Role, ...],
    within: Tolerance,
    std_within: Tolerance | None = None,
    given: Mapping[Role, str] | None = None,
    names: Mapping[str, str] | None = None,
    only: tuple[str, ...] | None = None,
    without: Left | None = None,
) -> tuple[CellClaim, ...]:
    """Return a claim on the statistic that each cell prints.

    `rows` says what each row heading names, `columns` what the column heading names, or each of
    those that stand one above the other, `given` what neither names. Headings of one role name one
    thing together, as "F1 30", and `names` translates a heading, or such several. A statistic is a
    word of `statistics.named` or `cell_measures`; `std_within` is for all measures of spread.
    `only` keeps some row names. What is in `without` is left to that gap: all cells of a name or
    heading, a row or column by its name, or one cell by (row, column). What is of an algorithm that
    the experiment has left out, or compares with one, is left to its gap. Raises DeclarationError,
    a line a fault, where a heading names nothing that the experiment has, and for names in `only`
    and `without` that the table does not have.
    """
    _check_dicts(table, given=given, names=names, without=without)
    levels = (columns,) if isinstance(columns, str) else tuple(columns)
    _check_roles(table, rows, levels, tuple(given or {}))
    cells = list(_cells(table, (*rows, *levels), given or {}, names or {}))
    left = without or {}
    faults = [*_unknown_rows(table, only), *_unknown_names(table, left, cells)]
    kept = [each for each in cells if only is None or each.cell.row in only]
    claims, unsaid = _claims(kept, of, left, (within, std_within or within))
    if faults := [*faults, *unsaid]:
        raise DeclarationError("\n".join(faults))
    return tuple(claims)


def computed_cells(
    table: PublishedTable,
    *,
    measure: Callable[[str, str], Measure],
    within: Tolerance,
    only: tuple[str, ...] | None = None,
) -> tuple[CellClaim, ...]:
    """Return a claim per cell, measured by what `measure` makes of its (row, column).

    `only` keeps some row names; DeclarationError for one that the table does not have.
    """
    if faults := list(_unknown_rows(table, only)):
        raise DeclarationError("\n".join(faults))
    return tuple(
        _cell_claim(TableCell(table=table, row=row, column=column), measure(row, column), within)
        for row, column in table.places()
        if only is None or row in only
    )


def _check_dicts(table: PublishedTable, **several: object) -> None:
    for word, value in several.items():
        if not isinstance(value, Mapping | None):
            message = f"{table.label}, {word} is {shown_value(value)}; it must be a dict"
            raise DeclarationError(message)


def _check_roles(
    table: PublishedTable,
    rows: tuple[Role, ...],
    columns: tuple[Role, ...],
    given: tuple[Role, ...],
) -> None:
    if unknown := [role for role in (*rows, *columns, *given) if role not in get_args(Role)]:
        message = (
            f"{table.label}: no role {unknown[0]!r}; there is {', '.join(get_args(Role))}, and "
            "headings of one role name one thing together, as 'F1 30' for ('problem', 'problem')"
        )
        raise DeclarationError(message)
    if len(rows) != len(table.headings):
        message = f"{table.label} has the row headings {table.headings}, not one per {rows}"
        raise DeclarationError(message)
    for column in table.columns:
        if len(levels := _levels(column)) != len(columns):
            message = f"{table.label} has the column headings {levels}, not one per {columns}"
            raise DeclarationError(message)


def _levels(column: Column) -> tuple[str, ...]:
    return column.levels or (column.name,)


def _cells(
    table: PublishedTable, roles: tuple[Role, ...], given: Words, names: Mapping[str, str]
) -> Iterator[_CellOf]:
    """Yield every number with the word for each role and its printed headings."""
    headings_of = dict(zip(table.row_names, table.rows, strict=True))
    levels_of = {column.name: _levels(column) for column in table.columns}
    for row, column in table.places():
        headings = (*headings_of[row], *levels_of[column])
        printed: dict[Role, list[str]] = {}
        for role, heading in zip(roles, headings, strict=True):
            printed.setdefault(role, []).append(heading)
        words = dict(given)
        for role, several in printed.items():
            apart = " ".join(names.get(each, each) for each in several if each)
            words[role] = names.get(" ".join(filter(None, several)), apart)
        cell = TableCell(table=table, row=row, column=column)
        yield _CellOf(cell=cell, words=words, headings=headings)


def _claims(
    cells: Iterable[_CellOf], of: Experiment, left: Left, within: tuple[Tolerance, Tolerance]
) -> tuple[list[CellClaim], list[str]]:
    """Return the claims, and why others cannot be made."""
    claims: list[CellClaim] = []
    places: dict[str, str] = {}  # the first of each fault
    for each in cells:
        try:
            claims.append(_claim(each, of, left, within))
        except DeclarationError as error:
            for fault in str(error).splitlines():
                places.setdefault(fault, each.place)
    return claims, [f"{place}: {fault}" for fault, place in places.items()]


def _claim(
    each: _CellOf, of: Experiment, left: Left, within: tuple[Tolerance, Tolerance]
) -> CellClaim:
    """Return the claim on a cell, by the tolerance of all statistics or that of spreads."""
    left = {**of.left_out, **left}
    gap = next((left[name] for name in each.names if name in left), None)
    if gap is None:
        algorithm = each.words.get("algorithm", "")
        against = compared_with(each.words.get("statistic", ""), algorithm, of)
        gap = next((of.left_out[name] for name in against if name in of.left_out), None)
    lacking = list(_lacking(of, each.words, tuple(left)))
    if lacking and gap is None:
        raise DeclarationError("\n".join(lacking))
    own = None if lacking else _statistic(of, each.words)
    accepted = within[own is not None and is_spread(own.statistic)]
    measure = own if gap or own is None else measure_of(own, of)
    if isinstance(accepted, FromMinimum) and isinstance(measure, Statistic):
        accepted = accepted.on(of.problems.get(measure.problem), measure.statistic)
    claim = _cell_claim(each.cell, measure, accepted)
    return replace(claim, gap=gap, group=gap.what) if isinstance(gap, Gap) else claim


def _lacking(of: Experiment, words: Words, left: tuple[object, ...]) -> Iterator[str]:
    """Yield what the experiment lacks; a problem or algorithm may be `left` to a gap."""
    roles: tuple[tuple[Role, Mapping[str, Any]], ...] = (
        ("problem", of.problems),
        ("algorithm", of.algorithms),
    )
    for role, known in roles:
        if (word := words.get(role)) not in (*known, *left):
            yield f"{role} {word!r} is none of {', '.join(known)}"
    if not is_printable(word := words.get("statistic", "")):
        lower = word.lower()
        hint = f"; names={{{word!r}: {lower!r}}} translates it" if is_printable(lower) else ""
        yield f"statistic {word!r} is none of {', '.join(WORDS)}{hint}"


def _unknown_rows(table: PublishedTable, only: tuple[str, ...] | None) -> Iterator[str]:
    for name in only or ():
        if name not in table.row_names:
            yield f"{table.label}, only: no row {name!r}; {known_words(name, table.row_names)}"


def _unknown_names(table: PublishedTable, left: Left, cells: Iterable[_CellOf]) -> Iterator[str]:
    seen = dict.fromkeys(name for each in cells for name in each.names if name)
    for name, gap in left.items():
        if name not in seen:
            kind = "cell" if isinstance(name, tuple) else "name, heading, row or column"
            words = known_words(name, (each for each in seen if isinstance(each, type(name))))
            yield f"{table.label}, without: no {kind} {name!r}; {words}"
        if not isinstance(gap, Gap):
            yield f"{table.label}, without {name!r}: {shown_value(gap)} is no Gap"


def _statistic(of: Experiment, words: Words) -> Statistic:
    return Statistic(
        experiment=of.name,
        problem=words["problem"],
        algorithm=words["algorithm"],
        statistic=words["statistic"],
        quantity=words.get("quantity", "cost"),
    )


def _cell_claim(cell: TableCell, measure: Measure | None, accepted: Tolerance) -> CellClaim:
    return CellClaim(
        table=cell.table, row=cell.row, column=cell.column, measure=measure, accepted=accepted
    )
