import re
from xml.etree import ElementTree as ET

from repro.judge.centre_bias import FLAG, Bias
from repro.report.drawings.centre_bias import bias_plot
from repro.report.drawings.draw import Drawing, drawing
from tests.written_rows import rows_of

SVG = "{http://www.w3.org/2000/svg}"
NAMES = ("WOA", "random search (floor)")


def bias(algorithm: str, shift: float, ratio: float) -> Bias:
    return Bias(
        algorithm=algorithm,
        shift=shift,
        ratios={"F1": ratio, "F2": ratio},
        ratio=ratio,
        interval=(ratio / 2, 3 * ratio),
        p=0.25,
    )


FOUND = [
    bias("WOA", 0.1, 4e4),
    bias("WOA", 0.2, 7e6),
    *(bias(NAMES[1], s, 1.0) for s in (0.1, 0.2)),
]


def drawn(found: list[Bias]) -> Drawing:
    return drawing(lambda: bias_plot(NAMES, found), title="Bias", identifier="bias")


def texts(shown: Drawing) -> list[str]:
    root = ET.fromstring(shown.svg)  # noqa: S314 (our own text)
    return [element.text or "" for element in root.iter(f"{SVG}text")]


def test_algorithms_shifts_and_the_flag_are_named() -> None:
    assert {*NAMES, "shift 0.1", "shift 0.2", f"{FLAG:g}: centre bias"} <= set(texts(drawn(FOUND)))


def test_description_says_every_ratio_and_who_is_flagged() -> None:
    description = drawn(FOUND).description

    assert "WOA 40000 at 0.1, 7.00×10^6 at 0.2; random search (floor) 1 at 0.1" in description
    assert description.endswith("biased to the centre: WOA.")
    assert drawn(FOUND[2:]).description.endswith("biased to the centre: none.")


def test_data_hold_the_mean_and_every_problem() -> None:
    headings, *rows = rows_of(drawn(FOUND).frame)

    assert headings == ("algorithm", "shift", "problem", "ratio", "low", "high", "p by Holm")
    assert len(rows) == 4 * 3
    assert rows[0] == ("WOA", "0.1", "geometric mean", "40000", "20000", "120000", "0.25")
    assert rows[1] == ("WOA", "0.1", "F1", "40000", "", "", "")


def test_the_flag_stands_on_the_axis_even_where_all_ratios_are_near_one() -> None:
    shown = drawn(FOUND[2:])
    box = re.search(r'viewBox="0 0 ([\d.]+) ([\d.]+)"', shown.svg)

    assert box
    (x,) = re.findall(r'd="M ([\d.]+) [\d.]+ L \1 [\d.]+"[^>]*stroke-dasharray: 4', shown.svg)
    assert 0 < float(x) < float(box[1])


def test_drawing_is_light_and_the_same_again() -> None:
    assert drawn(FOUND) == drawn(FOUND)
    assert len(drawn(FOUND).svg) < 20_000
