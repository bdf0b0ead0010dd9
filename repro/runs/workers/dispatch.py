"""Running tasks on any executor, a few batches at a time, each finished one handed on at once."""

from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import CancelledError, Executor, Future, wait
from queue import SimpleQueue

from repro.errors import ReproError
from repro.runs.plan import Task
from repro.runs.run import Record, execute_all, failed
from repro.runs.workers.batches import Batches

IN_FLIGHT = 3  # batches handed out per worker, so that none waits while results are stored
BATCH_SECONDS = 0.1  # against a tenth of a millisecond that handing out a batch costs
GRACE_SECONDS = 2.0  # what runs may take after an interrupt before they are given up


def run_all(
    tasks: Iterable[Task],
    executor: Executor,
    workers: int | Callable[[], int],
    keep: Callable[[list[Record]], None],
    *,
    batch_seconds: float = BATCH_SECONDS,
) -> None:
    """Run the tasks in batches of about so many seconds and hand finished records to `keep`.

    `workers` may be a function where their number changes. An interrupt drops what has not
    started, waits a moment for what has, keeps it, and is raised again.
    """
    flights = _Flights(executor)
    batches = Batches(tasks, batch_seconds)
    count = workers if callable(workers) else lambda: workers
    try:
        flights.submit(batches, count())
        while flights.waiting:
            landed = flights.landed()
            records = [record for future in landed for record in flights.outcome(future)]
            keep(records)
            flights.forget(landed)
            batches.learn(records)
            flights.submit(batches, count())
    except KeyboardInterrupt:
        executor.shutdown(wait=False, cancel_futures=True)
        keep(flights.last())
        raise


class _Flights:
    """The batches that are handed out and not yet kept."""

    def __init__(self, executor: Executor) -> None:
        self.waiting: dict[Future[list[Record]], tuple[Task, ...]] = {}
        self._executor = executor
        self._done: SimpleQueue[Future[list[Record]]] = SimpleQueue()
        self._suspects: list[Task] = []  # runs of lost batches
        self._alone: Future[list[Record]] | None = None

    def submit(self, batches: Iterator[tuple[Task, ...]], workers: int) -> None:
        """Hand out batches until enough are in flight, and at the end each suspect alone.

        Only then is it certain which of the runs that were lost together is to blame.
        """
        while len(self.waiting) < workers * IN_FLIGHT and (batch := next(batches, None)):
            self._hand_out(batch)
        if self._suspects and not self.waiting:
            self._alone = self._hand_out((self._suspects.pop(0),))

    def _hand_out(self, batch: tuple[Task, ...]) -> Future[list[Record]]:
        future = self._executor.submit(execute_all, batch)
        self.waiting[future] = batch
        future.add_done_callback(self._done.put)
        return future

    def landed(self) -> list[Future[list[Record]]]:
        """Wait for a batch and return all that are done."""
        done = [self._done.get()]
        while not self._done.empty():
            done.append(self._done.get())
        return done

    def outcome(self, future: Future[list[Record]]) -> list[Record]:
        """Return the records of a batch; those of a lost one are to be had one by one.

        A run whose worker is lost for good while no other is in flight is a failed run.
        """
        batch = self.waiting[future]
        try:
            return future.result()
        except (CancelledError, ReproError):  # the whole cluster went away, or cannot be used
            raise
        except Exception as error:  # noqa: BLE001 (what a cluster says of a lost worker)
            if future is not self._alone:
                self._suspects.extend(batch)
                return []
            return [failed(batch[0], f"its worker was lost: {type(error).__name__}: {error}", 0.0)]

    def forget(self, futures: list[Future[list[Record]]]) -> None:
        """Drop batches whose records are kept."""
        for future in futures:
            del self.waiting[future]

    def last(self) -> list[Record]:
        """Return the records of all that is finished or ends in a moment."""
        started = [future for future in self.waiting if not future.cancel()]
        done = wait(started, timeout=GRACE_SECONDS).done
        finished = [future for future in done if not (future.cancelled() or future.exception())]
        return [record for future in finished for record in future.result()]
