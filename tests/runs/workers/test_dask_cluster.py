import platform
import sys
from concurrent.futures import CancelledError, ThreadPoolExecutor
from types import ModuleType
from typing import Any, ClassVar

import pytest

from repro.determinism.provenance import provenance
from repro.errors import ClusterLostError, InputError
from repro.runs.run import execute, execute_all
from repro.runs.workers.dask_cluster import cluster, run_packed
from tests.held_searches import tasks_of
from tests.runs.test_run import same
from tests.small_papers import Guessing

TASKS = tasks_of(guess=Guessing())


class Client:
    """What Dask's client looks like to us."""

    executors: ClassVar[list[ThreadPoolExecutor]] = []

    def __init__(self, address: str, **_: Any) -> None:  # noqa: ANN401
        """Answer at one address alone."""
        if address != "tcp://here:1":
            message = "Timed out trying to connect"
            raise OSError(message)

    def close(self, timeout: float) -> None:
        """Leave."""

    def nthreads(self) -> dict[str, int]:
        """Return the threads of each worker."""
        return {"tcp://a": 3, "tcp://b": 2}

    def get_executor(self, **_: Any) -> ThreadPoolExecutor:  # noqa: ANN401
        """Return an executor."""
        self.executors.append(ThreadPoolExecutor(1))
        return self.executors[-1]


@pytest.fixture
def dask(monkeypatch: pytest.MonkeyPatch) -> None:
    """Put our client in the place of Dask's."""
    distributed = ModuleType("distributed")
    distributed.Client = Client  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "distributed", distributed)


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
def test_cluster_counts_its_threads_anew_now_and_then(monkeypatch: pytest.MonkeyPatch) -> None:
    with cluster("tcp://here:1") as (_, threads):
        assert threads() == 5
        monkeypatch.setattr(Client, "nthreads", lambda _: {})
        assert threads() == 5
        monkeypatch.setattr("repro.runs.workers.dask_cluster.COUNT_SECONDS", 0.0)
        assert threads() == 1


@pytest.mark.usefixtures("dask")
def test_runs_on_a_cluster_are_those_of_this_machine_with_their_environment() -> None:
    with cluster("tcp://here:1") as (executor, _):
        records = executor.submit(execute_all, TASKS).result()

    assert all(same(record, execute(task)) for record, task in zip(records, TASKS, strict=True))
    assert {record.environment["python"] for record in records if record.environment} == {
        platform.python_version()
    }


@pytest.mark.usefixtures("dask")
@pytest.mark.parametrize(
    ("part", "there", "fault"),
    [
        ("environment", {**provenance(), "python": "3.1"}, "python: 3.1 there, 3."),
        ("environment", {**provenance(), "packages": {"numpy": "0"}}, "packages: {'numpy': '0'}"),
        ("sources", ["changed"], "sources: others there, these here"),
    ],
)
def test_worker_with_another_engine_is_refused(
    monkeypatch: pytest.MonkeyPatch, part: str, there: object, fault: str
) -> None:
    monkeypatch.setattr(
        "repro.runs.workers.dask_cluster.run_packed",
        lambda payload: {**run_packed(payload), part: there},
    )

    with cluster("tcp://here:1") as (executor, _):
        error = executor.submit(execute_all, TASKS).exception()

    assert isinstance(error, InputError)
    assert fault in str(error)
    assert str(error).startswith("a worker of the cluster at 'tcp://here:1' has another engine: ")


@pytest.mark.usefixtures("dask")
def test_worker_without_the_package_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    def lacking(_: bytes) -> None:
        message = "No module named 'repro'"
        raise ModuleNotFoundError(message)

    monkeypatch.setattr("repro.runs.workers.dask_cluster.run_packed", lacking)

    with cluster("tcp://here:1") as (executor, _):
        error = executor.submit(execute_all, TASKS).exception()

    assert isinstance(error, InputError)
    assert str(error).endswith("has another engine: No module named 'repro'")


@pytest.mark.usefixtures("dask")
def test_scheduler_that_takes_no_more_tasks_is_lost() -> None:
    with cluster("tcp://here:1") as (executor, _):
        Client.executors[-1].shutdown()
        with pytest.raises(ClusterLostError, match="RuntimeError"):
            executor.submit(execute_all, TASKS)


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
