import gc
from collections.abc import Iterator
from pathlib import Path
from time import monotonic, strftime

import pytest

from benchmarks.chart import chart
from benchmarks.goals import measured
from benchmarks.results import Results
from benchmarks.sessions import SESSIONS, last_runs

_RESULTS = pytest.StashKey[Results]()
_BEGUN = pytest.StashKey[float]()


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--results", type=Path, help="write the page of results to this file")


def pytest_configure(config: pytest.Config) -> None:
    config.stash[_RESULTS] = Results()
    config.stash[_BEGUN] = monotonic()


@pytest.fixture(scope="session")
def results(pytestconfig: pytest.Config) -> Results:
    return pytestconfig.stash[_RESULTS]


@pytest.fixture(scope="session")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return where whole calls have their stores, "first" and "second", and what is compiled."""
    return tmp_path_factory.mktemp("engine")


@pytest.fixture(autouse=True)
def _without_garbage_collection() -> Iterator[None]:
    gc.collect()
    gc.disable()
    yield
    gc.enable()


def pytest_sessionfinish(session: pytest.Session) -> None:
    page, results = session.config.getoption("--results"), session.config.stash[_RESULTS]
    if page and results.rows:
        for row in last_runs():
            results.add(SESSIONS, *row)
        took = measured(monotonic() - session.config.stash[_BEGUN], ".0f")
        results.add(SESSIONS, "`nox -s bench`", took, strftime("%Y-%m-%d"))
        page.write_text(results.text(), encoding="utf-8")
        if results.curves:
            page.with_name("cost.svg").write_text(chart(results.curves), encoding="utf-8")
