"""What the pages draw from the runs themselves, beside the verdicts on what is printed."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from repro.judge.findings import Finding
from repro.model.evidence import Evidence
from repro.report.drawings.style import Rows
from repro.report.files import csv_text
from repro.report.views.algorithms import Comparison, comparisons
from repro.report.views.centre_bias import CentreBias, centre_biases
from repro.report.views.distribution import Distribution, distributions
from repro.report.words import anchor
from repro.runs.moved_optima import centred


@dataclass(frozen=True, slots=True, kw_only=True)
class RunsView:
    """Tests between algorithms, what they do off the centre, and how their runs are spread.

    `shiftable` says whether any problem has its optimum about the centre.
    """

    comparisons: tuple[Comparison, ...]
    centre_biases: tuple[CentreBias, ...]
    distributions: tuple[Distribution, ...]
    shiftable: bool

    def context(self) -> dict[str, object]:
        """Return what the templates name."""
        return {
            "comparisons": self.comparisons,
            "centre_biases": self.centre_biases,
            "distributions": self.distributions,
            "shiftable": self.shiftable,
        }

    def files(self, key: str) -> dict[str, str]:
        """Return the CSV files of a paper's page, by their place in the reports folder."""
        return {f"tables/{key}-{name}.csv": csv_text(rows) for name, rows in self.tables().items()}

    def tables(self) -> Mapping[str, Rows]:
        """Return the data of everything shown, by the name of its file."""
        named = [
            (kind, c.experiment.name, rows) for c in self.comparisons for kind, rows in c.tables()
        ]
        named += [("centre bias", b.experiment.name, b.drawing.rows) for b in self.centre_biases]
        spread = {each.name: each.drawing.rows for each in self.distributions}
        return {anchor(kind, name): rows for kind, name, rows in named} | spread


def runs_view(evidence: Evidence, findings: Sequence[Finding]) -> RunsView:
    """Return what is shown of a paper's runs; `findings` are those of its claims, in order."""
    return RunsView(
        comparisons=comparisons(evidence, findings),
        centre_biases=centre_biases(evidence),
        distributions=distributions(evidence),
        shiftable=any(map(centred, evidence.paper.experiments)),
    )
