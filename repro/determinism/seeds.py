"""Seeds from names: the same run has the same random numbers whenever and wherever it runs."""

import hashlib

import numpy as np

RULE = (
    "numpy's default_rng on a SeedSequence of the first 128 bits of the SHA-256 of the run's name "
    "(paper/experiment/problem/algorithm/repeat/run)"
)


def generator(*name: object) -> np.random.Generator:
    """Return the generator that belongs to a name."""
    digest = hashlib.sha256("/".join(map(str, name)).encode()).digest()
    return np.random.default_rng(np.random.SeedSequence(int.from_bytes(digest[:16], "big")))


def seed_of(*name: object) -> int:
    """Return the seed of a name: `numpy.random.default_rng(seed)` is its generator.

    `generator` does not call this, as a change of what it calls makes all stored runs again.
    """
    return int.from_bytes(hashlib.sha256("/".join(map(str, name)).encode()).digest()[:16], "big")
