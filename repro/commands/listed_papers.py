"""Papers as rows: experiments, tables, and how many runs are done."""

from collections import Counter
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from repro.commands.made_before import changed_since, unreadable
from repro.commands.shown_rows import warn
from repro.model.paper import Paper
from repro.runs.plan import plan
from repro.runs.store.store import Store
from repro.runs.studies import studies

Row = dict[str, Any]


def listing(papers: Iterable[Paper], repeats: int, store: Path) -> list[Row]:
    """Return one row per paper; the store is read and not changed."""
    with Store(store, writing=False) as opened:
        finished = opened.finished()
    if unreadable(store):
        warn(f"what the runs in {store} were made of cannot be read: no change is named")
    return [_row(paper, repeats, finished, store) for paper in papers]


def _row(paper: Paper, repeats: int, finished: frozenset[str], store: Path) -> Row:
    tasks = plan([paper], repeats)
    lacking = {(t.experiment, t.problem, t.algorithm) for t in tasks if t.key not in finished}
    changed = changed_since(store, paper) if lacking else {}
    total = Counter(task.experiment for task in tasks)
    done = Counter(task.experiment for task in tasks if task.key in finished)
    experiments, others = (
        [
            {
                "name": experiment.name,
                "problems": list(experiment.problems),
                "algorithms": list(experiment.algorithms),
                "done": done[experiment.name],
                "missing": total[experiment.name] - done[experiment.name],
                "changed": [
                    {"problem": problem, "algorithm": algorithm, "parts": list(parts)}
                    for (name, problem, algorithm), parts in changed.items()
                    if name == experiment.name and (name, problem, algorithm) in lacking
                ],
            }
            for experiment in group
        ]
        for group in (paper.experiments, [s.experiment for s in studies(paper, repeats)])
    )
    return {
        "key": paper.key,
        "title": paper.source.title,
        "tables": [table.label for table in paper.tables],
        "claims": len(paper.claims),
        "experiments": experiments,
        "studies": others,
        "done": done.total(),
        "missing": total.total() - done.total(),
    }
