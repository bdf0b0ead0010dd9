import math
from dataclasses import dataclass, replace

import numpy as np
import pytest
from numpy.typing import NDArray

from repro.errors import DeclarationError
from repro.functions import FUNCTIONS
from repro.model.evidence import Evidence, Runs
from tests.small_papers import EXPERIMENT, PAPER, Bowl, evidence, evidence_of

Vector = NDArray[np.float64]
CELL = ("search", "bowl", "guess")


@dataclass(frozen=True, slots=True, kw_only=True)
class Sized(Bowl):
    """A bowl that says how far a point lies from its centre."""

    def quantity(self, name: str, points: Vector) -> Vector:
        """Return the distance times the number that `name` is."""
        return float(name) * np.asarray(np.linalg.norm(points - self.data, axis=-1))


def test_values_are_the_costs_of_every_run() -> None:
    assert evidence(guess=[[1, 2], [3, 4]]).values(CELL).tolist() == [[1, 2], [3, 4]]


def test_cost_after_k_iterations_is_that_of_the_history() -> None:
    found = evidence(guess=[[1, 2]])  # whose histories fall from 5 times the cost to the cost

    assert found.values(CELL, "cost after 1 iteration").tolist() == [[5, 10]]
    assert found.values(CELL, "cost after 4 iterations").tolist() == [[2, 4]]
    assert found.values(CELL, "cost after 5 iterations").tolist() == found.values(CELL).tolist()
    half = found.values(CELL, "cost after half of the iterations")
    assert half.tolist() == found.values(CELL, "cost after 2 iterations").tolist()


@pytest.mark.parametrize("k", [0, 6])
def test_iteration_that_was_not_run_is_refused(k: int) -> None:
    fault = f"search/bowl/guess: no 'cost after {k} iterations'; it has iterations 1 to 5"
    with pytest.raises(DeclarationError, match=fault):
        evidence(guess=[[1, 2]]).values(CELL, f"cost after {k} iterations")


def test_other_quantities_are_the_problems_own() -> None:
    sized = replace(EXPERIMENT, problems={"bowl": Sized(centre=(3.0, 4.0))})
    paper = replace(PAPER, experiments=(sized,), results=(), claims=())

    assert evidence(paper, guess=[[1, 2]]).values(CELL, "2").tolist() == [[10.0, 10.0]]


def test_quantity_of_a_problem_that_has_none_is_refused() -> None:
    with pytest.raises(DeclarationError, match="search/bowl/guess: no quantity 'total', only"):
        evidence(guess=[[1, 2]]).values(CELL, "total")


def test_experiment_is_found_by_name() -> None:
    assert evidence().experiment("search") is EXPERIMENT


def test_cells_that_were_not_run_are_absent() -> None:
    found: Evidence = evidence(guess=[[1, 2]])

    assert set(found.runs) == {CELL}
    assert isinstance(found.runs[CELL], Runs)


def test_quantity_is_measured_once_for_all_that_ask() -> None:
    asked: list[int] = []

    def norm(points: Vector) -> Vector:
        asked.append(len(points))
        return np.asarray(np.linalg.norm(points, axis=-1))

    runs = Runs(
        costs=np.zeros((4, 3)),
        points=np.arange(24.0).reshape(4, 3, 2),
        histories=np.zeros((1, 3, 5)),
        evaluations=20,
    )

    first, second = (runs.measured("norm", norm) for _ in range(2))

    assert asked == [4]
    assert first.shape == (4, 3)
    assert first is second


def test_floor_is_the_minimum_of_a_function_and_nothing_else() -> None:
    branin = FUNCTIONS["branin"].problem()
    experiment = replace(EXPERIMENT, problems={"bowl": Bowl(), "branin": branin})
    found = evidence_of(replace(PAPER, experiments=(experiment,), results=(), claims=()), {})

    assert found.floor(("search", "branin", "guess")) == branin.minimum
    assert found.floor(("search", "bowl", "guess")) == -math.inf
    assert found.floor(("elsewhere", "bowl", "guess")) == -math.inf


def test_ceiling_is_the_worst_that_a_search_was_after_one_iteration() -> None:
    found = evidence(guess=[[1, 2], [3, 9]])
    unknown = replace(found.runs[CELL], histories=np.zeros(0))

    assert found.ceiling(CELL) == 45  # histories fall from five times the final cost
    assert found.deeper({CELL: unknown}).ceiling(CELL) == math.inf


def test_deeper_cells_take_the_place_of_shallow_ones() -> None:
    found = evidence(guess=[[1, 2]])
    more = evidence(guess=[[1, 2], [3, 4]]).runs

    assert found.deeper(more).values(CELL).tolist() == [[1, 2], [3, 4]]
    assert found.values(CELL).tolist() == [[1, 2]]
