"""Rows as DataFrames: one frame a kind of row, which the CSV files, LaTeX and the API share.

The columns of each are described in docs/data.md.
"""

import dataclasses
import math
from array import array
from collections.abc import Callable, Iterable, Mapping, Sequence

import numpy as np
import pandas as pd

from repro.audit import AuditRow
from repro.determinism.seeds import seed_of
from repro.judge.certificates import Certificate
from repro.model.identifiers import identifiers
from repro.report.escapes import csv_value
from repro.report.plain_rows import RANK_SUM, STANDING, TEST
from repro.report.results import Json
from repro.runs.raw_runs import RawCell, ran_as

Entries = Iterable[Json]
INSTANT = "time [s]"
DIGITS = 6  # of what is drawn: a curve has more points than digits that matter
FINDING = (
    *("table", "row", "column", "claim", "where", "printed", "unit", "value"),
    *("measured_low", "measured_high", "accepted_low", "accepted_high", "quantile", "repeats"),
    *("verdict", "side", "note", "readings_tried", "turns_on", "group", "unseen", "id"),
)
"""The columns of a table's CSV file, in their order."""
MORE_OF_A_FINDING = ("measure", "tolerance", "as_run", "as_run_side", "readings")
FINDINGS = ("paper", *FINDING, *MORE_OF_A_FINDING)
AUDIT = tuple(field.name for field in dataclasses.fields(AuditRow))
CERTIFICATES = tuple(field.name for field in dataclasses.fields(Certificate))
TESTS, STANDINGS = ("paper", *TEST), ("paper", *STANDING)
RANK_SUMS = {
    **{name: name for name in ("problem", "algorithm", "against", "p")},
    "holm": "p by Holm",
    "wins": "wins",
    "wins_low": "low",
    "wins_high": "high",
}
"""The fields of a rank-sum test by the columns of its CSV file."""
PUBLISHED = (
    *("study", "experiment", "problem", "algorithm", "repeat", "run", "cost", "evaluations"),
)
"""The columns of a published file of runs."""
RUNS = ("paper", *PUBLISHED, "seed", "seconds")


def csv_text(frame: pd.DataFrame, digits: int | None = None) -> str:
    """Return a frame as the text of a CSV file; floats are exact, or of so many digits.

    Instants keep twelve: of fewer, two that follow each other could be one. No text of it, a
    heading neither, is a formula where the file is opened.
    """
    if digits is not None and INSTANT in frame:
        frame = frame.assign(**{INSTANT: frame[INSTANT].map("{:.12g}".format)})
    form = None if digits is None else f"%.{digits}g"
    texts = frame.select_dtypes(exclude="number").columns
    frame = frame.assign(**{name: frame[name].map(csv_value) for name in texts})
    frame = frame.rename(columns=csv_value)
    text: str = frame.to_csv(index=False, lineterminator="\n", float_format=form)
    return text


def findings_frame(entries: Entries) -> pd.DataFrame:
    """Return a row a printed number or sentence of papers in results.json."""
    return pd.DataFrame(_rows(entries, _findings), columns=list(FINDINGS))


def audit_frame(entries: Entries) -> pd.DataFrame:
    """Return a row for each thing that the printed tables say about themselves."""
    return pd.DataFrame(_rows(entries, lambda entry: entry["audit"]), columns=list(AUDIT))


def certificates_frame(entries: Entries) -> pd.DataFrame:
    """Return a row a motion whose least time was asked for."""
    rows = _rows(entries, lambda entry: entry["certificates"])
    return pd.DataFrame(rows, columns=list(CERTIFICATES))


def frame_of_tests(entries: Entries) -> pd.DataFrame:
    """Return a row for each rank-sum test, and one for each rank of an algorithm."""
    return pd.DataFrame(_rows(entries, lambda entry: entry["tests"]), columns=list(TESTS))


def rank_sums(rows: Iterable[Json]) -> pd.DataFrame:
    """Return the rank-sum tests among rows of tests, as their CSV file has them."""
    tests = pd.DataFrame(rows, columns=list(TEST))
    own = tests.loc[tests["test"] == RANK_SUM, list(RANK_SUMS)]
    return own.rename(columns=RANK_SUMS).astype(dict.fromkeys(("p", "p by Holm", "wins"), float))


def standings_frame(entries: Entries) -> pd.DataFrame:
    """Return a row for each algorithm on each problem beside the baselines."""
    return pd.DataFrame(_rows(entries, lambda entry: entry["standings"]), columns=list(STANDINGS))


def _rows(entries: Entries, of: Callable[[Json], Iterable[Json]]) -> list[Json]:
    return [{"paper": entry["key"], **row} for entry in entries for row in of(entry)]


def _findings(entry: Json) -> Iterable[Json]:
    names = identifiers(
        (one["table"] or "claim", one["row"], one["column"], one["claim"])
        for one in entry["findings"]
    )
    for name, one in zip(names, entry["findings"], strict=True):
        measured, accepted = (
            without_end(one[name]) if one[name] else (None, None)
            for name in ("measured", "accepted")
        )
        yield {
            **one,
            "measured_low": measured[0], "measured_high": measured[1],
            "accepted_low": accepted[0], "accepted_high": accepted[1],
            "readings_tried": len(one["readings"]), "turns_on": "; ".join(one["turns_on"]),
            "id": name,
        }  # fmt: skip


def without_end(interval: Sequence[float | None]) -> tuple[float, float]:
    """Return both ends of an interval of results.json; one that is not there is infinite."""
    low, high = interval
    return -math.inf if low is None else low, math.inf if high is None else high


def cell_frame(cell: RawCell) -> pd.DataFrame:
    """Return the runs of a cell by repeat and run, each once, the names in every row."""
    columns = {each.name: getattr(cell, each.name) for each in dataclasses.fields(cell)}
    frame = pd.DataFrame(
        {
            name: np.asarray(values) if isinstance(values, array) else values
            for name, values in columns.items()
        }
    )
    once = frame.drop_duplicates(["repeat", "run"], keep="last")
    return once.sort_values(["repeat", "run"], ignore_index=True)


def runs_frame(
    key: str, published: pd.DataFrame, drawn_as: Mapping[str, str], master_seed: str = ""
) -> pd.DataFrame:
    """Return published runs with their paper and seeds; the seconds are not known of them.

    `drawn_as` names the experiments that draw the random numbers of another.
    """
    frame = published.assign(paper=key)
    if "seconds" not in frame:
        frame["seconds"] = math.nan
    seeds = _seeds(key, published, drawn_as, master_seed)
    frame["seed"] = pd.Series(seeds, index=frame.index, dtype=object)
    return frame[list(RUNS)]


def _seeds(
    key: str, published: pd.DataFrame, drawn_as: Mapping[str, str], master_seed: str
) -> list[int]:
    names = ("study", "experiment", "problem", "algorithm", "repeat", "run")
    first = (master_seed,) if master_seed else ()
    seeds = []
    for study, experiment, *rest in zip(*(published[name] for name in names), strict=True):
        name = ran_as(study, experiment)
        seeds.append(seed_of(*first, key, drawn_as.get(name, name), *rest))
    return seeds
