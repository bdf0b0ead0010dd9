"""The calibration of the verdicts, which is package data: what truthful and false papers get."""

import json
from importlib.resources import files
from typing import Any


def calibration() -> dict[str, Any]:
    """Return what the package ships of tables whose truth is known; all empty where there is none.

    `rows` are the share of each verdict, by repeats, statistic and factor: a printed value that
    lies so many times as far from the minimum as the true one; 1 is the truth, 0.01 is a hundred
    times nearer. `narrow` is the same, of runs whose distances from the minimum span less than a
    decade. `coverage` says how often an interval that promised so much held the true value, and how
    often plain resampling would have, by kind of costs; `by` what was run.
    """
    found: dict[str, Any] = {"rows": [], "narrow": [], "coverage": [], "by": {}}
    data = files("repro.judge").joinpath("calibration.json")
    if data.is_file():
        found |= json.loads(data.read_text(encoding="utf-8"))
    return found
