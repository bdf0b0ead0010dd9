"""The calibration of the verdicts, which is package data: what truthful and false papers get."""

import json
from importlib.resources import files
from typing import Any


def calibration() -> dict[str, Any]:
    """Return `rows`, `coverage` and `by`, all empty where the verdicts are not calibrated yet.

    `rows` hold repeats, statistic, factor, verdict and share, the factor 1 being the truth;
    `coverage` kind (of distribution), repeats, statistic, promised and reached; `by` what was run.
    """
    found: dict[str, Any] = {"rows": [], "coverage": [], "by": {}}
    data = files("repro.judge").joinpath("calibration.json")
    if data.is_file():
        found |= json.loads(data.read_text(encoding="utf-8"))
    return found
