import os
from pathlib import Path

import pytest

from repro.report.kept import find, keep


def test_no_more_is_kept_than_a_bound_and_the_oldest_goes_first(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("repro.report.kept.MOST", 400)
    for name in ("a" * 64, "b" * 64, "c" * 64):
        keep(tmp_path, name, bytes(50))
        os.utime(tmp_path / f"{name}.kept", (ord(name[0]), ord(name[0])))
    assert find(tmp_path, "a" * 64) == bytes(50)  # which makes it the youngest
    keep(tmp_path, "d" * 64, bytes(50))
    assert [name for name in "abcd" if find(tmp_path, 64 * name)] == ["a", "c", "d"]


def test_a_folder_that_cannot_be_written_keeps_nothing(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    keep(tmp_path / "file", "a", b"text")
    assert find(tmp_path / "file", "a") is None
