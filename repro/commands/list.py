"""`repro list`: papers, experiments, tables, and how many runs are done."""

import json
import sys
from argparse import Namespace
from collections import Counter
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from repro.commands import catalogue
from repro.model.paper import Paper
from repro.runs.plan import plan
from repro.runs.store.store import finished_keys
from repro.runs.studies import studies

Row = dict[str, Any]


def run(options: Namespace) -> int:
    """Print the papers; the store is read and not changed."""
    rows = listing(catalogue.chosen(options), options.repeats, options.store)
    sys.stdout.write(json.dumps(rows, indent=2) + "\n" if options.json else listing_text(rows))
    return 0


def listing(papers: Iterable[Paper], repeats: int, store: Path) -> list[Row]:
    """Return one row per paper; the store is read and not changed."""
    finished = finished_keys(store)
    return [_row(paper, repeats, finished) for paper in papers]


def _row(paper: Paper, repeats: int, finished: frozenset[str]) -> Row:
    tasks = plan([paper], repeats)
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
            }
            for experiment in group
        ]
        for group in (paper.experiments, [s.experiment for s in studies(paper, repeats)])
    )
    return {
        "key": paper.key,
        "title": paper.source.title,
        "tables": [table.label for table in (*paper.inputs, *paper.results)],
        "claims": len(paper.claims),
        "experiments": experiments,
        "studies": others,
        "done": done.total(),
        "missing": total.total() - done.total(),
    }


def listing_text(rows: list[Row]) -> str:
    """Return the listing as text for a terminal."""
    lines = []
    for row in rows:
        lines.append(f"{row['key']}: {row['title']}")
        lines.append(f"  tables: {', '.join(row['tables'])}; claims: {row['claims']}")
        lines.extend(
            f"  {experiment['name']}: {' '.join(experiment['algorithms'])} on "
            f"{' '.join(experiment['problems'])}, {experiment['done']} runs done, "
            f"{experiment['missing']} missing"
            for experiment in row["experiments"]
        )
        if others := row["studies"]:
            lines.append(
                f"  {len(others)} studies besides: {sum(o['done'] for o in others)} runs done, "
                f"{sum(o['missing'] for o in others)} missing"
            )
    return "\n".join(lines) + "\n"
