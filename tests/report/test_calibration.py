from pathlib import Path

import pytest

from repro.report import calibration as module
from repro.report.calibration import calibration


def test_without_a_calibration_there_are_no_rows(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "files", lambda _: tmp_path)

    assert calibration() == {"rows": [], "narrow": [], "coverage": [], "by": {}}


def test_calibration_is_read_as_it_is_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "calibration.json").write_text('{"rows": [{"share": 0.5}]}')
    monkeypatch.setattr(module, "files", lambda _: tmp_path)

    assert calibration() == {"rows": [{"share": 0.5}], "narrow": [], "coverage": [], "by": {}}
