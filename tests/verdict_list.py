"""The verdicts that the committed pages are expected to show, one CSV a paper.

`python -m tests.verdict_list` writes the lists anew from reports/results.json: do so only with a
line in CHANGELOG.md that says which verdict changed and why.
"""

import csv
import json
from pathlib import Path
from typing import Any

FOLDER = Path(__file__).parent / "verdicts"
RESULTS = Path(__file__).parent.parent / "reports" / "results.json"
COLUMNS = ("table", "row", "column", "claim", "printed", "verdict", "side")


def committed_results() -> dict[str, Any]:
    """Return the committed results.json, papers by key."""
    results = json.loads(RESULTS.read_text(encoding="utf-8"))
    return {entry["key"]: entry for entry in results["papers"]}


def verdict_rows(entry: dict[str, Any]) -> list[tuple[str, ...]]:
    """Return the rows of one paper's list."""
    return [tuple(str(finding[name] or "") for name in COLUMNS) for finding in entry["findings"]]


def expected_rows(key: str) -> list[tuple[str, ...]]:
    """Return the committed list of one paper."""
    with (FOLDER / f"{key}.csv").open(encoding="utf-8", newline="") as file:
        heading, *rows = csv.reader(file)
    assert tuple(heading) == COLUMNS
    return [tuple(row) for row in rows]


def main() -> None:
    """Write every list anew."""
    FOLDER.mkdir(exist_ok=True)
    for key, entry in committed_results().items():
        with (FOLDER / f"{key}.csv").open("w", encoding="utf-8", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows([COLUMNS, *verdict_rows(entry)])


if __name__ == "__main__":
    main()
