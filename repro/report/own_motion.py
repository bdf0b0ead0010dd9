"""A motion of a user's own as files: samples for a controller, and a page with drawings."""

import csv
import io
from collections.abc import Iterator, Sequence
from dataclasses import asdict
from typing import Any

import numpy as np
from numpy.typing import NDArray

from repro.judge.own_motion import OwnResult
from repro.report.arm_page import arm_drawing, arm_page
from repro.report.drawings.arm_motion import SAMPLES, Moving
from repro.report.drawings.chain_postures import postures
from repro.report.drawings.draw import Drawing, drawing
from repro.report.drawings.own_motion import joints_plot
from repro.report.escapes import csv_value
from repro.robotics.chain import Chain
from repro.robotics.own_motion import increasing, points_of, sampled
from repro.robotics.polynomial_motion import KINDS
from repro.robotics.whereabouts import below

Vector = NDArray[np.float64]
ROWS = 50  # samples of a segment in a CSV
LEAST = 5  # samples of a segment on a page
SLACK = 1e-6  # m below the base plane that are rounding


def row(found: OwnResult) -> dict[str, Any]:
    """Return the certificate as one row for JSON, with what stands beside it."""
    return {
        **asdict(found.certificate),
        "lost": [asdict(loss) for loss in found.losses],
        "beside": [
            {"planner": each.planner, "what": each.what, "time": each.time, "skipped": each.skipped}
            for each in found.beside
        ],
    }


def csv_text(found: OwnResult) -> str:
    """Return samples in rad, m and s, as a ROS JointTrajectory wants them.

    Instants are strictly increasing; a column per joint for positions, velocities and
    accelerations.
    """
    at = np.array(found.certificate.at)
    parts = [sampled(found.problem, at, derivative=m, samples=ROWS) for m in range(3)]
    times = parts[0][0]
    kept = increasing(times)
    values = np.hstack([values * np.array(found.si) for _, values in parts])[kept]
    kinds = ("positions", "velocities", "accelerations")
    text = io.StringIO()
    rows = csv.writer(text, lineterminator="\n")
    headings = (f"{kind}.{name}" for kind in kinds for name in found.names)
    rows.writerow(["time_from_start", *map(csv_value, headings)])
    rows.writerows(
        [repr(time), *(f"{value:.12g}" for value in line)]
        for time, line in zip(times[kept].tolist(), values.tolist(), strict=True)
    )
    return text.getvalue()


def page(found: OwnResult, *, says: Sequence[str]) -> str:
    """Return the page as HTML that needs nothing else; `says` are its paragraphs."""
    return arm_page(found.title, tuple(_drawings(found)), says=says)


def _drawings(found: OwnResult) -> Iterator[Drawing]:
    if not found.certificate.at:
        return
    if found.chain is not None:
        yield _arm(found, found.chain)
    title = f"{found.title}: the joints over time"
    yield drawing(lambda: joints_plot(found), title=title, identifier="joints")


def _arm(found: OwnResult, chain: Chain) -> Drawing:
    motion = _moving(found, chain)
    units = [
        (name, "mm" if unit == "m" else "°")
        for name, unit in zip(found.names, found.units, strict=True)
    ]
    return arm_drawing(
        f"{found.title}: the arm",
        [motion],
        postures(chain, np.array(points_of(found.problem)) * np.array(found.si)),
        joints=units,
        notes=tuple(_below_base(motion)),
    )


def _moving(found: OwnResult, chain: Chain) -> Moving:
    at = np.array(found.certificate.at)
    orders = range(4 if "jerk" in found.limits else 3)
    samples = max(LEAST, SAMPLES // len(at))
    parts = [sampled(found.problem, at, derivative=m, samples=samples) for m in orders]
    kept = increasing(parts[0][0])
    angles, *moved = (values[kept] for _, values in parts)
    angles = angles * np.array(found.si)
    return Moving(
        name="proved motion" if found.certificate.minimum is not None else "motion found",
        durations=tuple(at.tolist()),
        times=parts[0][0][kept],
        postures=postures(chain, angles),
        angles=angles,
        shares=np.stack(
            [_share(values, found.limits[KINDS[m]]) for m, values in enumerate(moved, start=1)],
            axis=1,
        ),
    )


def _share(values: Vector, limits: Sequence[Sequence[float]]) -> Vector:
    """Return how much of its limit on that side each joint uses, shape (n, joints)."""
    low, high = np.array(limits).T
    return np.asarray(np.maximum(values / high, values / low))


def _below_base(motion: Moving) -> Iterator[str]:
    """Yield for how long, and how deep, links or tool are below the base plane."""
    heights = {
        "lowest link": np.array([posture.corners[:, 2].min() for posture in motion.postures]),
        "tool": motion.tool[:, 2],
    }
    for what, values in heights.items():
        found = below(motion.times, values, -SLACK)
        if found.lasting > 0.0:
            yield (
                f"The {what} is below the base plane for {found.lasting:.3g} s of "
                f"{motion.total:.4g} s, down to {found.least:.3g} m."
            )
