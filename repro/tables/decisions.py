"""p against z, effect size, decision and the counts of a sign test."""

import math
from collections.abc import Iterator
from fractions import Fraction

from repro.tables.facts import Decision
from repro.tables.probabilities import COMPUTED, p_value_rows
from repro.tables.relations import Cell, PValues
from repro.tables.rows import AuditRow, Grade, audit_row
from repro.tables.true_numbers import Span, exact, shown, span

NORMAL = "p is from the normal approximation, without a continuity correction"
SAME_SIDES = "p and the decision are of the same number of sides"
BEYOND = 38.0  # of this z, p is below the least double


def decision_rows(paper: str, decision: Decision) -> Iterator[AuditRow]:
    """Yield a row per contradiction between what is printed of one test."""
    if decision.test is not None and decision.n:
        sides = decision.sides or 1  # the least p of one side is the smaller
        relation = PValues(numbers=(decision.p,), test=decision.test, n=decision.n, sides=sides)
        yield from p_value_rows(paper, relation)
    elif not _is_share(span(decision.p.printed)):
        yield audit_row(
            paper,
            (decision.p,),
            check="p-value",
            grade=Grade.IMPOSSIBLE,
            explanation=f"printed is p = {decision.p.printed.text}; no p is outside 0 to 1",
        )
    yield from _against_level(paper, decision)
    if decision.z is not None:
        yield from _against_z(paper, decision, decision.z)
    if decision.tally is not None:
        yield from _sign_test(paper, decision)


def _is_share(around: Span) -> bool:
    return around.low <= 1 and around.high >= 0


def _against_level(paper: str, decision: Decision) -> Iterator[AuditRow]:
    p, alpha = span(decision.p.printed), decision.alpha
    if decision.rejects is None:
        return
    wrong = p.high < alpha if not decision.rejects else p.low > alpha
    if not wrong:
        return
    # p of the other number of sides is twice or half as large
    still = 2 * p.high < alpha if not decision.rejects else p.low > 2 * alpha
    sides = {1: "one-sided ", 2: "two-sided ", None: ""}[decision.sides]
    yield audit_row(
        paper,
        (decision.p, *([decision.decided] if decision.decided else [])),
        check="p-decision",
        grade=Grade.INCONSISTENT,
        explanation=(
            f"printed is {sides}p = {decision.p.printed.text}, which is "
            f"{'below' if not decision.rejects else 'above'} the level {shown(alpha)}, and the "
            f"hypothesis is {'rejected' if decision.rejects else 'not rejected'}"
        ),
        condition=None if still else SAME_SIDES,
    )


def _against_z(paper: str, decision: Decision, z: Cell) -> Iterator[AuditRow]:
    around = span(z.printed)
    low, high = sorted((abs(around.low), abs(around.high)))
    if around.low <= 0 <= around.high:
        low = Fraction(0)
    p = span(decision.p.printed, share=COMPUTED)
    tails = [Fraction(math.erfc(min(float(end), BEYOND) / math.sqrt(2))) for end in (high, low)]
    two = Span(tails[0], tails[1])
    one, other = Span(two.low / 2, two.high / 2), Span(1 - two.high / 2, 1 - two.low / 2)
    forms = {1: (one, other), 2: (two,), None: (one, other, two)}[decision.sides]
    if not any(p.meets(form) for form in forms):
        yield audit_row(
            paper,
            (decision.p, z),
            check="p-z",
            grade=Grade.INCONSISTENT,
            explanation=(
                f"z = {z.printed.text} gives p = {shown(two.low)} to {shown(two.high)} two-sided "
                f"and half of it one-sided; printed is {decision.p.printed.text}"
            ),
            condition=NORMAL,
        )
    if decision.r is not None and decision.n:
        yield from _effect(paper, decision, decision.r, Span(low, high))


def _effect(paper: str, decision: Decision, r: Cell, size: Span) -> Iterator[AuditRow]:
    """Check r = z/√N, where N may count the values of one sample, or of both."""
    n, around = decision.n or 1, span(r.printed)
    squares = sorted((around.low**2, around.high**2))
    if around.low <= 0 <= around.high:
        squares[0] = Fraction(0)
    if any(size.low**2 <= squares[1] * k and size.high**2 >= squares[0] * k for k in (n, 2 * n)):
        return
    yield audit_row(
        paper,
        (r, decision.z) if decision.z else (r,),
        check="effect-size",
        grade=Grade.INCONSISTENT,
        explanation=(
            f"z = {decision.z.printed.text if decision.z else ''} over √{n} is "
            f"{float(size.high) / math.sqrt(n):.4g}, over √{2 * n} "
            f"{float(size.high) / math.sqrt(2 * n):.4g}; printed is r = {r.printed.text}"
        ),
    )


def _sign_test(paper: str, decision: Decision) -> Iterator[AuditRow]:
    """Check p against wins and losses; ties are left out, or halved between them."""
    tally = decision.tally
    if tally is None or tally.wins is None or tally.losses is None:
        return
    wins, losses = (exact(cell.printed.value) for cell in (tally.wins, tally.losses))
    ties = exact(tally.ties.printed.value) if tally.ties else Fraction(0)
    if any(count < 0 or count.denominator != 1 for count in (wins, losses, ties)):
        return
    half, odd = divmod(int(ties), 2)
    pairs = {
        (int(wins) + shared, int(losses) + shared + rest)
        for shared, rest in ((0, 0), (half, 0), (half, odd))
    } | {(int(wins) + half + odd, int(losses) + half)}
    values = [p for pair in pairs for p in _sign_values(*pair, sides=decision.sides)]
    printed = span(decision.p.printed, share=COMPUTED)
    if any(printed.low <= value <= printed.high for value in values):
        return
    exactly = _binomial(int(wins), int(losses))
    yield audit_row(
        paper,
        (decision.p, *tally.cells),
        check="sign-test",
        grade=Grade.INCONSISTENT,
        explanation=(
            f"{wins} wins and {losses} losses give p = {shown(min(Fraction(1), 2 * exactly))} "
            f"two-sided and {shown(exactly)} one-sided by the exact sign test, and nothing nearer "
            f"by its normal approximation; printed is {decision.p.printed.text}"
        ),
        condition="p is of a sign test of these counts",
    )


def _sign_values(wins: int, losses: int, *, sides: int | None) -> Iterator[Fraction]:
    """Yield p by the exact test and by the normal one, with and without correction."""
    total, apart = wins + losses, abs(wins - losses)
    tail = _binomial(wins, losses)
    one = [tail, 1 - tail + Fraction(math.comb(total, min(wins, losses)), 2**total)]
    two = [min(Fraction(1), 2 * tail)]
    for corrected in (apart, max(0, apart - 1)):
        normal = Fraction(math.erfc(corrected / math.sqrt(2 * total))) if total else Fraction(1)
        two.append(normal)
        one += [normal / 2, 1 - normal / 2]
    yield from {1: one, 2: two, None: one + two}[sides]


def _binomial(wins: int, losses: int) -> Fraction:
    """Return the chance of as few heads as the smaller count, or fewer."""
    total = wins + losses
    return Fraction(sum(math.comb(total, k) for k in range(min(wins, losses) + 1)), 2**total)
