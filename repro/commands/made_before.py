"""What the runs of a store were made of, kept beside them: so that `list` can say what changed."""

import json
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

from repro.commands.shown_rows import warn
from repro.model.paper import Paper
from repro.runs.plan import Memory, made_of
from repro.runs.whole_files import read_file, set_aside, write_file

_NAME = "made-of.json"
_DIGITS = 12  # of a digest: it is compared with one other
Cells = Mapping[str, Mapping[str, str]]


def remember(store: Path, papers: Iterable[Paper]) -> None:
    """Note in the store's folder what the runs of these papers' protocols are made of."""
    if unreadable(store):
        path = store / _NAME
        warn(f"{path} cannot be read; it is set aside as {set_aside(path)}")
    cells = {**(_before(store) or {}), **dict(_now(papers))}
    pairs = sorted({pair for cell in cells.values() for pair in cell.items()})
    parts = {pair: k for k, pair in enumerate(pairs)}
    content = {
        "parts": pairs,
        "cells": {name: sorted(parts[p] for p in cell.items()) for name, cell in cells.items()},
    }
    write_file(store, _NAME, json.dumps(content, ensure_ascii=False) + "\n")


def changed_since(store: Path, paper: Paper) -> dict[tuple[str, str, str], tuple[str, ...]]:
    """Return what decides runs and is another than it was, by experiment, problem and algorithm.

    A cell that nothing is known of is left out.
    """
    before = _before(store) or {}
    found = {}
    for name, now in _now([paper]):
        _, *place = name.split("/")
        if changed := _other_parts(before.get(name, now), now):
            experiment, problem, algorithm = place
            found[experiment, problem, algorithm] = changed
    return found


def _now(papers: Iterable[Paper]) -> Iterator[tuple[str, Mapping[str, str]]]:
    memory: Memory = {}
    for paper in papers:
        for experiment in paper.experiments:
            for problem in experiment.problems:
                for algorithm in experiment.algorithms:
                    parts = made_of(experiment, problem, algorithm, memory).parts
                    cell = {part: digest[:_DIGITS] for part, digest in parts.items()}
                    yield f"{paper.key}/{experiment.name}/{problem}/{algorithm}", cell


def _other_parts(before: Mapping[str, str], now: Mapping[str, str]) -> tuple[str, ...]:
    """Return the names of parts that differ, the whole left out where a part of it is named."""
    names = [name for name in sorted({*before, *now}) if before.get(name) != now.get(name)]
    plain = {name.removeprefix("value of ") for name in names}
    return tuple(
        name for name in sorted(plain) if not any(each.startswith(f"{name}.") for each in plain)
    )


def unreadable(store: Path) -> bool:
    """Return whether the store has a note of what its runs are made of that cannot be read."""
    return _before(store) is None


def _before(store: Path) -> Cells | None:
    try:
        content: Any = json.loads(read_file(store / _NAME).decode())
        parts = [(str(name), str(digest)) for name, digest in content["parts"]]
        return {
            str(name): dict(parts[k] for k in numbers) for name, numbers in content["cells"].items()
        }
    except FileNotFoundError:
        return {}
    except (OSError, ValueError, LookupError, TypeError, AttributeError, RecursionError):
        return None  # it only explains: without it nothing is said of changes
