import json
import subprocess
import sys
from argparse import Namespace
from collections.abc import Callable
from pathlib import Path

import pytest

from repro.commands.kept_listing import FOLDER, MADE_OF, OTHER_ROOMS, keep_listing, told
from tests.small_stores import change, filled

ROWS = [{"key": "small2020", "done": 6}]


@pytest.fixture
def made() -> list[int]:
    """Return a list that grows with every listing that is made."""
    return []


@pytest.fixture
def listed(tmp_path: Path, made: list[int]) -> Callable[..., object]:
    """Return what lists papers of a store that is filled."""
    store = filled(tmp_path)

    def listing(keys: tuple[str, ...] = (), repeats: int = 1) -> None:
        options = Namespace(command="list", store=store, keys=keys, repeats=repeats, json=True)
        if not told(options):
            made.append(repeats)
            keep_listing(options, ROWS)

    return listing


def test_a_listing_is_made_once(listed: Callable[..., object], made: list[int]) -> None:
    listed()
    listed()
    assert made == [1]


def test_another_question_is_another_listing(
    listed: Callable[..., object], made: list[int]
) -> None:
    listed()
    listed(repeats=2)
    listed(("small2020",))
    assert made == [1, 2, 1]


@pytest.mark.parametrize(
    "changed",
    [
        lambda store: change(store, "delete from run where id = 1"),
        lambda store: (store / MADE_OF).write_text("{}"),
        lambda store: next((store / FOLDER).iterdir()).write_bytes(b"[]"),
    ],
    ids=["runs", "what they were made of", "what is kept"],
)
def test_a_listing_is_made_again_where_anything_changed(
    listed: Callable[..., object], made: list[int], tmp_path: Path, changed: Callable[..., object]
) -> None:
    listed()
    changed(tmp_path)
    listed()
    assert made == [1, 1]


@pytest.mark.parametrize("keys", [("./small2020.py",), ("a/b",), (".",)])
def test_what_is_told_of_files_is_not_kept(
    listed: Callable[..., object], made: list[int], tmp_path: Path, keys: tuple[str, ...]
) -> None:
    listed(keys)
    listed(keys)
    assert made == [1, 1]
    assert not (tmp_path / FOLDER).exists()


def test_no_store_is_made_for_a_listing(tmp_path: Path) -> None:
    store = tmp_path / "none"
    options = Namespace(command="list", store=store, keys=(), repeats=1, json=True)
    assert not told(options)
    keep_listing(options, ROWS)
    assert list(tmp_path.iterdir()) == []


def test_what_is_kept_is_printed_as_it_was(
    listed: Callable[..., object], capsys: pytest.CaptureFixture[str]
) -> None:
    listed()
    assert capsys.readouterr().out == ""
    listed()
    assert json.loads(capsys.readouterr().out) == ROWS


def test_a_listing_rests_on_no_room_whose_changes_leave_it_as_it_is() -> None:
    code = """
import importlib, pkgutil, sys, papers, repro.commands.list
for each in pkgutil.iter_modules(papers.__path__):
    importlib.import_module(f"papers.{each.name}")
print(*sys.modules)
"""
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, check=True, text=True)
    loaded = {name for name in found.stdout.split() if name.startswith("repro.")}
    of_others = {name for name in loaded if name.split(".")[1] in OTHER_ROOMS}
    assert "repro.runs.plan" in loaded
    assert of_others == {"repro.report", "repro.report.kept"}  # they keep


def test_a_change_in_another_room_leaves_the_listing(
    listed: Callable[..., object],
    made: list[int],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    engine = tmp_path / "engine"
    for room in ("runs", "judge"):
        (engine / room).mkdir(parents=True)
    monkeypatch.setattr("repro.__path__", [str(engine)])
    listed()
    (engine / "judge" / "verdict.py").touch()
    listed()
    assert made == [1]
    (engine / "runs" / "plan.py").touch()
    listed()
    assert made == [1, 1]
