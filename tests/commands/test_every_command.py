"""Every command over streams that break: it does what it does, and ends with the same code."""

import shutil
from itertools import product
from pathlib import Path

import pytest

from repro.commands.arguments import _TEXTS
from tests.commands.forked import Said, called
from tests.damages import LONG
from tests.small_stores import with_pages

STORE = ("--store", "store")
PLACES = (*STORE, "--reports", "reports")
MOTION = Path(__file__).parents[1] / "motions" / "ruckig_moving.toml"
CALLS = {
    "reproduce": ("small2020", "--repeats", "1", "--protocol-only", *PLACES),
    "report": ("small2020", "--repeats", "1", *PLACES),
    "list": ("small2020", *STORE),
    "compare": ("nowhere:search",),
    "new": ("new2020",),
    "check": ("small2020",),
    "again": ("small2020", "no such number"),
    "export": ("small2020", "--format", "csv", "--to", "out", *STORE),
    "audit": ("table.csv",),
    "certify": ("small2020",),
    "motion": (str(MOTION), "--seconds", "5"),
    "references": ("small2020",),
    "verify": (*STORE, "--paper", "small2020"),
    "flips": ("reports/results.json", "reports/results.json"),
}
COMMANDS = [(name, *arguments) for name, arguments in CALLS.items()]


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with a store, its pages and an impossible table, of which each has a copy."""
    folder = tmp_path_factory.mktemp("made")
    (folder / "table.csv").write_text("F,Best,Mean,Worst\nF1,2.0,1.0,3.0\n", encoding="utf-8")
    return with_pages(folder)


@pytest.fixture(scope="module")
def unspoilt(made: Path, tmp_path_factory: pytest.TempPathFactory) -> list[Said]:
    return called(copied(made, tmp_path_factory.mktemp("unspoilt")), *COMMANDS)


def copied(folder: Path, to: Path) -> Path:
    return shutil.copytree(folder, to, dirs_exist_ok=True)


def test_every_command_is_called() -> None:
    assert CALLS.keys() == _TEXTS.keys()


def test_commands_do_work_before_their_streams_are_spoilt(unspoilt: list[Said]) -> None:
    codes = dict(zip(CALLS, [said.code for said in unspoilt], strict=True))

    refused = {name for name, code in codes.items() if code == 2}
    assert refused == {"compare", "again"}, unspoilt
    assert {name for name, code in codes.items() if code == 1} == {"audit"}


# each stream and each way to break it once; at length all of them
WAYS = [("left", "1"), ("full", "2"), ("closed", "0 1 2")]
EVERY_WAY = list(product(("left", "full", "closed"), ("1", "2", "0 1 2")))


@pytest.mark.faults
@pytest.mark.parametrize(("kind", "numbers"), EVERY_WAY if LONG else WAYS)
def test_a_broken_stream_changes_no_exit_code_and_makes_no_traceback(
    tmp_path: Path, made: Path, unspoilt: list[Said], kind: str, numbers: str
) -> None:
    broken = called(copied(made, tmp_path), *COMMANDS, spoil=f"{kind} {numbers}")

    assert [said.code for said in broken] == [said.code for said in unspoilt]
    assert not [said for said in broken if "Traceback" in said.out + said.err]
    assert (tmp_path / "reports" / "index.html").exists()
    assert (tmp_path / "out").is_dir()


def test_a_closed_standard_input_is_said_in_one_line(tmp_path: Path) -> None:
    (said,) = called(tmp_path, ("audit", "-"), spoil="closed 0")

    assert (said.code, said.out) == (2, "")
    assert said.err == "repro: standard input: it is closed\n"
