"""`repro again`: one printed number once more; what it needs is run, and nothing else."""

import difflib
import sys
from argparse import Namespace
from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from repro.commands import catalogue
from repro.commands.arguments import STORE
from repro.commands.compare_entrants import entrant_in
from repro.commands.compiled_code import say_whether_kept
from repro.commands.shown_rows import warn
from repro.determinism.provenance import provenance
from repro.errors import InputError, ReproError
from repro.judge.findings import Finding, judged
from repro.model.claims import CellClaim, Claim
from repro.model.evidence import Evidence
from repro.model.identifiers import anchor, claim_names, place_of
from repro.model.paper import Paper
from repro.report.frames import without_end
from repro.report.results import read_results
from repro.report.words import count_of, digits_for, interval, number, verdict_words
from repro.runs.compared import tasks_of
from repro.runs.gather import gather
from repro.runs.plan import Task, plan
from repro.runs.run import execute
from repro.runs.session import mended, run_missing
from repro.runs.store.store import Store
from repro.runs.verify import Outcome, compare
from repro.runs.workers.local import checked_workers, local

MOST_NAMES = 3  # that an error lists
PLACE = ("table", "row", "column", "claim")  # by which a finding is told from others


class RunFailedError(ReproError):
    """A run that was asked for by name gave no result."""

    exit_code = 1


@dataclass(frozen=True, slots=True, kw_only=True)
class Again:
    """A claim, and what the first repeat of the protocol says of it here and now.

    `page` is the entry of the number in results.json, None where none says anything of it.
    """

    claim: Claim
    finding: Finding
    runs: int
    stored: int = 0
    page: Mapping[str, Any] | None = None

    @property
    def value(self) -> float:
        """What is measured, in the printed unit."""
        return self.finding.value if self.finding.value is not None else float("nan")

    @property
    def text(self) -> str:
        """Lines for a terminal, in the digits of the pages."""
        claim, found = self.claim, self.finding
        worded = not isinstance(claim, CellClaim) and claim.in_words
        digits = 4 if worded else digits_for(claim.printed)
        unit = f" {claim.printed.unit}".rstrip()
        runs = count_of(self.runs, "run")
        runs += f", {self.stored} of them from the store" if self.stored else ""
        how = f"first repeat, {runs}" if self.runs else "computed, no run"
        note = f"; {found.note}" if found.note else ""
        lines = (
            ", ".join(place_of(claim)),
            f"  printed   {'in words' if worded else claim.printed.text + unit}",
            f"  re-run    {number(self.value, digits)}{unit} ({found.measure}; {how})",
            f"  interval  {interval(found.measured, digits)}{unit}",
            f"  accepted  {interval(found.accepted, digits)}{unit} ({found.tolerance})",
            f"  verdict   {verdict_words(found.verdict, found.side)}{note}",
            *([f"  its page  {self._on_page(digits, unit)}"] if self.page else []),
        )
        return "".join(f"{line}\n" for line in lines)

    def _on_page(self, digits: int, unit: str) -> str:
        """Return what the pages say of the number, and whether the first repeat comes out again."""
        page = self.page or {}
        told = [verdict_words(page["verdict"], page["side"])]
        if page["turns_on"]:
            told.append(f"turns on {', '.join(page['turns_on'])}")
        if page["measured"]:
            ends = interval(without_end(page["measured"]), digits)
            depth = f" by {count_of(page['repeats'], 'repeat')}" if page["repeats"] else ""
            told.append(f"interval {ends}{unit}{depth}")
        if page["value"] is not None:
            first = number(page["value"], digits)
            same = "as here" if first == number(self.value, digits) else "which differs"
            told.append(f"re-run {first}{unit}, {same}")
        return "; ".join(told)


def run(options: Namespace) -> int:
    """Print what the first repeat gives for the number here and now."""
    paper = catalogue.chosen_one(options)
    if task := _compared_run(options, paper):
        return _run_of_search(task, options.store or STORE)
    workers = checked_workers(options.workers)
    say_whether_kept()
    with local(workers) as executor:
        found = run_again(
            paper,
            options.name,
            executor=executor,
            workers=workers,
            master_seed=options.master_seed,
            folder=options.store,
        )
    if not options.master_seed:
        found = replace(found, page=_entry(options.reports, paper.key, found.finding))
    sys.stdout.write(found.text)
    return 0


def _entry(reports: Path, key: str, found: Finding) -> Mapping[str, Any] | None:
    """Return what the results of a folder say of a number, None where they do not know it."""
    known = (read_results(reports / "results.json") or {"papers": []})["papers"]
    place = (found.table, found.row, found.column, found.claim)
    findings = (each for entry in known if entry["key"] == key for each in entry["findings"])
    return next((each for each in findings if tuple(map(each.get, PLACE)) == place), None)


def _compared_run(options: Namespace, paper: Paper) -> Task | None:
    """Return the run of a search that was compared, where the name is that of one."""
    tasks = tasks_of(options.store or STORE, [paper], entrant_in, warn)
    names = (options.name, f"{paper.key}/{options.name}")
    return next((task for task in tasks if task.name in names), None)


def _run_of_search(task: Task, folder: Path) -> int:
    """Make one run of a compared search again and show it beside the stored one."""
    with Store(folder, writing=False) as store:
        stored = next(iter(store.records([task])), None)
    made = execute(task)
    if made.reason:
        message = f"run {task.name} failed: {made.reason}"
        raise RunFailedError(message)
    before = "not stored" if stored is None else stored.reason or repr(stored.cost)
    same = stored is None or compare(stored, made).outcome is not Outcome.MISMATCH
    sys.stdout.write(
        f"{task.name}\n  stored    {before}\n  re-run    {made.cost!r} ({made.evaluations} "
        f"evaluations; {'the same' if same else 'another run'})\n"
    )
    return 0 if same else RunFailedError.exit_code


def run_again(
    paper: Paper,
    name: str,
    *,
    executor: Executor,
    workers: int,
    master_seed: str = "",
    folder: Path | None = None,
) -> Again:
    """Run the first repeat of what one claim needs; `name` is its identifier on the pages.

    What the store in a folder has is taken from there, and what it lacks is kept there. Raises
    InputError where no claim, or more than one, has that name and where the paper lacks what a
    re-run needs, RunFailedError where a run fails.
    """
    claim = named_claim(paper, name)
    if claim.measure is None or claim.gap:
        message = f"{name} cannot be run: {claim.gap.because if claim.gap else 'no measure'}"
        raise InputError(message)
    needed = set(claim.measure.cells())
    tasks = [
        t for t in plan([paper], 1, master_seed) if (t.experiment, t.problem, t.algorithm) in needed
    ]
    with TemporaryDirectory() as passing, Store(folder or Path(passing), say=warn) as store:
        stored = len(tasks) - len(store.missing(tasks))
        made = partial(_made, store, paper, tasks, executor=executor, workers=workers)
        finding, _ = judged(claim, mended(store, made))
    return Again(claim=claim, finding=finding, runs=len(tasks), stored=stored)


def _made(
    store: Store, paper: Paper, tasks: Sequence[Task], *, executor: Executor, workers: int
) -> Evidence:
    failed = run_missing(
        store, tasks, executor=executor, workers=workers, environment=provenance, report=_silent
    )
    for record in failed:
        message = f"run {record.task.name} failed: {record.reason}"
        raise RunFailedError(message)
    return gather(store, paper, tasks)


def named_claim(paper: Paper, name: str) -> Claim:
    """Return the claim of that identifier, or the only one with `name` in its identifier."""
    if not paper.claims:
        message = f"{paper.key} claims no printed number: there is none to run again"
        raise InputError(message)
    names = dict(zip(claim_names(paper.claims), paper.claims, strict=True))
    if name in names:
        return names[name]
    near = [known for known in names if name in known]
    if len(near) == 1:
        return names[near[0]]
    many = count_of(len(near), "number") if near else "no number"
    rest = f" and {len(near) - MOST_NAMES} more" if len(near) > MOST_NAMES else ""
    shown = ", ".join(near[:MOST_NAMES] or _like(name, names))
    message = (
        f"{paper.key} has {many} named {name!r}; "
        f"{'these' if near else 'the most like it'}: {shown}{rest}"
    )
    raise InputError(message)


def _like(name: str, names: Iterable[str]) -> list[str]:
    """Return the names that are most like one that there is not: by words, then by letters."""
    asked = anchor(name)
    words = set(asked.split("-"))

    def likeness(known: str) -> tuple[int, float]:
        letters = difflib.SequenceMatcher(None, asked, known).ratio()
        return len(words.intersection(known.split("-"))), letters

    return sorted(names, key=likeness, reverse=True)[:MOST_NAMES]


def _silent(_done: int, _of: int) -> None:
    """Report no progress."""
