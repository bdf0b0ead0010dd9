"""The page that says how verdicts are made, in HTML and in Markdown."""

from collections.abc import Mapping
from typing import Any

from repro.judge.counting import GRAVEST
from repro.judge.deepening import SHARE
from repro.model.identifiers import anchor
from repro.report.drawings.draw import drawing
from repro.report.drawings.verdict_rule import EXAMPLES, verdict_plot
from repro.report.views.calibration import coverage_sheet, share_sheets
from repro.statistics.tables import DECADE, REACH

VERDICTS = "how-verdicts-are-made"


def verdict_context(found: Mapping[str, Any]) -> dict[str, object]:
    """Return what the templates of the page name; `found` is the calibration."""
    pictures = [
        (
            example,
            drawing(
                lambda example=example: verdict_plot(example),  # type: ignore[misc]
                title=f"An interval that makes a number {example.verdict}",
                identifier=anchor("verdict", example.verdict),
            ),
        )
        for example in EXAMPLES
    ]
    return {
        "pictures": pictures,
        "gravest": GRAVEST,
        "share_of_runs": SHARE,
        "reach": REACH,
        "decade": DECADE,
        "sheets": share_sheets(found["rows"]),
        "narrow": share_sheets(found.get("narrow", [])),
        "coverage": coverage_sheet(found["coverage"]) if found["coverage"] else None,
        "by": {name: _in_words(value) for name, value in found["by"].items()},
    }


def _in_words(value: object) -> str:
    if isinstance(value, Mapping):
        return ", ".join(f"{name} {each}" for name, each in value.items())
    return ", ".join(map(str, value)) if isinstance(value, list) else str(value)
