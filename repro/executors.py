"""Where tasks run: threads of this machine, or a Dask cluster that exists already."""

import os
from collections.abc import Iterator
from concurrent.futures import Executor, ThreadPoolExecutor
from contextlib import contextmanager

from repro.errors import ClusterLostError, InputError

CONNECT_SECONDS = 10


def usable_cores() -> int:
    """Return the number of cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def checked_workers(workers: int | None) -> int:
    """Return the number of workers, the usable cores for None; InputError below 1."""
    if workers is None:
        return usable_cores()
    if workers < 1:
        message = f"workers is {workers}; it must be 1 or more"
        raise InputError(message)
    return workers


@contextmanager
def local(workers: int) -> Iterator[Executor]:
    """Yield a pool of threads; the compiled loops release the interpreter lock."""
    with ThreadPoolExecutor(checked_workers(workers), thread_name_prefix="run") as executor:
        yield executor


@contextmanager
def cluster(address: str) -> Iterator[tuple[Executor, int]]:
    """Yield the executor of the Dask cluster at an address, and its number of threads.

    Raises InputError where `distributed` is not installed or nobody answers, ClusterLostError
    where the scheduler goes away while tasks run.
    """
    try:
        from distributed import Client  # noqa: PLC0415 (an extra that most users lack)
    except ImportError:
        message = "--dask needs the package distributed: pip install 'repro-whales[cluster]'"
        raise InputError(message) from None
    try:
        client = Client(address, timeout=CONNECT_SECONDS)
    except (OSError, ValueError) as error:
        message = f"no Dask scheduler answers at {address!r}: {error}"
        raise InputError(message) from None
    from concurrent.futures import CancelledError  # noqa: PLC0415

    with client:
        threads = sum(client.nthreads().values()) or 1
        try:
            yield client.get_executor(pure=False, retries=2), threads
        except (CancelledError, OSError) as error:
            message = f"the cluster at {address!r} was lost ({error}); run the same command again"
            raise ClusterLostError(message) from None
