"""Whatever stands under the names that we use: nothing of others is harmed, nothing far touched."""

import os
import shutil
import signal
import stat
import tempfile
from collections.abc import Callable, Iterator
from contextlib import chdir
from pathlib import Path

import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st

from repro.__main__ import main
from tests.commands.own_searches import standing_in
from tests.damages import LONG
from tests.small_papers import PAPER
from tests.small_stores import with_pages

TEXT = "somebody else's\n"
MODULE = "def own(cost, bounds, budget, rng): return bounds.mean(axis=1)\n"
STORE = ("--store", "store")
COMMANDS = {
    "reproduce": ("small2020", "--repeats", "1", "--protocol-only", *STORE),
    "report": ("small2020", "--repeats", "1", *STORE),
    "list": ("small2020", *STORE),
    "verify": (*STORE, "--paper", "small2020", "--sample", "2"),
    "compare": (
        *("mine:own", *STORE, "--reports", "private", "--runs", "1", "--workers", "1"),
        *("--quiet", "--no-centre-bias"),
    ),
    "export": ("small2020", *STORE, "--to", "out", "--format", "ioh"),
}
PAGES = ("index.html", "small2020.html", "small2020.optimum.html", "verdicts.md", "glossary.md",
         "another-seed.json", "figures/at-a-glance.svg", "tables/small2020-table-1.csv",
         "runs/small2020.csv.gz")  # fmt: skip
FOLDERS = ("figures", "tables", "runs")
OF_STORE = ("kept", "made-of.json", "compared.json", "compared.json.new", "repro.lock", "lock",
            "set-aside-1", "made-of-set-aside-1.json", "runs.sqlite", "runs.sqlite-wal",
            "runs.sqlite-shm", "runs.sqlite-journal")  # fmt: skip
OF_SEARCH = ("own.html", "own.md", "own.csv", "own/1-small2020-search-convergence.svg")
OURS = [*(f"reports/{name}" for name in PAGES), *(f"private/{name}" for name in OF_SEARCH)]
PLACES = [
    *OURS,
    *("reports/results.json", "reports/provenance.json", "private/own.json", "private/own"),
    *(f"reports/{name}" for name in (*FOLDERS, ".repro-00.draft", "own.html")),
    *(f"store/{name}" for name in OF_STORE),
    *("out/small2020-ioh", "out/small2020-ioh/1-search"),
]


def put_folder(path: Path, _theirs: Path) -> None:
    path.mkdir()
    (path / "inner").write_text(TEXT)


KINDS: dict[str, Callable[[Path, Path], object]] = {
    "link to a file": lambda path, theirs: path.symlink_to(theirs / "file"),
    "link to a folder": lambda path, theirs: path.symlink_to(theirs / "folder"),
    "link to nothing": lambda path, theirs: path.symlink_to(theirs / "nothing"),
    "link to itself": lambda path, _: path.symlink_to(path.name),
    "file": lambda path, _: path.write_text(TEXT),
    "empty file": lambda path, _: path.touch(),
    "folder": put_folder,
    "second name": lambda path, theirs: path.hardlink_to(theirs / "file"),
    "pipe": lambda path, _: os.mkfifo(path),
}


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """Yield a folder in which every command was called once, beside one of somebody else."""
    folder = tmp_path_factory.mktemp("made")
    (folder / "theirs" / "folder").mkdir(parents=True)
    (folder / "theirs" / "file").write_text(TEXT)
    (folder / "theirs" / "folder" / "deep").write_text(TEXT)
    (folder / "out").mkdir()
    (folder / "mine.py").write_text(MODULE)
    with_pages(folder)
    with (
        pytest.MonkeyPatch.context() as patch,
        standing_in(folder, patch, module=MODULE, paper=PAPER),
    ):
        for command, options in COMMANDS.items():
            assert main([command, *options]) == 0
        yield folder


def put(path: Path, kind: str, theirs: Path) -> None:
    """Let such a thing stand in a place, whatever stood there."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if path.is_dir():
        shutil.rmtree(path)
    path.unlink(missing_ok=True)
    KINDS[kind](path, theirs)


def content(folder: Path) -> dict[Path, tuple[int, str | bytes]]:
    """Return what stands in a folder: what it is, and what is in it or where it leads."""
    found: dict[Path, tuple[int, str | bytes]] = {}
    for path in folder.rglob("*"):
        mode = path.lstat().st_mode
        within = str(path.readlink()) if stat.S_ISLNK(mode) else b""
        found[path] = mode, path.read_bytes() if stat.S_ISREG(mode) else within
    return found


def copies(folder: Path) -> int:
    """Return how many files hold the text of somebody else."""
    return sum(each[1] == TEXT.encode() for each in content(folder).values())


LAYOUT = st.dictionaries(st.sampled_from(PLACES), st.sampled_from([*KINDS]), min_size=1, max_size=3)


@settings(
    max_examples=1_500 if LONG else 8,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)
@given(layout=LAYOUT, first=st.booleans(), command=st.sampled_from([*COMMANDS]))
@example(layout={"store/compared.json.new": "link to a file"}, first=True, command="compare")
@example(layout={"store/runs.sqlite": "link to nothing"}, first=True, command="reproduce")
@example(layout={"store/made-of.json": "pipe"}, first=False, command="list")
@example(
    layout={"store/made-of.json": "file", "store/made-of-set-aside-1.json": "file"},
    first=True,
    command="reproduce",
)
@example(layout={"store/repro.lock": "link to nothing"}, first=True, command="reproduce")
@example(layout={"store/compared.json": "file"}, first=False, command="compare")
@example(layout={"store/kept": "link to a folder"}, first=False, command="list")
@example(layout={"reports/figures": "link to a folder"}, first=True, command="report")
@example(layout={"reports/glossary.md": "file"}, first=True, command="report")
@example(layout={"private/own.html": "file"}, first=True, command="compare")
@example(layout={"out/small2020-ioh": "link to a folder"}, first=True, command="export")
def test_nothing_of_others_is_harmed_whatever_stands_under_our_names(
    made: Path,
    capsys: pytest.CaptureFixture[str],
    layout: dict[str, str],
    command: str,
    *,
    first: bool,
) -> None:
    with tempfile.TemporaryDirectory(dir=made.parent) as name:
        folder = shutil.copytree(made, Path(name) / "copy")
        for place in ("reports", "private") if first else ():
            shutil.rmtree(folder / place)
        for place, kind in layout.items():
            put(folder / place, kind, folder / "theirs")
        replaceable = [] if first else [folder / place for place in OURS if place in layout]
        before = content(folder / "theirs"), copies(folder)
        around = {path.name for path in folder.iterdir()} | {"reports", "private", "out"}
        capsys.readouterr()

        with chdir(folder):
            code = called(command, *COMMANDS[command])

        said = capsys.readouterr().err
        assert code in {0, 1, 2, 3}, said
        assert content(folder / "theirs") == before[0]
        assert copies(folder) >= before[1] - len(replaceable)
        assert {path.name for path in folder.iterdir()} <= around
        if code > 1:
            assert said.splitlines()[-1].startswith("repro: ")
            assert any(Path(place).name in said for place in layout) or "nothing to" in said


def called(*arguments: str) -> int:
    """Return the code of a command, which is one of an interrupt where it takes a minute."""
    before = signal.signal(signal.SIGALRM, signal.default_int_handler)
    signal.alarm(60)
    try:
        return main(arguments)
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, before)
