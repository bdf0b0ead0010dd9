"""Searches in plain Python that need a process of their own, and some that kill it."""

import os
import signal
import time
from dataclasses import dataclass, replace
from pathlib import Path
from typing import ClassVar, Unpack

from repro.functions import FUNCTIONS
from repro.model.paper import Paper
from repro.optimisers.search import Budget, Optimiser, Problem, Result, Spending
from repro.runs.plan import Task, plan
from tests.small_papers import Guessing, searching


@dataclass(frozen=True, slots=True, kw_only=True)
class Held(Guessing):
    """Random search that says that it holds the interpreter."""

    holds_interpreter: ClassVar[bool] = True


@dataclass(frozen=True, slots=True, kw_only=True)
class Telling(Guessing):
    """A search whose evaluations are the number of the process that it ran in.

    It makes the file `ended`, where one is named, when it has waited for its seconds.
    """

    holds_interpreter: ClassVar[bool] = True
    seconds: float = 0.0
    ended: str = ""

    def spending(self, population: int) -> Spending:  # noqa: ARG002 (as searches declare it)
        """Return more than any process number, which is no number of evaluations."""
        return Spending(each=2**22)

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Result:
        """Return the guess of any other, and where it was made."""
        time.sleep(self.seconds)
        if self.ended:
            Path(self.ended).touch()
        found = Guessing.minimise(self, problem, **budget)
        return Result(x=found.x, cost=found.cost, history=found.history, evaluations=os.getpid())


@dataclass(frozen=True, slots=True, kw_only=True)
class Free(Telling):
    """The same, which says that it does not hold the interpreter."""

    holds_interpreter: ClassVar[bool] = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Deadly(Guessing):
    """Kills its process as often as there are files left in a folder; `driver` must not die."""

    holds_interpreter: ClassVar[bool] = True
    folder: str
    driver: int

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Result:
        """Take one file away and die, or guess where there is none."""
        if os.getpid() == self.driver:
            message = "this would have killed the tests"
            raise RuntimeError(message)
        for file in Path(self.folder).iterdir():
            file.unlink()
            os.kill(os.getpid(), signal.SIGKILL)
        return Guessing.minimise(self, problem, **budget)


@dataclass(frozen=True, slots=True, kw_only=True)
class Interrupting(Guessing):
    """Raises what only the driver's Ctrl-C should, in its run or already when it is prepared."""

    holds_interpreter: ClassVar[bool] = True
    prepared: bool = False

    def prepare(self, problem: Problem) -> None:  # noqa: ARG002 (as searches declare it)
        """Raise the interrupt, where that is asked."""
        if self.prepared:
            raise KeyboardInterrupt

    def minimise(self, problem: Problem, **budget: Unpack[Budget]) -> Result:  # noqa: ARG002
        """Raise the interrupt."""
        message = "enough"
        raise KeyboardInterrupt(message)


def appears(path: Path) -> bool:
    """Return whether a file is there after a while, however busy the machine is."""
    for _ in range(6000):
        if path.exists():
            return True
        time.sleep(0.05)
    return False


def deadly(folder: Path, lives: int) -> Deadly:
    """Return a search that kills so many processes before it finds anything."""
    for k in range(lives):
        (folder / str(k)).touch()
    return Deadly(folder=str(folder), driver=os.getpid())


def tasks_of(**algorithms: Optimiser) -> tuple[Task, ...]:
    """Return three runs of each search."""
    return plan([searching(**algorithms)], 1)


def many(search: Optimiser, runs: int) -> Paper:
    """Return a paper of many runs of one search."""
    paper = searching(guess=search)
    return replace(paper, experiments=(replace(paper.experiments[0], runs=runs),))


def on_rosenbrock(**algorithms: Optimiser) -> Paper:
    """Return a paper whose problem is compiled."""
    paper = searching(**algorithms)
    problems = {"rosenbrock": FUNCTIONS["rosenbrock"].problem(3)}
    return replace(paper, experiments=(replace(paper.experiments[0], problems=problems, runs=8),))
