"""From a store to pages: what `reproduce` ends with and `report` does alone."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from types import MappingProxyType

from repro.commands.shown_rows import warn
from repro.judge.judgement import Judgement, judge
from repro.model.evidence import Cell, Runs
from repro.model.paper import Paper
from repro.report.earlier import keep_earlier
from repro.report.pages import write_report
from repro.report.results import Json
from repro.runs.gather import gather
from repro.runs.plan import Task, deeper_tasks
from repro.runs.raw_runs import RawRuns, drawn_as
from repro.runs.store.store import Store
from repro.runs.studies import studies

Run = Callable[[Sequence[Task]], None]


def write_pages(
    store: Store,
    chosen: Sequence[Paper],
    tasks: Sequence[Task],
    folder: Path,
    known: Sequence[str],
    run: Run = lambda _: None,
    called: Mapping[str, str] = MappingProxyType({}),
) -> Json:
    """Judge the papers by what the store has of the tasks, write the pages, return the results.

    `known` are the keys of all papers, in their order. `run` makes the runs that a reading needs
    besides, before it may turn a verdict; without it the store's are taken. `called` says what
    papers from elsewhere than this checkout are called at the command line.
    """
    keep_earlier(folder, [paper.key for paper in chosen], known, warn)
    own = {paper.key: [task for task in tasks if task.paper == paper.key] for paper in chosen}
    return write_report(
        (_told(judged(store, paper, own[paper.key], run)) for paper in chosen),
        folder,
        known,
        environments={key: store.environments(tasks) for key, tasks in own.items()},
        master_seed=tasks[0].seed if tasks else "",
        called=called,
    )


def _told(judgement: Judgement) -> Judgement:
    """Warn of searches whose best points lie outside the box, and return the judgement."""
    for each in judgement.outside:
        if each.outside:
            warn(f"{judgement.paper.key}, {each.says}")
    return judgement


def judged(
    store: Store, paper: Paper, tasks: Sequence[Task], run: Run = lambda _: None
) -> Judgement:
    """Return the judgement of one paper; `tasks` are its own."""
    others = studies(paper, max((task.repeat for task in tasks), default=1))
    seed = tasks[0].seed if tasks else ""
    raw = RawRuns(others)

    def fetch(depths: Mapping[Cell, int]) -> Mapping[Cell, Runs]:
        more = deeper_tasks(paper, others, depths, seed)
        run(more)
        return gather(store, paper, more, others, raw.note).runs

    judgement = judge(paper, gather(store, paper, tasks, others, raw.note), others, fetch)
    return replace(judgement, runs=raw.runs(), drawn_as=drawn_as(paper, others))
