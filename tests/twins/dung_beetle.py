"""Dung beetle optimisation in plain Python, after DBO.m of doi:10.1007/s11227-022-04959-6."""

import math
from collections.abc import Callable, Sequence
from typing import Literal

Bounds = Sequence[tuple[float, float]]


def dung_beetle(
    cost: Callable[[list[float]], float],
    bounds: Bounds,
    population: int,
    iterations: int,
    uniform: Callable[[], float],
    normal: Callable[[], float],
    *,
    groups: Literal["as coded", "proportional"] = "as coded",
    producers: float = 0.2,
    deflection: float = 0.1,
    pull: float = 0.3,
    natural: float = 0.1,
    obstacle: float = 0.1,
    size: float = 0.5,
) -> tuple[list[float], float, list[float], int]:
    """Return best position, its cost, best cost after each iteration, and evaluations (N T + N).

    "as coded" raises IndexError where N < 19; "proportional" ignores `producers`.
    """
    rollers, brood, small, thieves = _groups(population, producers, groups)
    swarm = _Swarm(cost, bounds, _uniform_positions(bounds, population, uniform))
    history: list[float] = []
    for t in range(1, iterations + 1):
        if uniform() < 1.0 - obstacle:
            _roll(swarm, rollers, uniform, k=deflection, b=pull, natural=natural)
        else:
            _dance(swarm, rollers, uniform)
        local = swarm.x[swarm.costs.index(min(swarm.costs))]
        near_local = _region(local, bounds, 1.0 - t / iterations)
        near_best = _region(swarm.best_x, bounds, 1.0 - t / iterations)
        for i in brood:
            swarm.place(i, _laid(swarm.own_x[i], local, near_local, uniform), near_local)
        for i in small:
            swarm.place(i, _foraged(swarm.own_x[i], near_best, uniform, normal))
        for i in thieves:
            swarm.place(i, _stolen(swarm.own_x[i], local, swarm.best_x, normal, size=size))
        swarm.remember()
        history.append(swarm.best_cost)
    return swarm.best_x, swarm.best_cost, history, swarm.evaluations


class _Swarm:
    """Positions and costs now, each beetle's own best, and the best of all."""

    def __init__(
        self, cost: Callable[[list[float]], float], bounds: Bounds, x: list[list[float]]
    ) -> None:
        self.cost, self.bounds = cost, bounds
        self.x = x
        self.costs = [cost(row) for row in x]
        self.evaluations = len(x)
        self.own_x, self.own_costs = list(x), list(self.costs)
        self.previous = list(x)
        self.best_cost = min(self.costs)
        self.best_x = x[self.costs.index(self.best_cost)]

    def place(self, i: int, x: list[float], region: Bounds | None = None) -> None:
        """Clip beetle i to the region, by default the box, and evaluate it at once."""
        self.x[i] = _clipped(x, self.bounds if region is None else region)
        self.costs[i] = self.cost(self.x[i])
        self.evaluations += 1

    def remember(self) -> None:
        """Update the own bests, keeping those of the iteration before, and the best of all."""
        self.previous = list(self.own_x)
        for i, f in enumerate(self.costs):
            if f < self.own_costs[i]:
                self.own_x[i], self.own_costs[i] = self.x[i], f
            if self.own_costs[i] < self.best_cost:
                self.best_x, self.best_cost = self.own_x[i], self.own_costs[i]


def _groups(population: int, producers: float, groups: str) -> tuple[range, range, range, range]:
    """Return the indices of rollers, brood, small beetles and thieves.

    DBO.m ends its groups at 12 and 19 whatever N is; "proportional" scales those of its N = 30.
    """
    first, second, third = {
        "as coded": (int(producers * population + 0.5), 12, 19),
        "proportional": (6 * population // 30, 12 * population // 30, 19 * population // 30),
    }[groups]
    return (
        range(first),
        range(first, second),
        range(second, third),
        range(third, population),
    )


def _roll(
    swarm: _Swarm,
    rollers: range,
    uniform: Callable[[], float],
    *,
    k: float,
    b: float,
    natural: float,
) -> None:
    """Move the rollers by Eq. (1), away from the worst beetle as it was before they moved."""
    worst = swarm.x[swarm.costs.index(max(swarm.costs))]
    for i in rollers:
        p, previous = swarm.own_x[i], swarm.previous[i]
        uniform()  # DBO.m draws a number that it never uses
        a = 1.0 if uniform() > natural else -1.0
        x = [p[j] + b * abs(p[j] - worst[j]) + a * k * previous[j] for j in range(len(p))]
        swarm.place(i, x)


def _dance(swarm: _Swarm, rollers: range, uniform: Callable[[], float]) -> None:
    """Move the rollers by Eq. (2); DBO.m does not skip the angles 90 and 180 degrees."""
    for i in rollers:
        p, previous = swarm.own_x[i], swarm.previous[i]
        degrees = int(180 * uniform()) + 1
        slope = math.tan(degrees * math.pi / 180.0)
        swarm.place(i, [p[j] + slope * abs(p[j] - previous[j]) for j in range(len(p))])


def _region(centre: list[float], bounds: Bounds, r: float) -> list[tuple[float, float]]:
    """Return Eqs. (3) and (5); lower exceeds upper where the centre is negative, as in DBO.m."""
    lower = _clipped([c * (1.0 - r) for c in centre], bounds)
    upper = _clipped([c * (1.0 + r) for c in centre], bounds)
    return list(zip(lower, upper, strict=True))


def _laid(
    p: list[float],
    local: list[float],
    region: list[tuple[float, float]],
    uniform: Callable[[], float],
) -> list[float]:
    """Return Eq. (4)."""
    x = []
    for j, (lower, upper) in enumerate(region):
        u, u2 = uniform(), uniform()
        x.append(local[j] + u * (p[j] - lower) + u2 * (p[j] - upper))
    return x


def _foraged(
    p: list[float],
    region: list[tuple[float, float]],
    uniform: Callable[[], float],
    normal: Callable[[], float],
) -> list[float]:
    """Return Eq. (6), its normal number shared by all dimensions."""
    n = normal()
    x = []
    for j, (lower, upper) in enumerate(region):
        x.append(p[j] + n * (p[j] - lower) + uniform() * (p[j] - upper))
    return x


def _stolen(
    p: list[float],
    local: list[float],
    best_x: list[float],
    normal: Callable[[], float],
    *,
    size: float,
) -> list[float]:
    """Return Eq. (7)."""
    x = []
    for j in range(len(p)):
        g = normal()
        x.append(best_x[j] + size * g * (abs(p[j] - local[j]) + abs(p[j] - best_x[j])))
    return x


def _uniform_positions(
    bounds: Bounds, population: int, uniform: Callable[[], float]
) -> list[list[float]]:
    """Return positions drawn dimension by dimension, as MATLAB fills a matrix."""
    x = [[0.0] * len(bounds) for _ in range(population)]
    for j, (lower, upper) in enumerate(bounds):
        for i in range(population):
            x[i][j] = lower + (upper - lower) * uniform()
    return x


def _clipped(x: list[float], bounds: Bounds) -> list[float]:
    """Return x clipped to lower, then to upper: inverted bounds end at upper."""
    return [min(max(v, lower), upper) for v, (lower, upper) in zip(x, bounds, strict=True)]
