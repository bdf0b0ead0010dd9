"""Average ranks and total ranks recomputed from the cells that they rank."""

import itertools
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction

from repro.tables.relations import AverageRank, TableCell
from repro.tables.rows import AuditRow, Grade, audit_row
from repro.tables.true_numbers import Span, exact, shown, span

Values = Mapping[tuple[str, str], Span]  # what can stand behind each cell


def rank_rows(paper: str, relation: AverageRank) -> Iterator[AuditRow]:
    """Yield a row where average ranks do not follow from the cells, one where totals do not."""
    places = [(row, column) for row in relation.rows for column in relation.columns]
    points = [exact(relation.table[place].value) for place in places]
    values = {place: Span(point, point) for place, point in zip(places, points, strict=True)}
    averages = _averages(relation, values)
    wrong = [name for name in relation.columns if not _fits(relation, name, averages[name])]
    if wrong:
        unrounded = _averages(relation, {place: span(relation.table[place]) for place in places})
        certain = not all(_fits(relation, name, unrounded[name]) for name in relation.columns)
        cells = [_cell(relation, relation.average, name) for name in wrong]
        given = "; ".join(
            f"{cell.column} {_in_words(averages[cell.column])}, printed {cell.printed.text}"
            for cell in cells
        )
        yield audit_row(
            paper,
            cells,
            check="average-rank",
            grade=Grade.INCONSISTENT if certain else Grade.NOTED,
            explanation=(
                f"ranked by the {len(relation.rows)} rows of {relation.table.label} (1 for the "
                f"lowest), the mean ranks are {given}; the other "
                f"{len(relation.columns) - len(wrong)} agree. {_exchange(relation, values)}"
            ),
            condition=None if certain else "the ranks were taken from the numbers as printed",
        )
    if relation.total is not None:
        yield from _total_rows(paper, relation, relation.total)


def _total_rows(paper: str, relation: AverageRank, total: str) -> Iterator[AuditRow]:
    """Check the total ranks against the printed average ranks."""
    averages = {name: relation.table[relation.average, name] for name in relation.columns}
    spans = {name: span(printed) for name, printed in averages.items()}
    for name, own in spans.items():
        printed = relation.table[total, name]
        lower = sum(rival.high < own.low for rival in spans.values())
        higher = sum(rival.low > own.high for rival in spans.values())
        ranks = Span(Fraction(1 + lower), Fraction(len(spans) - higher))
        if not ranks.low <= exact(printed.value) <= ranks.high:
            yield audit_row(
                paper,
                (_cell(relation, total, name), _cell(relation, relation.average, name)),
                check="total-rank",
                grade=Grade.INCONSISTENT,
                explanation=(
                    f"the average rank {averages[name].text} of {name} has place "
                    f"{_in_words(ranks)} among {', '.join(p.text for p in averages.values())}; "
                    f"printed is {printed.text}"
                ),
            )


def _averages(relation: AverageRank, values: Values) -> dict[str, Span]:
    """Return the mean rank of each column; ties may share the best, the mean or the worst place."""
    sums = dict.fromkeys(relation.columns, Span(Fraction(0), Fraction(0)))
    for row in relation.rows:
        rivals = [values[row, name] for name in relation.columns]
        for name in relation.columns:
            sums[name] += _rank(values[row, name], rivals)
    n = len(relation.rows)
    return {name: Span(total.low / n, total.high / n) for name, total in sums.items()}


def _rank(value: Span, rivals: Sequence[Span]) -> Span:
    lower = sum(rival.high < value.low for rival in rivals)
    same = sum(rival.meets(value) for rival in rivals)
    return Span(Fraction(1 + lower), Fraction(lower + same))


def _fits(relation: AverageRank, name: str, average: Span) -> bool:
    return span(relation.table[relation.average, name]).meets(average)


def _exchange(relation: AverageRank, values: Values) -> str:
    """Say which exchange of two cells of one row would make every average rank fit."""
    found = []
    for row in relation.rows:
        for one, other in itertools.combinations(relation.columns, 2):
            swapped = {
                **values,
                (row, one): values[row, other],
                (row, other): values[row, one],
            }
            averages = _averages(relation, swapped)
            if all(_fits(relation, name, averages[name]) for name in relation.columns):
                found.append(f"{one} and {other} in {row}")
    if not found:
        return "No exchange of two cells of one row makes all of them fit"
    return f"All fit if the cells of {' or of '.join(found)} change places"


def _in_words(ranks: Span) -> str:
    low, high = shown(ranks.low), shown(ranks.high)
    return low if low == high else f"{low} to {high} by the treatment of ties"


def _cell(relation: AverageRank, row: str, column: str) -> TableCell:
    return TableCell(table=relation.table, row=row, column=column)
