from dataclasses import replace

import numpy as np
import pytest

from repro.judge.certificates import certify
from repro.judge.times_found import CertificateBeatenError, found_times
from repro.model.evidence import Evidence, Runs
from repro.report.views.times import time_cells
from tests.doe2021 import ARM, PAPER
from tests.small_papers import evidence_of

(CERTIFICATE,) = certify(PAPER)
LEAST = float(ARM.shortest().sum())


def evidence(durations: list[float]) -> Evidence:
    points = np.array([[[duration] for duration in durations]])
    runs = Runs(costs=points[..., 0], points=points, histories=points, evaluations=1)
    return evidence_of(PAPER, {("motion", "arm", "WOA"): runs})


def test_times_are_shown_as_ratios_to_the_minimum() -> None:
    (found,) = found_times(CERTIFICATE, evidence([LEAST, 3 * LEAST]))
    assert found.least_ratio == pytest.approx(1.0)
    assert found.mean_ratio == pytest.approx(2.0)
    labels = [label for label, _, _ in time_cells(CERTIFICATE, [found])]
    assert labels[-2:] == ["re-run: WOA, all repeats, mean", "re-run: WOA, all repeats, best"]


def test_a_time_that_breaks_a_limit_counts_as_the_time_that_keeps_it() -> None:
    (found,) = found_times(CERTIFICATE, evidence([0.5 * LEAST]))
    assert found.least == LEAST


def test_a_run_that_claims_to_beat_the_certificate_fails_loudly() -> None:
    stricter = replace(CERTIFICATE, lower_bound=1.01 * LEAST)
    with pytest.raises(CertificateBeatenError, match="below the proved"):
        found_times(stricter, evidence([LEAST]))


def test_a_cost_that_is_least_where_limits_are_broken_is_not_compared() -> None:
    broken = replace(CERTIFICATE, minimum=None)
    assert found_times(broken, evidence([LEAST])) == ()


def test_a_time_outside_the_box_of_durations_is_no_time_found() -> None:
    too_short, too_long = 0.5 * ARM.durations[0], 2.0 * ARM.durations[1]

    (found,) = found_times(CERTIFICATE, evidence([too_short, 2 * LEAST, too_long]))

    assert (found.least, found.mean) == (2 * LEAST, 2 * LEAST)
    assert found_times(CERTIFICATE, evidence([too_long])) == ()
