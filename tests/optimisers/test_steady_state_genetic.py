import numpy as np
import pytest

from repro.determinism.draws import state_from, uniform
from repro.errors import InputError
from repro.optimisers import SteadyStateGA
from tests.small_problems import OFF_CENTRE, small
from tests.twins.steady_state_genetic import steady_state_genetic

VARIANTS = (
    SteadyStateGA(),
    SteadyStateGA(mixing="blend"),
    SteadyStateGA(mixing="one point"),
    SteadyStateGA(crossover=0.3, mutation=0.4),
    SteadyStateGA(crossover=1.0, mutation=0.0, mixing="blend"),
)


@pytest.mark.parametrize("name", ["rosenbrock", "steps", "slope"])
@pytest.mark.parametrize("optimiser", VARIANTS, ids=repr)
def test_compiled_search_is_its_twin(optimiser: SteadyStateGA, name: str) -> None:
    problem = small(name)
    state = state_from(np.random.default_rng(7))
    rng = np.random.default_rng(7)

    result = optimiser.minimise(problem, population=11, iterations=14, rng=rng)
    x, cost, history, evaluations = steady_state_genetic(
        problem.cost,
        problem.box,
        11,
        14,
        lambda: float(uniform(state)),
        lambda: 0.0,
        crossover=optimiser.crossover,
        mutation=optimiser.mutation,
        mixing=optimiser.mixing,
    )

    assert result.x.tolist() == x
    assert result.cost == cost
    assert result.history.tolist() == history
    assert result.evaluations == evaluations


@pytest.mark.parametrize("optimiser", VARIANTS, ids=repr)
def test_evaluations_are_calls_of_the_cost_and_at_most_one_per_place(
    optimiser: SteadyStateGA,
) -> None:
    problem = small("slope")

    result = optimiser.minimise(problem, population=20, rng=np.random.default_rng(1), iterations=30)

    assert result.evaluations == problem.data[0] <= 20 + 20 * 30


def test_tossed_genes_are_those_of_the_start_where_nothing_mutates() -> None:
    optimiser, rng = SteadyStateGA(mutation=0.0), np.random.default_rng(3)
    state = state_from(np.random.default_rng(3))
    start = [
        [lower + (upper - lower) * float(uniform(state)) for _ in range(20)]
        for lower, upper in OFF_CENTRE
    ]

    result = optimiser.minimise(small("slope"), population=20, iterations=100, rng=rng)

    assert result.x.tolist() == [min(genes) for genes in start]


@pytest.mark.parametrize(
    ("field", "value"), [("crossover", 1.1), ("mutation", -0.1), ("mixing", "swap")]
)
def test_impossible_parameter_is_refused_by_name(field: str, value: object) -> None:
    with pytest.raises(InputError, match=f"{field}={value!r}"):
        SteadyStateGA(**{field: value})  # type: ignore[arg-type]
