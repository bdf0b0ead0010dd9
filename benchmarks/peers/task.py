"""What a peer is asked for: one run of one algorithm, all else equal."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, slots=True, kw_only=True)
class Task:
    """One run: `objective` takes a point (n,); every coordinate lies in [lower, upper]."""

    algorithm: str
    function: str
    objective: Callable[[Any], Any]
    lower: float
    upper: float
    dimension: int
    population: int
    iterations: int
    seed: int
