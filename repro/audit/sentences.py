"""Sentences of the text, and printed ranks, against the cells that they speak of."""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from fractions import Fraction

from repro.model.claims import CellClaim, Claim, Sentence
from repro.model.measures.measure import Measure, Rank, Statistic
from repro.model.paper import Paper
from repro.tables.arithmetic import NARROWEST, Arithmetic, statistic_span
from repro.tables.relations import TableCell
from repro.tables.rows import AuditRow, Grade, audit_row
from repro.tables.statistic_words import SPREADS
from repro.tables.true_numbers import Span, is_scientific, span

COMPARED = replace(NARROWEST, exact_zeros=False)  # printed numbers are compared, not computed
Cells = Mapping[Statistic, TableCell]


def sentence_rows(paper: Paper) -> Iterator[AuditRow]:
    """Yield a row per sentence or printed rank that the printed table itself contradicts."""
    cells = {
        claim.measure: claim.cell
        for claim in paper.claims
        if isinstance(claim, CellClaim) and isinstance(claim.measure, Statistic)
    }
    for claim in paper.claims:
        if claim.measure is not None:
            yield from _rank(paper.key, claim, claim.measure, cells)
        if isinstance(claim, Sentence) and claim.measure is not None:
            yield from _same_number(paper.key, claim, claim.measure, cells)


def _rank(paper: str, claim: Claim, measure: Measure, cells: Cells) -> Iterator[AuditRow]:
    """Check a rank where every number that it compares stands in one table; ties may share."""
    if not isinstance(measure, Rank) or measure.ties == "dense":  # whose places others decide, too
        return
    rivals = [name for name in measure.among if name != measure.of.algorithm]
    names = (measure.of.algorithm, *rivals)
    statistics = [replace(measure.of, algorithm=name) for name in names]
    found = {s.algorithm: cells[s] for s in statistics if s in cells}
    if len(found) < len(names) or len({cell.table.label for cell in found.values()}) > 1:
        return
    rank, own = claim.printed.value, measure.of.algorithm
    places = {
        given: _place({name: _span(cell, measure.of, given) for name, cell in found.items()}, own)
        for given in (COMPARED, NARROWEST)
    }
    wrong = [given for given, place in places.items() if not place.low <= rank <= place.high]
    if not wrong:
        return
    place = places[NARROWEST]
    lower = [name for name in rivals if _lies_below(found[name], found[own], measure.of)]
    below = " and ".join(f"{found[name].printed.text} for {name}" for name in lower)
    cell = found[own]
    own_cell = (claim.cell,) if isinstance(claim, CellClaim) else ()
    yield audit_row(
        paper,
        (*own_cell, cell, *(found[name] for name in lower)),
        check="rank-in-table" if own_cell else "rank-in-text",
        grade=Grade.INCONSISTENT,
        explanation=(
            f"{_said(claim)}: rank {claim.printed.text}. "
            f"{cell.table.label} prints {cell.printed.text} for {own}, and "
            f"{below or 'nothing'} below it, which makes it rank {place.low}"
            + (f" to {place.high}" if place.high > place.low else "")
        ),
        condition=wrong[0].beyond(COMPARED),
    )


def _said(claim: Claim) -> str:
    if isinstance(claim, CellClaim):
        return f"{claim.cell.where} prints"
    return f"{claim.where} says, {claim.claim!r}"


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


def _place(spans: Mapping[str, Span], own: str) -> Span:
    """Return the lowest and highest rank that `own` can have; ties may share."""
    lower = sum(span.high < spans[own].low for span in spans.values())
    ties = sum(span.meets(spans[own]) for span in spans.values()) - 1
    return Span(Fraction(1 + lower), Fraction(1 + lower + ties))


def _lies_below(cell: TableCell, own: TableCell, statistic: Statistic) -> bool:
    return _span(cell, statistic, NARROWEST).high < _span(own, statistic, NARROWEST).low


def _span(cell: TableCell, statistic: Statistic, given: Arithmetic) -> Span:
    return statistic_span(
        cell.printed,
        scientific=is_scientific(cell.table),
        spread=statistic.statistic if statistic.statistic in SPREADS else "",
        given=given,
    )
