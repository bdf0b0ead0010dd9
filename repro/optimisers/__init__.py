"""Optimisers, one file per algorithm, each a frozen dataclass of its parameters."""

from repro.optimisers.differential_evolution import DE
from repro.optimisers.dung_beetle import DBO
from repro.optimisers.genetic import GA
from repro.optimisers.gravitational import GSA
from repro.optimisers.grey_wolf import GWO
from repro.optimisers.hybrid_whale import HybridWOA
from repro.optimisers.particle_swarm import PSO
from repro.optimisers.random_search import RandomSearch
from repro.optimisers.search import Optimiser, Problem, Result
from repro.optimisers.slime_mould import SMA
from repro.optimisers.slime_whale import SlimeWOA
from repro.optimisers.steady_state_genetic import SteadyStateGA
from repro.optimisers.whale import WOA

__all__ = [
    "DBO",
    "DE",
    "GA",
    "GSA",
    "GWO",
    "PSO",
    "SMA",
    "WOA",
    "HybridWOA",
    "Optimiser",
    "Problem",
    "RandomSearch",
    "Result",
    "SlimeWOA",
    "SteadyStateGA",
]
