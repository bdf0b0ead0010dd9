"""Random damage to a store, and what comes of it."""

import os
import random
from dataclasses import dataclass
from pathlib import Path

from repro.errors import ReproError
from tests.small_stores import read, reproduced

LONG = os.environ.get("REPRO_FAULTS") == "long"
"""Whether the tests of faults run in their long form."""

Rows = list[tuple[object, ...]]


@dataclass(frozen=True)
class Trial:
    """What a reader was shown, what was stored after running again, and all that was said.

    The rows are None where the store was refused.
    """

    shown: Rows | None
    records: Rows | None
    made: list[str]
    said: list[str]


def damaged(whole: bytes, seed: str) -> bytes:
    """Return a file with a bit of a byte above 0 flipped or, one time in four, its end cut off."""
    rng = random.Random(seed)  # noqa: S311 (places of damage, not secrets)
    if rng.random() < 0.25:
        return whole[: rng.randrange(len(whole))]
    place = rng.choice([place for place, byte in enumerate(whole) if byte])
    return whole[:place] + bytes([whole[place] ^ (1 << rng.randrange(8))]) + whole[place + 1 :]


def tried(folder: Path) -> Trial:
    """Read a store, then run what it lacks."""
    said = []
    shown = records = None
    made: list[str] = []
    try:
        shown = read(folder)
    except ReproError as error:
        said.append(str(error))
    try:
        records, made, lines = reproduced(folder)
        said += lines
    except ReproError as error:
        said.append(str(error))
    return Trial(shown, records, made, said)
