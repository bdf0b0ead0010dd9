import numpy as np

from repro.determinism.draws import state_from
from repro.optimisers.tent_map import STARTS, started, tent

UNIT = np.tile([0.0, 1.0], (4, 1))


def whales(kind: str, population: int = 60) -> np.ndarray:
    state = state_from(np.random.default_rng(3))
    found: np.ndarray = started(UNIT, population, float(STARTS.index(kind)), state)
    return found


def test_tent_map_doubles_the_distance_to_the_nearer_end() -> None:
    for z in (0.0, 0.1, 0.25, 0.5, 0.6, 1.0):
        assert tent(z) == 2.0 * min(z, 1.0 - z)


def test_orbits_run_through_whales_coordinates_or_both() -> None:
    down, across, chain = (whales(kind) for kind in STARTS[1:])

    assert down[1, 0] == tent(down[0, 0])
    assert across[0, 1] == tent(across[0, 0])
    assert chain.ravel()[1] == tent(chain.ravel()[0])
    assert chain[1, 0] == tent(chain[0, -1])


def test_every_orbit_of_doubles_ends_at_zero_after_as_many_steps_as_a_double_has_bits() -> None:
    # each step of slope 2 drops one bit of the 53
    down, across, chain = (whales(kind) for kind in STARTS[1:])

    assert (down[55:] == 0.0).all()
    assert (down[:10] > 0.0).all()
    assert (chain.ravel()[55:] == 0.0).all()
    assert (across > 0.0).all()


def test_whales_start_inside_their_box() -> None:
    bounds = np.array([[-3.0, -1.0], [2.0, 5.0]])
    for kind in range(len(STARTS)):
        X = started(bounds, 40, float(kind), state_from(np.random.default_rng(5)))
        assert ((bounds[:, 0] <= X) & (bounds[:, 1] >= X)).all()
