"""results.json: everything that the pages say, for programs to read."""

import dataclasses
import json
from collections import Counter
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from repro.audit import AuditRow
from repro.judge.certificates import Certificate
from repro.judge.findings import Finding
from repro.model.paper import Assumption, Paper

SCHEMA = 1
Json = dict[str, Any]


def paper_result(
    paper: Paper,
    *,
    findings: Iterable[Finding],
    audit: Iterable[AuditRow],
    certificates: Iterable[Certificate],
    provenance: Mapping[str, object],
) -> Json:
    """Return one paper's entry in results.json."""
    return {
        "key": paper.key,
        "title": paper.source.title,
        "summary": paper.summary,
        "provenance": dict(provenance),
        "findings": _plain(findings),
        "audit": _plain(audit),
        "certificates": _plain(certificates),
        "assumptions": [_assumption(assumption) for assumption in paper.assumptions],
        "errata": _plain(paper.errata),
        "gaps": _plain(paper.gaps),
    }


def _plain(rows: Iterable[Any]) -> list[Json]:
    return [dataclasses.asdict(row) for row in rows]


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
    papers = [entries[key] for key in order if key in entries]
    return {
        "schema": SCHEMA,
        "provenance": _common_provenance(papers),
        "papers": papers,
    }


def _common_provenance(papers: Iterable[Json]) -> Json:
    together: Json = {"repeats": 0, "runs": 0, "environments": []}
    for paper in papers:
        own = paper["provenance"]
        together["repeats"] = max(together["repeats"], own["repeats"])
        together["runs"] += own["runs"]
        for environment in own["environments"]:
            if environment not in together["environments"]:
                together["environments"].append(environment)
    return together


def read_results(path: Path) -> Json | None:
    """Return the content of an earlier results.json, or None where there is none of this schema."""
    content = read_json(path)
    return content if content and content.get("schema") == SCHEMA else None


def read_json(path: Path) -> Json | None:
    """Return the object that a file holds, or None where there is none."""
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None
    return content if isinstance(content, dict) else None


def results_text(results: Json) -> str:
    """Return results.json as text."""
    return json.dumps(results, indent=1, ensure_ascii=False, allow_nan=False) + "\n"


def verdict_counts(entry: Json) -> Counter[str]:
    """Return how many findings of a paper have each verdict."""
    return Counter(str(finding["verdict"]) for finding in entry["findings"])
