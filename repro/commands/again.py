"""One printed number once more: run what it needs, and nothing else."""

from concurrent.futures import Executor
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

from repro.errors import InputError, ReproError
from repro.model.claims import CellClaim, Claim
from repro.model.paper import Paper
from repro.report.words import digits_for, identifiers, interval, number
from repro.runs.plan import plan
from repro.runs.session import gather, run_missing
from repro.runs.store.store import Store
from repro.tables.published import UNITS

MOST_NAMES = 8  # that an error lists


class RunFailedError(ReproError):
    """A run that was asked for by name gave no result."""

    exit_code = 1


@dataclass(frozen=True, slots=True, kw_only=True)
class Again:
    """A claim, and what the first repeat of the protocol gives for it here and now."""

    claim: Claim
    value: float
    runs: int

    @property
    def text(self) -> str:
        """Lines for a terminal, in the digits of the pages."""
        claim = self.claim
        worded = not isinstance(claim, CellClaim) and claim.in_words
        digits = 4 if worded else digits_for(claim.printed)
        unit = f" {claim.printed.unit}".rstrip()
        runs = f"{self.runs} run{'s' * (self.runs > 1)}"
        how = f"first repeat, {runs}" if self.runs else "computed, no run"
        return (
            f"{', '.join(_place(claim))}\n"
            f"  printed   {'in words' if worded else claim.printed.text + unit}\n"
            f"  re-run    {number(self.value, digits)}{unit}"
            f" ({claim.measure.words if claim.measure else ''}; {how})\n"
            f"  accepted  {interval(claim.accepted.band(claim.printed), digits)}{unit}\n"
        )


def run_again(
    paper: Paper, name: str, *, executor: Executor, workers: int, master_seed: str = ""
) -> Again:
    """Run the first repeat of what one claim needs; `name` is its identifier on the pages.

    Raises InputError where no claim, or more than one, has that name and where the paper lacks
    what a re-run needs, RunFailedError where a run fails.
    """
    claim = named_claim(paper, name)
    if claim.measure is None:
        why = claim.gap.because if not isinstance(claim, CellClaim) and claim.gap else ""
        message = f"{name} cannot be run: {why}"
        raise InputError(message)
    needed = set(claim.measure.cells())
    tasks = [
        t for t in plan([paper], 1, master_seed) if (t.experiment, t.problem, t.algorithm) in needed
    ]
    with TemporaryDirectory() as folder, Store(Path(folder)) as store:
        failed = run_missing(
            store, tasks, executor=executor, workers=workers, environment=dict, report=_silent
        )
        for record in failed:
            message = f"run {record.task.name} failed: {record.reason}"
            raise RunFailedError(message)
        measured = claim.measure.measure(gather(store, paper, tasks))
    return Again(claim=claim, value=measured.value / UNITS[claim.printed.unit], runs=len(tasks))


def named_claim(paper: Paper, name: str) -> Claim:
    """Return the claim of that identifier, or the only one with `name` in its identifier."""
    names = dict(zip(identifiers(map(_place, paper.claims)), paper.claims, strict=True))
    if name in names:
        return names[name]
    near = [known for known in names if name in known]
    if len(near) == 1:
        return names[near[0]]
    listed = "\n  ".join((near or list(names))[:MOST_NAMES])
    message = f"{paper.key} has {len(near) or 'no'} numbers named {name!r}; some names:\n  {listed}"
    raise InputError(message)


def _place(claim: Claim) -> tuple[str, ...]:
    if isinstance(claim, CellClaim):
        return claim.table.label, claim.row, claim.column
    return "claim", claim.claim


def _silent(_done: int, _of: int) -> None:
    """Report no progress."""
