"""The command line in processes of their own."""

import signal
import sqlite3
import subprocess
import sys
import textwrap
import time
from contextlib import closing
from pathlib import Path

import pytest

from tests.small_papers import ENDLESS, MODULE

ROOT = Path(__file__).parents[2]
PROGRAM = """
    import papers, runpy, signal, sys
    signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell may have it ignored
    papers.__path__.append(sys.argv.pop(1))
    runpy.run_module("repro", run_name="__main__", alter_sys=True)
"""


@pytest.fixture
def slow(tmp_path: Path) -> tuple[str, ...]:
    """Return the command that knows one more paper, of 40 runs, half of them slow."""
    return (*command(tmp_path, "slow2021", MODULE), "--workers", "1")


def command(folder: Path, key: str, module: str) -> tuple[str, ...]:
    """Return the command that knows a paper more and makes its runs in a folder."""
    (folder / "papers").mkdir()
    (folder / "papers" / f"{key}.py").write_text(module, encoding="utf-8")
    places = ("--store", str(folder / "store"), "--reports", str(folder / "reports"))
    program = (sys.executable, "-c", textwrap.dedent(PROGRAM), str(folder / "papers"))
    return (*program, "reproduce", key, "--repeats", "1", *places)


def runs_in(store: Path) -> int:
    if not (store / "runs.sqlite").exists():
        return 0
    with closing(sqlite3.connect(store / "runs.sqlite")) as database:
        tables = database.execute("select count(*) from sqlite_master").fetchone()[0]
        return int(database.execute("select count(*) from run").fetchone()[0]) if tables else 0


def stopped(command: tuple[str, ...], store: Path, by: signal.Signals) -> tuple[int, str]:
    """Stop a command when three of its runs are stored; return exit code and error output."""
    with subprocess.Popen(command, cwd=ROOT, stderr=subprocess.PIPE, text=True) as process:
        limit = time.monotonic() + 300
        while runs_in(store) < 3 and time.monotonic() < limit:
            time.sleep(0.02)
        process.send_signal(by)
        try:
            _, err = process.communicate(timeout=300)
        finally:
            process.kill()
    return process.returncode, err


def test_interrupted_command_exits_with_130_and_a_later_call_goes_on(
    slow: tuple[str, ...], tmp_path: Path
) -> None:
    code, err = stopped(slow, tmp_path / "store", signal.SIGINT)
    kept = runs_in(tmp_path / "store")

    done = subprocess.run(slow, cwd=ROOT, capture_output=True, text=True, timeout=300, check=False)

    assert code == 130
    assert err.endswith("repro: interrupted; finished runs are kept, the same call goes on\n")
    assert "Traceback" not in err
    assert 3 <= kept < 40
    assert done.returncode == 0
    assert f"{40 - kept}/{40 - kept} runs (100 %)" in done.stderr
    assert (tmp_path / "reports" / "slow2021.html").exists()


@pytest.mark.parametrize(("by", "search"), [(signal.SIGINT, "compiled"), (signal.SIGTERM, "plain")])
def test_interrupt_waits_for_no_long_run_and_keeps_every_short_one(
    tmp_path: Path, by: signal.Signals, search: str
) -> None:
    endless = (*command(tmp_path, "endless2021", ENDLESS.format(search=search)), "--workers", "2")

    code, err = stopped(endless, tmp_path / "store", by)

    assert code == 128 + by
    assert err.endswith("repro: interrupted; finished runs are kept, the same call goes on\n")
    assert "Traceback" not in err
    assert "Fatal" not in err
    assert runs_in(tmp_path / "store") == 3


def test_list_loads_nothing_that_it_does_not_need(tmp_path: Path) -> None:
    program = """
        import sys
        from repro.__main__ import main
        main(["list", "--store", sys.argv[1]])
        unwanted = {"matplotlib", "scipy.stats", "jinja2", "pandas"} & set(sys.modules)
        sys.exit(", ".join(unwanted) or 0)
    """

    done = subprocess.run(
        (sys.executable, "-c", textwrap.dedent(program), str(tmp_path)),
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )

    assert (done.returncode, done.stderr) == (0, "")
    assert "liang2026: " in done.stdout
