import io
import subprocess
import sys
from argparse import Namespace
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from repro.__main__ import main
from repro.commands import own_papers
from repro.commands.kept_output import FOLDER, KEPT, MADE_OF, tell, told
from repro.runs.store.store import Store
from tests.small_papers import PAPER, let_be_known
from tests.small_stores import ENVIRONMENT, RECORDS, change, with_pages

SAID = "small2020 ✓\n"
Change = Callable[[Path], object]


@pytest.fixture(params=KEPT)
def asked(
    request: pytest.FixtureRequest, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> Namespace:
    """Return what is asked for in a house of one paper, whose runs and pages are there."""
    papers = tmp_path / "house" / "papers"
    papers.mkdir(parents=True)
    (papers / "__init__.py").touch()
    (papers / "small2020.py").write_text("PAPER = 1\n", encoding="utf-8")
    monkeypatch.setattr(own_papers, "HOME", papers.parent)
    folder = with_pages(tmp_path, "store")
    return Namespace(
        command=request.param,
        store=folder / "store",
        reports=folder / "reports",
        keys=[],
        repeats=1,
    )


of = pytest.mark.parametrize
only = {name: of("asked", [name], indirect=True) for name in KEPT}


def test_what_was_told_is_told_again(asked: Namespace, capsys: pytest.CaptureFixture[str]) -> None:
    assert not told(asked)
    tell(asked, SAID)
    assert told(asked)
    assert capsys.readouterr().out == SAID * 2


def test_a_folder_whose_name_is_no_text_is_told_again(
    asked: Namespace, monkeypatch: pytest.MonkeyPatch
) -> None:
    printed = io.StringIO()
    monkeypatch.setattr("sys.stdout", printed)
    told(asked)
    tell(asked, "pages: \udcff\n")
    assert told(asked)
    assert printed.getvalue() == "pages: \udcff\n" * 2


@of("asked_else", [{"keys": ["small2020"]}, {"repeats": 2}, {"json": True}])
def test_another_question_has_another_answer(
    asked: Namespace, asked_else: dict[str, object]
) -> None:
    told(asked)
    tell(asked, SAID)
    assert not told(Namespace(**{**vars(asked), **asked_else}))
    assert told(asked)


@of("keys", [["./small2020.py"], ["a/b"], ["."]])
def test_what_is_told_of_files_is_not_kept(asked: Namespace, keys: list[str]) -> None:
    asked.keys = keys
    assert not told(asked)
    tell(asked, SAID)
    assert not told(asked)


def test_what_is_told_beside_a_faulty_paper_is_not_kept(asked: Namespace) -> None:
    assert not told(asked)
    asked.faulty = True
    tell(asked, SAID)
    del asked.faulty
    assert not told(asked)


def test_what_a_paper_from_elsewhere_may_change_is_not_kept(
    asked: Namespace, monkeypatch: pytest.MonkeyPatch
) -> None:
    told(asked)
    tell(asked, SAID)
    monkeypatch.setattr("importlib.metadata.entry_points", lambda group: (group,))
    assert not told(asked)


def edited(path: str, text: str = "other") -> Change:
    return lambda folder: (folder / path).write_text(text, encoding="utf-8")


SOURCES = {
    "declaration edited": edited("house/papers/small2020.py", "PAPER = 2\n"),
    "declaration added": edited("house/papers/more.py"),
    "what is kept damaged": lambda folder: _kept(folder).write_bytes(b"other"),
}
RUNS = {
    "run lost": lambda folder: change(folder / "store", "delete from run where id = 1"),
    "first run another": lambda folder: _again(0, folder),
    "last run another": lambda folder: _again(-1, folder),
    "what they were made of": edited(f"store/{MADE_OF}", "{}"),
}
PAGES = {
    "page edited": edited("reports/small2020.md"),
    "page lost": lambda folder: (folder / "reports" / "results.json").unlink(),
    "file added": edited("reports/more.txt"),
}


def _kept(folder: Path) -> Path:
    (found,) = (
        path
        for path in (folder / "store" / FOLDER).iterdir()
        if path.read_bytes().endswith(SAID.encode())
    )
    return found


def _again(number: int, folder: Path) -> None:
    with Store(folder / "store") as store:
        store.begin(ENVIRONMENT)
        store.add([replace(RECORDS[number], cost=RECORDS[number].cost + 1.0)])


@of(
    ("asked", "changed"),
    [
        pytest.param(command, changed, id=f"{command}: {name}")
        for command, rests in KEPT.items()
        for name, changed in {
            **SOURCES,
            **(RUNS if rests.runs else {}),
            **(PAGES if rests.pages else {}),
        }.items()
    ],
    indirect=["asked"],
)
def test_nothing_is_told_again_where_anything_changed(
    asked: Namespace, changed: Change, tmp_path: Path
) -> None:
    told(asked)
    tell(asked, SAID)
    changed(tmp_path)
    assert not told(asked)


def test_a_package_of_another_version_has_all_made_again(
    asked: Namespace, monkeypatch: pytest.MonkeyPatch
) -> None:
    told(asked)
    tell(asked, SAID)
    monkeypatch.setattr("importlib.metadata.distributions", lambda: iter(()))
    assert not told(asked)


@only["reproduce"]
@of(
    "other",
    [
        lambda patch: patch.setenv("OPENBLAS_CORETYPE", "Haswell"),
        lambda patch: patch.setattr("platform.processor", lambda: "another"),
        lambda patch: patch.setattr("os.cpu_count", lambda: 77),
    ],
    ids=["settings", "processor", "cores"],
)
def test_pages_of_another_machine_are_written_again(
    asked: Namespace, monkeypatch: pytest.MonkeyPatch, other: Callable[..., object]
) -> None:
    told(asked)
    tell(asked, SAID)
    other(monkeypatch)
    assert not told(asked)


@only["reproduce"]
def test_sources_that_change_during_a_call_leave_its_output_untold(
    asked: Namespace, tmp_path: Path
) -> None:
    told(asked)
    edited("house/papers/small2020.py", "PAPER = 2\n")(tmp_path)
    tell(asked, SAID)
    assert not told(asked)


@of("command", KEPT)
def test_no_store_is_made_for_what_is_kept(tmp_path: Path, command: str) -> None:
    asked = Namespace(
        command=command, store=tmp_path / "none", reports=tmp_path / "none", keys=[], repeats=1
    )
    assert not told(asked)
    tell(asked, SAID)
    assert list(tmp_path.iterdir()) == []


def test_a_listing_rests_on_no_room_whose_changes_leave_it_as_it_is() -> None:
    code = """
import importlib, pkgutil, sys, papers, repro.commands.list
for each in pkgutil.iter_modules(papers.__path__):
    importlib.import_module(f"papers.{each.name}")
print(*sys.modules)
"""
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, check=True, text=True)
    loaded = {name for name in found.stdout.split() if name.startswith("repro.")}
    of_others = {name for name in loaded if name.split(".")[1] in KEPT["list"].without}
    assert "repro.runs.plan" in loaded
    assert of_others == {"repro.report", "repro.report.kept"}  # they keep


@only["list"]
def test_a_change_in_another_room_leaves_the_listing(
    asked: Namespace, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    engine = tmp_path / "engine"
    for room in ("runs", "judge"):
        (engine / room).mkdir(parents=True)
    monkeypatch.setattr("repro.__path__", [str(engine)])
    told(asked)
    tell(asked, SAID)
    (engine / "judge" / "verdict.py").touch()
    assert told(asked)
    (engine / "runs" / "plan.py").touch()
    assert not told(asked)


@pytest.fixture
def command(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Return what reproduces the small paper, after it was called once."""
    let_be_known(monkeypatch, PAPER)
    places = ["--store", str(tmp_path / "store"), "--reports", str(tmp_path / "reports")]
    command = ["reproduce", "--repeats", "1", *places]
    assert main(command) == 0
    return command


def test_damaged_run_is_found_though_nothing_else_changed(
    command: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    change(tmp_path / "store", "update run set cost = cost + 1 where id = 1")

    assert main(command) == 0
    assert "is damaged; it is set aside" in capsys.readouterr().err


def test_reproduce_with_nothing_to_do_says_the_same_and_loads_no_paper(
    capsys: pytest.CaptureFixture[str], command: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    first = capsys.readouterr().out
    monkeypatch.setattr("repro.commands.catalogue.known", pytest.fail)
    assert main(command) == 0
    assert capsys.readouterr().out == first
