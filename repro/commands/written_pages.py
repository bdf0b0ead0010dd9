"""From a store to pages: what `reproduce` ends with and `report` does alone."""

from collections.abc import Sequence
from pathlib import Path

from repro.judge.judgement import Judgement, judge
from repro.model.paper import Paper
from repro.report.pages import write_report
from repro.report.results import Json
from repro.runs.gather import gather
from repro.runs.plan import Task
from repro.runs.store.store import Store
from repro.runs.studies import studies


def write_pages(
    store: Store, chosen: Sequence[Paper], tasks: Sequence[Task], folder: Path, known: Sequence[str]
) -> Json:
    """Judge the papers by what the store has of the tasks, write the pages, return the results.

    `known` are the keys of all papers, in their order.
    """
    own = {paper.key: [task for task in tasks if task.paper == paper.key] for paper in chosen}
    return write_report(
        (judged(store, paper, own[paper.key]) for paper in chosen),
        folder,
        known,
        environments={key: store.environments(tasks) for key, tasks in own.items()},
        master_seed=tasks[0].seed if tasks else "",
    )


def judged(store: Store, paper: Paper, tasks: Sequence[Task]) -> Judgement:
    """Return the judgement of one paper; `tasks` are its own."""
    others = studies(paper, max((task.repeat for task in tasks), default=1))
    return judge(paper, gather(store, paper, tasks, others), others)
