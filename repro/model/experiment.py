"""What a paper runs: algorithms on problems, so many times."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from repro.errors import DeclarationError
from repro.model.known_words import shown_value
from repro.model.open_points import Gap
from repro.optimisers.own_search import as_optimiser

_MAPPINGS = {
    "problems": '{"F1": FUNCTIONS["sphere"].problem(30)}',
    "algorithms": '{"WOA": WOA()}',
    "left_out": '{"WOA": TEXT.gap("its equations")}',
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Experiment:
    """Every algorithm on every problem, `runs` times, under the paper's protocol.

    `proposed` is the algorithm that the paper puts forward; the others are compared with it. Where
    `evaluations` is given, it is the budget of a run in place of the iterations. Runs draw the
    random numbers of the runs of `drawn_as`, an experiment's name, where one is given. An algorithm
    that is a callable f(cost, bounds, budget, rng) -> x is kept as an `OwnSearch` of it. Where the
    paper's tables call the greatest cost the best, they `maximise`: the audit reads them so; runs
    minimise all the same. `left_out` are algorithms of the paper that cannot be re-run, each with
    the gap that says why; the proposed one may be among them.
    """

    name: str
    where: str
    proposed: str
    problems: Mapping[str, Any]
    algorithms: Mapping[str, Any]  # optimisers, once it is made
    population: int
    iterations: int
    runs: int
    evaluations: int | None = None
    drawn_as: str = ""
    maximise: bool = False
    left_out: Mapping[str, Gap] = field(default_factory=dict)

    def __post_init__(self) -> None:
        """Raise DeclarationError for an algorithm that is no search, and for lists of them."""
        for name, meant in _MAPPINGS.items():
            if not isinstance(value := getattr(self, name), Mapping):
                message = f"{self.name}, {name} is {shown_value(value)}; it must be a dict: {meant}"
                raise DeclarationError(message)
        optimisers = {
            name: as_optimiser(given, f"{self.name}, algorithm {name!r}")
            for name, given in self.algorithms.items()
        }
        object.__setattr__(self, "algorithms", optimisers)

    @property
    def runs_proposed(self) -> bool:
        """Whether the algorithm that the paper puts forward is one that is run."""
        return self.proposed in self.algorithms
