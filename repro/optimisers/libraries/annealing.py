"""Dual annealing as scipy offers it.

Y. Xiang, D. Y. Sun, W. Fan, X. G. Gong, Physics Letters A 233 (1997) 216-220,
doi:10.1016/S0375-9601(97)00474-X, by `scipy.optimize.dual_annealing` with its defaults (local
searches by L-BFGS-B among them), but that it goes on until the budget is spent, where scipy would
end after 1000 steps; its schedule does not depend on that end.
"""

from dataclasses import dataclass, field
from functools import partial
from typing import ClassVar, Unpack

import numpy as np

from repro.optimisers.libraries.budget import CountedCost, release, until_spent
from repro.optimisers.search import Budget, Problem, Result

_ENDLESS = 2**31 - 1


@dataclass(frozen=True, slots=True, kw_only=True)
class ScipyDualAnnealing:
    """scipy's dual annealing; `release` is the version of scipy that runs it."""

    holds_interpreter: ClassVar[bool] = True
    initial_temperature: float = 5230.0
    visit: float = 2.62
    accept: float = -5.0
    release: str = field(default_factory=partial(release, "scipy"))

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Result:
        """Return the best point found by N·T evaluations; see `Optimiser`."""
        from scipy.optimize import dual_annealing  # noqa: PLC0415 (slow imports late)

        def anneal(cost: CountedCost, rng: np.random.Generator) -> None:
            dual_annealing(
                cost,
                cost.bounds,
                maxiter=_ENDLESS,
                maxfun=_ENDLESS,
                initial_temp=self.initial_temperature,
                visit=self.visit,
                accept=self.accept,
                rng=rng,
            )

        return until_spent(anneal, problem, **budget)
