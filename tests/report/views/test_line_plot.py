import math

from repro.judge.certificates import certify
from repro.report.views.line_plot import drawn_ends, drawn_number, least_values
from tests.doe2021 import PAPER
from tests.report.views.test_findings import finding


def test_only_a_total_time_of_a_certified_motion_has_a_proved_least() -> None:
    (certificate, *_) = certify(PAPER)

    least = dict(zip(PAPER.claims, least_values(PAPER.claims, [certificate]), strict=True))

    assert {claim.printed.text: value for claim, value in least.items() if value} == {
        "2.357": certificate.minimum,
        "2.1": certificate.minimum,
        "2.36": certificate.minimum,
    }


def test_what_is_drawn_is_printed_number_band_interval_and_least() -> None:
    found = finding("F1", printed="2.5", accepted=(2.0, 3.0), measured=(1.0, math.inf))

    assert drawn_number(found, 0.5) == "2.5,2,3,1,,0.5"
    assert drawn_number(finding("F1", printed="2.5", measured=None), None) == ""
    assert drawn_ends((1 / 3, 1e-30)) == "0.333333,1e-30"
