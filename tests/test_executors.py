import os
import sys
from concurrent.futures import CancelledError, ThreadPoolExecutor
from threading import current_thread
from types import ModuleType
from typing import Any, Self

import pytest

from repro.errors import ClusterLostError, InputError
from repro.executors import checked_workers, cluster, local, usable_cores


class Client:
    """What Dask's client looks like to us."""

    def __init__(self, address: str, **_: Any) -> None:  # noqa: ANN401
        """Answer at one address alone."""
        if address != "tcp://here:1":
            message = "Timed out trying to connect"
            raise OSError(message)

    def __enter__(self) -> Self:
        """Connect."""
        return self

    def __exit__(self, *_: object) -> None:
        """Leave."""

    def nthreads(self) -> dict[str, int]:
        """Return the threads of each worker."""
        return {"tcp://a": 3, "tcp://b": 2}

    def get_executor(self, **_: Any) -> ThreadPoolExecutor:  # noqa: ANN401
        """Return an executor."""
        return ThreadPoolExecutor(1)


@pytest.fixture
def dask(monkeypatch: pytest.MonkeyPatch) -> None:
    """Put our client in the place of Dask's."""
    distributed = ModuleType("distributed")
    distributed.Client = Client  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "distributed", distributed)


@pytest.mark.parametrize("workers", [0, -3])
def test_less_than_one_worker_is_refused(workers: int) -> None:
    with (
        pytest.raises(InputError, match=f"workers is {workers}; it must be 1 or more"),
        local(workers),
    ):
        pass


def test_local_executor_runs_in_threads_of_this_process() -> None:
    with local(2) as executor:
        names = set(executor.map(lambda _: (os.getpid(), current_thread().name[:3]), range(20)))

    assert names == {(os.getpid(), "run")}


def test_cores_are_those_that_this_process_may_use(monkeypatch: pytest.MonkeyPatch) -> None:
    assert 1 <= usable_cores() <= (os.cpu_count() or 1)

    monkeypatch.delattr(os, "sched_getaffinity", raising=False)

    assert usable_cores() == (os.cpu_count() or 1)


def test_cluster_without_its_package_is_refused_with_the_cure(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setitem(sys.modules, "distributed", None)

    with pytest.raises(InputError, match=r"pip install 'repro-whales\[cluster\]'"), cluster("here"):
        pass


@pytest.mark.usefixtures("dask")
def test_address_where_nobody_answers_is_refused_by_name() -> None:
    fault = "no Dask scheduler answers at 'tcp://there:1': Timed out"
    with pytest.raises(InputError, match=fault), cluster("tcp://there:1"):
        pass


@pytest.mark.usefixtures("dask")
def test_cluster_gives_its_executor_and_number_of_threads() -> None:
    with cluster("tcp://here:1") as (executor, threads):
        assert executor.submit(max, 1, 2).result() == 2

    assert threads == 5


@pytest.mark.usefixtures("dask")
@pytest.mark.parametrize("error", [CancelledError("gone"), ConnectionError("gone")])
def test_cluster_that_goes_away_asks_for_the_same_command_again(error: Exception) -> None:
    with (
        pytest.raises(ClusterLostError, match=r"was lost .*; run the same command again") as lost,
        cluster("tcp://here:1"),
    ):
        raise error

    assert lost.value.exit_code == 75


@pytest.mark.usefixtures("dask")
def test_other_errors_are_not_blamed_on_the_cluster() -> None:
    with pytest.raises(ZeroDivisionError), cluster("tcp://here:1"):
        raise ZeroDivisionError


def test_workers_are_the_usable_cores_unless_they_are_named() -> None:
    assert checked_workers(None) == usable_cores()
    assert checked_workers(3) == 3
    with pytest.raises(InputError, match="workers is 0"):
        checked_workers(0)
