"""A measure of one's own: what share of the runs ends below a threshold."""

from dataclasses import dataclass
from typing import ClassVar

from repro.determinism.seeds import generator
from repro.model import Measured
from repro.statistics.tables import next_tables


@dataclass(frozen=True, kw_only=True)
class ShareBelow:
    """The share of runs, in percent, whose cost is below a threshold."""

    follows: ClassVar[bool] = False  # it looks at the ends of the runs alone
    cell: tuple[str, str, str]
    threshold: float

    @property
    def words(self):
        """Return what is measured, as a phrase."""
        return f"share of runs of {self.cell[2]} below {self.threshold:g}"

    def cells(self):
        """Return the cells of runs that it needs: (experiment, problem, algorithm)."""
        return (self.cell,)

    def measure(self, evidence):
        """Return the share in the first repeat, and in tables that may come next."""
        costs = evidence.values(self.cell)  # shape (repeats, runs)
        rng = generator("share below", evidence.key, *self.cell)
        tables = next_tables(costs, tables=2000, rng=rng)  # shape (2000, runs)
        share = [100.0 * (table < self.threshold).mean(axis=-1) for table in (costs, tables)]
        return Measured(value=float(share[0][0]), draws=share[1], repeats=len(costs))
