"""`repro compare`: a user's search under every protocol, and a private report of it."""

import sys
from argparse import Namespace
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from repro.commands import catalogue
from repro.commands.progress import Progress
from repro.commands.shown_rows import warn
from repro.determinism.provenance import provenance
from repro.errors import SOME_RUN_FAILED, InputError
from repro.judge.certificates import certify
from repro.judge.users_search import users_search
from repro.model.identifiers import anchor
from repro.model.paper import Paper
from repro.optimisers.libraries import BASELINES
from repro.optimisers.users_search import Entrant, entrant
from repro.report.files import usable_folder, write_file
from repro.report.pages import render
from repro.report.views.users_search import UsersSearchView, users_search_view
from repro.runs.gather import gather
from repro.runs.plan import Task, plan
from repro.runs.run import Record
from repro.runs.session import run_missing
from repro.runs.store.store import Store
from repro.runs.studies import PER_STUDY, studies
from repro.runs.workers.local import checked_workers, local


@dataclass(frozen=True, slots=True, kw_only=True)
class Compared:
    """The page of a comparison, and the runs that failed."""

    page: Path
    failed: tuple[Record, ...]


def run(options: Namespace) -> int:
    """Run the search, write its report, and say where that is."""
    compared = compare(
        options.search,
        catalogue.chosen(options),
        name=options.name,
        repeats=options.repeats,
        store=options.store,
        folder=options.reports,
        workers=checked_workers(options.workers),
        report=Progress(),
    )
    for record in compared.failed:
        warn(f"run {record.task.name} failed: {record.reason}")
    sys.stdout.write(f"page: {compared.page}\n")
    return SOME_RUN_FAILED if compared.failed else 0


def compare(
    place: str,
    papers: Sequence[Paper],
    *,
    name: str | None,
    repeats: int,
    store: Path,
    folder: Path,
    workers: int,
    report: Callable[[int, int], None],
) -> Compared:
    """Run the search at a place under the papers' protocols and write its private report.

    Raises InputError for a place, name or folder that cannot be used.
    """
    papers = _with_protocols(papers)
    found = entrant(place)
    called = _checked_name(place.rpartition(":")[2] if name is None else name, papers)
    _refuse_published(folder)
    own = {paper.key: entered(paper, called, found) for paper in papers}
    tasks = [task for task in plan(own.values(), repeats) if task.algorithm == called]
    usable_folder(folder)
    with Store(store) as opened:
        with local(workers) as executor:
            failed = run_missing(
                opened, tasks, executor=executor, workers=workers,
                environment=provenance, report=report,
            )  # fmt: skip
        compared = [
            (paper, _views(opened, paper, own[paper.key], tasks, called)) for paper in papers
        ]
    context = {"name": called, "place": place, "repeats": repeats, "papers": compared,
               "failed": [(record.task.name, record.reason) for record in failed]}  # fmt: skip
    return Compared(page=_written(folder, called, context), failed=tuple(failed))


def _written(folder: Path, name: str, context: Mapping[str, object]) -> Path:
    """Write the report as HTML and Markdown, and return the former's path."""
    stem = anchor(name) or "search"
    for suffix in ("md", "html"):
        write_file(folder / f"{stem}.{suffix}", render(f"compare.{suffix}", context))
    return folder / f"{stem}.html"


def entered(paper: Paper, name: str, found: Entrant) -> Paper:
    """Return the paper's protocols with the user's search alone, and no claims."""
    experiments = tuple(
        replace(experiment, algorithms={name: found}, proposed=name)
        for experiment in paper.experiments
    )
    bare = replace(
        paper, results=(), claims=(), assumptions=(), together=(), figures=(), relations=()
    )
    return replace(bare, experiments=experiments)


def _views(
    store: Store, paper: Paper, own: Paper, tasks: Iterable[Task], name: str
) -> tuple[UsersSearchView, ...]:
    published = gather(store, paper, plan([paper], PER_STUDY), studies(paper, PER_STUDY))
    runs = {**published.runs, **gather(store, own, tasks).runs}
    certificates = certify(paper)
    return tuple(
        users_search_view(users_search(paper, experiment, runs, certificates, name=name))
        for experiment in paper.experiments
    )


def _with_protocols(papers: Sequence[Paper]) -> list[Paper]:
    """Return the papers that run something; InputError where none does."""
    found = [paper for paper in papers if paper.experiments]
    without = [paper.key for paper in papers if not paper.experiments]
    if not found:
        message = f"no experiments in {', '.join(without)}: no protocol to run a search under"
        raise InputError(message)
    for key in without:
        warn(f"{key} has no experiments: it is left out")
    return found


def _checked_name(name: str, papers: Iterable[Paper]) -> str:
    taken = {
        algorithm
        for paper in papers
        for experiment in paper.experiments
        for algorithm in (*experiment.algorithms, *BASELINES)
    }
    if name in taken:
        message = f"the name {name!r} belongs to another algorithm: choose one with --name"
        raise InputError(message)
    if not name.strip() or "/" in name or not name.isprintable():
        message = f"the name {name!r} must be printable, with no '/': choose one with --name"
        raise InputError(message)
    return name


def _refuse_published(folder: Path) -> None:
    """Raise InputError for a folder of published pages, which a private report must not enter."""
    if (folder / "results.json").exists() or folder.resolve() == Path("reports").resolve():
        message = f"the folder {folder} holds published pages: choose another with --reports"
        raise InputError(message)
