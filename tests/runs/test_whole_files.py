import os
from pathlib import Path

import pytest

from repro.errors import InputError
from repro.runs.whole_files import (
    read_file,
    set_aside,
    usable_folder,
    write_file,
    write_named,
)


def test_a_reports_folder_is_made_with_its_parents(tmp_path: Path) -> None:
    usable_folder(tmp_path / "a" / "reports")
    assert (tmp_path / "a" / "reports").is_dir()


def test_a_reports_folder_that_is_a_file_is_refused(tmp_path: Path) -> None:
    place = tmp_path / "reports"
    place.write_text("in the way")
    with pytest.raises(InputError, match="cannot be used"):
        usable_folder(place)


def test_a_file_is_replaced_whole_and_leaves_no_draft(tmp_path: Path) -> None:
    for text in ("first", "second"):
        write_file(tmp_path, "tables/a.csv", text)
    assert [path.name for path in (tmp_path / "tables").iterdir()] == ["a.csv"]
    assert (tmp_path / "tables" / "a.csv").read_text() == "second"


def test_a_file_that_cannot_be_written_is_named(tmp_path: Path) -> None:
    (tmp_path / "tables").write_text("in the way")
    with pytest.raises(InputError, match=r"a\.csv cannot be written"):
        write_file(tmp_path, "tables/a.csv", "text")


@pytest.mark.parametrize("planted", ["link", "file"])
def test_what_stands_in_the_place_of_a_draft_is_left(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, planted: str
) -> None:
    theirs, draft = tmp_path / "theirs", tmp_path / ".repro-00.draft"
    theirs.write_text("theirs")
    draft.symlink_to(theirs) if planted == "link" else draft.write_text("theirs")
    monkeypatch.setattr("secrets.token_hex", lambda _: "00")

    with pytest.raises(InputError, match="html cannot be written: File exists"):
        write_file(tmp_path, "index.html", "ours")

    assert theirs.read_text() == draft.read_text() == "theirs"
    assert not (tmp_path / "index.html").exists()


def test_no_two_drafts_have_one_name(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    names = set()
    monkeypatch.setattr(Path, "replace", lambda draft, _: names.add(draft.name))
    for _ in range(50):
        write_file(tmp_path, "index.html", "ours")
    assert len(names) == 50


def test_a_link_in_the_place_of_a_page_is_replaced_and_not_followed(tmp_path: Path) -> None:
    theirs = tmp_path / "theirs"
    theirs.write_text("theirs")
    (tmp_path / "index.html").symlink_to(theirs)

    write_file(tmp_path, "index.html", b"ours")

    assert theirs.read_text() == "theirs"
    assert (tmp_path / "index.html").read_text() == "ours"


def test_what_is_set_aside_takes_no_name_that_is_taken(tmp_path: Path) -> None:
    (tmp_path / "results-set-aside-1.json").write_text("earlier")
    (tmp_path / "results.json").write_text("now")

    aside = set_aside(tmp_path / "results.json")

    assert (aside.name, aside.read_text()) == ("results-set-aside-2.json", "now")
    assert (tmp_path / "results-set-aside-1.json").read_text() == "earlier"
    assert not (tmp_path / "results.json").exists()


def test_no_link_below_a_folder_is_followed_and_one_above_it_is(tmp_path: Path) -> None:
    (tmp_path / "theirs").mkdir()
    (tmp_path / "disk").mkdir()
    (tmp_path / "reports").symlink_to(tmp_path / "disk")
    (tmp_path / "reports" / "tables").symlink_to(tmp_path / "theirs")

    with pytest.raises(InputError, match=r"a\.csv cannot be written: \S*/reports/tables is a link"):
        write_file(tmp_path / "reports", "tables/a.csv", "text")
    write_file(tmp_path / "reports", "a.csv", "text")

    assert not list((tmp_path / "theirs").iterdir())
    assert (tmp_path / "disk" / "a.csv").read_text() == "text"


def test_a_file_that_the_user_names_is_written_where_its_link_leads(tmp_path: Path) -> None:
    (tmp_path / "page").write_text("before")
    for name, to in (("link", "page"), ("new", "made"), ("circle", "circle")):
        (tmp_path / name).symlink_to(tmp_path / to)

    write_named(tmp_path / "link", "text")
    write_named(tmp_path / "new", "text")
    write_named(Path(os.devnull), "text")

    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "page").read_text() == (tmp_path / "made").read_text() == "text"
    with pytest.raises(InputError, match="circle cannot be written"):
        write_named(tmp_path / "circle", "text")
    with pytest.raises(InputError, match="absent/page cannot be written"):
        write_named(tmp_path / "absent" / "page", "text")
    assert not list(tmp_path.glob(".repro*"))


def test_nothing_is_waited_for_at_a_pipe(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "results.json")

    with pytest.raises(OSError, match="it is no file"):
        read_file(tmp_path / "results.json")


def test_a_folder_is_set_aside_with_all_that_is_in_it(tmp_path: Path) -> None:
    (tmp_path / "made-of.json").mkdir()
    (tmp_path / "made-of.json" / "inner").write_text("theirs")

    assert (set_aside(tmp_path / "made-of.json") / "inner").read_text() == "theirs"
