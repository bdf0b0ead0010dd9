from collections.abc import Iterator
from dataclasses import replace
from xml.etree import ElementTree as ET

import numpy as np
import pytest

from papers.liang2026 import FANUC, PAPER
from repro.model.figures import Motion, ToolPath
from repro.report.drawings.convergence import CostScale
from repro.report.drawings.draw import Drawing, draw
from repro.report.drawings.style import COLOURS, line_style
from repro.robotics import MinimumTime, quintic
from tests.small_papers import evidence_of
from tests.written_rows import rows_of

NO_RUNS = evidence_of(PAPER, {})
SET_MOTION = PAPER.figures[2]


def texts(drawing: Drawing) -> set[str | None]:
    svg = ET.fromstring(drawing.svg)  # noqa: S314 (our own text)
    return {element.text for element in svg.iter("{http://www.w3.org/2000/svg}text")}


def test_zero_stands_below_every_other_cost() -> None:
    costs = np.array([0.0, 1e-300, 1.0])
    places = CostScale.of(costs).place(costs)
    assert places[0] < places[1] == pytest.approx(-300)
    assert places[2] == 0.0


@pytest.mark.parametrize(
    ("costs", "labels"),
    [
        ([1e-16, 1e4], ["10⁻¹⁵", "10⁻¹⁰", "10⁻⁵", "10⁰"]),
        ([2e-7, 3e-6], ["2×10⁻⁷", "5×10⁻⁷", "10⁻⁶", "2×10⁻⁶"]),
        ([3.0, 60.0], ["5", "10", "20", "50"]),
    ],
)
def test_marks_of_a_logarithmic_axis_are_round(costs: list[float], labels: list[str]) -> None:
    ticks = CostScale.of(np.array(costs)).ticks()
    assert [label for _, label in sorted(ticks.items())] == labels


@pytest.mark.parametrize("costs", [[-10.0, 5.0], [0.0, 0.0], [38.0, 39.0]])
def test_costs_without_decades_stand_at_their_own_value(costs: list[float]) -> None:
    assert CostScale.of(np.array(costs)).place(np.array(costs)).tolist() == costs


def test_a_motion_with_set_durations_needs_no_runs() -> None:
    drawn = draw(SET_MOTION, NO_RUNS, "a")
    assert "5 + 5 = 10 s, with at most 1.534 rad/s, 0.9445 rad/s²" in drawn.description
    assert rows_of(drawn.frame)[-1][:2] == ("durations as set", "10")
    assert float(rows_of(drawn.frame)[-1][2]) == FANUC.waypoints[-1][0]


def test_limits_are_drawn_with_their_label() -> None:
    shown = texts(draw(SET_MOTION, NO_RUNS, "a"))
    assert {"limit 3", "limit 3.5"} <= shown


def test_jerk_is_drawn_where_it_is_limited() -> None:
    limited = replace(FANUC, jerk=(20.0,) * 6)
    figure = Motion(label="F", caption="c", problem=limited, durations=(5.0, 5.0))
    drawn = draw(figure, NO_RUNS, "a")
    assert "limit 20" in texts(drawn)
    assert len(rows_of(drawn.frame)[0]) == 2 + 4 * 6


def test_tool_path_tells_how_far_the_print_lies_off() -> None:
    arm = MinimumTime(
        waypoints=((0.0, 0.0), (np.pi / 2, 0.0)),
        law=quintic,
        velocity=(1.0, 1.0),
        acceleration=(1.0, 1.0),
        durations=(0.1, 5.0),
    )
    figure = ToolPath(
        label="F",
        caption="c",
        problem=arm,
        dh=((1.0, 0.0, 0.0), (1.0, 0.0, 0.0)),
        convention="standard",
        printed_waypoints=((2.0, 0.0, 0.0), (0.0, 2.0, 0.003)),
    )
    drawn = draw(figure, NO_RUNS, "a")
    assert "0.00, 3.00 mm" in drawn.description
    assert ("printed waypoint", "2", "0", "2", "0.003") in rows_of(drawn.frame)
    path = [row for row in rows_of(drawn.frame) if row[0] == "tool path"]
    radii = [np.hypot(float(x), float(y)) for _, _, x, y, _ in path]
    assert radii == pytest.approx([2.0] * len(path), rel=1e-5)


def relative_luminance(colour: str) -> float:
    """Return WCAG 2.2's relative luminance of a colour in hexadecimal notation."""
    shares = np.array([int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5)])
    linear = np.where(shares <= 0.04045, shares / 12.92, ((shares + 0.055) / 1.055) ** 2.4)
    return float(linear @ [0.2126, 0.7152, 0.0722])


@pytest.mark.parametrize("ground", ["#ffffff", "#111111"])
@pytest.mark.parametrize("colour", [colour for colour in COLOURS if colour != "#000000"])
def test_every_colour_stands_out_in_light_and_dark(colour: str, ground: str) -> None:
    low, high = sorted((relative_luminance(colour), relative_luminance(ground)))
    assert (high + 0.05) / (low + 0.05) >= 3  # WCAG 2.2, criterion 1.4.11


def styles() -> Iterator[tuple[str, str]]:
    for index in range(42):
        style = line_style(index)
        yield style["color"], str(style["linestyle"])


def test_no_two_of_many_curves_look_alike() -> None:
    assert len(set(styles())) == 42
    first = list(styles())[:6]
    assert len({dashes for _, dashes in first}) == len({colour for colour, _ in first}) == 6
