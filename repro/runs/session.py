"""One session at the store: run what is missing, and mend what is damaged."""

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor
from itertools import groupby
from operator import attrgetter
from typing import TypeVar

from repro.errors import DamageError
from repro.runs.plan import Task
from repro.runs.run import Record
from repro.runs.store.store import Store
from repro.runs.workers.dispatch import BATCH_SECONDS, run_all

T = TypeVar("T")
MENDINGS = 3  # more damage than that within one call is the disk's


def run_missing(
    store: Store,
    tasks: Sequence[Task],
    *,
    executor: Executor,
    workers: int | Callable[[], int],
    environment: Callable[[], dict[str, object]],
    report: Callable[[int, int], None],
    note: Callable[[Record], None] = lambda _: None,
    batch_seconds: float = BATCH_SECONDS,
) -> list[Record]:
    """Run every task that the store lacks, keep each at once, and return the failed ones.

    `note` is told of every record, `report` (done, to do) after every batch.
    """
    total = sum(1 for _ in store.lacking(tasks))
    failed: list[Record] = []
    done = 0
    here = environment() if total else {}
    begun: Mapping[str, object] | None = None

    def keep(records: list[Record]) -> None:
        nonlocal done, begun
        for there, made_there in groupby(records, attrgetter("environment")):
            if begun != (there or here):
                begun = there or here
                store.begin(begun)
            store.add(made_there)
        failed.extend(record for record in records if record.reason)
        for record in records:
            note(record)
        done += len(records)
        report(done, total)

    # asked for again while runs are handed out, so that many more than fit in memory can be
    run_all(store.lacking(tasks), executor, workers, keep, batch_seconds=batch_seconds)
    return failed


def mended(store: Store, work: Callable[[], T]) -> T:
    """Return what the work at a store returns; set damage aside and work again as it shows."""
    for _ in range(MENDINGS):
        try:
            return work()
        except DamageError as damage:
            store.mend(damage)
    return work()
