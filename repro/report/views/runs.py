"""What the pages draw from the runs themselves, beside the verdicts on what is printed."""

from collections.abc import Mapping
from dataclasses import dataclass

import pandas as pd

from repro.judge.judgement import Judgement
from repro.model.identifiers import anchor
from repro.report.drawings.draw import Drawing
from repro.report.drawings.svg import standalone
from repro.report.frames import DIGITS, csv_text
from repro.report.views.algorithms import AlgorithmsView, algorithms_views
from repro.report.views.centre_bias import CentreBiasView, centre_bias_view
from repro.report.views.distribution import Distribution, distributions
from repro.runs.moved_optima import centred


@dataclass(frozen=True, slots=True, kw_only=True)
class RunsView:
    """Tests between algorithms, what they do off the centre, and how their runs are spread.

    `shiftable` says whether any problem has its optimum about the centre, `outside` which searches
    left the box.
    """

    comparisons: tuple[AlgorithmsView, ...]
    centre_biases: tuple[CentreBiasView, ...]
    distributions: tuple[Distribution, ...]
    shiftable: bool
    outside: tuple[str, ...] = ()

    def context(self) -> dict[str, object]:
        """Return what the templates name."""
        return {
            "comparisons": self.comparisons,
            "centre_biases": self.centre_biases,
            "distributions": self.distributions,
            "shiftable": self.shiftable,
            "outside": self.outside,
        }

    def files(self, key: str) -> dict[str, str]:
        """Return the CSV and SVG files of a paper, by their place in the reports folder."""
        tables = {
            f"tables/{key}-{name}.csv": csv_text(frame, DIGITS)
            for name, frame in self.tables().items()
        }
        figures = {
            f"figures/{key}-{name}.svg": standalone(drawing.svg)
            for name, drawing in self.drawings().items()
        }
        return tables | figures

    def drawings(self) -> Mapping[str, Drawing]:
        """Return what is drawn, by the name of its files."""
        ranks = {
            anchor("ranks", each.experiment.name): each.ranking.drawing
            for each in self.comparisons
            if each.ranking
        }
        biases = {
            anchor("centre bias", each.found.experiment.name): each.drawing
            for each in self.centre_biases
        }
        return ranks | biases | {each.name: each.drawing for each in self.distributions}

    def tables(self) -> Mapping[str, pd.DataFrame]:
        """Return the data of everything shown, by the name of its file."""
        named = [
            (kind, c.experiment.name, frame) for c in self.comparisons for kind, frame in c.tables()
        ]
        named += [
            ("centre bias", b.found.experiment.name, b.drawing.frame) for b in self.centre_biases
        ]
        spread = {each.name: each.drawing.frame for each in self.distributions}
        return {anchor(kind, name): frame for kind, name, frame in named} | spread


def runs_view(judgement: Judgement) -> RunsView:
    """Return what is shown of a paper's runs."""
    paper = judgement.paper
    return RunsView(
        comparisons=algorithms_views(judgement),
        centre_biases=tuple(centre_bias_view(paper.key, b) for b in judgement.centre_biases),
        distributions=distributions(paper, judgement.evidence),
        shiftable=any(map(centred, paper.experiments)),
        outside=tuple(each.says for each in judgement.outside if each.outside),
    )
