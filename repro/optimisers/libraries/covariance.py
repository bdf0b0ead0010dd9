"""CMA-ES with restarts, as the package `cmaes` offers it.

N. Hansen, A. Ostermeier, Evolutionary Computation 9(2) (2001) 159-195,
doi:10.1162/106365601750190398, with the restarts of A. Auger, N. Hansen, CEC 2005, 1769-1776,
doi:10.1109/CEC.2005.1554902 (IPOP), run as the package's documentation shows them: a uniform
random mean, a first step of a fifth of the width, and a population that doubles at each restart.
The box is searched as a unit cube, so that every coordinate has the same width.
"""

from dataclasses import dataclass, field
from functools import partial
from typing import ClassVar, Unpack

import numpy as np

from repro.optimisers.libraries.budget import CountedCost, release, until_spent
from repro.optimisers.search import Budget, Problem, Result


@dataclass(frozen=True, slots=True, kw_only=True)
class CMAES:
    """CMA-ES with a growing population; `release` is the version of cmaes that runs it.

    `step` is the first standard deviation as a share of the box, `growth` the factor of the
    population at each restart.
    """

    holds_interpreter: ClassVar[bool] = True
    step: float = 0.2
    growth: int = 2
    release: str = field(default_factory=partial(release, "cmaes"))

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Result:
        """Return the best point found by N·T evaluations; see `Optimiser`."""
        from cmaes import CMA  # noqa: PLC0415 (slow imports late)

        agents = None  # the package's own choice, 4 + 3 ln n

        def adapt(cost: CountedCost, rng: np.random.Generator) -> None:
            nonlocal agents
            lower, upper = cost.bounds.T
            search = CMA(
                mean=rng.uniform(size=len(lower)),
                sigma=self.step,
                bounds=np.tile([0.0, 1.0], (len(lower), 1)),
                seed=int(rng.integers(2**32)),
                population_size=agents,
            )
            while not search.should_stop():
                points = [search.ask() for _ in range(search.population_size)]
                search.tell([(x, cost(lower + x * (upper - lower))) for x in points])
            agents = self.growth * search.population_size

        return until_spent(adapt, problem, **budget)
