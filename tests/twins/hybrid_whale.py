"""Whale optimisation with switchable additions, in plain Python; without any, WOA.m exactly."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Literal

from tests.twins.box import Rule, brought_back
from tests.twins.waves import cosine_of_turns

Bounds = Sequence[tuple[float, float]]


@dataclass(frozen=True, slots=True, kw_only=True)
class _Additions:
    """What is added to the whale; shares are of the population, mutation of the box width."""

    start: Literal["uniform", "tent", "tent across", "tent chain"] = "uniform"
    control: Literal["linear", "quadratic"] = "linear"
    spiral: tuple[float, float] = (1.0, 1.0)
    probability: Literal["constant", "cosine"] = "constant"
    probability_selects: Literal["encircling", "spiral"] = "encircling"
    coefficients: Literal["scalar", "vector"] = "scalar"
    leader: Literal["per dimension", "per whale"] = "per dimension"
    spiral_range: Literal["shrinking", "symmetric"] = "shrinking"
    differential: float = 0.0
    scale: float = 0.5
    crossover: float = 0.9
    genetic: float = 0.0
    mutation: float = 0.01
    greedy: bool = True
    disturbance: float = 0.0
    partner: Literal["random", "best"] = "random"
    shared_draw: bool = False
    evolves: Literal["the worst", "any"] = "the worst"
    bounds: Rule = "clip"
    perturbs: Literal["by the box", "in proportion"] = "by the box"
    chain: Literal["one step", "going on"] = "one step"


def hybrid_whale(
    cost: Callable[[list[float]], float],
    box: Bounds,
    population: int,
    iterations: int,
    uniform: Callable[[], float],
    normal: Callable[[], float],
    **parameters: Any,  # noqa: ANN401 -- checked by _Additions
) -> tuple[list[float], float, list[float], int]:
    """Return best position, its cost, best cost after each iteration, and evaluations.

    Parameters are the fields of `_Additions`.
    """
    additions = _Additions(**parameters)
    x = _START[additions.start](box, population, uniform)
    herd = _Herd(cost, box, additions.bounds, x, uniform, normal)
    history: list[float] = []
    for t in range(iterations):
        for i in range(population):
            x[i] = herd.held(x[i])
            herd.costs[i] = herd.assess(x[i])
        order = sorted(range(population), key=herd.costs.__getitem__)
        worst = int(additions.differential * population + 0.5)
        evolved = order[population - worst :]
        if additions.evolves == "any":
            evolved = _some_whales(herd, worst)
        for i in evolved:
            herd.offer(i, _recombined(herd, i, additions), greedy=additions.greedy)
        for i in order[: int(additions.genetic * population + 0.5)]:
            herd.offer(i, _blended(herd, i, additions), greedy=additions.greedy)
        if additions.disturbance > 0.0:
            herd.assess(_disturbed(herd, additions, 1.0 - t / iterations))
        history.append(herd.best_cost)
        schedule = _scheduled(additions, t, iterations)
        for i in range(population):
            _MOVE[additions.coefficients](herd, i, additions, schedule)
    return herd.best_x, herd.best_cost, history, herd.evaluations


class _Herd:
    """Positions and costs now, the best so far, and where numbers are drawn."""

    def __init__(
        self,
        cost: Callable[[list[float]], float],
        bounds: Bounds,
        rule: Rule,
        x: list[list[float]],
        uniform: Callable[[], float],
        normal: Callable[[], float],
    ) -> None:
        self.cost, self.bounds, self.rule = cost, bounds, rule
        self.uniform, self.normal = uniform, normal
        self.x, self.costs = x, [math.inf] * len(x)
        self.best_x, self.best_cost = [0.0] * len(bounds), math.inf
        self.orbits = [0.0] * len(bounds)
        self.evaluations = 0

    def held(self, x: list[float]) -> list[float]:
        """Return x brought back into the box."""
        return brought_back(x, self.bounds, self.rule, self.uniform)

    def assess(self, x: list[float]) -> float:
        """Return the cost of x, counted, and keep x if it is the best so far."""
        f = self.cost(x)
        self.evaluations += 1
        if f < self.best_cost:
            self.best_x, self.best_cost = list(x), f
        return f

    def offer(self, i: int, x: list[float], *, greedy: bool) -> None:
        """Let x take the place of whale i, if greedy only where it costs less."""
        f = self.assess(x)
        if not greedy or f < self.costs[i]:
            self.x[i], self.costs[i] = x, f

    def index(self) -> int:
        """Return the index of any whale."""
        return int(len(self.x) * self.uniform())

    def index_outside(self, taken: set[int]) -> int:
        """Return the index of a whale that is not taken, drawn until one is found."""
        k = self.index()
        while k in taken:
            k = self.index()
        return k


def _some_whales(herd: _Herd, count: int) -> list[int]:
    """Return different whales, the drawn one changing places with the next in the line."""
    line = list(range(len(herd.x)))
    for k in range(count):
        other = k + int((len(line) - k) * herd.uniform())
        line[k], line[other] = line[other], line[k]
    return line[:count]


def _recombined(herd: _Herd, i: int, additions: _Additions) -> list[float]:
    """Return a trial of differential evolution from three other whales."""
    r1 = herd.index_outside({i})
    r2 = herd.index_outside({i, r1})
    r3 = herd.index_outside({i, r1, r2})
    trial = list(herd.x[i])
    for j in range(len(trial)):
        if herd.uniform() <= additions.crossover:
            step = herd.x[r2][j] - herd.x[r3][j]
            trial[j] = herd.x[r1][j] + additions.scale * step
    return herd.held(trial)


def _blended(herd: _Herd, i: int, additions: _Additions) -> list[float]:
    """Return an arithmetic crossover with another whale, plus normal mutation."""
    crossed = additions.partner == "best"
    partner = list(herd.best_x) if crossed else herd.x[herd.index_outside({i})]
    alpha = herd.uniform()
    child = []
    for own, other, (lower, upper) in zip(herd.x[i], partner, herd.bounds, strict=True):
        middle = alpha * own + (1.0 - alpha) * other
        unit = {"by the box": upper - lower, "in proportion": middle}[additions.perturbs]
        child.append(middle + additions.mutation * unit * herd.normal())
    return herd.held(child)


def _disturbed(herd: _Herd, additions: _Additions, left: float) -> list[float]:
    """Return a position around the best, as far as what is left of the disturbance."""
    reach = additions.disturbance * left
    x = []
    for j, (best, (lower, upper)) in enumerate(zip(herd.best_x, herd.bounds, strict=True)):
        z = _tent(herd.orbits[j] or herd.uniform())
        if additions.chain == "going on":
            herd.orbits[j] = z
        unit = {"by the box": upper - lower, "in proportion": best}[additions.perturbs]
        x.append(best + reach * unit * (2.0 * z - 1.0))
    return herd.held(x)


@dataclass(frozen=True, slots=True, kw_only=True)
class _Schedule:
    """Coefficients of one iteration, in the letters of WOA.m; p is that of the chosen branch."""

    a: float
    a2: float
    b: float
    p: float


def _scheduled(additions: _Additions, t: int, iterations: int) -> _Schedule:
    s = t / iterations
    first, last = additions.spiral
    return _Schedule(
        a={"linear": 2.0 - 2.0 * t / iterations, "quadratic": 2.0 * (1.0 - s * s)}[
            additions.control
        ],
        a2=-1.0 - s,
        b=last + (first - last) * (1.0 - s),
        p={"constant": 0.5, "cosine": 0.5 + 0.5 * math.cos(math.pi * t / iterations)}[
            additions.probability
        ],
    )


def _move_by_scalars(herd: _Herd, i: int, additions: _Additions, schedule: _Schedule) -> None:
    """Move whale i in place with A and C common to its dimensions, as WOA.m."""
    r1 = herd.uniform()
    r2 = r1 if additions.shared_draw else herd.uniform()
    u, p = herd.uniform(), herd.uniform()
    if _spirals(p, additions, schedule):
        _spiral(herd, i, u, additions, schedule)
        return
    A = 2.0 * schedule.a * r1 - schedule.a
    C = 2.0 * r2
    searching = abs(A) >= 1.0
    each = {"per dimension": True, "per whale": False}[additions.leader]
    k = herd.index() if searching and not each else i
    for j in range(len(herd.bounds)):
        if searching:
            k = herd.index() if each else k
            herd.x[i][j] = _approached(herd.x[k][j], herd.x[i][j], A, C)
        else:
            herd.x[i][j] = _approached(herd.best_x[j], herd.x[i][j], A, C)


def _move_by_vectors(herd: _Herd, i: int, additions: _Additions, schedule: _Schedule) -> None:
    """Move whale i in place with A and C drawn in each dimension, as the paper's vectors."""
    u, p = herd.uniform(), herd.uniform()
    if _spirals(p, additions, schedule):
        _spiral(herd, i, u, additions, schedule)
        return
    each = {"per dimension": True, "per whale": False}[additions.leader]
    k = i if each else herd.index()  # drawn even where no dimension searches
    for j in range(len(herd.bounds)):
        r1 = herd.uniform()
        r2 = r1 if additions.shared_draw else herd.uniform()
        A = 2.0 * schedule.a * r1 - schedule.a
        C = 2.0 * r2
        if abs(A) >= 1.0:
            k = herd.index() if each else k
            herd.x[i][j] = _approached(herd.x[k][j], herd.x[i][j], A, C)
        else:
            herd.x[i][j] = _approached(herd.best_x[j], herd.x[i][j], A, C)


def _approached(leader: float, x: float, A: float, C: float) -> float:
    """Return Eqs. (2.1), (2.2) of the best or (2.7), (2.8) of any whale."""
    return leader - A * abs(C * leader - x)


def _spirals(p: float, additions: _Additions, schedule: _Schedule) -> bool:
    chosen = p < schedule.p
    return {"encircling": not chosen, "spiral": chosen}[additions.probability_selects]


def _spiral(herd: _Herd, i: int, u: float, additions: _Additions, schedule: _Schedule) -> None:
    """Move whale i in place around the best, Eq. (2.5)."""
    l = {  # noqa: E741 -- the paper's letter
        "shrinking": (schedule.a2 - 1.0) * u + 1.0,
        "symmetric": 2.0 * u - 1.0,
    }[additions.spiral_range]
    turn = math.exp(schedule.b * l) * cosine_of_turns(l)
    for j, best in enumerate(herd.best_x):
        herd.x[i][j] = abs(best - herd.x[i][j]) * turn + best


def _uniform_positions(
    bounds: Bounds, population: int, uniform: Callable[[], float]
) -> list[list[float]]:
    """Return positions drawn dimension by dimension, as MATLAB fills a matrix."""
    x = [[0.0] * len(bounds) for _ in range(population)]
    for j, (lower, upper) in enumerate(bounds):
        for i in range(population):
            x[i][j] = lower + (upper - lower) * uniform()
    return x


def _tent_positions(
    bounds: Bounds, population: int, uniform: Callable[[], float]
) -> list[list[float]]:
    """Return positions along one tent orbit per dimension, its steps the whales."""
    x = [[0.0] * len(bounds) for _ in range(population)]
    for j, (lower, upper) in enumerate(bounds):
        z = uniform()
        for i in range(population):
            x[i][j] = lower + (upper - lower) * z
            z = _tent(z)
    return x


def _tent_positions_across(
    bounds: Bounds, population: int, uniform: Callable[[], float]
) -> list[list[float]]:
    """Return positions along one tent orbit per whale, its steps the dimensions."""
    x = [[0.0] * len(bounds) for _ in range(population)]
    for i in range(population):
        z = uniform()
        for j, (lower, upper) in enumerate(bounds):
            x[i][j] = lower + (upper - lower) * z
            z = _tent(z)
    return x


def _tent_chain(bounds: Bounds, population: int, uniform: Callable[[], float]) -> list[list[float]]:
    """Return positions along one tent orbit through all dimensions of all whales."""
    x: list[list[float]] = []
    z = uniform()
    for _ in range(population):
        x.append([])
        for lower, upper in bounds:
            x[-1].append(lower + (upper - lower) * z)
            z = _tent(z)
    return x


def _tent(z: float) -> float:
    return z / 0.5 if z < 0.5 else (1.0 - z) / 0.5


_START = {
    "uniform": _uniform_positions,
    "tent": _tent_positions,
    "tent across": _tent_positions_across,
    "tent chain": _tent_chain,
}
_MOVE = {"scalar": _move_by_scalars, "vector": _move_by_vectors}
