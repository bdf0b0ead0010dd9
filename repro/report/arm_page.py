"""A page that shows any arm on its motions, drawn and live."""

from collections.abc import Sequence
from dataclasses import replace

from repro.report.drawings.arm import motions_plot
from repro.report.drawings.arm_motion import Moving
from repro.report.drawings.draw import Drawing, drawing
from repro.report.rendering import render
from repro.robotics.skeleton import Skeleton


def arm_drawing(
    title: str,
    motions: Sequence[Moving],
    stops: Sequence[Skeleton],
    *,
    joints: Sequence[tuple[str, str]] = (),
    notes: Sequence[str] = (),
    identifier: str = "arm",
) -> Drawing:
    """Return an arm ready for a page: the first motion solid, a second as its ghost.

    `stops` are the postures at the waypoints, `joints` name and unit (° or mm) of each joint,
    numbers and ° where empty; `notes` are told below the arm, as text. All motions have the same
    corners, whatever chain they are of.
    """
    told = f"An arm of {len(motions[0].postures[0].joints)} joints, as lines through its links"
    made = drawing(
        lambda: motions_plot(motions, stops, told=told, joints=joints),
        title=title,
        identifier=identifier,
    )
    return replace(made, notes=tuple(notes))


def arm_page(title: str, drawings: Sequence[Drawing], *, says: Sequence[str] = ()) -> str:
    """Return a whole HTML page: what is said, a line each, and drawings, an arm live."""
    return render("arm.html", {"title": title, "drawings": tuple(drawings), "says": tuple(says)})
