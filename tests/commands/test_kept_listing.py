from collections.abc import Callable
from pathlib import Path

import pytest

from repro.commands.kept_listing import FOLDER, MADE_OF, kept_listing
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

    def listing(keys: tuple[str, ...] = (), repeats: int = 1) -> object:
        def make() -> list[dict[str, object]]:
            made.append(repeats)
            return list(ROWS)

        return kept_listing(store, keys, repeats, make)

    return listing


def test_a_listing_is_made_once(listed: Callable[..., object], made: list[int]) -> None:
    assert listed() == listed() == ROWS
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
    assert listed() == ROWS
    assert made == [1, 1]


@pytest.mark.parametrize("keys", [("./small2020.py",), ("a/b",), ("other2021",)])
def test_files_and_papers_that_are_not_all_found_are_not_kept(
    listed: Callable[..., object], made: list[int], tmp_path: Path, keys: tuple[str, ...]
) -> None:
    listed(keys)
    listed(keys)
    assert made == [1, 1]
    assert not (tmp_path / FOLDER).exists()


def test_no_store_is_made_for_a_listing(tmp_path: Path) -> None:
    assert kept_listing(tmp_path / "none", (), 1, lambda: ROWS) == ROWS
    assert list(tmp_path.iterdir()) == []
