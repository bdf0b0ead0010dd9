"""The picture of the README: every printed number of every paper as one square, by verdict."""

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass

from repro.model.identifiers import anchor
from repro.report.results import Json

ACROSS = 46  # squares in a line
STEP = 16  # px from square to square
NAMES = 190  # px for what stands before them
APART = 10  # px between papers


@dataclass(frozen=True, slots=True, kw_only=True)
class Squares:
    """The squares of one paper: verdict, and how many px to the right and below the others."""

    name: str
    top: int
    squares: tuple[tuple[str, int, int], ...]


def picture(papers: Iterable[Json]) -> dict[str, object]:
    """Return what the template of the picture names: strips, their height in px, and counts."""
    found, top = [], 0
    held: Counter[str] = Counter()
    for paper in papers:
        verdicts = [finding["verdict"] for finding in paper["findings"]]
        if not verdicts:
            continue
        held.update(verdicts)
        places = (divmod(position, ACROSS) for position in range(len(verdicts)))
        squares = tuple(
            (anchor(verdict), NAMES + STEP * column, top + STEP * line)
            for verdict, (line, column) in zip(verdicts, places, strict=True)
        )
        found.append(Squares(name=paper["cited"], top=top, squares=squares))
        top = squares[-1][2] + STEP + APART
    return {"strips": tuple(found), "height": top, "held": held}
