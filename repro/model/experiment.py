"""What a paper runs: algorithms on problems, so many times."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from repro.optimisers.search import Optimiser


@dataclass(frozen=True, slots=True, kw_only=True)
class Experiment:
    """Every algorithm on every problem, `runs` times, under the paper's protocol.

    `proposed` is the algorithm that the paper puts forward; the others are compared with it. Where
    `evaluations` is given, it is the budget of a run in place of the iterations. Runs draw the
    random numbers of the runs of `drawn_as`, an experiment's name, where one is given.
    """

    name: str
    where: str
    proposed: str
    problems: Mapping[str, Any]
    algorithms: Mapping[str, Optimiser]
    population: int
    iterations: int
    runs: int
    evaluations: int | None = None
    drawn_as: str = ""
