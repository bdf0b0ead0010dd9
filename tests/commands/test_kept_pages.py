from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from repro.commands.kept_output import FOLDER
from repro.commands.kept_pages import (
    _surroundings,
    declared_by,
    extent_of,
    planned_extent,
)
from repro.commands.written_pages import write_pages
from repro.judge.judgement import Judgement, judge
from repro.model.paper import Paper
from repro.runs.plan import plan
from repro.runs.store.store import Store
from tests.doe2021 import PAPER as OF_MANY_KINDS
from tests.small_papers import PAPER
from tests.small_stores import ENVIRONMENT, RECORDS, TASKS, change, filled

Content = dict[str, bytes]


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return the file that declares the small paper, as if it were one of this house."""
    house = tmp_path / "house"
    house.mkdir()
    file = house / f"{PAPER.key}.py"
    file.write_text("PAPER = 1\n", encoding="utf-8")
    (house / "other2021.py").write_text("PAPER = 2\n", encoding="utf-8")
    monkeypatch.setattr("papers.__path__", [str(house)])
    filled(tmp_path / "store")
    return file


def written(place: Path, paper: Paper = PAPER, name: str = "reports") -> Content:
    """Write the pages and return them."""
    folder = place.parents[1]
    with Store(folder / "store") as store:
        known, places = [PAPER.key, "other2021"], {PAPER.key: place}
        write_pages(store, [paper], TASKS, folder / name, known, places=places)
    files = (path for path in (folder / name).rglob("*") if path.is_file())
    return {str(path.relative_to(folder / name)): path.read_bytes() for path in files}


def kept(place: Path) -> list[Path]:
    """Return what is kept of papers' pages."""
    found = (place.parents[1] / "store" / FOLDER).glob("*")
    return [path for path in found if b'{"entry": ' in path.read_bytes()]


@pytest.fixture
def judged(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Return a list that grows by the key of every paper that is judged."""
    found: list[str] = []

    def noted(paper: Paper, *arguments: Any) -> Judgement:  # noqa: ANN401 (what judge takes)
        found.append(paper.key)
        return judge(paper, *arguments)

    monkeypatch.setattr("repro.commands.written_pages.judge", noted)
    return found


def test_kept_pages_are_those_that_are_made_without_them(place: Path, judged: list[str]) -> None:
    made = written(place)
    assert written(place, name="again") == made
    assert judged == [PAPER.key]
    for path in kept(place):
        path.unlink()
    assert written(place, name="anew") == made
    assert judged == [PAPER.key] * 2


@pytest.mark.parametrize(
    "damage",
    [
        lambda path: path.write_bytes(b""),
        lambda path: path.write_bytes(path.read_bytes()[:-1]),
        lambda path: path.write_bytes(path.read_bytes().replace(b"small2020", b"small2021")),
        lambda path: (path.unlink(), path.mkdir()),
    ],
    ids=["emptied", "cut", "edited", "a folder"],
)
def test_what_is_kept_and_damaged_is_made_again(
    place: Path, judged: list[str], damage: Callable[[Path], object]
) -> None:
    made = written(place)
    (path,) = kept(place)
    damage(path)
    assert written(place) == made
    assert judged == [PAPER.key] * 2


def test_a_kept_paper_is_not_taken_for_another(place: Path, judged: list[str]) -> None:
    written(place)
    (old,) = kept(place)
    place.write_text("PAPER = 1  # read again\n", encoding="utf-8")
    written(place)
    (new,) = set(kept(place)) - {old}
    new.write_bytes(old.read_bytes())
    written(place)
    assert judged == [PAPER.key] * 3


@pytest.mark.parametrize(
    "changed",
    [
        lambda place: place.write_text("PAPER = 3\n"),
        lambda place: place.with_suffix(".toml").write_text("title = ''\n"),
        lambda place: place.with_name("shared.py").touch(),
        lambda place: change(place.parents[1] / "store", "delete from run where id = 6"),
        lambda place: run_again(place.parents[1] / "store"),
    ],
    ids=["declaration", "prose", "module beside it", "run lost", "run of another time"],
)
def test_pages_are_made_again_where_what_they_follow_from_changed(
    place: Path, judged: list[str], changed: Callable[[Path], object]
) -> None:
    written(place)
    changed(place)
    written(place)
    assert judged == [PAPER.key] * 2


def run_again(store: Path) -> None:
    with Store(store) as opened:
        opened.begin(ENVIRONMENT)
        opened.add([replace(RECORDS[0], seconds=RECORDS[0].seconds + 1.0)])


def test_edited_engine_code_is_not_served_old_pages(
    place: Path, judged: list[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    engine = tmp_path / "engine"
    engine.mkdir()
    monkeypatch.setattr("repro.commands.kept_pages.repro", SimpleNamespace(__path__=[engine]))
    for text in ("x = 1\n", "x = 2\n"):
        (engine / "judge.py").write_text(text, encoding="utf-8")
        _surroundings.cache_clear()
        written(place)
    _surroundings.cache_clear()
    assert judged == [PAPER.key] * 2


def test_another_paper_that_changes_leaves_pages_as_they_are(
    place: Path, judged: list[str]
) -> None:
    written(place)
    place.with_name("other2021.py").write_text("PAPER = 4\n", encoding="utf-8")
    written(place)
    assert judged == [PAPER.key]


def test_a_module_that_a_paper_imports_declares_it_though_it_is_another_paper(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    texts = {"__init__": "", "own2020": "from dwelling import other2021", "other2021": "", "x": ""}
    (tmp_path / "dwelling").mkdir()
    for name, text in texts.items():
        (tmp_path / "dwelling" / f"{name}.py").write_text(text, encoding="utf-8")
    monkeypatch.syspath_prepend(str(tmp_path))
    names = declared_by(tmp_path / "dwelling" / "own2020.py", ["own2020", "other2021", "x"])
    assert {Path(name).stem for name in names} == {"__init__", "own2020", "other2021"}


@pytest.mark.parametrize("repeats", [1, 2, 10])
@pytest.mark.parametrize("protocol_only", [False, True])
@pytest.mark.parametrize("paper", [PAPER, OF_MANY_KINDS], ids=lambda paper: paper.key)
def test_the_extent_of_a_plan_is_known_before_it_is_made(
    paper: Paper, repeats: int, *, protocol_only: bool
) -> None:
    tasks = plan([paper], repeats, "seed", protocol_only=protocol_only)
    found = planned_extent(paper, repeats, "seed", protocol_only=protocol_only)
    assert found == extent_of(tasks)
