"""Runs as files of IOHprofiler, which IOHanalyzer and iohinspector read.

The format is that of C. Doerr et al., IOHprofiler (arXiv:1810.05281), as `ioh` 0.3 writes it.
"""

import json
from collections.abc import Iterator, Sequence

import numpy as np

from repro.model.experiment import Experiment
from repro.model.identifiers import anchor
from repro.runs.run import Record

VERSION = "0.3.5"
COLUMNS = ("evaluations", "raw_y")
Texts = dict[str, str]
"""Texts of files by their place in a folder."""


def ioh_files(experiment: Experiment, records: Sequence[Record]) -> Texts:
    """Return the two files of one cell by their place below the folder of its experiment.

    The best cost is known after each iteration: evaluations are spread evenly over them, and the
    first stands at 1. Problems and algorithms are numbered from 1, as two names may look alike.
    """
    task, dimension = records[0].task, records[0].x.size
    function = list(experiment.problems).index(task.problem) + 1
    algorithm = list(experiment.algorithms).index(task.algorithm) + 1
    folder = f"{algorithm}-{anchor(task.algorithm)}"
    stem = f"f{function}-{anchor(task.problem)}"
    data = f"data-{stem}/IOHprofiler_f{function}_DIM{dimension}.dat"
    runs = [
        {
            "instance": record.task.repeat,
            "evals": record.evaluations,
            "best": {"evals": record.evaluations, "y": record.cost, "x": record.x.tolist()},
        }
        for record in records
    ]
    content = {
        "version": VERSION,
        "suite": f"{task.paper}, {task.experiment}",
        "function_id": function,
        "function_name": task.problem,
        "maximization": False,
        "algorithm": {"name": task.algorithm, "info": f"re-run of {task.paper} by repro"},
        "attributes": list(COLUMNS),
        "scenarios": [{"dimension": dimension, "path": data, "runs": runs}],
    }
    lines = [line for record in records for line in _lines(record)]
    return {
        f"{folder}/IOHprofiler_{stem}.json": json.dumps(content, ensure_ascii=False) + "\n",
        f"{folder}/{data}": "".join(f"{line}\n" for line in lines),
    }


def _lines(record: Record) -> Iterator[str]:
    """Yield the headings, the first cost, every better one, and the final one."""
    yield " ".join(COLUMNS)
    known = np.flatnonzero(np.isfinite(record.history))
    costs = record.history[known]
    places = np.rint((known + 1) * record.evaluations / record.history.size).astype(int)
    steps = np.flatnonzero(np.diff(costs) < 0) + 1
    yield f"1 {float(costs[0]) if costs.size else float(record.cost)!r}"
    for step in steps:
        if 1 < places[step] < record.evaluations:
            yield f"{places[step]} {float(costs[step])!r}"
    if record.evaluations > 1:
        yield f"{record.evaluations} {record.cost!r}"
