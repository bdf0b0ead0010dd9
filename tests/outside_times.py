"""Ask the other planners anew: `nox -s references` writes repro/judge/planners.json."""

import json
from importlib.metadata import version
from pathlib import Path

from repro.commands.catalogue import all_papers
from repro.judge.certificates import certify
from repro.judge.outside_planners import outside_references

NAMES = ("paper", "problem", "planner", "what", "time")
FILE = Path(__file__).parent.parent / "repro" / "judge" / "planners.json"


def main(file: Path = FILE) -> None:
    """Ask ruckig and toppra for every motion of the papers; SystemExit where one gives no answer.

    An answer is kept where a minimum is certified, which it stands beside.
    """
    papers = tuple(all_papers().values())
    minima = {(row.paper, row.problem): row.minimum for each in papers for row in certify(each)}
    rows = outside_references(papers)
    if none := [f"{row.problem}: {row.skipped}" for row in rows if row.time is None]:
        message = f"not written, as planners gave no answer: {'; '.join(none)}"
        raise SystemExit(message)
    found = {
        "versions": {name: version(name) for name in sorted({row.planner for row in rows})},
        "rows": [
            {
                **{name: getattr(row, name) for name in NAMES},
                "minimum": minima[row.paper, row.problem],
            }
            for row in rows
            if minima[row.paper, row.problem] is not None
        ],
    }
    file.write_text(json.dumps(found, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
