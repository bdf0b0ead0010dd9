"""Running what a store lacks, here or on a cluster, as the options of a command say."""

from argparse import Namespace
from collections.abc import Callable, Sequence
from functools import partial

from repro.commands.progress import Progress
from repro.determinism.provenance import provenance
from repro.runs.plan import Task
from repro.runs.run import Record
from repro.runs.session import run_missing
from repro.runs.store.store import Store
from repro.runs.workers import dask_cluster
from repro.runs.workers.local import checked_workers, local


def run_lacking(
    store: Store,
    tasks: Sequence[Task],
    options: Namespace,
    report: Callable[[int, int], None],
    environment: Callable[[], dict[str, object]] = provenance,
) -> list[Record]:
    """Run what the store lacks and return the failed runs; see `run_missing`."""
    missing = partial(run_missing, store, tasks, environment=environment, report=report)
    if isinstance(report, Progress):
        if not report.expecting:
            report.expect(store.lacking(tasks), store.seconds())
        missing = partial(missing, note=report.note)
    if options.dask:
        with dask_cluster.cluster(options.dask) as (executor, threads):
            batch = dask_cluster.BATCH_SECONDS
            return missing(executor=executor, workers=threads, batch_seconds=batch)
    workers = checked_workers(options.workers)
    with local(workers, processes=getattr(options, "processes", False)) as executor:
        return missing(executor=executor, workers=workers)
