from dataclasses import replace

import numpy as np
import pytest

from repro.functions import FUNCTIONS
from repro.judge.centre_bias import centre_biases, shift_costs
from repro.model.evidence import Evidence, Runs
from repro.report.views.centre_bias import CentreBiasView, centre_bias_view
from repro.runs.moved_optima import CONTROL, FLOOR, IN_PLACE, SHARES, shift_name
from repro.runs.studies import study_name
from tests.doe2021 import PAPER, TEST
from tests.small_papers import evidence_of

EXPERIMENT = replace(TEST, problems={**TEST.problems, "F2": FUNCTIONS["branin"].problem()})
WIDER = replace(PAPER, experiments=(EXPERIMENT, *PAPER.experiments[1:]))
NAMES = ("WOA", "PSO", CONTROL, FLOOR)
SPREAD = np.random.default_rng(2).uniform(0.9, 1.1, size=(3, 4))


def runs(factor: float, repeats: int) -> Runs:
    costs = factor * SPREAD[:repeats]
    return Runs(
        costs=costs,
        points=np.ones((*costs.shape, 3)),
        histories=np.ones((*costs.shape, 12)),
        evaluations=72,
    )


def evidence(repeats: int = 1) -> Evidence:
    """Return evidence in which WOA gets worse with the shift and nothing else does."""
    found = {("test", "F1", name): runs(1.0, 3) for name in EXPERIMENT.algorithms}
    for share in (IN_PLACE, *SHARES):
        for name in NAMES:
            factor = 1000.0 if share and name == "WOA" else 1.0
            found[study_name("test", shift_name(share)), "F1", name] = runs(factor, repeats)
    return evidence_of(WIDER, found)


def view() -> CentreBiasView:
    (found,) = centre_biases(WIDER, evidence())
    return centre_bias_view(WIDER.key, found)


def test_only_problems_with_their_optimum_about_the_centre_take_part() -> None:
    assert view().found.problems == ("F1",)
    assert view().found.left_out == ("F2",)


def test_a_method_that_loses_by_the_shift_is_flagged_and_its_company_is_not() -> None:
    assert view().found.flagged == ("WOA",)
    biased, *others = view().rows
    assert [name for name, *_ in view().rows] == list(NAMES)
    assert all(text.startswith("1000 [1000, 1000], p = ") for text in biased[1:])
    assert all(text.endswith(", biased") for text in biased[1:])
    assert all(text == "1 [1, 1], p = 1" for _, *texts in others for text in texts)


def test_ranking_is_of_the_papers_own_algorithms() -> None:
    assert view().ranks == (("WOA", "1.50", "2.00", "2.00", "2.00"), ("PSO", "1.50", *["1.00"] * 3))
    assert view().place == (
        "WOA stands 1 of 2 in place, 2 of 2 with shift 0.1, 2 of 2 with shift 0.2, "
        "2 of 2 with shift 0.4 by mean rank over 1 problem."
    )


@pytest.mark.parametrize("repeats", [1, 2])
def test_as_many_repeats_count_in_place_as_were_shifted(repeats: int) -> None:
    costs = shift_costs(evidence(repeats), EXPERIMENT)

    assert {values.shape for values in costs.values()} == {(repeats, 4)}
    assert costs[IN_PLACE, "F1", "WOA"].tolist() == SPREAD[:repeats].tolist()


def test_shifted_runs_that_are_not_all_there_are_not_shown() -> None:
    whole = evidence()
    cell = (study_name("test", shift_name(SHARES[-1])), "F1", FLOOR)
    part = evidence_of(WIDER, {key: each for key, each in whole.runs.items() if key != cell})

    assert len(centre_biases(WIDER, whole)) == 1
    assert centre_biases(WIDER, part) == ()
