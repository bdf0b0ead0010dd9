"""Differential evolution as scipy offers it.

R. Storn, K. Price, Journal of Global Optimization 11 (1997) 341-359,
doi:10.1023/A:1008202821328, by `scipy.optimize.differential_evolution` with its defaults, but:

- as many agents as the protocol's population, where scipy would take 15 per dimension;
- a generation is evaluated as a whole before it replaces its parents (scipy's `vectorized`, as
  Storn and Price have it), which is several times as fast as one agent at a time;
- generations until the budget is spent, where scipy would end after 1000;
- a population that has converged, after scipy's polishing, makes room for a fresh one.
"""

from dataclasses import dataclass, field
from functools import partial
from typing import ClassVar, Unpack

import numpy as np

from repro.optimisers.libraries.budget import CountedCost, release, until_spent
from repro.optimisers.search import Budget, Problem, Result

_LEAST = 5  # scipy takes no fewer agents
_ENDLESS = 2**31 - 1


@dataclass(frozen=True, slots=True, kw_only=True)
class ScipyDifferentialEvolution:
    """scipy's differential evolution; `release` is the version of scipy that runs it."""

    holds_interpreter: ClassVar[bool] = True
    strategy: str = "best1bin"
    mutation: tuple[float, float] = (0.5, 1.0)
    recombination: float = 0.7
    release: str = field(default_factory=partial(release, "scipy"))

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Result:
        """Return the best point found by N·T evaluations; see `Optimiser`."""
        from scipy.optimize import differential_evolution  # noqa: PLC0415 (slow imports late)
        from scipy.stats.qmc import LatinHypercube  # noqa: PLC0415

        agents = max(budget["population"], _LEAST)

        def evolve(cost: CountedCost, rng: np.random.Generator) -> None:
            lower, upper = cost.bounds.T
            share = LatinHypercube(len(lower), rng=rng).random(agents)
            differential_evolution(
                cost.of_each,
                cost.bounds,
                vectorized=True,
                updating="deferred",
                strategy=self.strategy,
                mutation=self.mutation,
                recombination=self.recombination,
                maxiter=_ENDLESS,
                init=np.clip(lower + share * (upper - lower), lower, upper),
                rng=rng,
            )

        return until_spent(evolve, problem, **budget)
