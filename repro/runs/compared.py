"""Which searches of users were compared with a store, so that their runs can be planned again."""

import json
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

from repro.errors import InputError
from repro.model.experiment import Experiment
from repro.model.paper import Paper
from repro.optimisers.random_search import RandomSearch
from repro.optimisers.users_search import Entrant
from repro.runs.moved_optima import SHARES, centred, shift_name, shifted
from repro.runs.plan import Task, plan
from repro.runs.plan import tasks_of as tasks_of_experiments
from repro.runs.studies import study_name
from repro.runs.whole_files import read_file, set_aside, write_file

NAME = "compared.json"


@dataclass(frozen=True, slots=True, kw_only=True)
class Compared:
    """One search under one paper: its name, where it is found, and how much of it was run."""

    paper: str
    name: str
    place: str
    experiments: tuple[str, ...]
    problems: tuple[str, ...]
    runs: int | None
    repeats: int
    folder: str


def narrowed(
    paper: Paper,
    searches: dict[str, Any],
    *,
    experiments: Sequence[str] = (),
    problems: Sequence[str] = (),
    runs: int | None = None,
) -> Paper:
    """Return a paper's protocols with these searches alone, no claims, and only what is named.

    An empty list names all; `runs` stand in the place of the protocol's. Experiments without any
    of the problems are left out.
    """
    first = next(iter(searches))
    kept = tuple(
        replace(
            experiment, algorithms=dict(searches), proposed=first, problems=some,
            runs=experiment.runs if runs is None else runs,
        )
        for experiment in paper.experiments
        if not experiments or experiment.name in experiments
        if (some := {name: p for name, p in experiment.problems.items()
                     if not problems or name in problems})
    )  # fmt: skip
    bare = replace(
        paper, results=(), claims=(), assumptions=(), together=(), figures=(), relations=(),
        motion_readings=(),
    )  # fmt: skip
    return replace(bare, experiments=kept)


def beside(paper: Paper, own: Paper) -> Paper:
    """Return what a narrowed paper has left of a paper's protocols, with the paper's algorithms."""
    problems = {experiment.name: experiment.problems for experiment in own.experiments}
    kept = tuple(
        replace(experiment, problems=problems[experiment.name])
        for experiment in paper.experiments
        if experiment.name in problems
    )
    return replace(own, experiments=kept)


def moved(own: Paper) -> tuple[Experiment, ...]:
    """Return a narrowed paper's experiments with optima moved aside, for its searches alone."""
    return tuple(
        replace(
            shifted(experiment, share, floor=RandomSearch()),
            name=study_name(experiment.name, shift_name(share)), algorithms=experiment.algorithms,
        )
        for experiment in own.experiments
        if centred(experiment)
        for share in SHARES
    )  # fmt: skip


def moved_tasks(own: Paper) -> tuple[Task, ...]:
    """Return the runs of a narrowed paper with optima moved aside, once over."""
    return tuple(tasks_of_experiments(own, [(experiment, 1) for experiment in moved(own)]))


def remember(store: Path, found: Sequence[Compared], say: Callable[[str], None]) -> None:
    """Keep beside a store what was compared; the latest of one name is what is known of it.

    A file that cannot be read is set aside, with a line to `say`.
    """
    before = recalled(store)
    if before is None:
        path = store / NAME
        say(f"{path} cannot be read; it is set aside as {set_aside(path)}")
    known = {(each.paper, each.name): each for each in (*(before or ()), *found)}
    # spelt in ASCII, as the name of a folder may hold bytes that are no text
    text = json.dumps([asdict(each) for each in known.values()], indent=1)
    write_file(store, NAME, text + "\n", lasting=True)


def recalled(store: Path) -> list[Compared] | None:
    """Return what was compared with a store; None where a file says so that cannot be read."""
    try:
        rows: Any = json.loads(read_file(store / NAME).decode())
        return [
            Compared(**{**row, **{k: tuple(row[k]) for k in ("experiments", "problems")}})
            for row in rows
        ]
    except FileNotFoundError:
        return []
    except (OSError, ValueError, LookupError, TypeError, RecursionError):
        return None


def tasks_of(
    store: Path,
    papers: Sequence[Paper],
    load: Callable[[str, str], Entrant],
    say: Callable[[str], None],
) -> Iterator[Task]:
    """Yield the runs of searches that were compared under these papers.

    `load` returns the search at a place, and one that it cannot find is named by `say`.
    """
    declared = {paper.key: paper for paper in papers}
    found_before = recalled(store)
    if found_before is None:
        say(f"{store / NAME} cannot be read: searches that were compared are not known")
    for each in found_before or ():
        if each.paper not in declared:
            continue
        try:
            found: Entrant = load(each.place, each.folder)
        except InputError as error:
            say(f"{each.name}, compared before, is not looked at: {error}")
            continue
        own = narrowed(
            declared[each.paper], {each.name: found}, experiments=each.experiments,
            problems=each.problems, runs=each.runs,
        )  # fmt: skip
        yield from plan([own], each.repeats, protocol_only=True)
        yield from moved_tasks(own)
