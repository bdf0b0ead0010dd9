"""Sequential quadratic programming from random starts, as scipy offers it.

D. Kraft, A software package for sequential quadratic programming, DFVLR-FB 88-28 (1988), by
`scipy.optimize.minimize(method="SLSQP")` with its defaults from uniform random starts, one after
another until the budget is spent. Gradients are forward differences, and each costs as many
evaluations as there are dimensions.
"""

from dataclasses import dataclass, field
from functools import partial
from typing import ClassVar, Unpack

import numpy as np

from repro.optimisers.libraries.budget import CountedCost, release, until_spent
from repro.optimisers.search import Budget, Problem, Result


@dataclass(frozen=True, slots=True, kw_only=True)
class ScipySLSQP:
    """scipy's SLSQP from random starts; `release` is the version of scipy that runs it."""

    holds_interpreter: ClassVar[bool] = True
    tolerance: float = 1e-6
    release: str = field(default_factory=partial(release, "scipy"))

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Result:
        """Return the best point found by N·T evaluations; see `Optimiser`."""
        from scipy.optimize import minimize  # noqa: PLC0415 (slow imports late)

        def descend(cost: CountedCost, rng: np.random.Generator) -> None:
            start = rng.uniform(*cost.bounds.T)
            minimize(cost, start, method="SLSQP", bounds=cost.bounds, tol=self.tolerance)

        return until_spent(descend, problem, **budget)
