"""Runs one library's algorithms on request: `python -m benchmarks.peers.serve LIBRARY`.

One line of JSON goes each way. The first one out says which version runs what. A request holds
the fields of a Task but its objective; the answer holds seconds, best cost and evaluations.
"""

import contextlib
import importlib
import importlib.metadata
import json
import os
import sys
import time
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.peers.objectives import objectives
from benchmarks.peers.task import Task


class Counted:
    """An objective that counts its calls, under the name of the function."""

    def __init__(self, objective: Any) -> None:  # noqa: ANN401
        """Count from zero."""
        self._objective, self.calls, self.__name__ = objective, 0, objective.__name__

    def __call__(self, x: Any) -> Any:  # noqa: ANN401
        """Return the value."""
        self.calls += 1
        return self._objective(x)


def main() -> None:
    """Answer until the input ends."""
    if hasattr(os, "sched_setaffinity"):  # one core, the one that ours is measured on
        os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
    answers = os.fdopen(os.dup(1), "w")  # the libraries talk on stdout
    warnings.simplefilter("ignore")
    with quiet():
        library = importlib.import_module(f"benchmarks.peers.{sys.argv[1]}")
    version = importlib.metadata.version(library.PACKAGE)
    write(answers, {"version": version, "numpy": np.__version__, "runs": library.RUNS})
    for line in sys.stdin:
        request = json.loads(line)
        objective = Counted(objectives(np)[request["function"]])
        task = Task(objective=objective, **request)
        with quiet():
            start = time.process_time()  # all its threads, on the one core
            cost = library.run(task)
            seconds = time.process_time() - start
        # a compiled library calls no Python: it says itself how many it makes
        evaluations = objective.calls or library.evaluations(task)
        write(answers, {"seconds": seconds, "cost": cost, "evaluations": evaluations})


@contextlib.contextmanager
def quiet() -> Iterator[None]:
    """Send what the libraries print to nowhere."""
    with (
        Path(os.devnull).open("w", encoding="utf-8") as nowhere,
        contextlib.redirect_stdout(nowhere),
        contextlib.redirect_stderr(nowhere),
    ):
        yield


def write(stream: Any, answer: dict[str, Any]) -> None:  # noqa: ANN401
    """Write one line at once."""
    stream.write(json.dumps(answer) + "\n")
    stream.flush()


if __name__ == "__main__":
    main()
