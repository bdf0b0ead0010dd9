"""Asking a peer for runs: its own process, its own environment, one answer at a time."""

import json
import os
import subprocess
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import IO

ROOT = Path(__file__).parent.parent
ENVIRONMENTS = "REPRO_PEERS"
"""Variable that names the folder with one environment per lock."""

LOCK_OF = {
    "evolopy": "peers",
    "mealpy_": "mealpy",
    "niapy_": "peers",
    "opytimizer_": "peers",
    "pymoo_": "peers",
    "evosax_": "peers",
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Answer:
    """Seconds, best cost and evaluations of one run."""

    seconds: float
    cost: float
    evaluations: int


@dataclass(frozen=True, slots=True, kw_only=True)
class Peer:
    """A library that waits for requests: its version and what each of its algorithms runs."""

    library: str
    version: str
    numpy: str
    runs: Mapping[str, str]
    requests: IO[str]
    answers: IO[str]

    def run(self, **request: object) -> Answer:
        """Return one run; the fields are those of a Task but its objective."""
        self.requests.write(json.dumps(request) + "\n")
        self.requests.flush()
        return Answer(**json.loads(self.answers.readline()))


def python_of(library: str) -> Path | None:
    """Return the Python that has the library, or None where there is no such environment."""
    folder = os.environ.get(ENVIRONMENTS)
    path = Path(folder, LOCK_OF[library], "bin", "python") if folder else None
    return path if path and path.exists() else None


@contextmanager
def waiting(library: str, python: Path) -> Iterator[Peer]:
    """Yield the library in a process of its own, on one thread."""
    command = (python, "-m", "benchmarks.peers.serve", library)
    # it keeps itself to one core, and JAX to one thread
    environment = os.environ | {"XLA_FLAGS": "--xla_cpu_multi_thread_eigen=false"}
    with subprocess.Popen(
        command, cwd=ROOT, env=environment, text=True, stdin=-1, stdout=-1
    ) as process:
        if process.stdin is None or process.stdout is None:
            raise AssertionError
        told = json.loads(process.stdout.readline())
        yield Peer(library=library, requests=process.stdin, answers=process.stdout, **told)
        process.stdin.close()
