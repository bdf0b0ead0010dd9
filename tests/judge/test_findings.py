import math
from dataclasses import replace

import numpy as np
import pytest

from repro.judge.findings import PROVISIONAL, THIN, Finding, findings_of, judged
from repro.judge.verdict import Verdict
from repro.model.claims import Claim, Sentence
from repro.model.evidence import Runs
from repro.model.measures.measure import Computed, Statistic
from repro.model.open_points import Gap
from repro.model.paper import Paper
from repro.model.tolerances import Absolute, Between
from repro.tables.published import Printed, PublishedTable
from tests.small_papers import CLAIMS, PAPER, TABLE, evidence, evidence_of


def sentence(printed: Printed, value: float, *, within: float = 0) -> Sentence:
    return Sentence(
        claim="it is so",
        where="p. 4",
        printed=printed,
        measure=Computed(how="as it is", value=lambda: value),
        accepted=Absolute(within),
    )


def finding_of(claim: Claim) -> Finding:
    paper = replace(PAPER, results=(), claims=(claim,))
    (found,) = findings_of(paper.claims, evidence(paper))
    return found


def test_every_claim_has_a_finding_in_the_order_of_declaration() -> None:
    found = findings_of(CLAIMS, evidence(guess=[[0.05] * 3], wide=[[0.5] * 3]))

    assert [(f.table, f.row, f.column) for f in found] == [claim.place for claim in CLAIMS]
    assert [f.printed for f in found] == [claim.printed.text for claim in CLAIMS]


@pytest.mark.parametrize(
    ("value", "verdict", "side"),
    [(2.0, "reproduced", None), (1.0, "contradicted", "lower"), (3.0, "contradicted", "higher")],
)
def test_constant_value_is_judged_against_the_band(
    value: float, verdict: str, side: str | None
) -> None:
    found = finding_of(sentence(Printed("2.0"), value))

    assert (found.verdict, found.side) == (verdict, side)
    assert found.measured == (value, value)
    assert found.accepted == pytest.approx((1.95, 2.05))
    assert (found.claim, found.where, found.table) == ("it is so", "p. 4", None)


def test_numbers_are_in_the_printed_unit() -> None:
    found = finding_of(sentence(Printed("90", "deg"), math.pi / 2))

    assert found.verdict == Verdict.REPRODUCED
    assert found.value == pytest.approx(90)
    assert found.measured == pytest.approx((90, 90))
    assert found.unit == "deg"


def test_claim_without_runs_is_not_run_and_names_them() -> None:
    guess, wide, *_ = findings_of(CLAIMS, evidence(guess=[[0.05] * 3]))

    assert wide.verdict == Verdict.NOT_RUN
    assert wide.note == "no whole repeat of search/bowl/wide"
    assert (wide.measured, wide.value, wide.side) == (None, None, None)
    assert guess.verdict == Verdict.REPRODUCED


def test_claim_with_a_gap_is_not_reproducible_for_its_reason() -> None:
    gap = Gap(what="times on the arm", where="p. 9", because="it needs the arm")
    arm = replace(sentence(Printed("16.4", "%"), 1.0), measure=None, gap=gap)

    found = finding_of(arm)

    assert (found.verdict, found.note) == (Verdict.NOT_REPRODUCIBLE, "it needs the arm")
    assert (found.measured, found.measure) == (None, "")


def test_one_repeat_is_provisional_and_two_are_not() -> None:
    once = findings_of(CLAIMS, evidence(guess=[[0.05] * 3], wide=[[0.5] * 3]))
    twice = findings_of(CLAIMS, evidence(guess=[[0.05] * 3] * 2, wide=[[0.5] * 3] * 2))

    assert {f.note for f in once} == {PROVISIONAL, THIN}
    assert {f.note for f in twice} == {""}
    assert {f.repeats for f in twice} == {2}


def test_claim_that_needs_no_runs_is_never_provisional() -> None:
    found = finding_of(sentence(Printed("2.0"), 2.0))

    assert (found.note, found.repeats, found.quantile) == ("", 0, None)


def test_quantile_is_the_share_of_tables_below_the_printed_value() -> None:
    tied, *_ = findings_of(CLAIMS, evidence(guess=[[0.05] * 3]))
    below, *_ = findings_of(CLAIMS, evidence(guess=[[0.2] * 3]))
    among, *_ = findings_of(CLAIMS, evidence(guess=[[0.04, 0.05, 0.06]] * 40))

    assert (tied.quantile, below.quantile) == (0.5, 0.0)
    # a mean of three from a symmetric distribution; the standard error of a share of 2000 tables
    # is 0.011: 5 of them
    assert among.quantile == pytest.approx(0.5, abs=0.06)


def test_measured_interval_holds_the_central_tables() -> None:
    costs = np.random.default_rng(1).lognormal(size=(20, 3))
    found, *_ = findings_of(CLAIMS, evidence(guess=costs.tolist()))

    assert found.measured is not None
    low, high = found.measured
    standard_error = float(costs.std()) / 3**0.5
    assert low < float(costs.mean()) < high
    assert high - low > 2 * standard_error


def published(costs: list[list[float]], scale: float) -> Paper:
    cell = np.array(costs[0]) * scale
    page = f"""
        Table 1, p. 3
        problem | statistic || guess
        bowl    | mean      || {cell.mean():.2e}
                | std       || {cell.std(ddof=1):.2e}
    """
    table = PublishedTable.read(page)
    claims = tuple(replace(claim, table=table) for claim in CLAIMS if claim.column == "guess")
    return replace(PAPER, results=(table,), claims=claims)


def contradicted_share(scale: float) -> float:
    rng = np.random.default_rng(5)
    verdicts = []
    for _ in range(40):
        costs = rng.normal(1.0, 0.1, size=(5, 20)).tolist()
        paper = published(costs, scale)
        found = findings_of(paper.claims, evidence(paper, guess=costs))
        verdicts += [f.verdict for f in found]
    return verdicts.count(Verdict.CONTRADICTED) / len(verdicts)


def test_our_own_runs_as_a_paper_prints_them_are_not_contradicted() -> None:
    assert contradicted_share(1.0) <= 0.05


def test_ten_times_our_own_runs_are_contradicted() -> None:
    assert contradicted_share(10.0) >= 0.95


def test_finding_says_what_was_measured_and_what_was_accepted() -> None:
    first, *_ = findings_of(CLAIMS, evidence(guess=[[0.05] * 3]))
    ranked = finding_of(replace(sentence(Printed("1", "rank"), 1.0), accepted=Between(1, 1)))

    assert first.where == TABLE.where
    assert first.measure == "mean cost of guess on bowl"
    assert first.tolerance == "within 25 % and the printed rounding"
    assert (ranked.measure, ranked.tolerance) == ("as it is", "exactly 1")


def of_best(*repeats: float) -> Finding:
    statistic = Statistic(experiment="e", problem="p", algorithm="a", statistic="best")
    claim = replace(sentence(Printed("1"), 1.0), measure=statistic)
    empty = np.zeros((len(repeats), 4, 1))
    costs = np.array([[value + k for k in range(4)] for value in repeats])
    runs = Runs(costs=costs, points=empty, histories=empty, evaluations=1)
    return judged(claim, evidence_of(PAPER, {("e", "p", "a"): runs}))[0]


def test_no_extreme_is_contradicted_by_one_repeat() -> None:
    once, often = of_best(90.0), of_best(*[90.0] * 20)

    assert (once.verdict, once.side, once.note) == (Verdict.UNDECIDED, None, THIN)
    assert (often.verdict, often.side) == (Verdict.CONTRADICTED, "higher")


def test_only_consistent_numbers_say_by_which_factor_they_could_be_off() -> None:
    spread = [[0.02, 0.05, 0.12]] * 4
    consistent, *_ = findings_of(CLAIMS, evidence(guess=spread))
    reproduced, *_ = findings_of(CLAIMS, evidence(guess=[[0.05] * 3] * 2))

    assert consistent.verdict is Verdict.CONSISTENT
    assert isinstance(consistent.unseen, float)
    assert consistent.measured is not None
    low, high = consistent.measured
    assert consistent.unseen == pytest.approx(max(high / 0.05, 0.05 / low))
    assert (reproduced.verdict, reproduced.unseen) == (Verdict.REPRODUCED, None)


def test_finding_counts_under_its_own_place_unless_it_shares_a_result_or_counts_not() -> None:
    own = sentence(Printed("2.0"), 2.0)
    shared, shown = replace(own, group="one result"), replace(own, counts=False)

    assert [finding_of(claim).group for claim in (own, shared, shown)] == [
        "it is so",
        "one result",
        None,
    ]
    assert findings_of(CLAIMS, evidence(guess=[[0.05] * 3]))[0].group == "Table 1, bowl mean, guess"


def test_gap_about_a_result_is_a_result_that_is_not_reproducible() -> None:
    gap = Gap(what="times on the arm", where="p. 9", because="it needs the arm")
    method = replace(gap, what="order of the work", result=False)
    paper = replace(PAPER, results=(), claims=(), gaps=(gap, method))

    (found,) = findings_of(paper.said, evidence(paper))

    assert (found.verdict, found.claim, found.group) == (
        Verdict.NOT_REPRODUCIBLE,
        "times on the arm",
        "times on the arm",
    )


def test_gap_that_a_claim_carries_is_said_once() -> None:
    gap = Gap(what="times on the arm", where="p. 9", because="it needs the arm")
    carrying = replace(sentence(Printed("16.4", "%"), 1.0), measure=None, gap=gap)
    paper = replace(PAPER, results=(), claims=(carrying,), gaps=(gap,))

    assert paper.said == (carrying,)


def test_cell_left_to_a_gap_is_not_measured() -> None:
    gap = Gap(what="quoted column", where="p. 9", because="another budget")
    left = replace(CLAIMS[0], gap=gap)

    (found,) = findings_of((left,), evidence(guess=[[0.05] * 3]))

    assert (found.verdict, found.note) == (Verdict.NOT_REPRODUCIBLE, "another budget")
    assert (found.measured, found.printed) == (None, "0.05")
