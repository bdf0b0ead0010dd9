"""What a search is held to: its box, its budget, its inputs, and the cost that it reports."""

from collections.abc import Iterator
from dataclasses import dataclass
from numbers import Integral, Real
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from repro.determinism.noise import ROOM, noise_of_run
from repro.determinism.plain_costs import PlainCost, is_compiled
from repro.determinism.seeds import generator
from repro.errors import InputError
from repro.optimisers.search import (
    DeclaresSpending,
    LeavesBox,
    NeedsScratch,
    Optimiser,
    Problem,
    Result,
    checked_bounds,
    noise_of,
    value,
    without_noise,
)
from repro.runs.equal_budget import declared_evaluations

Vector = NDArray[np.float64]
_SHOWN = 4  # coordinates of a point that a message shows


@dataclass(frozen=True, slots=True, kw_only=True)
class Given:
    """A problem whose bounds and data are one run's own, so that no run can spoil another's."""

    problem: Any
    bounds: Vector
    data: Vector
    before: tuple[bytes, bytes]

    @classmethod
    def of(cls, problem: Problem, stream: str) -> Self:
        """Return the problem with copies of its bounds and data for the run of that name.

        A cost that needs room for numbers of its own has it at the start of the data. There stands,
        too, what noise is drawn by, so that it follows from the name of the run alone.
        """
        bounds, data = checked_bounds(problem).copy(), _checked_data(problem)
        if noise_of(problem):
            data[:ROOM] = noise_of_run(stream)
        return cls(problem=problem, bounds=bounds, data=data, before=_bytes(problem, bounds, data))

    @property
    def is_as_it_was(self) -> bool:
        """Whether bounds and data are what was given."""
        return _bytes(self.problem, self.bounds, self.data) == self.before

    def __getattr__(self, name: str) -> Any:  # noqa: ANN401 (whatever the problem has besides)
        """Return anything else as the problem has it."""
        return getattr(self.problem, name)

    @property
    def kernel(self) -> Any:  # noqa: ANN401 (numba ships no types)
        """The cost as a function of (point, data), whatever form the problem has it in."""
        kernel = self.problem.kernel
        return kernel if is_compiled(kernel) else PlainCost.of(kernel)

    @property
    def noise(self) -> float:
        """What every draw that the cost adds is below; 0 where it adds none."""
        return noise_of(self.problem)

    def cost(self, x: Vector) -> float:
        """Return the cost of a point, without noise."""
        return value(self.problem.kernel, without_noise(self.problem, self.data), x)


def _checked_data(problem: Problem) -> Vector:
    try:
        data = np.array(problem.data, dtype=np.float64)
    except (TypeError, ValueError):
        data = np.empty((0, 0))
    if data.ndim != 1:
        shown = " ".join(f"{problem.data!r:.80}".split())
        message = f"data must be numbers of shape (k,), not {shown}"
        raise InputError(message)
    return data


def _bytes(problem: Problem, bounds: Vector, data: Vector) -> tuple[bytes, bytes]:
    room = problem.scratch if isinstance(problem, NeedsScratch) else 0
    return bounds.tobytes(), data[room:].tobytes()


def in_numbers(result: Any) -> Result:  # noqa: ANN401 (whatever a search returned)
    """Return a result as vectors and plain numbers of its own; TypeError for what has none."""
    cost, evaluations = result.cost, result.evaluations
    if not isinstance(cost, Real):
        message = f"the search reports the cost {cost!r:.40}, which is not one number"
        raise TypeError(message)
    if not isinstance(evaluations, Integral):
        message = f"the search reports {evaluations!r:.40} evaluations, which is no whole number"
        raise TypeError(message)
    x, history = (np.array(part, dtype=np.float64) for part in (result.x, result.history))
    return Result(x=x, cost=float(cost), history=history, evaluations=int(evaluations))


def conduct(
    optimiser: Optimiser,
    subject: Any,  # noqa: ANN401 (any problem)
    stream: str,
    *,
    population: int,
    **budget: int,
) -> tuple[Result, Given]:
    """Return the result of a search that is seeded by the name of its run, and what it was given.

    The budget is `iterations` or `evaluations`. Raises whatever the search raises.
    """
    given = Given.of(subject, stream)
    rng = generator(stream)
    return in_numbers(optimiser.minimise(given, population=population, rng=rng, **budget)), given


def fault(
    result: Result,
    given: Given,
    *,
    optimiser: Optimiser,
    population: int,
    iterations: int | None,
    evaluations: int | None,
) -> str | None:
    """Return what is wrong with a search or its result, None where nothing is.

    One that does not declare its spending may spend N·(T + 1) evaluations.
    """
    most = evaluations or _most(optimiser, population, iterations or 0)
    free = isinstance(optimiser, LeavesBox) and optimiser.leaves_box
    return next(_faults(result, given, free=free, iterations=iterations, most=most), None)


def _faults(
    result: Result,
    given: Given,
    *,
    free: bool,
    iterations: int | None,
    most: int,
) -> Iterator[str]:
    if not given.is_as_it_was:
        yield "the search, or the cost, changed the bounds or data that it was given"
    if not np.isfinite(result.cost):
        where = f" at {_shown(result.x)}" if np.isnan(result.cost) else ""
        yield f"the best cost is {result.cost}{where}"
    if result.x.shape != (len(given.bounds),):
        yield f"the best point has shape {result.x.shape}, not ({len(given.bounds)},)"
    outside = ~((given.bounds[:, 0] <= result.x) & (result.x <= given.bounds[:, 1]))
    if outside.any() and not free:
        j = int(outside.argmax())
        low, high = given.bounds[j]
        yield f"the search left the box: coordinate {j + 1} is {result.x[j]}, not {low} to {high}"
    if iterations is not None and result.history.shape != (iterations,):
        yield f"the history has shape {result.history.shape}, not ({iterations},)"
    if not 0 < result.evaluations <= most:
        yield f"the search spent {result.evaluations} evaluations of at most {most}"
    # with noise: the sum of the cost and a draw below the noise may round to the very end
    if not (cost := given.cost(result.x)) <= result.cost <= cost + given.noise:
        noise = f" and noise from 0 to {given.noise:g}" if given.noise else ""
        again = given.cost(result.x)
        unsteady = f", and {again!r} when asked again: the cost draws or keeps a state of its own"
        yield (
            f"the search reports the cost {result.cost!r} for a point that costs {cost!r}{noise}"
            f"{'' if again == cost or np.isnan(cost) else unsteady}"
        )


def _most(optimiser: Optimiser, population: int, iterations: int) -> int:
    if isinstance(optimiser, DeclaresSpending):
        return declared_evaluations(optimiser, population, iterations)
    return population * (iterations + 1)


def _shown(x: Vector) -> str:
    more = f", … ({len(x)} coordinates)" if len(x) > _SHOWN else ""
    return f"x = [{', '.join(map(str, x[:_SHOWN].tolist()))}{more}]"
