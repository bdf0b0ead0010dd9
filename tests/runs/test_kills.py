"""`reproduce` killed at random instants, again and again, and two of them at once."""

import os
import random
import signal
import sqlite3
import subprocess
import sys
import textwrap
import time
from collections import Counter
from contextlib import closing
from itertools import count
from pathlib import Path

import pytest

from tests.damages import LONG
from tests.small_papers import MODULE

ROOT = Path(__file__).parents[2]
KILLS = 100 if LONG else 3
KILLS_PER_LIFE = 10
PROGRAM = textwrap.dedent("""
    import papers, runpy, sys
    papers.__path__.append(sys.argv.pop(1))
    runpy.run_module("repro", run_name="__main__", alter_sys=True)
""")
Rows = list[tuple[object, ...]]


def command(folder: Path) -> tuple[str, ...]:
    """Return the command that runs the slow paper in a folder of its own."""
    (folder / "papers").mkdir(parents=True, exist_ok=True)
    (folder / "papers" / "slow2021.py").write_text(MODULE, encoding="utf-8")
    places = ("--store", str(folder / "store"), "--reports", str(folder / "reports"))
    program = (sys.executable, "-c", PROGRAM, str(folder / "papers"))
    return (*program, "reproduce", "slow2021", "--repeats", "1", "--workers", "2", *places)


def finish(folder: Path) -> str:
    done = subprocess.run(
        command(folder), cwd=ROOT, capture_output=True, text=True, timeout=600, check=False
    )
    assert (done.returncode, "Traceback" in done.stderr) == (0, False), done.stderr
    return done.stderr


def rows(folder: Path) -> Rows:
    """Return every stored run but for what the clock decides."""
    with closing(sqlite3.connect(folder / "store" / "runs.sqlite")) as database:
        assert database.execute("pragma integrity_check").fetchone() == ("ok",)
        assert list((folder / "store").glob("set-aside-*")) == []
        return database.execute(
            "select key, paper, experiment, problem, algorithm, repeat, run, cost, x, evaluations, "
            "reason, y from run join curve using (id) order by key"
        ).fetchall()


def pages(folder: Path) -> dict[str, bytes]:
    reports = folder / "reports"
    return {
        str(path.relative_to(reports)): path.read_bytes()
        for path in sorted(reports.rglob("*"))
        if path.is_file() and path.suffix != ".draft"  # of a write that was cut short
    }


def left_behind(folder: Path) -> list[str]:
    """Return the processes that still work on a folder."""
    found = []
    for entry in Path("/proc").glob("[0-9]*/cmdline"):
        try:
            text = entry.read_bytes().replace(b"\0", b" ").decode(errors="replace")
        except OSError:  # it ended meanwhile
            continue
        if str(folder) in text and entry.parent.name != str(os.getpid()):
            found.append(text)
    return found


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> tuple[Rows, dict[str, bytes], float]:
    """Return rows and pages of an uninterrupted call, and how long it took."""
    folder = tmp_path_factory.mktemp("whole")
    start = time.monotonic()
    finish(folder)
    return rows(folder), pages(folder), time.monotonic() - start


def assert_same(
    folder: Path, whole: tuple[Rows, dict[str, bytes], float], tally: Counter[str]
) -> None:
    assert rows(folder) == whole[0]
    assert pages(folder) == whole[1]
    tally["runs compared after kills"] += len(whole[0])
    tally["bytes of pages compared"] += sum(map(len, whole[1].values()))


def killed(folder: Path, seconds: float) -> bool:
    """Start a call, kill it after so many seconds, and return whether it was still at work."""
    with subprocess.Popen(command(folder), cwd=ROOT, stderr=subprocess.DEVNULL) as process:
        try:
            process.wait(seconds)
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGKILL)
    assert process.returncode in (0, -signal.SIGKILL)
    return process.returncode != 0


@pytest.mark.faults
@pytest.mark.skipif(not Path("/proc/self/cmdline").exists(), reason="looks for orphans in /proc")
def test_killed_calls_lose_nothing_and_end_as_an_uninterrupted_one(
    tmp_path: Path, whole: tuple[Rows, dict[str, bytes], float], tally: Counter[str]
) -> None:
    rng = random.Random("kills")  # noqa: S311 (instants, not secrets)
    kills = 0
    for life in count():
        folder = tmp_path / str(life)
        for _ in range(KILLS_PER_LIFE):
            if kills == KILLS or not killed(folder, rng.uniform(0.0, whole[2])):
                break
            kills += 1
            tally["kills survived"] += 1
            tally["of these with the store open"] += journal(folder).exists()
            assert left_behind(folder) == []
        finish(folder)
        assert_same(folder, whole, tally)
        if kills == KILLS:
            break

    assert len(whole[0]) == 40


def journal(folder: Path) -> Path:
    return folder / "store" / "runs.sqlite-wal"


@pytest.mark.faults
def test_two_calls_at_once_both_finish_and_make_each_run_once(
    tmp_path: Path, whole: tuple[Rows, dict[str, bytes], float], tally: Counter[str]
) -> None:
    both = [
        subprocess.Popen(command(tmp_path), cwd=ROOT, stderr=subprocess.PIPE, text=True)
        for _ in range(2)
    ]
    said = [process.communicate(timeout=600)[1] for process in both]

    assert [process.returncode for process in both] == [0, 0]
    made = [int(text.rpartition("/40 runs")[0].rpartition("\n")[2] or 0) for text in said]
    assert sorted(made) == [0, 40]
    assert_same(tmp_path, whole, tally)
