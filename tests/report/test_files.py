from pathlib import Path

import pytest

from repro.errors import InputError
from repro.report.files import usable_folder, write_file


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
        write_file(tmp_path / "tables" / "a.csv", text)
    assert [path.name for path in (tmp_path / "tables").iterdir()] == ["a.csv"]
    assert (tmp_path / "tables" / "a.csv").read_text() == "second"


def test_a_file_that_cannot_be_written_is_named(tmp_path: Path) -> None:
    (tmp_path / "tables").write_text("in the way")
    with pytest.raises(InputError, match=r"a\.csv cannot be written"):
        write_file(tmp_path / "tables" / "a.csv", "text")
