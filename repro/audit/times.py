"""Printed times against the proved minimum of the problem."""

from collections.abc import Iterator

from repro.judge.certificates import certify
from repro.model.claims import CellClaim, Claim
from repro.model.measures.measure import Statistic
from repro.model.paper import Paper
from repro.tables.published import UNITS
from repro.tables.relations import Number, TableCell, TextNumber
from repro.tables.rows import AuditRow, Grade, audit_row
from repro.tables.true_numbers import DOUBLES, exact, factor, shown, span, times


def time_rows(paper: Paper) -> Iterator[AuditRow]:
    """Yield a row per printed total time that no motion under the limits can have."""
    proved = {
        certificate.problem: certificate
        for certificate in certify(paper)
        if certificate.lower_bound is not None
    }
    for claim in paper.claims:
        if not isinstance(claim.measure, Statistic) or claim.measure.quantity != "total":
            continue
        problem = f"{claim.measure.experiment}/{claim.measure.problem}"
        certificate = proved.get(problem)
        if certificate is None or certificate.lower_bound is None:
            continue
        bound = exact(certificate.lower_bound) / exact(UNITS[claim.printed.unit])
        highest = span(claim.printed).high
        if highest < bound * (1 - DOUBLES):
            yield audit_row(
                paper.key,
                (_number(claim),),
                check="time-bound",
                grade=Grade.IMPOSSIBLE,
                explanation=(
                    f"printed is {claim.printed.text} {claim.printed.unit}, at most "
                    f"{shown(highest)}; the least time under the printed limits is "
                    f"{shown(bound)}, {times(factor(bound, highest))} as much ({problem}; "
                    f"{certificate.method}; {'; '.join(certificate.binding)})"
                ),
            )


def _number(claim: Claim) -> Number:
    if isinstance(claim, CellClaim):
        return TableCell(table=claim.table, row=claim.row, column=claim.column)
    return TextNumber(printed=claim.printed, where=claim.where)
