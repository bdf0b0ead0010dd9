import subprocess
import sys
import warnings
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from repro.determinism.compiled import jit
from repro.errors import InputError
from repro.functions import FUNCTIONS
from repro.optimisers import Problem, Result
from repro.optimisers.libraries import BASELINES, CMAES, ScipySLSQP
from repro.optimisers.libraries.budget import WORST, BudgetSpent, CountedCost, release, until_spent
from tests.budgets import examples
from tests.small_problems import KERNELS, OFF_CENTRE, Small, small

Vector = NDArray[np.float64]
FROM_LIBRARIES = [name for name in BASELINES if name != "random search"]

each_baseline = pytest.mark.parametrize("name", BASELINES)
each_from_a_library = pytest.mark.parametrize("name", FROM_LIBRARIES)


def _constant(x: Vector, data: Vector) -> float:  # noqa: ARG001
    data[0] += 1.0
    return 3.0


def _holed(x: Vector, data: Vector) -> float:
    data[0] += 1.0
    return np.nan if x[0] < 1.0 else x[0] + x[1]


def _nowhere(x: Vector, data: Vector) -> float:  # noqa: ARG001
    data[0] += 1.0
    return np.nan


def _endless(x: Vector, data: Vector) -> float:
    data[0] += 1.0
    return np.inf if x[0] < 1.0 else 1e300 * x[1]


HOSTILE = {
    "constant": jit(_constant),
    "holed": jit(_holed),
    "nowhere": jit(_nowhere),
    "endless": jit(_endless),
}


def hostile(name: str, box: tuple[tuple[float, float], ...] = OFF_CENTRE) -> Small:
    return Small(name=name, kernel=HOSTILE[name], data=np.zeros(2), box=box)


def run(name: str, problem: Problem, *, seed: int = 1, **budget: int) -> Result:
    spent = {"population": 10, **(budget or {"iterations": 30})}
    return BASELINES[name].minimise(problem, rng=np.random.default_rng(seed), **spent)


@each_baseline
@settings(max_examples=examples(6), deadline=None)
@given(population=st.integers(1, 40), evaluations=st.integers(40, 500))
def test_budget_is_spent_in_whole_iterations_and_never_exceeded(
    name: str, population: int, evaluations: int
) -> None:
    problem = small("rosenbrock", room=500)

    result = run(name, problem, population=population, evaluations=evaluations)

    whole = evaluations - evaluations % population
    assert result.evaluations == problem.calls == whole
    assert result.history.shape == (evaluations // population,)


@each_baseline
@pytest.mark.parametrize("kind", ["rosenbrock", "steps", "slope"])
def test_history_is_the_best_of_what_was_asked_for(name: str, kind: str) -> None:
    problem, same = small(kind, room=300), small(kind)

    result = run(name, problem)

    best_so_far = np.minimum.accumulate([same.cost(x) for x in problem.points])
    assert result.history.tolist() == best_so_far[9::10].tolist()
    assert result.cost == best_so_far[-1] == same.cost(result.x.tolist())


@each_baseline
@pytest.mark.parametrize("kind", ["rosenbrock", "slope"])
def test_no_point_outside_the_box_is_asked_for(name: str, kind: str) -> None:
    problem = small(kind, room=300)

    run(name, problem)

    lower, upper = np.array(OFF_CENTRE).T
    asked = np.array(problem.points)
    assert ((lower <= asked) & (asked <= upper)).all()


@each_baseline
def test_equal_generators_give_equal_bits_and_one_generator_moves_on(name: str) -> None:
    problem, rng = small("rosenbrock"), np.random.default_rng(5)
    np.random.seed(3)  # noqa: NPY002 (a library may draw from it by mistake)

    first, second = (
        BASELINES[name].minimise(problem, population=10, iterations=40, rng=rng) for _ in range(2)
    )
    np.random.seed(4)  # noqa: NPY002
    again = run(name, problem, seed=5, iterations=40)

    assert again.x.tolist() == first.x.tolist()
    assert again.history.tolist() == first.history.tolist()
    assert second.history.tolist() != first.history.tolist()


@each_from_a_library
@pytest.mark.parametrize("seed", range(3))
def test_every_library_beats_random_search_on_the_sphere(name: str, seed: int) -> None:
    problem = FUNCTIONS["sphere"].problem(dimension=10)

    floor = run("random search", problem, seed=seed, population=20, iterations=100)
    found = run(name, problem, seed=seed, population=20, iterations=100)

    assert found.cost < 0.1 * floor.cost


@each_baseline
def test_cost_that_is_everywhere_the_same_is_met_in_silence(
    name: str, capfd: pytest.CaptureFixture[str]
) -> None:
    problem = hostile("constant")

    result = run(name, problem)

    assert (result.cost, result.evaluations, problem.calls) == (3.0, 300, 300)
    assert capfd.readouterr() == ("", "")


@each_baseline
@pytest.mark.parametrize("kind", ["holed", "endless"])
def test_cost_that_is_no_number_somewhere_is_never_the_best(name: str, kind: str) -> None:
    problem = hostile(kind)

    result = run(name, problem)

    assert np.isfinite(result.cost)
    assert result.x[0] >= 1.0
    assert result.evaluations == problem.calls == 300


@each_baseline
def test_cost_that_is_nowhere_a_number_gives_an_infinite_best_inside_the_box(name: str) -> None:
    result = run(name, hostile("nowhere"))

    lower, upper = np.array(OFF_CENTRE).T
    assert result.cost == np.inf
    assert ((lower <= result.x) & (result.x <= upper)).all()


@each_baseline
def test_coordinate_without_width_keeps_its_value(name: str) -> None:
    problem = small("slope", box=((-3.0, 7.0), (2.5, 2.5), (2.0, 4.0)))

    result = run(name, problem)

    assert result.x[1] == 2.5
    assert result.cost == problem.cost(result.x.tolist()) < 2.0


@each_baseline
def test_box_of_one_point_spends_the_budget_there(name: str) -> None:
    problem = small("slope", box=((1.0, 1.0), (-2.0, -2.0)))

    result = run(name, problem)

    assert (result.x.tolist(), result.cost, problem.calls) == ([1.0, -2.0], -1.0, 300)


@each_baseline
def test_impossible_budget_and_bounds_are_refused(name: str) -> None:
    with pytest.raises(InputError, match="pay for no iteration"):
        run(name, small("slope"), evaluations=9)
    with pytest.raises(InputError, match="either iterations or evaluations"):
        run(name, small("slope"), iterations=5, evaluations=500)
    with pytest.raises(InputError, match="finite pairs lower <= upper"):
        run(name, small("slope", box=((0.0, np.inf),)))


@each_baseline
def test_one_dimension_is_enough(name: str) -> None:
    result = run(name, Small(name="1", kernel=KERNELS["steps"], data=np.zeros(2), box=((-9, 9),)))

    assert result.cost == 0.0


def test_only_searches_from_libraries_hold_the_interpreter() -> None:
    holding = [name for name in BASELINES if getattr(BASELINES[name], "holds_interpreter", False)]

    assert holding == FROM_LIBRARIES


def test_parameters_and_release_are_part_of_the_words_that_key_a_run() -> None:
    assert repr(CMAES()) != repr(CMAES(step=0.3))
    assert f"release='{release('cmaes')}'" in repr(CMAES())
    assert repr(ScipySLSQP()) != repr(replace(ScipySLSQP(), release="0.1"))
    assert release("no-such-package") == "none"


def test_cost_counts_what_is_asked_and_ends_with_the_budget() -> None:
    cost = CountedCost(small("slope"), population=2, iterations=2)

    told = [cost(np.array([x, 0.0, 3.0])) for x in (5.0, 9.0, -9.0, 0.0)]

    assert told == [8.0, 10.0, 0.0, 3.0]  # outside counts as the nearest point inside
    with pytest.raises(BudgetSpent):
        cost(np.zeros(3))
    assert cost.result().history.tolist() == [8.0, 0.0]
    assert cost.result().x.tolist() == [-3.0, 0.0, 3.0]


def test_cost_that_is_not_finite_is_told_as_the_worst() -> None:
    cost = CountedCost(hostile("holed"), population=1, iterations=1)

    assert cost(np.array([0.0, 0.0, 3.0])) == WORST


def test_strategy_that_swallows_every_exception_is_stopped_all_the_same() -> None:
    def stubborn(cost: CountedCost, rng: np.random.Generator) -> None:  # noqa: ARG001
        try:
            cost(np.zeros(3))
        except Exception:  # noqa: BLE001 (the point of the test)
            pytest.fail("the end of the budget was swallowed")

    problem = small("slope")
    until_spent(stubborn, problem, population=5, iterations=2, rng=np.random.default_rng(1))

    assert problem.calls == 10


def test_what_a_library_warns_of_is_not_heard(capfd: pytest.CaptureFixture[str]) -> None:
    def warning(cost: CountedCost, rng: np.random.Generator) -> None:  # noqa: ARG001
        warnings.warn("a step left the box", stacklevel=1)
        cost(np.zeros(3) / np.zeros(3))

    until_spent(warning, small("slope"), population=5, iterations=2, rng=np.random.default_rng(1))

    assert capfd.readouterr() == ("", "")


def test_warnings_are_as_they_were_after_a_search() -> None:
    before = list(warnings.filters)

    run("SLSQP multistart (scipy)", small("slope"))

    assert warnings.filters == before


def test_baselines_load_no_library_before_they_run() -> None:
    code = (
        "import sys, repro.optimisers.libraries; "
        "print([m for m in ('scipy.optimize', 'cmaes', 'threadpoolctl') if m in sys.modules])"
    )

    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)

    assert done.stdout == "[]\n"
