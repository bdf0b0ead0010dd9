"""`repro list`: papers, experiments, tables, and how many runs are done."""

import json
import sys
from argparse import Namespace
from collections import Counter
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

from repro.commands import catalogue
from repro.commands.made_before import changed_since, in_words, unreadable
from repro.commands.shown_rows import warn
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


def _changes(changed: Iterable[Row]) -> Iterator[str]:
    """Yield a line for each set of parts that is another than when runs were made of it."""
    cells: dict[tuple[str, ...], list[str]] = {}
    for each in changed:
        place = f"{each['algorithm']} on {each['problem']}"
        cells.setdefault(tuple(each["parts"]), []).append(place)
    for parts, places in cells.items():
        yield f"    changed since they ran: {in_words(parts)} (of {in_words(places)})"


def listing_text(rows: list[Row]) -> str:
    """Return the listing as text for a terminal."""
    lines = []
    for row in rows:
        lines.append(f"{row['key']}: {row['title']}")
        lines.append(f"  tables: {', '.join(row['tables']) or 'none'}; claims: {row['claims']}")
        for experiment in row["experiments"]:
            lines.append(
                f"  {experiment['name']}: {' '.join(experiment['algorithms'])} on "
                f"{' '.join(experiment['problems'])}, {experiment['done']} runs done, "
                f"{experiment['missing']} missing"
            )
            lines.extend(_changes(experiment["changed"]))
        if not row["experiments"]:
            lines.append("  no experiments: nothing to run")
        if others := row["studies"]:
            noun = "study" if len(others) == 1 else "studies"
            done, missing = (sum(o[state] for o in others) for state in ("done", "missing"))
            lines.append(f"  {len(others)} {noun} besides: {done} runs done, {missing} missing")
    return "\n".join(lines) + "\n"
