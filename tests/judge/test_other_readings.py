from dataclasses import replace

import numpy as np
import pytest

from repro.judge.findings import Finding, findings_of
from repro.judge.other_readings import (
    AS_CHOSEN,
    FARTHEST,
    evidence_under_readings,
    fingerprints,
)
from repro.judge.verdict import Verdict
from repro.model.assumptions import Alternative, Assumption
from repro.model.claims import CellClaim
from repro.model.evidence import Evidence, Runs
from repro.model.measures.measure import Computed
from repro.model.paper import Paper
from tests.small_papers import CLAIMS, PAPER, evidence_of


def open_paper(*alternatives: Alternative) -> Paper:
    assumption = Assumption(
        what="width", chosen="ours", alternatives=alternatives, because="so", where="p. 3"
    )
    return replace(PAPER, assumptions=(assumption,))


WIDER = Alternative(
    name="wider", says="three times", algorithms={("search", "guess"): {"width": 3.0}}
)


def runs(cost: float) -> Runs:
    return Runs(
        costs=np.full((2, 3), cost),
        points=np.zeros((2, 3, 2)),
        histories=np.zeros((1, 3, 5)),
        evaluations=20,
    )


def judged(paper: Paper, found: Evidence) -> tuple[Finding, ...]:
    return findings_of(paper.claims, found, evidence_under_readings(paper, found))


def evidence(paper: Paper, *, guess: float, **readings: float) -> Evidence:
    cells = {
        ("search", "bowl", "guess"): runs(guess),
        ("search", "bowl", "wide"): runs(0.5),
    }
    others = {(f"search [{name}]", "bowl", "guess"): runs(cost) for name, cost in readings.items()}
    return evidence_of(paper, cells | others)


def test_number_that_a_reading_holds_depends_on_it() -> None:
    paper = open_paper(WIDER)
    found = evidence(paper, guess=5.0, wider=0.05)

    mean, *_ = judged(paper, found)

    assert (mean.verdict, mean.side, mean.turns_on) == (Verdict.DEPENDS, None, ("wider",))
    (outcome,) = mean.readings
    assert (outcome.reading, outcome.verdict) == ("wider", Verdict.REPRODUCED)
    assert (outcome.measured, outcome.repeats) == ((0.05, 0.05), 2)


def test_number_that_every_reading_contradicts_is_contradicted() -> None:
    paper = open_paper(WIDER)
    found = evidence(paper, guess=5.0, wider=50.0)

    mean, *_ = judged(paper, found)

    assert [outcome.side for outcome in mean.readings] == ["higher"]
    assert (mean.verdict, mean.turns_on) == (Verdict.CONTRADICTED, ())


def test_no_reading_is_promoted_because_it_fits() -> None:
    paper = open_paper(WIDER)
    found = evidence(paper, guess=5.0, wider=0.05)

    plain, *_ = findings_of(paper.claims, found)
    varied, *_ = judged(paper, found)

    assert (varied.measured, varied.value) == (plain.measured, plain.value)


def test_reading_bears_only_on_numbers_whose_runs_it_changes() -> None:
    paper = open_paper(WIDER)
    found = evidence(paper, guess=5.0, wider=0.05)

    findings = judged(paper, found)

    assert {f.column: len(f.readings) for f in findings if f.row == "bowl mean"} == {
        "guess": 1,
        "wide": 0,
    }


def test_held_number_is_judged_under_every_reading_too() -> None:
    paper = open_paper(WIDER)

    agreeing, *_ = judged(paper, evidence(paper, guess=0.05, wider=0.05))
    opposed, *_ = judged(paper, evidence(paper, guess=0.05, wider=0.5))

    assert (agreeing.verdict, len(agreeing.readings)) == (Verdict.REPRODUCED, 1)
    assert (opposed.verdict, opposed.turns_on) == (Verdict.DEPENDS, ("wider",))


def test_reading_that_was_not_run_says_nothing() -> None:
    paper = open_paper(WIDER)

    assert evidence_under_readings(paper, evidence(paper, guess=5.0)) == ()


def test_reading_of_a_computed_number_needs_no_run() -> None:
    claim = replace(CLAIMS[0], measure=Computed(how="by hand", value=lambda: 0.05))
    paper = open_paper(Alternative(name="rule", says="by hand", claims=(claim,)))
    found = evidence(paper, guess=5.0)

    mean, *_ = judged(paper, found)

    assert mean.turns_on == ("rule",)


@pytest.mark.parametrize(
    ("guess", "wider", "nearest"),
    [(5.0, 0.05, "wider"), (0.05, 5.0, AS_CHOSEN)],
)
def test_fingerprint_names_the_reading_that_is_nearest_to_the_column(
    guess: float, wider: float, nearest: str
) -> None:
    paper = mean_only(open_paper(WIDER))
    found = evidence(paper, guess=guess, wider=wider)

    (column,) = (
        p
        for p in fingerprints(paper.claims, found, evidence_under_readings(paper, found))
        if p.column == "guess"
    )

    assert column.nearest == nearest
    assert {round(column.chosen, 6), round(column.others[0][1], 6)} == {0.0, 2.0}


def test_fingerprint_counts_the_numbers_that_the_re_run_comes_out_below() -> None:
    paper = mean_only(open_paper(WIDER))

    lower = {
        guess: sum(p.lower for p in fingerprints(paper.claims, evidence(paper, guess=guess), ()))
        for guess in (0.01, 0.05, 5.0)
    }

    # the mean of the other column is as printed
    assert lower == {0.01: 1, 0.05: 0, 5.0: 0}


def test_zero_is_farther_from_a_number_than_any_other_double() -> None:
    paper = mean_only(open_paper(WIDER))
    found = evidence(paper, guess=0.0, wider=5e-324)

    (column,) = (
        p
        for p in fingerprints(paper.claims, found, evidence_under_readings(paper, found))
        if p.column == "guess"
    )

    assert column.chosen == FARTHEST > column.others[0][1] > 300


def mean_only(paper: Paper) -> Paper:
    means = tuple(c for c in CLAIMS if isinstance(c, CellClaim) and "mean" in c.row)
    return replace(paper, results=(), claims=means)
