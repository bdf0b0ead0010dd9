"""A made-up paper whose searches are plain Python and take no time."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, Unpack

import numpy as np
from numpy.typing import NDArray

from repro.determinism.compiled import jit
from repro.model.cells import every_cell
from repro.model.evidence import Cell, Evidence, Runs
from repro.model.experiment import Experiment
from repro.model.paper import Paper, Source
from repro.model.tolerances import Percent
from repro.optimisers.search import Budget, Optimiser, Problem, Result
from repro.tables.published import PublishedTable

if TYPE_CHECKING:
    import pytest

Vector = NDArray[np.float64]


def _line_of(text: str) -> int:
    """Return the first line of this file that holds the text."""
    lines = Path(__file__).read_text(encoding="utf-8").splitlines()
    return 1 + next(k for k, line in enumerate(lines) if text in line)


def _bowl(x: Vector, data: Vector) -> float:
    """Return the squared distance from the centre."""
    return float(((x - data) ** 2).sum())


bowl = jit(_bowl)


@dataclass(frozen=True, slots=True, kw_only=True)
class Bowl:
    """Minimise the squared distance from a centre."""

    centre: tuple[float, ...] = (0.5, -0.25)

    @property
    def bounds(self) -> Vector:
        """The square from -1 to 1."""
        return np.tile([-1.0, 1.0], (len(self.centre), 1))

    @property
    def kernel(self) -> Any:  # noqa: ANN401 (as in the protocol)
        """The cost."""
        return bowl

    @property
    def data(self) -> Vector:
        """The centre."""
        return np.array(self.centre)

    @property
    def identity(self) -> tuple[object, ...]:
        """The centre."""
        return (self.centre,)


@dataclass(frozen=True, slots=True, kw_only=True)
class Guessing:
    """Random search in a box `width` times the problem's, too short to need a process."""

    holds_interpreter: ClassVar[bool] = False
    width: float = 1.0

    @property
    def leaves_box(self) -> bool:
        """Whether it guesses outside the box."""
        return self.width > 1.0

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Result:
        """Return the best of the guesses."""
        size = (budget["iterations"], budget["population"], len(problem.bounds))
        low, high = problem.bounds.T
        guesses = self.width * budget["rng"].uniform(low, high, size=size)
        costs = np.array([[problem.kernel(x, problem.data) for x in row] for row in guesses])
        x = guesses.reshape(-1, size[2])[costs.argmin()]
        history = np.minimum.accumulate(costs.min(axis=1))
        return Result(x=x, cost=float(costs.min()), history=history, evaluations=costs.size)


@dataclass(frozen=True, slots=True, kw_only=True)
class Failing:
    """A search that ends with a cost that is no number, or raises an error where None is given."""

    holds_interpreter: ClassVar[bool] = False
    cost: float | None = None

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Result:  # noqa: ARG002
        """Raise the error, or return the cost."""
        if self.cost is None:
            message = "lost the way"
            raise ValueError(message)
        return Result(x=np.zeros(2), cost=self.cost, history=np.zeros(1), evaluations=1)


LOST = f"ValueError: lost the way (small_papers.py, line {_line_of('raise ValueError(message)')})"
"""What is said of a run of `Failing`."""


def let_be_known(monkeypatch: "pytest.MonkeyPatch", *papers: Paper) -> None:
    """Let the command line know these papers alone, as if they were this house's."""
    # not above, since every worker process that runs a search of a small paper loads this file
    from repro.commands.catalogue import folders  # noqa: PLC0415
    from repro.commands.paper_modules import Declared  # noqa: PLC0415

    folder = Path(folders()[0]).resolve()
    known = [Declared(paper=each, place=folder / f"{each.key}.py") for each in papers]
    monkeypatch.setattr("repro.commands.catalogue.known", lambda: known)


TABLE = PublishedTable.read("""
    Table 1, p. 3 (3 runs)
    problem | statistic || guess | wide
    bowl    | mean      || 0.05  | 0.5
            | std       || 0.02  | 0.4
""")

EXPERIMENT = Experiment(
    name="search",
    where="p. 3",
    proposed="guess",
    problems={"bowl": Bowl()},
    algorithms={"guess": Guessing(), "wide": Guessing(width=4.0)},
    population=4,
    iterations=5,
    runs=3,
)

CLAIMS = every_cell(
    TABLE, of=EXPERIMENT, rows=("problem", "statistic"), columns="algorithm", within=Percent(25)
)

PAPER = Paper(
    key="small2020",
    source=Source(authors="A. Nobody", title="A small paper"),
    summary="Guessing near by beats guessing far away.",
    experiments=(EXPERIMENT,),
    inputs=(),
    results=(TABLE,),
    claims=CLAIMS,
    assumptions=(),
    errata=(),
    gaps=(),
)


def evidence_of(paper: Paper, runs: Mapping[Cell, Runs]) -> Evidence:
    """Return evidence of a paper's own experiments, from these runs."""
    return Evidence(key=paper.key, experiments=paper.experiments, runs=runs)


def searching(**algorithms: Optimiser) -> Paper:
    """Return a paper without claims that runs these algorithms."""
    experiment = replace(
        EXPERIMENT, algorithms=algorithms, proposed=next(iter(algorithms), "guess")
    )
    return replace(PAPER, experiments=(experiment,), results=(), claims=())


def evidence(paper: Paper = PAPER, **costs: list[list[float]]) -> Evidence:
    """Return evidence with these costs, shape (repeats, runs), by algorithm; the points are 0."""
    runs = {}
    for algorithm, values in costs.items():
        cell = np.array(values)
        runs["search", "bowl", algorithm] = Runs(
            costs=cell,
            points=np.zeros((*cell.shape, 2)),
            histories=cell[..., None] * np.arange(5.0, 0.0, -1.0),
            evaluations=20,
        )
    return evidence_of(paper, runs)


MODULE = """
import time
from dataclasses import dataclass, replace
from tests.small_papers import EXPERIMENT, PAPER as SMALL, Guessing

@dataclass(frozen=True)
class Slow(Guessing):
    def minimise(self, problem, **budget):
        time.sleep(0.05)
        return super(Slow, self).minimise(problem, **budget)

SEARCH = replace(EXPERIMENT, algorithms={"guess": Slow(), "wide": Guessing(width=4.0)}, runs=20)
PAPER = replace(SMALL, key="slow2021", experiments=(SEARCH,))
"""
"""The text of a paper module, of 40 runs, half of them slow."""

ENDLESS = """
from dataclasses import replace
from repro.optimisers import WOA
from tests.held_searches import Telling, on_rosenbrock
from tests.small_papers import Guessing

QUICK, LONG = Guessing(), {{"compiled": WOA(), "plain": Telling(seconds=600.0)}}
SHORT = replace(on_rosenbrock(quick=QUICK).experiments[0], name="short", runs=3)
ENDLESS = replace(SHORT, name="endless", algorithms={{"long": LONG["{search}"]}}, proposed="long")
ENDLESS = replace(ENDLESS, population=1000, iterations=10**6)
PAPER = replace(on_rosenbrock(quick=QUICK), key="endless2021", experiments=(SHORT, ENDLESS))
"""
"""The text of a paper module, of 3 short runs and 3 that take minutes."""
