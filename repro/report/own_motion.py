"""A motion of a user's own as files: samples for a controller, and a page with drawings."""

import json
from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

import numpy as np
from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup
from numpy.typing import NDArray

from repro.judge.own_motion import OwnResult
from repro.report.drawings.own_arm import still
from repro.report.drawings.own_motion import joint_plots
from repro.report.drawings.style import drawing_style
from repro.report.drawings.svg import inline_svg
from repro.robotics.own_motion import increasing, sampled

Vector = NDArray[np.float64]
ROWS = 50  # samples of a segment in a CSV
FRAMES = 160  # of a moving arm, about


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
    heading = ["time_from_start", *(f"{kind}.{name}" for kind in kinds for name in found.names)]
    lines = [",".join(f'"{cell}"' if "," in cell else cell for cell in heading)]
    lines += [
        ",".join([repr(time), *(f"{value:.12g}" for value in line)])
        for time, line in zip(times[kept].tolist(), values.tolist(), strict=True)
    ]
    return "\n".join(lines) + "\n"


def page(found: OwnResult, *, says: Sequence[str]) -> str:
    """Return the page as HTML that needs nothing else; `says` are its paragraphs."""
    environment = Environment(
        loader=PackageLoader("repro.report"), autoescape=True, undefined=StrictUndefined
    )
    environment.policies["json.dumps_kwargs"] = {"allow_nan": False}
    drawn = bool(found.certificate.at)
    postures = _postures(found) if drawn and found.chain else None
    with drawing_style():
        plots = _svg(joint_plots(found), "joints", "The joints over time") if drawn else ""
        arm = _svg(still(postures[1], found.problem), "arm", "The arm") if postures else ""
    scene = None
    if postures:
        times, corners = postures
        scene = {
            "times": np.round(times / times[-1], 6).tolist(),
            "seconds": float(f"{times[-1]:.6g}"),
            "corners": np.round(corners, 5).tolist(),
            "angles": [[f"{value:.4g}" for value in line] for line in _angles(found)[1].tolist()],
            "names": [f"{n} [{u}]" for n, u in zip(found.names, found.units, strict=True)],
        }
    template = environment.get_template("own_motion.html.jinja")
    return template.render(
        title=found.title,
        says=says,
        plots=Markup(plots),  # noqa: S704 (our own drawing, whose texts are escaped)
        arm=Markup(arm),  # noqa: S704
        scene=scene and Markup(json.dumps(scene).replace("<", "\\u003c")),  # noqa: S704
    )


def _svg(canvas: Any, identifier: str, title: str) -> str:  # noqa: ANN401 (matplotlib's)
    return inline_svg(canvas, identifier=identifier, title=title, description=title)


def _angles(found: OwnResult) -> tuple[Vector, Vector]:
    at = np.array(found.certificate.at)
    samples = max(3, FRAMES // len(at))
    times, values = sampled(found.problem, at, derivative=0, samples=samples)
    kept = increasing(times)
    return times[kept], values[kept]


def _postures(found: OwnResult) -> tuple[Vector, Vector]:
    """Return times (n,) and the corners of the arm's links (n, joints + 2, 3) in m."""
    times, values = _angles(found)
    chain = found.chain
    if chain is None:
        return times, np.zeros((0, 0, 3))
    return times, np.array([chain.corners(q) for q in values * np.array(found.si)])
