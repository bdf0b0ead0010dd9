"""The share of targets that runs reach against iterations, all problems together.

Targets are those of COCO: N. Hansen et al., COCO: a platform for comparing continuous optimizers,
Optimization Methods and Software 36 (2021), with 51 of them between the worst and the best that is
shown on each problem, equally far apart in log cost where costs are above 0.
"""

import numpy as np
import pandas as pd
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from repro.model.evidence import Evidence
from repro.model.experiment import Experiment
from repro.report.drawings.convergence import CostScale
from repro.report.drawings.style import CURVE_POINTS, Plot, line_style, panels_two_abreast

Vector = NDArray[np.float64]
TARGETS = 51
HEADINGS = ("algorithm", "iteration", "share of targets reached")


def ecdf_plot(experiment: Experiment, evidence: Evidence) -> Plot:
    """Return, for each algorithm, the share of (problem, run, target) that is reached by then."""
    names = [n for n in experiment.algorithms if any(cell[2] == n for cell in evidence.runs)]
    shares = {name: reached(experiment, evidence, name) for name in names}
    steps = {  # at another budget a search has other iterations
        name: np.unique(np.linspace(0, len(share) - 1, CURVE_POINTS).round().astype(int))
        for name, share in shares.items()
    }
    styles = {name: line_style(list(experiment.algorithms).index(name)) for name in names}
    legend = [Line2D([], [], label=name, **styles[name]) for name in names]
    canvas, (axes,) = panels_two_abreast(1, height=2.2, legend=legend, gaps=(0.6, 0.6))
    for name in names:
        axes.plot(steps[name] + 1.0, shares[name][steps[name]], **styles[name])
    axes.set(ylim=(0.0, 1.02), xlabel="iteration", ylabel="share of targets")
    ends = ", ".join(f"{name} {shares[name][-1]:.2f}" for name in names)
    return Plot(
        canvas=canvas,
        description=f"Share of {TARGETS} targets a problem, between the worst and the best that is "
        f"shown, that runs have reached; at the end: {ends}.",
        frame=pd.DataFrame(
            [(name, k + 1, shares[name][k]) for name in names for k in steps[name]],
            columns=list(HEADINGS),
        ),
    )


def reached(experiment: Experiment, evidence: Evidence, algorithm: str) -> Vector:
    """Return the share of targets reached after each iteration, over runs and problems."""
    found = []
    for problem in experiment.problems:
        every = [r.histories[0] for (_, p, _), r in evidence.runs.items() if p == problem]
        own = evidence.runs.get((experiment.name, problem, algorithm))
        if own is None or not every:
            continue
        finite = np.concatenate([h[np.isfinite(h)] for h in every])
        scale = CostScale.of(finite)
        places = scale.place(finite)
        targets = np.linspace(places.max(), places.min(), TARGETS + 1)[1:]
        history = scale.place(
            np.where(np.isfinite(own.histories[0]), own.histories[0], finite.max())
        )
        found.append((history[:, :, None] <= targets).mean(axis=(0, 2)))
    longest = max(map(len, found))
    held = [np.concatenate([each, np.full(longest - len(each), each[-1])]) for each in found]
    return np.asarray(np.mean(held, axis=0))
