"""The final costs of runs of searches, in the shapes that they have."""

import hashlib

import numpy as np
from numpy.typing import NDArray

Vector = NDArray[np.float64]
Generator = np.random.Generator
DOMAINS = ("any", "errors", "whole", "minimum")
MINIMA = (-450, -12569.5, 100, 1500, -1, -186.7309, 0.998, -0.25)  # of usual test functions


def named_rng(*names: object) -> Generator:
    """Return the generator of a name, the same in whatever process it is asked for."""
    digest = hashlib.sha256(" ".join(map(str, names)).encode()).digest()
    return np.random.default_rng(int.from_bytes(digest[:16]))


def number_of_runs(rng: Generator) -> int:
    """Return how often a search is run: mostly 2 to 60 times, now and then far more."""
    usual = (10, 20, 25, 30, 50, 51)
    kind = rng.random()
    if kind < 0.4:
        return int(usual[int(rng.integers(len(usual)))])
    return int(rng.integers(2, 61)) if kind < 0.97 else int(rng.integers(61, 1001))


def runs_of(rng: Generator, n: int, domain: str, minimum: float = 0.0) -> Vector:
    """Return n final costs: any, errors ≥ 0, whole numbers, or none below `minimum`."""
    if domain == "whole":
        runs = _whole(rng, n)
    elif domain == "any" and rng.random() < 0.4:
        runs = _signed(rng, n)
    else:
        runs = _errors(rng, n)
    if domain == "minimum":
        runs = np.maximum(minimum + runs, minimum)
    if rng.random() < 0.3:  # as a table of sorted runs is summed
        runs = np.sort(runs)
    return runs


def _errors(rng: Generator, n: int) -> Vector:
    scale = 10.0 ** rng.uniform(-8, 6)
    kinds = (
        lambda: np.exp(rng.normal(0, rng.uniform(0.1, 15), n)) * scale,
        lambda: rng.exponential(scale, n),
        lambda: np.where(rng.random(n) < rng.random(), 0.0, rng.exponential(scale, n)),
        lambda: scale + rng.exponential(scale * 10.0 ** rng.uniform(-17, 0), n),
        lambda: np.full(n, scale),
        lambda: np.where(np.arange(n) == rng.integers(n), scale * 10.0 ** rng.uniform(0, 9), scale),
        lambda: 10.0 ** rng.uniform(-300, 2, n),
        lambda: np.abs(rng.standard_cauchy(n)) * scale,
        lambda: np.where(rng.random(n) < 0.5, scale, scale * (1 + 10.0 ** rng.uniform(-16, 1))),
        lambda: np.zeros(n),  # the optimum in every run
    )
    return np.asarray(kinds[int(rng.integers(len(kinds)))](), dtype=float)


def _signed(rng: Generator, n: int) -> Vector:
    scale = 10.0 ** rng.uniform(-8, 6)
    kinds = (
        lambda: rng.normal(-scale, scale / 3, n),
        lambda: np.maximum(rng.standard_cauchy(n), -1.0) * scale,
        lambda: rng.normal(0, scale, n),
        lambda: -scale - rng.exponential(scale * 10.0 ** rng.uniform(-12, 0), n),
    )
    return kinds[int(rng.integers(len(kinds)))]()


def _whole(rng: Generator, n: int) -> Vector:
    scale = 10 ** int(rng.integers(1, 7))
    kinds = (
        lambda: rng.integers(0, scale, n),
        lambda: scale + rng.integers(0, 14, n),
        lambda: np.full(n, rng.integers(1, scale + 1)),
        lambda: rng.binomial(int(rng.integers(1, 30)), rng.random(), n),
        lambda: rng.poisson(rng.exponential(20), n),
        lambda: rng.geometric(0.01, n) * 10,
    )
    return kinds[int(rng.integers(len(kinds)))]().astype(float)
