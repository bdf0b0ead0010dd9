"""The least p-values that rank tests of n values can give."""

import math
from collections.abc import Iterator
from fractions import Fraction

from repro.tables.relations import Number, PValues
from repro.tables.rows import AuditRow, Grade, audit_row
from repro.tables.true_numbers import shown, span

# In single precision z is off by a few 2^-24 of itself, and a p-value by z² times as much.
COMPUTED = Fraction(1, 2**12)
SIDES = {1: "one-sided", 2: "two-sided"}


def p_value_rows(paper: str, relation: PValues) -> Iterator[AuditRow]:
    """Yield a row per p-value below what the test can give, exactly or by its approximation."""
    floors = sorted([_exact_floor(relation), _approximate_floor(relation)])
    for number in relation.numbers:
        around = span(number.printed, share=COMPUTED)
        if around.high < floors[0] or around.low > 1:
            yield _row(paper, number, relation, Grade.IMPOSSIBLE)
        elif around.high < floors[1]:
            yield _row(paper, number, relation, Grade.NOTED)


def _row(paper: str, number: Number, relation: PValues, grade: Grade) -> AuditRow:
    n = relation.n
    size, formula = (
        (f"{n} against {n} values", f"{relation.sides}/C({2 * n}, {n})")
        if relation.test == "rank-sum"
        else (f"{n} pairs", f"{relation.sides}/2^{n}")
    )
    return audit_row(
        paper,
        (number,),
        check="p-value",
        grade=grade,
        explanation=(
            f"printed is p = {number.printed.text} for a {SIDES[relation.sides]} "
            f"{relation.test} test of {size}; the exact test gives {formula} = "
            f"{shown(_exact_floor(relation))} at least, the normal approximation "
            f"{shown(_approximate_floor(relation))} at least (without "
            "continuity correction, ties as favourable as can be); no test gives more than 1"
        ),
    )


def _exact_floor(relation: PValues) -> float:
    """Return the p-value of two fully separated samples, or of n differences of one sign."""
    n = relation.n
    return relation.sides / (math.comb(2 * n, n) if relation.test == "rank-sum" else 2**n)


def _approximate_floor(relation: PValues) -> float:
    """Return the same by the normal approximation, the least of its usual forms.

    Ties make the variance smaller: it is smallest with each sample (rank-sum) or all differences
    (signed-rank) equal. A continuity correction would raise the value.
    """
    n = relation.n
    if relation.test == "rank-sum":
        ties = 2 * (n**3 - n) / (2 * n * (2 * n - 1))
        z = n * n / 2 / math.sqrt(n * n / 12 * (2 * n + 1 - ties))
    else:
        variance = n * (n + 1) * (2 * n + 1) / 24 - (n**3 - n) / 48
        z = n * (n + 1) / 4 / math.sqrt(variance)
    return math.erfc(z / math.sqrt(2)) * relation.sides / 2
