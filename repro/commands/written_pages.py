"""From a store to pages: what `reproduce` ends with and `report` does alone."""

import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from types import MappingProxyType

from repro.commands.kept_output import FOLDER
from repro.commands.kept_pages import Request, extent_of, names_of, packed, unpacked
from repro.commands.shown_rows import warn
from repro.judge.judgement import Judgement, judge
from repro.model.evidence import Cell, Runs
from repro.model.paper import Paper
from repro.report.earlier import keep_earlier
from repro.report.kept import find, keep
from repro.report.pages import made_of
from repro.report.results import Json, Made
from repro.report.writing import write_report
from repro.runs.gather import cell_of, gather
from repro.runs.plan import Task, deeper_tasks, of_paper
from repro.runs.raw_runs import RawRuns, drawn_as
from repro.runs.store.store import Store
from repro.runs.studies import studies
from repro.runs.workers.local import usable_cores
from repro.runs.workers.side_by_side import Ask, side_by_side

Run = Callable[[Sequence[Task]], None]


def write_pages(
    store: Store,
    chosen: Sequence[Paper],
    tasks: Sequence[Task],
    folder: Path,
    known: Sequence[str],
    run: Run | None = None,
    called: Mapping[str, str] = MappingProxyType({}),
    places: Mapping[str, Path] = MappingProxyType({}),
) -> Json:
    """Judge the papers by what the store has of the tasks, write the pages, return the results.

    `known` are the keys of all papers, in their order. `run` makes the runs that a reading needs
    besides, before it may turn a verdict; without it the store's are taken. `called` says what
    papers from elsewhere than this checkout are called at the command line, `places` where each
    is declared: pages of those of this house are kept, and taken again while nothing changes.
    """
    own = {paper.key: of_paper(tasks, paper.key) for paper in chosen}
    asked = [
        Request(
            paper=paper,
            tasks=partial(own.__getitem__, paper.key),
            extent=extent_of(own[paper.key]),
            called=called.get(paper.key, ""),
        )
        for paper in chosen
    ]
    return write_made(made_pages(store, asked, places, known, run), folder, known)


def write_made(papers: Sequence[Made], folder: Path, known: Sequence[str]) -> Json:
    """Write the pages of papers, say what is to be said of them, and return the results."""
    keep_earlier(folder, [made.entry["key"] for made in papers], known, warn)
    for line in (line for made in papers for line in made.says):
        warn(line)
    return write_report(papers, folder, known)


def made_pages(
    store: Store,
    asked: Sequence[Request],
    places: Mapping[str, Path],
    known: Sequence[str],
    run: Run | None = None,
) -> list[Made]:
    """Return what is written of each paper: as it was kept, else made, several at a time.

    It is the same to the last bit wherever it comes from.
    """
    names = names_of(store, asked, places, known)
    found = {key: find(store.folder / FOLDER, name) for key, name in names.items()}
    left = [each for each in asked if found.get(each.paper.key) is None]
    made = dict(_made(store, left, run))
    if run and made:  # runs were made meanwhile, on which the pages rest
        names = names_of(store, left, places, known)
    for key in made.keys() & names.keys():
        keep(store.folder / FOLDER, names[key], made[key])
    found |= made
    return [unpacked(found[each.paper.key] or b"") for each in asked]


def _made(store: Store, left: Sequence[Request], run: Run | None) -> Iterator[tuple[str, bytes]]:
    """Yield what is made of papers in copies of this process, which makes the runs they want."""
    if left:
        import scipy.stats  # noqa: F401, PLC0415 (slow to load, and once for all copies)
    left = sorted(left, key=lambda each: -each.extent.runs)

    def make(number: int, wants: bytes) -> None:
        with store.taken_up():
            (run or _none)(_wanted(left[number], wants))

    calls = [partial(_apart, store.folder, each, run is not None) for each in left]
    with store.set_down():
        answers = side_by_side(calls, usable_cores(), make)
    for each, answer in zip(left, answers, strict=True):
        # a copy that failed has its say here
        yield each.paper.key, pages(store, each, run) if answer is None else answer


def _apart(folder: Path, asked: Request, may_ask: bool, ask: Ask) -> bytes:  # noqa: FBT001 (bound)
    """Return what is made of a paper in a copy of the process that has the store."""
    with Store(folder, writing=False) as store:

        def wanted(more: Sequence[Task]) -> None:
            finished = store.finished(asked.paper.key)
            if may_ask and any(task.key not in finished for task in more):
                depths = {cell_of(task): task.repeat for task in more}
                wants = json.dumps([(*cell, depth) for cell, depth in depths.items()])
                with store.set_down():  # what is opened later has the new runs
                    ask(wants.encode())

        return pages(store, asked, wanted)


def _wanted(asked: Request, wants: bytes) -> Sequence[Task]:
    """Return the runs that a copy wants."""
    depths = {tuple(cell): depth for *cell, depth in json.loads(wants)}
    tasks = asked.tasks()
    others = studies(asked.paper, max(asked.extent.repeats.values()))
    return deeper_tasks(asked.paper, others, depths, tasks[0].seed)


def pages(store: Store, asked: Request, run: Run | None = None) -> bytes:
    """Return all that is written of a paper, packed."""
    tasks = asked.tasks()
    judgement = judged(store, asked.paper, tasks, run or _none)
    seed = tasks[0].seed if tasks else ""
    made = made_of(judgement, store.environments(tasks), seed, asked.called)
    missing = sum(1 for _ in store.lacking(tasks))
    return packed(replace(made, tasks=len(tasks), missing=missing))


def _none(_: Sequence[Task]) -> None:
    """Make no runs."""


def judged(store: Store, paper: Paper, tasks: Sequence[Task], run: Run = _none) -> Judgement:
    """Return the judgement of one paper; `tasks` are its own."""
    others = studies(paper, max((task.repeat for task in tasks), default=1))
    seed = tasks[0].seed if tasks else ""
    raw = RawRuns(others)

    def fetch(depths: Mapping[Cell, int]) -> Mapping[Cell, Runs]:
        more = deeper_tasks(paper, others, depths, seed)
        run(more)
        return gather(store, paper, more, others, raw.note).runs

    judgement = judge(paper, gather(store, paper, tasks, others, raw.note), others, fetch)
    return replace(judgement, runs=raw.cells(), drawn_as=drawn_as(paper, others))
