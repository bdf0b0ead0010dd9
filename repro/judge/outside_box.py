"""Searches that their source lets leave the box, and what they found out there."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from repro.model.evidence import Cell, Evidence
from repro.model.paper import Paper
from repro.optimisers.search import LeavesBox


@dataclass(frozen=True, slots=True, kw_only=True)
class OutsideBox:
    """An algorithm that may leave the box; `outside` of its `runs` ended with a point out there."""

    experiment: str
    algorithm: str
    outside: int
    runs: int
    problems: tuple[str, ...]

    @property
    def says(self) -> str:
        """What a reader must know of it, as a sentence without its end."""
        where = f", on {', '.join(self.problems)}" if self.problems else ""
        return (
            f"{self.experiment}: the source of {self.algorithm} lets points leave the box; "
            f"{self.outside} of {self.runs} runs end with a point outside it{where}"
        )


def outside_boxes(paper: Paper, evidence: Evidence) -> tuple[OutsideBox, ...]:
    """Return every algorithm of the protocol that declares to leave the box and was run."""
    found = []
    for experiment in paper.experiments:
        for name, optimiser in experiment.algorithms.items():
            if not (isinstance(optimiser, LeavesBox) and optimiser.leaves_box):
                continue
            cells = [(experiment.name, problem, name) for problem in experiment.problems]
            left = {cell: ~inside_box(evidence, cell) for cell in cells if cell in evidence.runs}
            if left:
                found.append(
                    OutsideBox(
                        experiment=experiment.name,
                        algorithm=name,
                        outside=sum(int(runs.sum()) for runs in left.values()),
                        runs=sum(runs.size for runs in left.values()),
                        problems=tuple(cell[1] for cell, runs in left.items() if runs.any()),
                    )
                )
    return tuple(found)


def inside_box(evidence: Evidence, cell: Cell) -> NDArray[np.bool_]:
    """Return which runs of a cell end with a point in the box, shape (repeats, runs)."""
    bounds = np.asarray(evidence.experiment(cell[0]).problems[cell[1]].bounds)
    points = evidence.runs[cell].points
    inside = (bounds[:, 0] <= points) & (points <= bounds[:, 1])
    return np.asarray(inside.all(axis=-1))
