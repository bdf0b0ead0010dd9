"""results.json: everything that the pages say, for programs to read."""

import dataclasses
import json
import math
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from repro.judge.conclusions import conclude
from repro.judge.counting import counts
from repro.judge.judgement import Judgement
from repro.model.assumptions import Assumption
from repro.report.calibration import calibration
from repro.report.cited import cited
from repro.report.plain_rows import rows_of_standings, rows_of_tests
from repro.runs.whole_files import read_file
from repro.tables.rows import Grade

SCHEMA = 2
BEFORE = 1
"""The schema of five verdicts, without groups, readings of every number, tests and standings."""
PROVENANCE = "provenance.json"
LINE = 160  # characters, the longest line of what is not a single text
Json = dict[str, Any]
Environments = list[dict[str, object]]
Files = dict[str, str | bytes]


@dataclasses.dataclass(frozen=True, slots=True, kw_only=True)
class Made:
    """What is written of one paper: its entries in results.json and provenance.json, its files.

    `files` are by their place in the reports folder; `says` is what a terminal is told besides.
    Of so many `tasks` as many runs are `missing`.
    """

    entry: Json
    provenance: Json
    files: Files
    says: Sequence[str] = ()
    tasks: int = 0
    missing: int = 0


def paper_result(judgement: Judgement, master_seed: str) -> Json:
    """Return one paper's entry in results.json."""
    paper, runs = judgement.paper, judgement.evidence.runs
    protocol = {experiment.name for experiment in paper.experiments}
    return {
        "key": paper.key,
        "title": paper.source.title,
        "cited": cited(paper.key, paper.source),
        "control": paper.control,
        "summary": paper.summary,
        "provenance": {
            "repeats": judgement.repeats,
            "runs": sum(cell.costs.size for cell in runs.values()),
            "protocol_runs": sum(
                cell.costs.size for (name, *_), cell in runs.items() if name in protocol
            ),
            "master_seed": master_seed,
            "drawn_as": dict(judgement.drawn_as),
        },
        "conclusions": _finite(dataclasses.asdict(conclude(judgement))),
        "findings": _plain(judgement.findings),
        "audit": _plain(judgement.audit),
        "certificates": _plain(judgement.certificates),
        "tests": _finite(rows_of_tests(judgement.tests)),
        "standings": _finite(rows_of_standings(judgement.standings)),
        "assumptions": [_assumption(assumption) for assumption in paper.assumptions],
        "errata": _plain(paper.errata),
        "gaps": _plain(paper.gaps),
        "equations": [
            {"label": each.label, "where": each.where, "says": each.says} for each in paper.formulas
        ],
    }


def _plain(rows: Iterable[Any]) -> list[Json]:
    return [
        {name: _finite(value) for name, value in dataclasses.asdict(row).items()} for row in rows
    ]


def _finite(value: object) -> object:
    """Return a value with None for ends that are not there, as JSON has no infinity."""
    if isinstance(value, tuple | list):
        return [_finite(each) for each in value]
    if isinstance(value, dict):
        return {name: _finite(each) for name, each in value.items()}
    return None if isinstance(value, float) and not math.isfinite(value) else value


def _assumption(assumption: Assumption) -> Json:
    """Return an assumption in words: what its alternatives change is code."""
    return {
        "what": assumption.what,
        "where": assumption.where,
        "chosen": assumption.chosen,
        "alternatives": [
            {"says": each.says, "reading": each.name, "untried": each.untried}
            for each in assumption.alternatives
        ],
        "because": assumption.because,
    }


def merged(fresh: Iterable[Json], old: Json | None, order: Iterable[str]) -> Json:
    """Return the whole of results.json: fresh entries, and old ones of papers not redone."""
    entries = {entry["key"]: entry for entry in (old or {}).get("papers", [])}
    entries |= {entry["key"]: entry for entry in fresh}
    papers = [entries[key] for key in dict.fromkeys((*order, *entries)) if key in entries]
    return {
        "schema": SCHEMA,
        "provenance": {
            "repeats": max((paper["provenance"]["repeats"] for paper in papers), default=0),
            "runs": sum(paper["provenance"]["runs"] for paper in papers),
        },
        "papers": papers,
        "calibration": calibration()["rows"],
    }


def provenance_entry(judgement: Judgement, environments: Environments, called: str = "") -> Json:
    """Return what differs between equal runs: where, when and how fast they were made.

    `seconds` are the median of a run, by experiment, problem, algorithm and kind of run; `called`
    is what a paper from elsewhere than this checkout is called at the command line.
    """
    return {
        **({"called": called} if called else {}),
        "environments": environments,
        "seconds": [
            {
                "experiment": found.experiment.name,
                "problem": problem.problem,
                "algorithm": row.algorithm,
                "run as": row.kind,
                "seconds": float(f"{row.seconds:.3g}"),
            }
            for found in judgement.standings
            for problem in found.problems
            for row in problem.rows
        ],
    }


def merged_provenance(fresh: Mapping[str, Json], old: Json | None, order: Iterable[str]) -> Json:
    """Return the whole of provenance.json: fresh entries, and old ones of papers not redone."""
    entries = {**(old or {}).get("papers", {}), **fresh}
    return {"papers": {key: entries[key] for key in order if key in entries}}


def read_results(path: Path) -> Json | None:
    """Return the content of an earlier results.json, or None where there is none of this schema."""
    content = read_json(path)
    return content if content and content.get("schema") == SCHEMA else None


def read_results_of_any_age(path: Path) -> Json | None:
    """Return what a results.json of this schema or the one before says; None where it is none.

    Both name findings and their verdicts alike.
    """
    content = read_json(path)
    return content if content and content.get("schema") in {BEFORE, SCHEMA} else None


def read_json(path: Path) -> Json | None:
    """Return the object that a file holds, or None where there is none."""
    try:
        content = json.loads(read_file(path).decode())
    except (OSError, ValueError, RecursionError):
        return None
    return content if isinstance(content, dict) else None


def results_text(results: Json) -> str:
    """Return results.json as text: what fits on a line stands on one."""
    return _lines(results) + "\n"


def _lines(value: object, depth: int = 1) -> str:
    """Return a value as JSON, a part of it on a line of its own where it is long."""
    whole = json.dumps(value, ensure_ascii=False, allow_nan=False)
    if len(whole) <= LINE or not isinstance(value, dict | list):
        return whole
    blanks = " " * depth
    if isinstance(value, dict):
        keys = (json.dumps(str(name), ensure_ascii=False) for name in value)
        parts = [
            f"{name}: {_lines(own, depth + 1)}"
            for name, own in zip(keys, value.values(), strict=True)
        ]
    else:
        parts = [_lines(own, depth + 1) for own in value]
    opened, closed = "{}" if isinstance(value, dict) else "[]"
    body = ",\n".join(f"{blanks}{part}" for part in parts)
    return f"{opened}\n{body}\n{blanks[1:]}{closed}"


def impossible_rows(entry: Mapping[str, Any]) -> list[Json]:
    """Return the audit rows of a paper that no runs whatever can give; those are counted."""
    return [
        row
        for row in entry["audit"]
        if row["grade"] == Grade.IMPOSSIBLE and row.get("condition") is None
    ]


def cell_counts(entry: Mapping[str, Any]) -> Counter[str]:
    """Return how many numbers of a paper's tables have each verdict, each by itself."""
    return Counter(finding["verdict"] for finding in entry["findings"] if finding["table"])


def verdict_counts(entry: Mapping[str, Any]) -> Counter[str]:
    """Return how many results of a paper have each verdict; what is one result counts once."""
    return counts((finding["group"], finding["verdict"]) for finding in entry["findings"])
