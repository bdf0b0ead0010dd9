from xml.etree import ElementTree as ET

import pytest

from repro.judge.proved_times import ProvedTime
from repro.judge.times_beside import TimeBeside, TimesBeside
from repro.report.drawings.draw import Drawing, drawing
from repro.report.drawings.times import BREAKS, times_plot
from tests.written_rows import rows_of

SVG = "{http://www.w3.org/2000/svg}"
PROVED = ProvedTime(
    experiment="motion", problem="arm", certificate="motion/arm", least=4.478, bound=4.478,
    readings=(4.9,), algorithm="IWOA", printed=4.69,
)  # fmt: skip


def time(name: str, value: float | None, printed: float | None = None, *,
         baseline: bool = False) -> TimeBeside:  # fmt: skip
    ends = None if value is None else (value, value + 0.1)
    return TimeBeside(name=name, baseline=baseline, printed=printed, value=value, interval=ends)


FOUND = TimesBeside(
    proved=PROVED,
    rows=(
        time("IWOA", 4.4784, 4.69),
        time("told only", None, 5.0),
        time("CMA-ES (cmaes)", 4.478, baseline=True),
    ),
)


def drawn(found: TimesBeside = FOUND) -> Drawing:
    return drawing(lambda: times_plot(found), title="Times", identifier="times")


def texts(shown: Drawing) -> set[str]:
    root = ET.fromstring(shown.svg)  # noqa: S314 (our own text)
    return {element.text or "" for element in root.iter(f"{SVG}text")}


def test_searches_marks_and_the_unit_are_named() -> None:
    assert {"IWOA", "CMA-ES", "printed", "re-run", "baseline", "whole time of the motion [s]",
            "proved least: 4.478 s", "least under another reading"} <= texts(drawn())  # fmt: skip


def test_the_text_alternative_has_every_number() -> None:
    assert drawn().description == (
        "IWOA printed 4.69 s, re-run 4.4784 s (4.4784 to 4.5784 s); told only printed 5 s; "
        "CMA-ES (cmaes) mean 4.4780 s (4.4780 to 4.5780 s); proved least: 4.478 s, under other "
        "readings of the motion 4.9000 s."
    )


def test_data_hold_every_mark_and_line() -> None:
    _, *rows = rows_of(drawn().frame)

    assert [(row[1], row[2]) for row in rows] == [
        ("printed", "4.69"),
        ("re-run", "4.4784"),
        ("printed", "5"),
        ("baseline", "4.478"),
        ("proved minimum", "4.478"),
        ("proved minimum, other reading", "4.9"),
    ]


@pytest.mark.parametrize(("printed", "breaks"), [(4.69, False), (2.3, True)])
def test_a_time_below_the_bound_is_said_to_break_a_limit(printed: float, breaks: bool) -> None:  # noqa: FBT001 (a case)
    found = TimesBeside(proved=PROVED, rows=(time("IWOA", 4.5, printed),))

    assert (BREAKS in drawn(found).description) is breaks
