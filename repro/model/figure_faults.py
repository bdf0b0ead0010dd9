"""What no figure and no relation of a paper may say, a line a fault."""

import dataclasses
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from typing import get_args

from repro.model.experiment import Experiment
from repro.model.figures import Arm, Convergence, Figure, JointCurves, SplineMotion
from repro.model.known_words import known_words
from repro.robotics.shown_motion import ShowsMotion
from repro.tables.published import PublishedTable
from repro.tables.relations import Relation, TableCell

FIGURES: tuple[type, ...] = get_args(Figure)
RELATIONS: tuple[type, ...] = get_args(Relation)


def figure_faults(
    figures: Iterable[Figure], experiments: Iterable[Experiment], assumed: Iterable[str]
) -> Iterator[str]:
    """Yield what the figures name that is not there; `assumed` are the paper's assumptions."""
    figures, assumed = list(figures), list(assumed)
    runs = {experiment.name: experiment for experiment in experiments}
    for label, times in Counter(figure.label for figure in figures).items():
        if times > 1:
            yield f"{times} figures are called {label!r}: a label names one figure"
    for figure in figures:
        if isinstance(figure, Arm):
            for what in figure.assumed:
                if what not in assumed:
                    known = known_words(what, assumed)
                    yield f"{figure.label}: no assumption {what!r}; {known}"
        else:
            yield from (f"{figure.label}: {fault}" for fault in _run_faults(figure, runs))


def _run_faults(figure: Figure, runs: Mapping[str, Experiment]) -> Iterator[str]:
    """Yield what a figure shows of runs that are of nothing."""
    name = getattr(figure, "experiment", "")
    algorithms = getattr(figure, "algorithms", ())
    must = bool(algorithms) or isinstance(figure, (Convergence, SplineMotion))
    if not name and not must:
        return
    if name not in runs:
        yield f"no experiment {name!r}; {known_words(name, runs)}"
        return
    for each in algorithms:
        if each not in runs[name].algorithms:
            known = known_words(each, runs[name].algorithms)
            yield f"experiment {name!r} has no algorithm {each!r}; {known}"
    if algorithms and not all(_is_run(problem, runs[name]) for problem in _problems(figure)):
        known = ", ".join(map(repr, runs[name].problems))
        yield f"its problem is none of experiment {name!r}, which has {known}"


def _problems(figure: Figure) -> tuple[object, ...]:
    """Return the problems whose runs a figure shows."""
    if isinstance(figure, JointCurves):
        return figure.paths
    return (getattr(figure, "problem", None),)


def _is_run(problem: object, experiment: Experiment) -> bool:
    # what others wrote may hold arrays, of which == makes no truth
    plain = not isinstance(problem, ShowsMotion)
    return any(own is problem or (plain and own == problem) for own in experiment.problems.values())


def relation_faults(
    relations: Iterable[Relation], tables: Iterable[PublishedTable]
) -> Iterator[str]:
    """Yield the tables that relations speak of and that the paper does not declare."""
    known = [table.label for table in tables]
    spoken = (
        (type(relation).__name__, table.label)
        for relation in relations
        for table in tables_of(relation)
    )
    for kind, label in dict.fromkeys(spoken):
        if label not in known:
            yield f"{kind}: no table {label!r}; {known_words(label, known)}"


def tables_of(part: object) -> Iterator[PublishedTable]:
    """Yield the tables of a relation, or of what is in it."""
    if isinstance(part, (PublishedTable, TableCell)):
        yield part.table if isinstance(part, TableCell) else part
    elif isinstance(part, Mapping):
        yield from (table for each in part.values() for table in tables_of(each))
    elif isinstance(part, tuple | list):
        yield from (table for each in part for table in tables_of(each))
    elif isinstance(part, RELATIONS):
        for field in dataclasses.fields(part):  # type: ignore[arg-type]
            yield from tables_of(getattr(part, field.name))
