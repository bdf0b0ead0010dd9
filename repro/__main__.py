"""The command line, and the only importer of papers."""

import argparse
import dataclasses
import importlib
import json
import pkgutil
import sys
from collections.abc import Callable, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

import papers
from repro.commands.arguments import parsed
from repro.errors import InputError, ReproError, StoreError, Terminated
from repro.model.paper import Paper

if TYPE_CHECKING:
    from repro.runs.plan import Task
    from repro.runs.run import Record
    from repro.runs.store.store import Store

INTERRUPTED = 130
TERMINATED = 143
SOME_RUN_FAILED = 1
PAGES = "repro.report.pages"  # takes seconds to load, with all that draws


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit code; bad input is one line on stderr."""
    options = parsed(_COMMANDS, arguments)
    command: Callable[[argparse.Namespace], int] = options.command
    try:
        return command(options)
    except ReproError as error:
        sys.stderr.write(f"repro: {error}\n")
        return error.exit_code
    except KeyboardInterrupt as interrupt:
        sys.stderr.write("\nrepro: interrupted; finished runs are kept, the same call goes on\n")
        return TERMINATED if isinstance(interrupt, Terminated) else INTERRUPTED


def all_papers() -> dict[str, Paper]:
    """Return every paper that a module of `papers` declares, by key."""
    modules = (
        importlib.import_module(f"papers.{info.name}")
        for info in pkgutil.iter_modules(papers.__path__)
    )
    return {module.PAPER.key: module.PAPER for module in modules}


def _chosen(keys: Sequence[str]) -> list[Paper]:
    known = all_papers()
    for key in keys:
        if key not in known:
            message = f"unknown paper {key!r}; known: {', '.join(known)}"
            raise InputError(message)
    return [paper for key, paper in known.items() if not keys or key in keys]


def _reproduce(options: argparse.Namespace) -> int:
    from repro.commands.interrupts import terminable  # noqa: PLC0415
    from repro.report import unchanged  # noqa: PLC0415
    from repro.report.files import usable_folder  # noqa: PLC0415
    from repro.runs.plan import plan  # noqa: PLC0415
    from repro.runs.session import mended  # noqa: PLC0415
    from repro.runs.store.store import Store  # noqa: PLC0415
    from repro.runs.workers.local import checked_workers  # noqa: PLC0415 (slow imports late)

    chosen = _chosen(options.keys)
    tasks = plan(chosen, options.repeats, options.master_seed, protocol_only=options.protocol_only)
    checked_workers(options.workers)
    usable_folder(options.reports)
    written = unchanged.Written(
        tasks=tasks, chosen=[paper.key for paper in chosen], known=list(all_papers()),
        declarations=list(papers.__path__), reports=options.reports,
    )  # fmt: skip

    def work() -> "list[Record]":
        if written.stand(store):
            return []
        failed = _run(store, tasks, options)
        pages = importlib.import_module(PAGES)
        pages.write_report(store, chosen, tasks, options.reports, all_papers().values())
        written.remember(store)
        return failed

    with terminable(), Store(options.store, say=_warn) as store:
        failed = mended(store, work)
    for record in failed:
        _warn(f"run {record.task.name} failed: {record.reason}")
    return _written(options, SOME_RUN_FAILED if failed else 0)


def _written(options: argparse.Namespace, code: int = 0) -> int:
    sys.stdout.write(f"pages: {options.reports / 'index.html'}\n")
    return code


def _compare(options: argparse.Namespace) -> int:
    from repro.commands.compare import compare  # noqa: PLC0415 (slow imports late)
    from repro.commands.progress import Progress  # noqa: PLC0415
    from repro.runs.workers.local import checked_workers  # noqa: PLC0415

    compared = compare(
        options.search,
        _chosen(options.keys),
        name=options.name,
        repeats=options.repeats,
        store=options.store,
        folder=options.reports,
        workers=checked_workers(options.workers),
        report=Progress(),
    )
    for record in compared.failed:
        sys.stderr.write(f"repro: run {record.task.name} failed: {record.reason}\n")
    sys.stdout.write(f"page: {compared.page}\n")
    return SOME_RUN_FAILED if compared.failed else 0


def _run(store: "Store", tasks: Sequence["Task"], options: argparse.Namespace) -> list["Record"]:
    """Run what the store lacks, here or on a cluster, and return the failed runs."""
    from repro.commands.progress import Progress  # noqa: PLC0415
    from repro.determinism.provenance import provenance  # noqa: PLC0415
    from repro.runs.session import run_missing  # noqa: PLC0415
    from repro.runs.workers import dask_cluster as cluster  # noqa: PLC0415 (slow imports late)
    from repro.runs.workers.local import checked_workers, local  # noqa: PLC0415

    run = partial(run_missing, store, tasks, environment=provenance, report=Progress())
    if options.dask:
        with cluster.cluster(options.dask) as (executor, threads):
            return run(executor=executor, workers=threads, batch_seconds=cluster.BATCH_SECONDS)
    workers = checked_workers(options.workers)
    with local(workers, processes=options.processes) as executor:
        executor.submit(importlib.import_module, PAGES)  # loads while others run
        return run(executor=executor, workers=workers)


def _warn(line: str) -> None:
    sys.stderr.write(f"repro: {line}\n")


def _report(options: argparse.Namespace) -> int:
    from repro.report.pages import write_report  # noqa: PLC0415
    from repro.runs.plan import plan  # noqa: PLC0415 (slow imports late)
    from repro.runs.store.store import Store  # noqa: PLC0415

    chosen = _chosen(options.keys)
    tasks = plan(chosen, options.repeats, options.master_seed, protocol_only=options.protocol_only)
    with Store(options.store, writing=False) as store:
        if not store.path.exists():
            message = f"there is no store in {options.store}; `repro reproduce` makes one"
            raise InputError(message)
        write_report(store, chosen, tasks, options.reports, all_papers().values())
    return _written(options)


def _verify(options: argparse.Namespace) -> int:
    from repro.determinism.provenance import provenance  # noqa: PLC0415
    from repro.runs.plan import plan  # noqa: PLC0415 (slow imports late)
    from repro.runs.store.store import Store  # noqa: PLC0415
    from repro.runs.verify import Outcome, verify  # noqa: PLC0415

    folder = options.folder or options.store
    with Store(folder, writing=False) as store:
        repeats = max(store.repeats(), options.repeats)
    found = verify(
        folder,
        plan(all_papers().values(), repeats, options.master_seed),
        sample=options.sample,
        seed=options.seed,
        here=provenance(),
    )
    sys.stdout.write(
        json.dumps(found.as_json(), indent=2) + "\n" if options.json else found.as_text()
    )
    if found.damaged:
        message = f"{len(found.damaged)} rows are damaged; `repro reproduce` sets them aside"
        raise StoreError(message)
    if not found.sample:
        message = f"nothing was compared: no run in {folder} is one that this version would make"
        raise InputError(message)
    return SOME_RUN_FAILED if found.count(Outcome.MISMATCH) else 0


def _again(options: argparse.Namespace) -> int:
    from repro.commands.again import run_again  # noqa: PLC0415 (slow imports late)
    from repro.runs.workers.local import checked_workers, local  # noqa: PLC0415

    (paper,) = _chosen([options.key])
    workers = checked_workers(options.workers)
    with local(workers) as executor:
        found = run_again(
            paper,
            options.name,
            executor=executor,
            workers=workers,
            master_seed=options.master_seed,
        )
    sys.stdout.write(found.text)
    return 0


def _list(options: argparse.Namespace) -> int:
    from repro.commands.listing import listing, listing_text  # noqa: PLC0415 (slow imports late)

    rows = listing(_chosen(options.keys), options.repeats, options.store)
    sys.stdout.write(json.dumps(rows, indent=2) + "\n" if options.json else listing_text(rows))
    return 0


def _audit(options: argparse.Namespace) -> int:
    from repro.audit import audit  # noqa: PLC0415 (slow imports late)

    rows = [row for paper in _chosen(options.keys) for row in audit(paper)]
    lines = [
        f"{row.grade}: {row.paper}, {row.table}, {row.row or 'several cells'}"
        f"{f', {row.column}' if row.column else ''}: {row.explanation}"
        for row in rows
    ]
    return _say(rows, lines, as_json=options.json)


def _certify(options: argparse.Namespace) -> int:
    from repro.judge.certificates import certify  # noqa: PLC0415 (slow imports late)

    rows = [row for paper in _chosen(options.keys) for row in certify(paper)]
    lines = [
        f"{row.paper}, {row.problem}: "
        + ("no minimum" if row.minimum is None else f"minimum {row.minimum:.6g} s")
        + f"; {row.explanation or '; '.join(row.binding)}"
        for row in rows
    ]
    return _say(rows, lines, as_json=options.json)


def _references(options: argparse.Namespace) -> int:
    from repro.judge.outside_planners import outside_references  # noqa: PLC0415 (slow imports late)

    rows = outside_references(_chosen(options.keys))
    lines = [
        f"{row.paper}, {row.problem}, {row.planner}: "
        + (f"skipped, {row.skipped}" if row.time is None else f"{row.time:.6g} s, {row.what}")
        for row in rows
    ]
    return _say(rows, lines, as_json=options.json)


def _say(rows: Sequence[Any], lines: Sequence[str], *, as_json: bool) -> int:
    if as_json:
        plain = [dataclasses.asdict(row) for row in rows]
        sys.stdout.write(json.dumps(plain, indent=2, ensure_ascii=False) + "\n")
    else:
        sys.stdout.writelines(line + "\n" for line in lines)
    return 0


def _flips(options: argparse.Namespace) -> int:
    from repro.judge.two_results import compare  # noqa: PLC0415 (slow imports late)
    from repro.report.results import read_results  # noqa: PLC0415

    both = []
    for path in (options.first, options.second):
        found = read_results(path)
        if found is None:
            message = f"{path}: no results are there"
            raise InputError(message)
        both.append(found)
    comparison = compare(*both)
    as_json = json.dumps(comparison.as_json(), indent=2, ensure_ascii=False) + "\n"
    sys.stdout.write(as_json if options.json else comparison.as_text())
    return 0


_COMMANDS = {
    "reproduce": _reproduce,
    "report": _report,
    "list": _list,
    "compare": _compare,
    "again": _again,
    "audit": _audit,
    "certify": _certify,
    "references": _references,
    "verify": _verify,
    "flips": _flips,
}

if __name__ == "__main__":
    sys.exit(main())
