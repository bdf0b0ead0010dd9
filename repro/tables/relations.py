"""What printed numbers must be to each other: declared by papers, recomputed by the audit."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Literal

from repro.errors import DeclarationError
from repro.tables.formulas import check_formula
from repro.tables.published import Printed, PublishedTable
from repro.tables.true_numbers import Span

RankTest = Literal["rank-sum", "signed-rank"]


@dataclass(frozen=True, slots=True, kw_only=True)
class TableCell:
    """A number that stands in a table."""

    table: PublishedTable
    row: str
    column: str

    def __post_init__(self) -> None:
        """Raise DeclarationError where the table has no such number."""
        self.table[self.row, self.column]

    @property
    def printed(self) -> Printed:
        """The number."""
        return self.table[self.row, self.column]

    @property
    def label(self) -> str:
        """The name of its table."""
        return self.table.label

    @property
    def where(self) -> str:
        """The place on the page, down to the cell."""
        return f"{self.label}, {self.row}, {self.column}"


@dataclass(frozen=True, slots=True, kw_only=True)
class PlacedNumber:
    """A number at a place of a table that was read from a file."""

    printed: Printed
    label: str
    row: str
    column: str

    @property
    def where(self) -> str:
        """The place in the file, down to the cell."""
        return f"{self.label}, {self.row}, {self.column}"


@dataclass(frozen=True, slots=True, kw_only=True)
class TextNumber:
    """A number that stands in the text."""

    printed: Printed
    where: str


Cell = TableCell | PlacedNumber
Number = Cell | TextNumber


@dataclass(frozen=True, slots=True, kw_only=True)
class Sum:
    """`total` is the sum of `addends`; whole numbers are not rounded where it is `exact`."""

    total: Number
    addends: tuple[Number, ...]
    exact: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Less:
    """`printed` is `before` less `after`; whole numbers are not rounded where it is `exact`."""

    printed: Number
    before: Number
    after: Number
    exact: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Equal:
    """The numbers are one and the same, by what the paper says of them."""

    numbers: tuple[Number, ...]
    exact: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Times:
    """`printed` says how many times `of` is as large as `to`."""

    printed: Number
    of: Number
    to: Number
    exact: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Mean:
    """`mean` is the average of `numbers`; where it is `exact`, whole ones are not rounded."""

    mean: Number
    numbers: tuple[Number, ...]
    exact: bool = False

    def __post_init__(self) -> None:
        """Raise DeclarationError where nothing is averaged."""
        if not self.numbers:
            message = f"{self.mean.where}: a mean of no numbers"
            raise DeclarationError(message)


@dataclass(frozen=True, slots=True, kw_only=True)
class ByFormula:
    """`printed` follows from `numbers` by a formula, all in the units that they are printed in.

    The formula is a text such as "100 * (old - new) / old", or a function that takes spans by
    these names and returns the span of its value. Numbers that are `exact` and whole are not
    rounded. A name that stands in a formula twice makes its span wider than it need be, so that
    fewer errors are found, and none where there is none.
    """

    printed: Number
    formula: str | Callable[..., Span]
    numbers: Mapping[str, Number]
    exact: bool = False

    def __post_init__(self) -> None:
        """Raise DeclarationError where the text is no formula of these names."""
        if isinstance(self.formula, str):
            check_formula(self.formula, self.numbers)


@dataclass(frozen=True, slots=True, kw_only=True)
class PercentLower:
    """`printed` says by how many percent `after` is lower than `before`."""

    printed: Number
    before: Number
    after: Number


@dataclass(frozen=True, slots=True, kw_only=True)
class AverageRank:
    """The row `average` holds the mean rank of each column over `rows`, 1 for the lowest number.

    The row `total`, where there is one, ranks those means.
    """

    table: PublishedTable
    rows: tuple[str, ...]
    columns: tuple[str, ...]
    average: str
    total: str | None = None

    def __post_init__(self) -> None:
        """Raise DeclarationError where the table lacks one of the numbers."""
        for row in (*self.rows, self.average, *filter(None, [self.total])):
            for column in self.columns:
                self.table[row, column]


@dataclass(frozen=True, slots=True, kw_only=True)
class PValues:
    """The p-values of a test of two samples of `n` values each, or of n pairs."""

    numbers: tuple[Number, ...]
    test: RankTest
    n: int
    sides: Literal[1, 2] = 2

    def __post_init__(self) -> None:
        """Raise DeclarationError for an empty sample."""
        if self.n < 1:
            message = f"a {self.test} test of {self.n} values"
            raise DeclarationError(message)


@dataclass(frozen=True, slots=True, kw_only=True)
class EqualSpacing:
    """The numbers, in this order, are one and the same step apart."""

    numbers: tuple[Number, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class InRange:
    """`value` lies between `low` and `high`, which the paper prints as its range."""

    value: Number
    low: Number
    high: Number


@dataclass(frozen=True, slots=True, kw_only=True)
class SameNumbers:
    """Two series are independent by their meaning, so that it is worth a note if they agree.

    `meaning` says what follows from it.
    """

    first: tuple[Number, ...]
    second: tuple[Number, ...]
    meaning: str

    def __post_init__(self) -> None:
        """Raise DeclarationError unless the series are equally long."""
        if not self.first or len(self.first) != len(self.second):
            message = f"series of {len(self.first)} and {len(self.second)} numbers: {self.meaning}"
            raise DeclarationError(message)


@dataclass(frozen=True, slots=True, kw_only=True)
class PrintedPoses:
    """Joint angles lead through a D-H table to printed positions of the last frame.

    `dh` has a row per joint and the columns named in `a`, `alpha`, `d`; `joints` has the same
    rows and a column per waypoint; `positions` has a row per waypoint and columns x, y, z.
    `offsets` are added to the joint angles, one each, as a theta column "θ₂ − 90°" prints them.
    """

    dh: PublishedTable
    a: str
    alpha: str
    d: str
    joints: PublishedTable
    positions: PublishedTable
    offsets: tuple[Printed, ...] = ()

    def __post_init__(self) -> None:
        """Raise DeclarationError where the three tables do not fit each other."""
        for name in (self.a, self.alpha, self.d):
            self.dh.column(name)
        tables = (self.dh.row_names, self.joints.row_names)
        waypoints = (self.joints.column_names, self.positions.row_names)
        if self.offsets and len(self.offsets) != len(self.dh.row_names):
            message = f"{self.dh.label}: {len(self.offsets)} offsets, {len(self.dh.row_names)} rows"
            raise DeclarationError(message)
        if len({len(rows) for rows in tables}) > 1 or len({*waypoints}) > 1:
            message = (
                f"{self.dh.label}, {self.joints.label}, {self.positions.label} do not fit: "
                f"joints {tables}, waypoints {waypoints}"
            )
            raise DeclarationError(message)
        for axis in "xyz":
            self.positions.column(axis)


Relation = (
    Sum
    | Less
    | Equal
    | Times
    | Mean
    | ByFormula
    | PercentLower
    | AverageRank
    | PValues
    | EqualSpacing
    | InRange
    | SameNumbers
    | PrintedPoses
)


def column_cells(table: PublishedTable, name: str) -> tuple[TableCell, ...]:
    """Return the cells of a column, from top to bottom."""
    return tuple(TableCell(table=table, row=row, column=name) for row in table.row_names)


def row_cells(table: PublishedTable, name: str) -> tuple[TableCell, ...]:
    """Return the cells of a row, from left to right."""
    return tuple(TableCell(table=table, row=name, column=column) for column in table.column_names)


def equally_spaced(table: PublishedTable) -> tuple[EqualSpacing, ...]:
    """Return one EqualSpacing per row."""
    return tuple(EqualSpacing(numbers=row_cells(table, row)) for row in table.row_names)


def row_sums(table: PublishedTable, *, total: str, addends: tuple[str, ...]) -> tuple[Sum, ...]:
    """Return one Sum per row: the column `total` is the sum of the columns `addends`."""
    return tuple(_row_sums(table, total, addends))


def _row_sums(table: PublishedTable, total: str, addends: tuple[str, ...]) -> Iterator[Sum]:
    for row in table.row_names:
        yield Sum(
            total=TableCell(table=table, row=row, column=total),
            addends=tuple(TableCell(table=table, row=row, column=name) for name in addends),
        )
