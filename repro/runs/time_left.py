"""How long the runs that are missing will take, from how long runs of their kinds took.

A kind is one algorithm on one problem of one experiment. What a run of it takes is known from runs
of this call, from those of earlier calls, or else from what an evaluation of its algorithm took on
other problems, of any algorithm that is compiled or not as this one is, or by a table. Only the
proportions matter: runs that are done say how much of that passes in a second of the clock.
"""

from collections import defaultdict
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass

from repro.runs.plan import Task
from repro.runs.run import holds_interpreter
from repro.runs.store.questions import Kind

STATED = {False: 0.5e-6, True: 25e-6}
"""Seconds that an evaluation takes where nothing is known: of compiled searches, of others."""
FEW = 3  # runs of a compiled kind below which the one that was compiled meanwhile stands out


@dataclass(slots=True)
class Taken:
    """A kind: evaluations of a run, runs left and done, what those took, and the longest."""

    evaluations: int
    in_python: bool
    left: int = 0
    done: int = 0
    seconds: float = 0.0
    longest: float = 0.0

    @property
    def settled(self) -> bool:
        """Whether the runs that are done say how long one takes."""
        return self.done >= (1 if self.in_python else FEW)

    @property
    def each(self) -> float:
        """Seconds of a run that is done, the longest left out: the first one was compiled."""
        if self.done == 1:
            return self.seconds
        return (self.seconds - self.longest) / (self.done - 1)


class TimeLeft:
    """Counts runs by kind as they are done."""

    def __init__(self) -> None:
        """Expect nothing yet."""
        self._kinds: dict[Kind, Taken] = {}
        self._earlier: Mapping[Kind, float] = {}
        self._spent = 0.0

    @property
    def runs(self) -> int:
        """How many runs are expected and not done."""
        return sum(kind.left for kind in self._kinds.values())

    def expect(self, tasks: Iterable[Task], earlier: Mapping[Kind, float]) -> None:
        """Count runs that are to be done; `earlier` are the seconds of a run in other calls."""
        self._earlier, self._spent = earlier, 0.0
        for task in tasks:
            kind = kind_of(task)
            if kind not in self._kinds:
                self._kinds[kind] = Taken(
                    evaluations=task.evaluations or task.population * task.iterations,
                    in_python=holds_interpreter(task),
                )
            self._kinds[kind].left += 1

    def note(self, kind: Kind, seconds: float) -> None:
        """Count a run that is done, and how long it took."""
        taken = self._kinds[kind]
        taken.left, taken.done = taken.left - 1, taken.done + 1
        taken.seconds += seconds
        taken.longest = max(taken.longest, seconds)
        self._spent += seconds

    def outlook(self, elapsed: float) -> tuple[float, float]:
        """Return the share of the work that is done and the seconds of the clock that are left.

        `elapsed` are those since the runs were expected, of which one is done.
        """
        rate = self._rate()
        rest = sum(
            taken.left * self._each(kind, rate) for kind, taken in self._kinds.items() if taken.left
        )
        if not rest:
            return 1.0, 0.0
        return self._spent / (self._spent + rest), rest * elapsed / max(self._spent, 1e-9)

    def _each(self, kind: Kind, rate: Callable[[Kind], float]) -> float:
        taken = self._kinds[kind]
        if taken.settled:
            return taken.each
        earlier = self._earlier.get(kind)
        return taken.evaluations * rate(kind) if earlier is None else earlier * self._slower()

    def _slower(self) -> float:
        """Return how many times as long runs take as they did in other calls."""
        pairs = [
            (taken.each, self._earlier[kind])
            for kind, taken in self._kinds.items()
            if taken.settled and kind in self._earlier
        ]
        before = sum(earlier for _, earlier in pairs)
        return sum(now for now, _ in pairs) / before if before else 1.0

    def _rate(self) -> Callable[[Kind], float]:
        """Return what tells the seconds of an evaluation for kinds without a run of their own."""
        found: dict[object, list[float]] = defaultdict(list)
        for kind, taken in self._kinds.items():
            seconds = taken.each if taken.settled else self._earlier.get(kind)
            if seconds is not None:
                for what in (kind[-1], taken.in_python):
                    found[what].append(seconds / taken.evaluations)
        means = {what: sum(rates) / len(rates) for what, rates in found.items()}

        def rate(kind: Kind) -> float:
            sort = self._kinds[kind].in_python
            # where only the other sort of search is known: how much slower this machine is
            slower = means.get(not sort, STATED[not sort]) / STATED[not sort]
            return means.get(kind[-1], means.get(sort, STATED[sort] * slower))

        return rate


def kind_of(task: Task) -> Kind:
    """Return the kind of a run."""
    return task.paper, task.experiment, task.problem, task.algorithm
