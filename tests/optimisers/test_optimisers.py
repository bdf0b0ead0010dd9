from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from repro.errors import InputError
from repro.functions import FUNCTIONS
from repro.optimisers import (
    DBO,
    DE,
    GA,
    GSA,
    GWO,
    PSO,
    SMA,
    WOA,
    HybridWOA,
    Optimiser,
    RandomSearch,
    Result,
    SlimeWOA,
    SteadyStateGA,
)
from repro.optimisers.libraries import BASELINES
from repro.optimisers.search import (
    DeclaresSpending,
    HoldsInterpreter,
    LeavesBox,
    NeedsScratch,
    hands_to_search,
)
from tests.additions import ADDITIONS, SLIME, SLIME_DETAILS, SLIME_PARTS, SLIME_TOGETHER, TOGETHER
from tests.budgets import examples
from tests.small_problems import OFF_CENTRE, Small, small

EVERY = (
    *(WOA(), GWO(), PSO(), DBO(), SMA(), GSA(), GSA(bounds="clip"), DE(), GA()),
    *(RandomSearch(), TOGETHER, SLIME_TOGETHER),
)
HOLDING = (*EVERY, *ADDITIONS, *SLIME)

each_optimiser = pytest.mark.parametrize("optimiser", EVERY, ids=lambda o: repr(o)[:30])


def run(optimiser: Optimiser, problem: Small, *, seed: int = 1, **budget: int) -> Result:
    spent = {"population": 24, **(budget or {"iterations": 10})}
    return optimiser.minimise(problem, rng=np.random.default_rng(seed), **spent)


@each_optimiser
def test_evaluations_are_the_calls_of_the_compiled_cost(optimiser: Optimiser) -> None:
    problem = small("slope")

    result = run(optimiser, problem)

    assert result.evaluations == problem.calls


@pytest.mark.parametrize(
    ("optimiser", "evaluations"),
    [
        *((o, 24 * 10) for o in (WOA(), GWO(), PSO(), SMA(), GSA(), HybridWOA(), RandomSearch())),
        *((o, 24 * 11) for o in (DBO(), DE())),
        (DBO(producers=0.75), 24 + (24 + 6) * 10),  # beetles 13 to 18 belong to two groups
        (GA(), 24 + 22 * 10),  # two elites are not evaluated again
        (HybridWOA(differential=0.25), 30 * 10),
        (HybridWOA(genetic=0.25), 30 * 10),
        (HybridWOA(disturbance=0.1), 25 * 10),
    ],
    ids=repr,
)
def test_evaluations_are_those_of_the_source(optimiser: Optimiser, evaluations: int) -> None:
    assert run(optimiser, small("slope"), iterations=10).evaluations == evaluations


@each_optimiser
@settings(max_examples=examples(10), deadline=None)
@given(budget=st.integers(100, 900))
def test_budget_of_evaluations_is_never_exceeded_and_never_half_used(
    optimiser: Optimiser, budget: int
) -> None:
    problem = small("slope")
    iteration = run(optimiser, problem, iterations=2).evaluations
    iteration -= run(optimiser, problem, iterations=1).evaluations

    result = run(optimiser, problem, evaluations=budget)

    assert budget - iteration < result.evaluations <= budget


@each_optimiser
def test_history_is_the_best_cost_so_far_of_every_iteration(optimiser: Optimiser) -> None:
    problem, same = small("rosenbrock", room=3000), small("rosenbrock")
    once, twice = (run(optimiser, same, iterations=n).evaluations for n in (1, 2))

    result = run(optimiser, problem, iterations=40)

    best_so_far = np.minimum.accumulate([same.cost(x) for x in problem.points])
    ends = once + (twice - once) * np.arange(40)
    assert result.history.tolist() == best_so_far[ends - 1].tolist()
    assert result.cost == best_so_far[-1] == same.cost(result.x.tolist())


@each_optimiser
def test_equal_generators_give_equal_results_and_one_generator_moves_on(
    optimiser: Optimiser,
) -> None:
    problem, rng = small("rosenbrock"), np.random.default_rng(5)

    first = optimiser.minimise(problem, population=24, iterations=10, rng=rng)
    second = optimiser.minimise(problem, population=24, iterations=10, rng=rng)
    again = run(optimiser, problem, seed=5)

    assert again.x.tolist() == first.x.tolist()
    assert again.history.tolist() == first.history.tolist()
    assert second.history.tolist() != first.history.tolist()


@pytest.mark.parametrize("optimiser", HOLDING, ids=repr)
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_best_point_lies_inside_the_box(optimiser: Optimiser, seed: int) -> None:
    lower, upper = np.array(OFF_CENTRE).T

    x = run(optimiser, small("slope"), seed=seed).x

    assert (lower <= x).all()
    assert (x <= upper).all()


def test_particles_leave_the_box_where_only_the_last_is_clipped() -> None:
    lower = np.array(OFF_CENTRE)[:, 0]

    assert (run(PSO(clip="last particle"), small("slope")).x < lower).all()


@each_optimiser
def test_search_goes_down_a_slope(optimiser: Optimiser) -> None:
    result = run(optimiser, small("slope"), iterations=300)

    assert result.cost < -45.0  # the corner costs -51; the worst of 300 seeds reached -46.9


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("name", ["rosenbrock", "steps", "slope"])
def test_whales_without_additions_are_the_whale_algorithm(name: str, seed: int) -> None:
    tried, tried_by_hybrid = small(name, room=1000), small(name, room=1000)

    plain = run(WOA(), tried, seed=seed, iterations=30)
    hybrid = run(HybridWOA(), tried_by_hybrid, seed=seed, iterations=30)

    assert tried_by_hybrid.points == tried.points
    assert hybrid.history.tolist() == plain.history.tolist()
    assert hybrid.x.tolist() == plain.x.tolist()
    assert hybrid.evaluations == plain.evaluations


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("name", ["rosenbrock", "steps", "slope"])
def test_slime_whales_without_parts_are_the_whale_algorithm(name: str, seed: int) -> None:
    plain = run(WOA(), small(name), seed=seed, iterations=30)
    slime = run(SlimeWOA(), small(name), seed=seed, iterations=30)

    assert slime.history.tolist() == plain.history.tolist()
    assert slime.x.tolist() == plain.x.tolist()
    assert slime.evaluations == plain.evaluations


@pytest.mark.parametrize("reading", SLIME_DETAILS, ids=repr)
def test_each_reading_of_the_slime_parts_changes_the_run(reading: SlimeWOA) -> None:
    before = run(SLIME_TOGETHER, small("rosenbrock"), iterations=20)
    after = run(reading, small("rosenbrock"), iterations=20)

    assert after.history.tolist() != before.history.tolist()


@pytest.mark.parametrize("addition", [*ADDITIONS, *SLIME_PARTS], ids=repr)
def test_each_addition_alone_changes_the_run(addition: Optimiser) -> None:
    plain = run(HybridWOA(), small("rosenbrock"), iterations=20)

    changed = run(addition, small("rosenbrock"), iterations=20)

    assert changed.history.tolist() != plain.history.tolist()


@pytest.mark.parametrize(
    ("parent", "child"),
    [
        (HybridWOA(differential=0.4), HybridWOA(differential=0.4, scale=0.9)),
        (HybridWOA(differential=0.4), HybridWOA(differential=0.4, crossover=0.1)),
        (HybridWOA(differential=0.4), HybridWOA(differential=0.4, greedy=False)),
        (HybridWOA(differential=0.4), HybridWOA(differential=0.4, evolves="any")),
        (HybridWOA(genetic=0.4), HybridWOA(genetic=0.4, mutation=0.1)),
        (HybridWOA(genetic=0.4), HybridWOA(genetic=0.4, greedy=False)),
    ],
    ids=repr,
)
def test_each_detail_of_an_addition_changes_the_run(parent: HybridWOA, child: HybridWOA) -> None:
    before = run(parent, small("rosenbrock"), iterations=20)
    after = run(child, small("rosenbrock"), iterations=20)

    assert after.history.tolist() != before.history.tolist()


@pytest.mark.parametrize(
    ("optimiser", "least"),
    [
        *((o, 1) for o in (WOA(), PSO(), SMA(), GSA(), SteadyStateGA(), RandomSearch())),
        (GWO(), 3),
        *((o, 4) for o in (DE(), HybridWOA())),
        (DBO(), 20),
        (DBO(groups="proportional"), 5),
        (GA(), 3),
        (GA(elites=0), 2),
        (GA(elites=9), 10),
    ],
    ids=repr,
)
def test_population_that_is_too_small_is_refused_with_the_least(
    optimiser: Optimiser, least: int
) -> None:
    with pytest.raises(InputError, match=f"population {least - 1} is too small.* {least} or more"):
        run(optimiser, small("slope"), population=least - 1, iterations=3)

    assert run(optimiser, small("slope"), population=least, iterations=3).history.shape == (3,)


@pytest.mark.parametrize(
    ("optimiser", "enough"), [(WOA(), 24), (DBO(), 48), (DE(), 48), (GA(), 46)], ids=repr
)
def test_budget_that_pays_for_no_iteration_is_refused(optimiser: Optimiser, enough: int) -> None:
    with pytest.raises(InputError, match="pay for no iteration"):
        run(optimiser, small("slope"), evaluations=enough - 1)

    assert run(optimiser, small("slope"), evaluations=enough).evaluations == enough


@pytest.mark.parametrize("budget", [{}, {"iterations": 5, "evaluations": 500}])
def test_budget_is_either_iterations_or_evaluations(budget: dict[str, Any]) -> None:
    rng = np.random.default_rng(1)

    with pytest.raises(InputError, match="either iterations or evaluations"):
        WOA().minimise(small("slope"), population=24, rng=rng, **budget)


@pytest.mark.parametrize(
    "box",
    [
        ((1.0, 0.0),),
        ((0.0, np.inf),),
        ((np.nan, 1.0),),
        ((0.0, 1.0, 2.0),),
        (),
        (0.0, 1.0),
    ],
    ids=repr,
)
def test_impossible_bounds_are_refused(box: Sequence[Any]) -> None:
    problem = small("slope", box=tuple(box))

    with pytest.raises(InputError, match="finite pairs lower <= upper"):
        run(WOA(), problem)


@pytest.mark.parametrize(
    ("kind", "field", "value"),
    [
        (HybridWOA, "differential", 1.1),
        (HybridWOA, "genetic", -0.1),
        (HybridWOA, "crossover", 2.0),
        (DBO, "producers", 1.1),
        (SMA, "restart", 1.1),
        (SlimeWOA, "restart", -0.1),
        (GSA, "final_percent", 101.0),
        (GSA, "bounds", "bounce"),
        (HybridWOA, "evolves", "the best"),
        (SMA, "contraction", "none"),
        (DE, "crossover", -0.1),
        (GA, "crossover", 1.1),
        (GA, "mutation", -0.1),
        (GA, "elites", -1),
    ],
)
def test_impossible_parameter_is_refused_by_name(
    kind: Callable[..., Optimiser], field: str, value: object
) -> None:
    with pytest.raises(InputError, match=f"{field}={value!r}"):
        kind(**{field: value})


def test_optimisers_say_more_of_themselves_by_protocols() -> None:
    assert PSO(clip="last particle").leaves_box
    assert not PSO().leaves_box
    assert not isinstance(WOA(), LeavesBox | HoldsInterpreter | DeclaresSpending)
    assert hands_to_search(WOA())
    assert isinstance(DE(), DeclaresSpending)
    assert all(
        isinstance(each, HoldsInterpreter) for name, each in BASELINES.items() if "(" in name
    )
    assert isinstance(FUNCTIONS["ackley"].problem(3), NeedsScratch)
