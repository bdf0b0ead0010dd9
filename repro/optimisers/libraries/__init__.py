"""Searches that a reader would ask for, each at the budget of the paper's own.

The pure-Python ones import their libraries when they run, and hold the interpreter while they do.
"""

from collections.abc import Mapping
from types import MappingProxyType

from repro.optimisers.libraries.annealing import ScipyDualAnnealing
from repro.optimisers.libraries.covariance import CMAES
from repro.optimisers.libraries.evolution import ScipyDifferentialEvolution
from repro.optimisers.libraries.multistart import ScipySLSQP
from repro.optimisers.random_search import RandomSearch
from repro.optimisers.search import Optimiser

__all__ = [
    "BASELINES",
    "CMAES",
    "ScipyDifferentialEvolution",
    "ScipyDualAnnealing",
    "ScipySLSQP",
]

BASELINES: Mapping[str, Optimiser] = MappingProxyType(
    {
        "random search": RandomSearch(),
        "differential evolution (scipy)": ScipyDifferentialEvolution(),
        "dual annealing (scipy)": ScipyDualAnnealing(),
        "SLSQP multistart (scipy)": ScipySLSQP(),
        "CMA-ES (cmaes)": CMAES(),
    }
)
"""Every baseline, by the name that the pages give it."""
