"""A comparison of a user's searches: what was asked, what was run, and what is to be said."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from repro.judge.centre_bias import CentreBias
from repro.judge.users_search import UsersSearch
from repro.model.evidence import Evidence
from repro.model.experiment import Experiment
from repro.model.paper import Paper
from repro.runs.honesty import Warned
from repro.runs.run import Record


@dataclass(frozen=True, slots=True, kw_only=True)
class Asked:
    """What is to be compared: searches by name, and how much of which protocols.

    Empty lists name all. `against` are the algorithms that are shown beside, `timeout` is in
    seconds a run, `centre_bias` says whether optima are moved aside, too.
    """

    searches: Mapping[str, Any]
    experiments: tuple[str, ...] = ()
    problems: tuple[str, ...] = ()
    against: tuple[str, ...] = ()
    runs: int | None = None
    repeats: int = 1
    timeout: float | None = None
    centre_bias: bool = True


@dataclass(frozen=True, slots=True, kw_only=True)
class Missing:
    """Algorithms that the store has no runs of, and the command that makes them."""

    paper: str
    experiment: str
    algorithms: tuple[str, ...]
    command: str

    @property
    def says(self) -> str:
        """One line."""
        names = ", ".join(self.algorithms)
        return f"no runs of {names} in {self.paper}/{self.experiment}: `{self.command}` makes them"


@dataclass(frozen=True, slots=True, kw_only=True)
class Part:
    """One experiment of a comparison: what was judged, and the runs behind it.

    `bias` is None where no optimum about the centre was moved, or the runs of that are not whole.
    """

    paper: Paper
    experiment: Experiment
    found: UsersSearch
    evidence: Evidence
    bias: CentreBias | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Comparison:
    """Everything that a comparison found; `records` are the runs of its own searches."""

    asked: Asked
    parts: tuple[Part, ...]
    records: tuple[Record, ...]
    failed: tuple[Record, ...]
    warnings: tuple[Warned, ...]
    missing: tuple[Missing, ...]
    libraries: Mapping[str, str]
