import re
from collections.abc import Sequence
from xml.etree import ElementTree as ET

import numpy as np
import pytest

from repro.report.drawings.draw import Drawing, drawing
from repro.report.drawings.ranks import rank_plot
from repro.statistics.friedman import friedman
from tests.written_rows import rows_of

NAMES = ("WOA", "PSO", "DE", "GSA", "SMA")
SVG = "{http://www.w3.org/2000/svg}"


def drawn(values: Sequence[Sequence[float]], names: tuple[str, ...] = NAMES) -> Drawing:
    found = friedman(np.array(values))
    return drawing(
        lambda: rank_plot(names, found, {"WOA": "2.5"}), title="Ranks", identifier="ranks"
    )


CLEAR = drawn([[1.0, 2.0, 3.0, 4.0, 5.0]] * 20)
CLOSE = drawn([[1.0, 2.0, 3.0, 4.0, 5.0], [5.0, 4.0, 3.0, 2.0, 1.0]])


def texts(shown: Drawing) -> list[str]:
    root = ET.fromstring(shown.svg)  # noqa: S314 (our own text)
    return [element.text or "" for element in root.iter(f"{SVG}text")]


def test_every_algorithm_is_named_with_its_rank() -> None:
    assert {"WOA 1.00", "PSO 2.00", "DE 3.00", "GSA 4.00", "SMA 5.00"} <= set(texts(CLEAR))
    assert "critical difference 1.36" in texts(CLEAR)


def test_description_says_ranks_and_groups() -> None:
    assert "WOA 1.00, PSO 2.00, DE 3.00, GSA 4.00, SMA 5.00" in CLEAR.description
    assert "Not told apart: WOA, PSO; PSO, DE; DE, GSA; GSA, SMA." in CLEAR.description
    assert "Not told apart: WOA, PSO, DE, GSA, SMA." in CLOSE.description


def test_algorithms_that_all_differ_have_no_bar() -> None:
    apart = drawn([[1.0, 2.0, 3.0]] * 200, ("A", "B", "C"))

    assert "All are told apart." in apart.description
    assert bars(apart) == 1  # that of the critical difference
    assert bars(CLOSE) == 2


def bars(shown: Drawing) -> int:
    return len(re.findall(r"stroke: #d55e00", shown.svg))


def test_data_hold_every_rank_from_the_lowest_on() -> None:
    headings, *rows = rows_of(CLEAR.frame)

    assert headings[:3] == ("algorithm", "average rank", "printed average rank")
    assert [row[0] for row in rows] == list(NAMES)
    assert [row[2] for row in rows] == ["2.5", "", "", "", ""]


@pytest.mark.parametrize("shown", [CLEAR, CLOSE])
def test_drawing_stays_light_and_inside_its_frame(shown: Drawing) -> None:
    assert len(shown.svg) < 20_000
    _, _, width, height = map(float, re.search(r'viewBox="([^"]*)"', shown.svg)[1].split())  # type: ignore[index]
    points = re.findall(r"[ML] (-?[\d.]+) (-?[\d.]+)", shown.svg)
    assert points
    assert all(0 <= float(x) <= width and 0 <= float(y) <= height for x, y in points)
