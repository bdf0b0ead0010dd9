"""How many examples property-based tests try, and what the tests of faults counted.

HYPOTHESIS_PROFILE is "tests", "faults" or "fuzz"; REPRO_FAULTS is "long" for the long form of
the faults.
"""

import gc
import os
from collections import Counter

import pytest
from hypothesis import settings

# compiled kernels make the first example slow, so no example has a deadline
settings.register_profile("tests", max_examples=40, deadline=None)
settings.register_profile("fuzz", max_examples=10_000, deadline=None)
settings.register_profile("faults", max_examples=2_000, deadline=None)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "tests"))


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Begin with the longest file, lest one worker ends alone with it."""
    items.sort(key=lambda item: item.get_closest_marker("full_size") is None)


def pytest_collection() -> None:
    """Collect some thousands of tests without looking for garbage among them."""
    gc.disable()


def pytest_collection_finish() -> None:
    """Let no later look for garbage pass over them either."""
    gc.freeze()
    gc.enable()


def pytest_make_parametrize_id(val: object, argname: str) -> str | None:
    """Name bytes by their argument: archives hold their time, and workers must agree on names."""
    return argname if isinstance(val, bytes) else None


_TALLY = pytest.StashKey[Counter[str]]()


@pytest.fixture
def tally(pytestconfig: pytest.Config) -> Counter[str]:
    """Return what counts kills, damages and bad inputs for the summary."""
    return pytestconfig.stash.setdefault(_TALLY, Counter())


def pytest_terminal_summary(
    terminalreporter: pytest.TerminalReporter, config: pytest.Config
) -> None:
    """Say what was counted."""
    for name, number in config.stash.get(_TALLY, Counter[str]()).items():
        terminalreporter.write_line(f"{name}: {number:,}")
