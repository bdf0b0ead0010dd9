from dataclasses import replace

import numpy as np
import pytest

from repro.model.experiment import Experiment
from repro.optimisers import DBO, DE, GA, WOA, HybridWOA, Optimiser, SteadyStateGA
from repro.runs.equal_budget import at_equal_evaluations, budget, declared_evaluations, unequal
from tests.optimisers.test_optimisers import EVERY
from tests.small_problems import small

PROTOCOL = Experiment(
    name="search",
    where="p. 3",
    proposed="WOA",
    problems={"slope": small("slope")},
    algorithms={"WOA": WOA(), "DE": DE(), "GA": GA()},
    population=24,
    iterations=10,
    runs=3,
)


@pytest.mark.parametrize("optimiser", [*EVERY, DBO(producers=0.75), GA(elites=0)], ids=repr)
def test_declared_evaluations_are_those_that_a_run_spends(optimiser: Optimiser) -> None:
    result = optimiser.minimise(
        small("slope"), population=24, iterations=10, rng=np.random.default_rng(1)
    )

    assert declared_evaluations(optimiser, 24, 10) == result.evaluations


def test_steady_state_spends_no_more_than_it_declares() -> None:
    problem = small("slope")

    SteadyStateGA().minimise(problem, population=24, iterations=10, rng=np.random.default_rng(1))

    assert 0 < problem.calls <= declared_evaluations(SteadyStateGA(), 24, 10)


def test_algorithms_of_another_budget_are_named_with_what_they_spend() -> None:
    assert unequal(PROTOCOL) == {"DE": 24 * 11, "GA": 24 + 22 * 10}


def test_only_algorithms_of_another_budget_run_again_with_that_of_the_protocol() -> None:
    again = at_equal_evaluations(PROTOCOL)

    assert again
    assert set(again.algorithms) == {"DE", "GA"}
    assert (again.evaluations, budget(PROTOCOL)) == (240, 240)


def test_protocol_of_one_budget_needs_no_other_run() -> None:
    fair: dict[str, Optimiser] = {"WOA": WOA(), "HybridWOA": HybridWOA()}

    assert at_equal_evaluations(replace(PROTOCOL, algorithms=fair)) is None
