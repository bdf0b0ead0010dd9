"""`repro certify`: proved minima of the motion problems."""

from argparse import Namespace

from repro.commands import catalogue
from repro.commands.shown_rows import show
from repro.judge.certificates import certify


def run(options: Namespace) -> int:
    """Print one line, or one JSON object, per certificate."""
    found = {paper.key: certify(paper) for paper in catalogue.chosen(options)}
    rows = [row for each in found.values() for row in each]
    lines = [
        f"{row.paper}, {row.problem}: "
        + ("no minimum" if row.minimum is None else f"minimum {row.minimum:.6g} s")
        + f"; {row.explanation or '; '.join(row.binding)}"
        for row in rows
    ]
    lines += [f"{key}: no motion, nothing to certify" for key, each in found.items() if not each]
    return show(rows, lines, as_json=options.json)
