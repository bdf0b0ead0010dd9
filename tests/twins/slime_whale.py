"""Whale optimisation with slime mould parts in plain Python; without any, WOA.m exactly.

Equations are those of doi:10.3390/a15100363.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from tests.twins.box import Rule, brought_back
from tests.twins.waves import cosine_of_turns

Bounds = Sequence[tuple[float, float]]


@dataclass(frozen=True, slots=True, kw_only=True)
class _Parts:
    """What is taken from the slime mould, and how the whale's own numbers are drawn."""

    b: float = 1.0
    control: str = "linear"
    weight: str = "none"
    weights: str = "per dimension"
    logarithm: str = "decimal"
    swing: str = "none"
    coefficients: str = "scalar"
    shared_draw: bool = False
    leader: str = "per dimension"
    spiral_range: str = "shrinking"
    restart: float = 0.0
    moves: str = "in turn"
    greedy: bool = False
    bounds: Rule = "clip"


@dataclass(frozen=True, slots=True, kw_only=True)
class _Moment:
    """What all whales see in one iteration; x changes while they move."""

    parts: _Parts
    x: list[list[float]]
    seen: list[list[float]]
    best_x: list[float]
    weights: list[list[float]]
    a: float
    a2: float
    uniform: Callable[[], float]

    def some_whale(self) -> int:
        """Return the index of any whale."""
        return int(len(self.x) * self.uniform())

    def coefficients(self) -> tuple[float, float]:
        """Return A and C, Eqs. (4) and (15)."""
        r = self.uniform()
        other = r if self.parts.shared_draw else self.uniform()
        return 2.0 * self.a * r - self.a, 2.0 * other

    def swing(self) -> float:
        """Return a number from [-a, a]."""
        return -self.a + 2.0 * self.a * self.uniform()


def slime_whale(
    cost: Callable[[list[float]], float],
    box: Bounds,
    population: int,
    iterations: int,
    uniform: Callable[[], float],
    normal: Callable[[], float],
    **parameters: Any,  # noqa: ANN401 -- checked by _Parts
) -> tuple[list[float], float, list[float], int]:
    """Return best position, its cost, best cost after each iteration, and evaluations (N T)."""
    del normal  # all twins are called alike
    parts = _Parts(**parameters)
    x = _uniform_positions(box, population, uniform)
    best_x, best_cost = [0.0] * len(box), math.inf
    history: list[float] = []
    kept: list[tuple[list[float], float]] = []
    evaluations = 0
    for t in range(1, iterations + 1):
        x = [brought_back(row, box, parts.bounds, uniform) for row in x]
        tried = [cost(row) for row in x]
        evaluations += population
        if parts.greedy and kept:
            x = [new if a < b else old for new, a, (old, b) in zip(x, tried, kept, strict=True)]
            tried = [min(a, b) for a, (_, b) in zip(tried, kept, strict=True)]
        costs = tried
        kept = [(list(row), value) for row, value in zip(x, costs, strict=True)]
        if min(costs) < best_cost:
            best_cost = min(costs)
            best_x = list(x[costs.index(best_cost)])
        history.append(best_cost)
        weights = _weights(parts, costs, len(box), uniform)
        a = {
            "linear": 2.0 - 2.0 * (t - 1) / iterations,
            "arctanh": math.atanh(-t / iterations + 1.0),
        }[parts.control]
        a2 = -1.0 - (t - 1) / iterations
        seen = [list(row) for row in x] if parts.moves == "at once" else x
        moment = _Moment(
            parts=parts, x=x, seen=seen, best_x=best_x, weights=weights, a=a, a2=a2, uniform=uniform
        )
        for i in range(population):
            x[i] = _restarted(moment, box) or _moved(moment, i)
    return best_x, best_cost, history, evaluations


def _weights(
    parts: _Parts, costs: list[float], dimension: int, uniform: Callable[[], float]
) -> list[list[float]]:
    """Return Eq. (11), drawn from the best whale to the worst; nothing where no weight is used."""
    if parts.weight == "none":
        return []
    log = {"decimal": math.log10, "natural": math.log}[parts.logarithm]
    draws = {"per dimension": dimension, "per whale": 1}[parts.weights]
    best, worst = min(costs), max(costs)
    weights: list[list[float]] = [[] for _ in costs]
    for place, i in enumerate(sorted(range(len(costs)), key=costs.__getitem__)):
        distance = 0.0 if best == worst else (best - costs[i]) / (best - worst)
        better_half = place < len(costs) // 2
        for _ in range(draws):
            change = uniform() * log(distance + 1.0)
            weights[i].append(1.0 + change if better_half else 1.0 - change)
        weights[i] *= dimension // draws
    return weights


def _restarted(moment: _Moment, bounds: Bounds) -> list[float] | None:
    """Return a point on the diagonal of the box with the chance z of Eq. (8), else nothing."""
    z = moment.parts.restart
    if z == 0.0 or moment.uniform() >= z:
        return None
    u = moment.uniform()
    return [lower + (upper - lower) * u for lower, upper in bounds]


def _moved(moment: _Moment, i: int) -> list[float]:
    """Return the next place of whale i; whales after it see it there, not yet clipped."""
    parts = moment.parts
    A, C = moment.coefficients() if parts.coefficients == "scalar" else (math.nan, math.nan)
    u, p = moment.uniform(), moment.uniform()
    if p >= 0.5:
        return _spiralled(moment, i, u)
    if parts.coefficients == "vector":
        return _approached_by_vectors(moment, i)
    if abs(A) < 1.0:
        return [_towards(b, v, A, C) for b, v in zip(moment.best_x, moment.x[i], strict=True)]
    k = moment.some_whale() if parts.leader == "per whale" else None
    return _each_coordinate(moment, i, lambda j: _sought(moment, i, j, k, (A, C)))


def _approached_by_vectors(moment: _Moment, i: int) -> list[float]:
    """Return Eq. (12) or (14) in each dimension, by its own A."""
    k = moment.some_whale() if moment.parts.leader == "per whale" else None

    def coordinate(j: int) -> float:
        A, C = moment.coefficients()
        if abs(A) < 1.0:
            return _towards(moment.best_x[j], moment.x[i][j], A, C)
        return _sought(moment, i, j, k, (A, C))

    return _each_coordinate(moment, i, coordinate)


def _each_coordinate(moment: _Moment, i: int, coordinate: Callable[[int], float]) -> list[float]:
    """Move whale i coordinate by coordinate: one that follows itself sees what has moved."""
    for j in range(len(moment.best_x)):
        moment.x[i][j] = coordinate(j)
    return moment.x[i]


def _sought(
    moment: _Moment, i: int, j: int, k: int | None, coefficients: tuple[float, float]
) -> float:
    """Return one coordinate by Eq. (14); without a weight, WOA's Eq. (7)."""
    k = moment.some_whale() if k is None else k
    A, C = coefficients
    factor = {
        "none": lambda: C,
        "of the whale": lambda: moment.weights[i][j],
        "of the leader": lambda: moment.weights[k][j],
    }[moment.parts.weight]()
    return _towards(moment.seen[k][j], moment.x[i][j], A, factor)


def _towards(leader: float, x: float, A: float, factor: float) -> float:
    return leader - A * abs(factor * leader - x)


def _spiralled(moment: _Moment, i: int, u: float) -> list[float]:
    """Return Eq. (13); a weight of the leader is that of the best whale, which is 1."""
    parts = moment.parts
    l = {"shrinking": (moment.a2 - 1.0) * u + 1.0, "symmetric": 2.0 * u - 1.0}[  # noqa: E741
        parts.spiral_range
    ]
    turn = math.exp(parts.b * l) * cosine_of_turns(l)
    n = len(moment.best_x)
    swings = {
        "none": lambda: [1.0] * n,
        "per dimension": lambda: [moment.swing() for _ in range(n)],
        "per whale": lambda: [moment.swing()] * n,
    }[parts.swing]()
    omegas = moment.weights[i] if parts.weight == "of the whale" else [1.0] * n
    return [
        abs(omega * best - x) * (v * turn) + best
        for best, x, omega, v in zip(moment.best_x, moment.x[i], omegas, swings, strict=True)
    ]


def _uniform_positions(
    bounds: Bounds, population: int, uniform: Callable[[], float]
) -> list[list[float]]:
    """Return positions drawn dimension by dimension, as MATLAB fills a matrix."""
    x = [[0.0] * len(bounds) for _ in range(population)]
    for j, (lower, upper) in enumerate(bounds):
        for i in range(population):
            x[i][j] = lower + (upper - lower) * uniform()
    return x
