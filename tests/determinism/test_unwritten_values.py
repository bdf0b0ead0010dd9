"""What is told of a search that no file has: whatever it does otherwise, its digest is another."""

import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from repro.determinism.unwritten_values import digest_of_unwritten

CELL = """
import functools, math
import numba
import numpy as np

SHARE = 1.0
WORDS = {"a", "b", "c"}
@numba.njit
def step(x): return x + 1.0
def helper(x): return step(SHARE * x)
def plain(cost, *, k=1): return helper(cost) if "a" in WORDS else k
def inner(share):
    def enclosed(cost): return share * cost
    return enclosed
partial = functools.partial(lambda share, cost: share * cost, 0.5)
enclosed = inner(0.5)
class Base:
    def find(self, cost): return cost
class Held(Base):
    __slots__ = ("share",)
    def __init__(self, share): self.share = share
    def __call__(self, cost): return self.weight * self.share * self.find(cost)
    @property
    def weight(self): return 1.0
    @staticmethod
    def other(cost): return cost
held = Held(0.5)
method = held.find
drawn = inner(np.random.default_rng(1))
recursive = lambda n: recursive(n - 1) if n else 0
"""
EDITS = [
    ("plain", "SHARE = 1.0", "SHARE = 2.0"),
    ("plain", "x + 1.0", "x + 2.0"),
    ("plain", "k=1", "k=2"),
    ("plain", '"b", "c"', '"b", "d"'),
    ("plain", "return helper(cost)", "return 1.0 + helper(cost)"),
    ("partial", "share * cost, 0.5", "share * cost, 0.6"),
    ("partial", "lambda share, cost: share * cost", "lambda share, cost: share + cost"),
    ("enclosed", "enclosed = inner(0.5)", "enclosed = inner(0.6)"),
    ("held", "Held(0.5)", "Held(0.6)"),
    ("held", "def find(self, cost): return cost", "def find(self, cost): return -cost"),
    ("held", "def weight(self): return 1.0", "def weight(self): return 2.0"),
    ("held", "def other(cost): return cost", "def other(cost): return -cost"),
    ("method", "Held(0.5)", "Held(0.6)"),
    ("method", "def find(self, cost): return cost", "def find(self, cost): return -cost"),
    ("drawn", "default_rng(1)", "default_rng(2)"),
    ("recursive", "n - 1", "n - 2"),
]


def digest(name: str, text: str = CELL) -> str:
    known: dict[str, Any] = {"__name__": "__main__"}
    exec(text, known)  # noqa: S102 (as a notebook does with a cell)
    return digest_of_unwritten(known[name])


@pytest.mark.parametrize(("name", "old", "new"), EDITS)
def test_edit_of_what_a_search_reaches_gives_another_digest(name: str, old: str, new: str) -> None:
    assert CELL.count(old) == 1

    assert digest(name, CELL.replace(old, new)) != digest(name)


@pytest.mark.parametrize("name", dict.fromkeys(name for name, *_ in EDITS))
def test_same_text_gives_the_same_digest(name: str) -> None:
    assert digest(name, CELL + "\nUNUSED = 1") == digest(name)


def test_digest_does_not_hang_on_the_order_of_sets() -> None:
    line = "from tests.determinism.test_unwritten_values import digest; print(digest('plain'))"
    found = {
        subprocess.check_output(
            (sys.executable, "-c", line), cwd=Path(__file__).parents[2],
            env={**os.environ, "PYTHONHASHSEED": seed},
        )
        for seed in ("1", "2", "3")
    }  # fmt: skip

    assert len(found) == 1
