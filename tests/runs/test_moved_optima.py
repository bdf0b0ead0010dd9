from dataclasses import replace

import pytest

from papers.liang2026 import PAPER as LIANG
from papers.smwoa2022 import PAPER as SMWOA
from repro.errors import InputError
from repro.functions import FUNCTIONS
from repro.functions.shifted import ShiftedProblem
from repro.model.experiment import Experiment
from repro.optimisers import DE, WOA
from repro.runs.moved_optima import CONTROL, FLOOR, IN_PLACE, SHARES, centred, shifted
from repro.runs.plan import plan
from tests.small_papers import PAPER

LIANG_TEST, LIANG_MOTION = LIANG.experiments
SMWOA_TEST = SMWOA.experiments[0]


def derived(share: float, experiment: Experiment = LIANG_TEST) -> Experiment:
    return shifted(experiment, share, floor=WOA())


def test_benchmark_functions_with_their_optimum_about_the_centre_are_shifted() -> None:
    assert centred(LIANG_TEST) == ("F1", "F5", "F10", "F12")
    assert centred(SMWOA_TEST) == tuple(f"F{k}" for k in range(1, 11))
    assert centred(LIANG_MOTION) == ()


def test_an_optimum_off_the_centre_in_one_coordinate_is_left_out() -> None:
    branin = {"F": FUNCTIONS["branin"].problem()}

    assert centred(replace(LIANG_TEST, problems=branin)) == ()


@pytest.mark.parametrize(("off", "counts"), [(4.9, True), (-4.9, True), (5.1, False)])
def test_an_optimum_counts_as_central_up_to_a_twentieth_of_the_half_width(
    off: float, *, counts: bool
) -> None:
    sphere = replace(FUNCTIONS["sphere"], box=((off - 100.0, off + 100.0),))
    experiment = replace(LIANG_TEST, problems={"F": sphere.problem(3)})

    assert bool(centred(experiment)) is counts


def test_the_derived_experiment_is_the_papers_but_for_place_and_company() -> None:
    experiment = derived(0.2)

    assert experiment.problems == {
        name: ShiftedProblem(problem=problem, share=0.2)
        for name, problem in LIANG_TEST.problems.items()
    }
    assert experiment.algorithms == {**LIANG_TEST.algorithms, CONTROL: DE(), FLOOR: WOA()}
    assert (experiment.runs, experiment.iterations) == (30, 500)


def test_in_place_only_the_company_is_run() -> None:
    experiment = derived(IN_PLACE)

    assert experiment.problems == LIANG_TEST.problems
    assert experiment.algorithms == {CONTROL: DE(), FLOOR: WOA()}


@pytest.mark.parametrize("share", [IN_PLACE, *SHARES])
def test_a_shifted_run_draws_the_random_numbers_of_the_run_in_place(share: float) -> None:
    experiment = replace(derived(share), name="aside")
    paper = replace(PAPER, experiments=(LIANG_TEST, experiment), results=(), claims=())
    streams: dict[str, set[str]] = {}
    for task in plan([paper], 1):
        streams.setdefault(task.experiment, set()).add(task.stream)
        assert task.name.startswith(f"small2020/{task.experiment}/")

    if share:
        assert streams["benchmark"] < streams["aside"]
    assert all(name.startswith("small2020/benchmark/") for name in streams["aside"])


@pytest.mark.parametrize("share", SHARES)
def test_every_shifted_optimum_lies_off_the_centre_and_within_the_middle_half(share: float) -> None:
    for problem in [
        *derived(share).problems.values(),
        *derived(share, SMWOA_TEST).problems.values(),
    ]:
        low, high = problem.bounds.T
        off = abs(problem.minimiser - (low + high) / 2) / ((high - low) / 2)
        assert (off > 0).all()
        assert (off <= 0.5).all()
        assert (off**2).mean() ** 0.5 > 0.6 * share


def test_an_experiment_without_such_problems_is_refused() -> None:
    with pytest.raises(InputError, match="motion: no benchmark function"):
        derived(0.2, LIANG_MOTION)
