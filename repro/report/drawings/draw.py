"""The counterpart of a paper's figure: a drawing, what it says in words, and its data."""

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import pandas as pd

from repro.model.assumptions import Assumption
from repro.model.evidence import Evidence
from repro.model.figures import Arm, Convergence, Figure, JointCurves, Motion, SplineMotion
from repro.report.drawings.arm import arm_plot
from repro.report.drawings.convergence import HEADINGS, convergence_plot
from repro.report.drawings.fitted_curves import joint_curves_plot
from repro.report.drawings.motion import motion_plot
from repro.report.drawings.spline import spline_plot
from repro.report.drawings.style import Plot, Scene, drawing_style, empty
from repro.report.drawings.svg import inline_svg
from repro.report.drawings.tool_path import tool_path_plot

NOTHING = "No runs yet"
_FIRST = re.compile(r"[.:;] (?=\D)")  # the end of what is said before numbers are


@dataclass(frozen=True, slots=True, kw_only=True)
class Drawing:
    """A figure ready for a page.

    `svg` is one inline element in the page's own text colour; `title` is label and caption;
    `description` says in words what is drawn, with its main numbers; `frame` holds the data;
    `scene`, where there is one, is what an interactive view of it draws; `notes` are what is to be
    known of it.
    """

    svg: str
    title: str
    description: str
    frame: pd.DataFrame = field(compare=False)  # a frame is equal to none as a whole
    scene: Scene | None = None
    notes: tuple[str, ...] = ()

    @property
    def caption(self) -> str:
        """What is drawn, as one sentence: the description up to its first numbers."""
        return _FIRST.split(self.description, maxsplit=1)[0].removesuffix(".") + "."


def draw(
    figure: Figure,
    evidence: Evidence,
    identifier: str,
    *,
    assumptions: Sequence[Assumption] = (),
) -> Drawing:
    """Return the drawing of a declared figure; where no run is there yet, it says so.

    `assumptions` are the paper's, of which a picture of an arm names some.

    `identifier` begins every id in the SVG, so it must differ between the drawings of a page.
    The same arguments give the same bytes.
    """
    title = f"{figure.label}: {figure.caption}"
    return drawing(
        lambda: plot_of(figure, evidence, assumptions), title=title, identifier=identifier
    )


def drawing(plotted: Callable[[], Plot], *, title: str, identifier: str) -> Drawing:
    """Return what `plotted` draws, in our style, ready for a page."""
    with drawing_style():
        plot = plotted()
        svg = inline_svg(
            plot.canvas, identifier=identifier, title=title, description=plot.description
        )
    return Drawing(
        svg=svg, title=title, description=plot.description, frame=plot.frame, scene=plot.scene
    )


def plot_of(figure: Figure, evidence: Evidence, assumptions: Sequence[Assumption]) -> Plot:
    """Return a declared figure as it is drawn; where no run is there yet, it says so."""
    if isinstance(figure, Arm):
        return arm_plot(figure, assumptions)
    if isinstance(figure, Convergence):
        return convergence_plot(figure, evidence) or _nothing()
    if isinstance(figure, Motion):
        return motion_plot(figure, evidence) or _nothing()
    if isinstance(figure, SplineMotion):
        return spline_plot(figure, evidence)
    if isinstance(figure, JointCurves):
        return joint_curves_plot(figure, evidence)
    return tool_path_plot(figure)


def _nothing() -> Plot:
    canvas = empty(0.6)
    canvas.text(0.5, 0.5, NOTHING, ha="center", va="center")
    return Plot(
        canvas=canvas, description=f"{NOTHING}.", frame=pd.DataFrame(columns=list(HEADINGS))
    )
