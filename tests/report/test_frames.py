import csv
import io
import math
from typing import Any

import numpy as np
import pandas as pd
import pytest
from hypothesis import given
from hypothesis import strategies as st

from repro.determinism.seeds import generator
from repro.report.frames import FINDING, csv_text, findings_frame, rank_sums, runs_frame

FINDING_ROW: dict[str, Any] = {
    **dict.fromkeys(("column", "claim", "side", "unseen", "group", "as_run", "as_run_side")),
    "table": "Table 1",
    "row": "bowl",
    "where": "p. 3",
    "printed": "0.05",
    "unit": "",
    "value": 0.1,
    "measured": [0.05, None],
    "accepted": [None, 2.0],
    "quantile": 0.5,
    "repeats": 2,
    "verdict": "depends",
    "note": "",
    "turns_on": ["a", "b"],
    "readings": [{}],
    "measure": "mean",
    "tolerance": "25 %",
}


def test_commas_and_quotes_stay_in_their_cell() -> None:
    assert csv_text(pd.DataFrame({"a,b": [1.5], "c": ['"']})) == '"a,b",c\n1.5,""""\n'


@given(st.lists(st.floats(allow_nan=False), min_size=1))
def test_every_float_comes_back_from_a_csv_to_the_last_bit(values: list[float]) -> None:
    text = csv_text(pd.DataFrame({"name": "a", "cost": values}))

    assert [float(row["cost"]) for row in csv.DictReader(io.StringIO(text))] == values


def test_ends_that_json_has_not_are_infinite_in_a_frame() -> None:
    (row,) = findings_frame([{"key": "a2020", "findings": [FINDING_ROW]}]).to_dict("records")

    assert (row["measured_low"], row["measured_high"]) == (0.05, math.inf)
    assert (row["accepted_low"], row["accepted_high"]) == (-math.inf, 2.0)
    assert (row["paper"], row["turns_on"], row["readings_tried"]) == ("a2020", "a; b", 1)
    assert row["id"] == "table-1-bowl"


def test_a_finding_without_a_measurement_has_none_in_its_frame() -> None:
    row = FINDING_ROW | {"measured": None, "value": None}

    frame = findings_frame([{"key": "a2020", "findings": [row]}])

    assert frame[["value", "measured_low", "measured_high"]].isna().all(axis=None)
    assert ",0.05,,,,,-inf,2.0,0.5," in csv_text(frame[list(FINDING)])


def test_frames_of_nothing_have_all_their_columns() -> None:
    assert csv_text(rank_sums([])) == "problem,algorithm,against,p,p by Holm,wins,low,high\n"
    assert list(findings_frame([]))[1:3] == ["table", "row"]


PUBLISHED = pd.DataFrame({
    "study": ["protocol", "shift 0.2"], "experiment": "e", "problem": "F1", "algorithm": "NA",
    "repeat": 1, "run": [1, 2], "cost": [0.5, 0.25], "evaluations": 9,
})  # fmt: skip


@pytest.mark.parametrize("seed", ["", "another"])
def test_seeds_are_those_of_the_runs_names(seed: str) -> None:
    frame = runs_frame("a2020", PUBLISHED, {"e [shift 0.2]": "e"}, seed)

    first = (seed,) if seed else ()
    for number, run in zip(frame["seed"], (1, 2), strict=True):
        expected = generator(*first, "a2020", "e", "F1", "NA", 1, run)
        assert np.random.default_rng(number).random() == expected.random()
    assert frame["seconds"].isna().all()


def test_a_study_that_draws_its_own_numbers_has_a_seed_of_its_own() -> None:
    frame = runs_frame("a2020", PUBLISHED, {})

    expected = generator("a2020", "e [shift 0.2]", "F1", "NA", 1, 2)
    assert np.random.default_rng(frame["seed"][1]).random() == expected.random()
