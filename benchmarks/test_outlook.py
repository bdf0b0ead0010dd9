"""How far the bar's time left is from the time that passes."""

import os
import pty
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from time import monotonic

from pytest_benchmark.fixture import BenchmarkFixture

from benchmarks.goals import measured
from benchmarks.measuring import timed
from benchmarks.results import Results, Section

ROOT = Path(__file__).parent.parent
OUTLOOK = Section(
    title="The time left",
    text="How far the seconds that the bar says are left lie from those that passed until the last "
    "run, as a share of these, while 10 to 90 % are done: the second repeat of each protocol, "
    "after a first one in an earlier call.",
    columns=("looks", "runs took [s]", "farthest off"),
)
_SAID = re.compile(r"\((\d+) %\), (?:(\d+) h )?(?:(\d+) min ?)?(?:(\d+) s )?left")


def read(text: str) -> tuple[int, int] | None:
    """Return the share in % and the seconds left that a bar says; None where none is there."""
    said = _SAID.search(text)
    if said is None:
        return None
    share, hours, minutes, seconds = (int(part or 0) for part in said.groups())
    return share, 3600 * hours + 60 * minutes + seconds


def looks(call: tuple[str | Path, ...], environment: dict[str, str]) -> Iterator[tuple[float, ...]]:
    """Yield the instant, the share in %, and the seconds left of each look at a terminal's bar."""
    ours, theirs = pty.openpty()
    with subprocess.Popen(call, env=environment, stdout=subprocess.DEVNULL, stderr=theirs) as child:
        os.close(theirs)
        while True:
            found = read(os.read(ours, 4096).decode(errors="replace"))
            if found:
                yield monotonic(), *found
                if found[0] == 100:
                    break
        child.terminate()
    os.close(ours)


def test_time_left(benchmark: BenchmarkFixture, results: Results, folder: Path) -> None:
    call = (sys.executable, "-m", "repro", "reproduce", "--repeats", "2", "--protocol-only")
    places = ("--store", folder / "second" / ".repro", "--reports", folder / "second" / "reports")
    environment = os.environ | {"NUMBA_CACHE_DIR": str(folder / "numba"), "PYTHONPATH": str(ROOT)}
    seen = timed(benchmark, lambda: list(looks((*call, *places), environment)))
    end = seen[-1][0]
    off = [abs(left / (end - at) - 1) for at, share, left in seen if 10 <= share <= 90]
    took = f"{end - seen[0][0]:.0f}"
    results.add(OUTLOOK, str(len(off)), took, measured(100 * max(off), ".0f %"))
