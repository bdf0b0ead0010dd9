import math
from collections.abc import Callable
from dataclasses import asdict, replace

import numpy as np
import pytest

from repro.determinism.draws import fill, normal, state_from, uniform
from repro.optimisers import DBO, DE, GA, GSA, GWO, PSO, SMA, WOA, HybridWOA, RandomSearch, SlimeWOA
from repro.optimisers.slime_mould import _weigh
from tests.additions import ADDITIONS, SLIME, TOGETHER
from tests.small_problems import OFF_CENTRE, small
from tests.twins.differential_evolution import differential_evolution
from tests.twins.dung_beetle import dung_beetle
from tests.twins.genetic import genetic
from tests.twins.gravitational import gravitational
from tests.twins.grey_wolf import grey_wolf
from tests.twins.hybrid_whale import hybrid_whale
from tests.twins.particle_swarm import particle_swarm
from tests.twins.random_search import random_search
from tests.twins.slime_mould import _weights, slime_mould
from tests.twins.slime_whale import slime_whale
from tests.twins.whale import whale

AnyOptimiser = DBO | DE | GA | GSA | GWO | HybridWOA | PSO | RandomSearch | SMA | SlimeWOA | WOA
Box = tuple[tuple[float, float], ...]
Outcome = tuple[list[float], float, list[float], int]

EPS = 2.0**-52

TWINS: dict[type[AnyOptimiser], Callable[..., Outcome]] = {
    DBO: dung_beetle,
    DE: differential_evolution,
    GA: genetic,
    GSA: gravitational,
    GWO: grey_wolf,
    HybridWOA: hybrid_whale,
    PSO: particle_swarm,
    RandomSearch: random_search,
    SMA: slime_mould,
    SlimeWOA: slime_whale,
    WOA: whale,
}

SWITCHED: tuple[AnyOptimiser, ...] = (
    *ADDITIONS,
    TOGETHER,
    replace(TOGETHER, greedy=True, coefficients="scalar"),
    replace(TOGETHER, leader="per dimension", probability_selects="encircling"),
    HybridWOA(differential=0.4, scale=0.9, crossover=0.3, greedy=False),
    HybridWOA(genetic=0.3, mutation=0.2, greedy=False),
    HybridWOA(differential=0.4, genetic=0.3, evolves="any"),
    HybridWOA(differential=1.0, evolves="any", bounds="reflect"),
    replace(TOGETHER, shared_draw=True, bounds="re-initialise"),
    replace(TOGETHER, perturbs="in proportion", chain="going on"),
    *SLIME,
    WOA(b=0.5),
    PSO(clip="last particle"),
    PSO(maximum_velocity=0.5, inertia=(0.7, 0.4), cognitive=1.5, social=1.2),
    DBO(groups="proportional"),
    DBO(producers=0.5, deflection=0.3, pull=0.7, natural=0.5, obstacle=0.6, size=0.9),
    SMA(restart=0.5),
    SMA(restart=0.0),
    SMA(contraction="falling"),
    GSA(bounds="clip"),
    GSA(bounds="reflect"),
    GSA(strength=10.0, decay=5.0, final_percent=40.0),
    DE(scale=(0.5, 0.5), crossover=0.9),
    GA(crossover=0.3, mutation=0.5, elites=0),
    GA(elites=5),
)


def assert_same(
    optimiser: AnyOptimiser,
    name: str = "rosenbrock",
    *,
    population: int,
    box: Box = OFF_CENTRE,
    gap: float = 0.0,
    iterations: int = 12,
    **twin_fields: object,
) -> None:
    """Run the optimiser and its twin from one seed; every point that they try must be the same."""
    ours, theirs = (small(name, box=box, gap=gap, room=3000) for _ in range(2))
    result = optimiser.minimise(
        ours, population=population, iterations=iterations, rng=np.random.default_rng(7)
    )
    state = state_from(np.random.default_rng(7))
    x, cost, history, evaluations = TWINS[type(optimiser)](
        theirs.cost,
        box,
        population,
        iterations,
        lambda: float(uniform(state)),
        lambda: float(normal(state)),
        **twin_fields,
    )
    assert ours.points == theirs.points
    assert (result.x.tolist(), result.cost, result.history.tolist()) == (x, cost, history)
    assert result.evaluations == evaluations == theirs.calls


@pytest.mark.parametrize("name", ["rosenbrock", "steps", "slope"])
@pytest.mark.parametrize("kind", TWINS, ids=lambda kind: kind.__name__)
def test_compiled_search_is_its_twin_with_the_default_parameters(
    kind: type[AnyOptimiser], name: str
) -> None:
    assert_same(kind(), name, population=21)


@pytest.mark.parametrize("name", ["rosenbrock", "steps"])
@pytest.mark.parametrize("optimiser", SWITCHED, ids=repr)
def test_compiled_search_is_its_twin_with_every_switch(optimiser: AnyOptimiser, name: str) -> None:
    assert_same(optimiser, name, population=23, **asdict(optimiser))


def test_an_orbit_that_goes_on_starts_anew_where_doubles_end_it() -> None:
    # every double in [0, 1] reaches 0 within 54 steps of slope 2
    optimiser = HybridWOA(disturbance=0.2, chain="going on")
    assert_same(optimiser, population=4, iterations=120, **asdict(optimiser))


@pytest.mark.parametrize("population", [20, 45, 62, 63, 100])
def test_dung_beetles_are_their_twin_at_any_population(population: int) -> None:
    assert_same(DBO(), population=population)


@pytest.mark.parametrize(
    ("optimiser", "least"),
    [(WOA(), 1), (GWO(), 3), (PSO(), 1), (SMA(), 1), (GSA(), 1), (DE(), 4), (HybridWOA(), 4)],
    ids=repr,
)
def test_compiled_search_is_its_twin_with_the_fewest_agents(
    optimiser: AnyOptimiser, least: int
) -> None:
    assert_same(optimiser, population=least)


@pytest.mark.parametrize("spread", [0.6, 0.75, 1.0, 1.5, 2.0])
def test_slime_mould_stays_real_where_costs_lie_within_eps(spread: float) -> None:
    # SMA.m has a logarithm of 0 or less, or a division by zero, up to a spread of eps
    assert_same(SMA(), "cliff", population=20, box=((-1.0, 1.0),) * 2, gap=spread * EPS)


@pytest.mark.parametrize("base", [0.0, 1.0])
@pytest.mark.parametrize("spread", [0.0, 1.0, 2.0, 3.0, 2.0**60])
def test_slime_mould_weights_stay_within_log10_of_two(base: float, spread: float) -> None:
    costs = np.array([base, base + spread * EPS, base + spread * EPS, base])
    order = np.argsort(costs, kind="stable")
    W = np.empty((4, 200))

    draws = np.empty(W.size)
    fill(draws, np.empty(W.size, dtype=np.uint64), state_from(np.random.default_rng(1)))
    _weigh(W, costs, order, draws)

    state = state_from(np.random.default_rng(1))
    assert W.tolist() == _weights(costs.tolist(), order.tolist(), 200, lambda: uniform(state))
    assert (np.abs(W - 1.0) <= math.log10(2.0)).all()
    assert (W[[1, 2]] < 1.0).any() == (spread > 1.0)


@pytest.mark.parametrize("kind", TWINS, ids=lambda kind: kind.__name__)
def test_compiled_search_is_its_twin_where_all_agents_coincide(kind: type[AnyOptimiser]) -> None:
    assert_same(kind(), population=20, box=((1.0, 1.0), (-2.0, -2.0)))
