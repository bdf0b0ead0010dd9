"""What an optimiser and a problem are, and how a compiled search is called."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NotRequired, Protocol, TypedDict, Unpack, runtime_checkable

import numpy as np
from numpy.typing import NDArray

from repro.determinism.compiled import SEARCH, ready
from repro.determinism.draws import state_from
from repro.determinism.noise import ROOM
from repro.determinism.plain_costs import callable_cost, passing
from repro.errors import InputError

Vector = NDArray[np.float64]


class Problem(Protocol):
    """Bounds plus a cost."""

    @property
    def bounds(self) -> Vector:
        """Lower and upper bound of each coordinate, shape (n, 2)."""

    @property
    def kernel(self) -> Any:  # noqa: ANN401 (numba ships no types)
        """Cost: compiled, (point, data) to cost, or plain Python, f(x) or f(x, data)."""

    @property
    def data(self) -> Vector:
        """Numbers that the cost needs besides the point, shape (k,)."""

    @property
    def identity(self) -> tuple[object, ...]:
        """What the cost depends on besides source code; equal problems have equal identities."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Result:
    """Best point (n,), its cost, best cost after each iteration, and evaluations spent."""

    x: Vector
    cost: float
    history: Vector
    evaluations: int


class Budget(TypedDict):
    """What a search may spend: agents, and either iterations or cost evaluations."""

    population: int
    iterations: NotRequired[int]
    evaluations: NotRequired[int]
    rng: np.random.Generator


class Optimiser(Protocol):
    """Anything that minimises a Problem within a budget.

    It may say more of itself: see HoldsInterpreter, LeavesBox and DeclaresSpending.
    """

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Result:
        """Return the best point found.

        Give `population`, `rng` and either `iterations` or a number of `evaluations`, of which
        the whole iterations that fit are run. Raises InputError for a budget that pays for no
        iteration, a population that the algorithm cannot work with, or impossible bounds.
        """


@dataclass(frozen=True, slots=True, kw_only=True)
class Spending:
    """Evaluations that an algorithm spends before its loop and in each iteration."""

    start: int = 0
    each: int


@runtime_checkable
class HoldsInterpreter(Protocol):
    """An optimiser or problem that says whether its runs go to processes and not to threads.

    It need not: without the attribute it follows from what is compiled. Both give the same bits.
    """

    @property
    def holds_interpreter(self) -> bool:
        """Whether runs in threads would wait for each other."""


@runtime_checkable
class LeavesBox(Protocol):
    """An optimiser whose source lets points leave the box."""

    @property
    def leaves_box(self) -> bool:
        """Whether its best point may lie outside."""


@runtime_checkable
class DeclaresSpending(Protocol):
    """An optimiser that does not evaluate every agent once in each iteration, and no more."""

    def spending(self, population: int) -> Spending:
        """Return what it spends with so many agents."""


@runtime_checkable
class NeedsScratch(Protocol):
    """A problem whose cost writes numbers of its own at the start of the data."""

    @property
    def scratch(self) -> int:
        """How many."""


@runtime_checkable
class AddsNoise(Protocol):
    """A problem whose cost may add a draw, another one at every evaluation.

    It draws by a state at the start of the data (see repro.determinism.noise).
    """

    @property
    def noise(self) -> float:
        """What every draw is below; 0 where it adds none."""


def noise_of(problem: Problem) -> float:
    """Return what the noise of a cost is below: draws start at 0, and that is none."""
    return problem.noise if isinstance(problem, AddsNoise) else 0.0


def without_noise(problem: Problem, data: Vector) -> Vector:
    """Return data with which the cost adds no noise: the same, where it adds none anyway."""
    if not noise_of(problem):
        return data
    silent = data.copy()
    silent[:ROOM] = 0.0
    return silent


@runtime_checkable
class TellsQuantities(Protocol):
    """A problem that says more of a point than its cost, such as a motion its total time."""

    def quantity(self, name: str, x: Vector) -> Vector:
        """Return a quantity of points of shape (..., n), shape (...); names are the problem's."""


def every_agent_once(population: int) -> Spending:
    """Return the spending of a loop that evaluates each agent once: N·T in all."""
    return Spending(each=population)


def search(
    kernel: Any,  # noqa: ANN401
    problem: Problem,
    *,
    parameters: tuple[float, ...] = (),
    spending: Callable[[int], Spending] = every_agent_once,
    least: int = 1,
    population: int,
    iterations: int | None = None,
    evaluations: int | None = None,
    rng: np.random.Generator,
) -> Result:
    """Run a compiled search that needs `least` agents and return its Result; see `Optimiser`."""
    if population < least:
        message = f"population {population} is too small; this search needs {least} or more"
        raise InputError(message)
    steps = _iterations(spending(population), iterations=iterations, evaluations=evaluations)
    bounds = checked_bounds(problem)
    with passing(problem.kernel) as cost:
        x, best, history, spent = ready(kernel, SEARCH)(
            cost,
            np.ascontiguousarray(problem.data, dtype=np.float64),
            bounds,
            population,
            steps,
            np.array(parameters, dtype=np.float64),
            state_from(rng),
        )
    return Result(x=x, cost=float(best), history=history, evaluations=int(spent))


def hands_to_search(optimiser: object) -> bool:
    """Return whether an optimiser's `minimise` leaves its work to the compiled `search`."""
    minimise = getattr(type(optimiser), "minimise", None)
    code, known = getattr(minimise, "__code__", None), getattr(minimise, "__globals__", {})
    return code is not None and any(known.get(name) is search for name in code.co_names)


def value(kernel: Any, data: Vector, x: Vector) -> float:  # noqa: ANN401
    """Return the cost of a point, shape (n,), by a kernel that is compiled or plain Python."""
    return float(callable_cost(kernel)(np.ascontiguousarray(x, dtype=np.float64), data))


def _iterations(cost: Spending, *, iterations: int | None, evaluations: int | None) -> int:
    """Return the number of whole iterations that the budget pays for."""
    if (iterations is None) == (evaluations is None):
        message = "give either iterations or evaluations, not both or neither"
        raise InputError(message)
    steps = iterations if evaluations is None else (evaluations - cost.start) // cost.each
    if steps is None or steps < 1:
        message = (
            f"iterations={iterations}, evaluations={evaluations} pay for no iteration; "
            f"one costs {cost.each} evaluations after {cost.start} at the start"
        )
        raise InputError(message)
    return steps


def checked_bounds(problem: Problem) -> Vector:
    """Return the bounds as a contiguous array; InputError unless finite and in order."""
    try:
        bounds = np.ascontiguousarray(problem.bounds, dtype=np.float64)
    except (TypeError, ValueError):
        bounds = np.empty(0)
    sound = bounds.ndim == 2 and bounds.shape[1] == 2 and len(bounds) > 0
    if not (sound and np.isfinite(bounds).all() and (bounds[:, 0] <= bounds[:, 1]).all()):
        shown = " ".join(f"{problem.bounds!r:.80}".split())
        message = f"bounds must be finite pairs lower <= upper of shape (n, 2), not {shown}"
        raise InputError(message)
    return bounds
