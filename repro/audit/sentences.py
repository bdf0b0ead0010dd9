"""Sentences of the text against the cells that they speak of."""

from collections.abc import Iterator, Mapping
from dataclasses import replace

from repro.model.claims import CellClaim, Sentence
from repro.model.measures.measure import Measure, Rank, Statistic
from repro.model.paper import Paper
from repro.tables.relations import TableCell
from repro.tables.rows import AuditRow, Grade, audit_row
from repro.tables.true_numbers import Span, is_scientific, span, statistic_span

Cells = Mapping[Statistic, TableCell]


def sentence_rows(paper: Paper) -> Iterator[AuditRow]:
    """Yield a row per sentence that the printed table itself contradicts."""
    cells = {
        claim.measure: claim.cell
        for claim in paper.claims
        if isinstance(claim, CellClaim) and isinstance(claim.measure, Statistic)
    }
    for claim in paper.claims:
        if isinstance(claim, Sentence) and claim.measure is not None:
            yield from _rank(paper.key, claim, claim.measure, cells)
            yield from _same_number(paper.key, claim, claim.measure, cells)


def _rank(paper: str, claim: Sentence, measure: Measure, cells: Cells) -> Iterator[AuditRow]:
    """Check a rank where every number that it compares stands in one table; ties may share."""
    if not isinstance(measure, Rank):
        return
    rivals = [name for name in measure.among if name != measure.of.algorithm]
    names = (measure.of.algorithm, *rivals)
    statistics = [replace(measure.of, algorithm=name) for name in names]
    found = {s.algorithm: cells[s] for s in statistics if s in cells}
    if len(found) < len(names) or len({cell.table.label for cell in found.values()}) > 1:
        return
    spans = {name: _span(cell, measure.of) for name, cell in found.items()}
    own = spans[measure.of.algorithm]
    lower = [name for name in rivals if spans[name].high < own.low]
    ties = [name for name in rivals if spans[name].meets(own)]
    if 1 + len(lower) <= claim.printed.value <= 1 + len(lower) + len(ties):
        return
    below = " and ".join(f"{found[name].printed.text} for {name}" for name in lower)
    cell = found[measure.of.algorithm]
    yield audit_row(
        paper,
        (cell, *(found[name] for name in lower)),
        check="rank-in-text",
        grade=Grade.INCONSISTENT,
        explanation=(
            f"{claim.where} says, {claim.claim!r}: rank {claim.printed.text}. "
            f"{cell.table.label} prints {cell.printed.text} for {measure.of.algorithm}, and "
            f"{below or 'nothing'} below it, which makes it rank {1 + len(lower)}"
            + (f" to {1 + len(lower) + len(ties)}" if ties else "")
        ),
    )


def _same_number(paper: str, claim: Sentence, measure: Measure, cells: Cells) -> Iterator[AuditRow]:
    """Check a number of the text against the cell that prints the same statistic."""
    if claim.in_words or not isinstance(measure, Statistic) or measure not in cells:
        return
    cell = cells[measure]
    if cell.printed.unit != claim.printed.unit or span(cell.printed).meets(span(claim.printed)):
        return
    yield audit_row(
        paper,
        (cell,),
        check="number-in-text",
        grade=Grade.INCONSISTENT,
        explanation=(
            f"{claim.where} prints {claim.printed.text} {claim.printed.unit} for the "
            f"{measure.words}, {cell.where} prints {cell.printed.text}"
        ),
    )


def _span(cell: TableCell, statistic: Statistic) -> Span:
    return statistic_span(
        cell.printed,
        scientific=is_scientific(cell.table),
        spread=statistic.statistic == "std",
    )
