"""The chart of cost against work: seconds of one run by its evaluations, both on decades."""

import io
from collections.abc import Mapping, Sequence

from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure

from repro.report.drawings.style import GRID, WIDTH, drawing_style, line_style

Curves = Mapping[str, Sequence[tuple[float, float]]]


def chart(curves: Curves) -> str:
    """Return the chart as SVG; a curve is its points (evaluations, seconds)."""
    text = io.StringIO()
    with drawing_style():
        figure = Figure(figsize=(WIDTH, WIDTH), layout="constrained")
        FigureCanvasSVG(figure)
        axes = figure.add_subplot()
        for index, (label, points) in enumerate(curves.items()):
            x, y = zip(*sorted(points), strict=True)
            axes.loglog(x, y, label=label, marker=".", **line_style(index))
        axes.set_xlabel("evaluations of one run")
        axes.set_ylabel("seconds")
        axes.grid(**GRID)
        figure.legend(loc="outside lower center", ncols=2, frameon=False)
        figure.savefig(text, format="svg", metadata={"Date": None})
    return text.getvalue()
