"""Re-running a random sample of stored runs, to see whether they come out again."""

import random
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import asdict, dataclass, replace
from enum import Enum
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from repro.determinism.provenance import DECISIVE
from repro.errors import InputError
from repro.runs.plan import Task
from repro.runs.run import Record, execute
from repro.runs.store.store import Store

LAST_BITS = 1e-12  # relative difference up to which only rounding can have differed


class Outcome(Enum):
    """What a run that is made again says of its record; the value is the word shown."""

    MATCH = "match"
    LAST_BITS = "last bits"
    MISMATCH = "mismatch"


@dataclass(frozen=True, slots=True, kw_only=True)
class RunTwice:
    """A stored run beside the same run made now; `difference` is the largest relative one."""

    run: str
    outcome: Outcome
    difference: float
    note: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Verification:
    """What the sample says of a store.

    `current` of the `stored` finished runs can be made again: they are planned by this version of
    the papers and of the program. `damaged` names rows that are not what was written; `elsewhere`
    says in what the environments of the stored runs differ from this one.
    """

    seed: str
    stored: int
    current: int
    sample: tuple[RunTwice, ...]
    damaged: tuple[str, ...]
    elsewhere: tuple[str, ...]

    def count(self, outcome: Outcome) -> int:
        """Return how many runs of the sample came out so."""
        return Counter(compared.outcome for compared in self.sample)[outcome]

    def as_json(self) -> dict[str, object]:
        """Return everything as plain values."""
        rows = [
            asdict(row)
            | {"outcome": row.outcome.value}
            | ({} if np.isfinite(row.difference) else {"difference": None})  # JSON has no infinity
            for row in self.sample
        ]
        counts = {outcome.value: self.count(outcome) for outcome in Outcome}
        return asdict(replace(self, sample=())) | {"counts": counts, "sample": rows}

    def as_text(self) -> str:
        """Return everything as lines for a terminal."""
        drawn = f"sample of {len(self.sample)} by the seed {self.seed!r}"
        lines = [
            f"{self.stored} finished runs, {self.current} of them of this version; {drawn}",
            *(f"damaged: {name}" for name in self.damaged),
            *(f"another environment: {text}" for text in self.elsewhere),
            *(
                f"{row.outcome.value}: {row.run}, {row.note}"
                for row in self.sample
                if row.outcome is not Outcome.MATCH
            ),
            ", ".join(f"{outcome.value}: {self.count(outcome)}" for outcome in Outcome),
        ]
        return "\n".join(lines) + "\n"


def verify(
    folder: Path, tasks: Iterable[Task], *, sample: int, seed: str, here: dict[str, object]
) -> Verification:
    """Return what a random sample of the stored runs says; the store is only read.

    `here` is this environment. Raises InputError for an impossible sample and where there is no
    store.
    """
    if sample < 1:
        message = f"sample is {sample}; it must be 1 or more"
        raise InputError(message)
    with Store(folder, writing=False) as store:
        if not store.path.exists():
            message = f"there is no store in {folder}"
            raise InputError(message)
        damaged = tuple(store.damaged())
        finished = store.finished()
        current = [task for task in tasks if task.key in finished]
        chosen = _drawn(current, sample, seed)
        records = () if damaged else tuple(store.records(chosen))
        environments = () if damaged else store.environments(chosen)
    return Verification(
        seed=seed,
        stored=len(finished),
        current=len(current),
        sample=tuple(compare(record, execute(record.task)) for record in records),
        damaged=damaged,
        elsewhere=tuple(_departures(environments, here)),
    )


def _drawn(tasks: Sequence[Task], count: int, seed: str) -> list[Task]:
    by_name = sorted(tasks, key=lambda task: task.name)
    rng = random.Random(f"verify/{seed}")  # noqa: S311 (a sample, no secret)
    return rng.sample(by_name, min(count, len(by_name)))


def compare(stored: Record, again: Record) -> RunTwice:
    """Return what a run that was made again says of its record."""
    name = stored.task.name
    if again.reason or stored.evaluations != again.evaluations:
        note = again.reason or f"{again.evaluations} evaluations, stored {stored.evaluations}"
        return RunTwice(run=name, outcome=Outcome.MISMATCH, difference=np.inf, note=note)
    pairs = (
        (np.array([stored.cost]), np.array([again.cost])),
        (stored.x, again.x),
        (stored.history, again.history),
    )
    # the store keeps no sign of a zero cost
    if all((one + 0.0).tobytes() == (other + 0.0).tobytes() for one, other in pairs):
        return RunTwice(run=name, outcome=Outcome.MATCH, difference=0.0)
    difference = max(_difference(one, other) for one, other in pairs)
    outcome = Outcome.LAST_BITS if difference <= LAST_BITS else Outcome.MISMATCH
    note = (
        f"cost {again.cost!r}, stored {stored.cost!r}, largest relative difference {difference:g}"
        f"{_parting(stored.history, again.history)}"
    )
    return RunTwice(run=name, outcome=outcome, difference=difference, note=note)


def _parting(stored: NDArray[np.float64], again: NDArray[np.float64]) -> str:
    """Return in words where two histories part first; nothing where they do not."""
    length = min(len(stored), len(again))
    (places,) = np.nonzero(
        (stored[:length] + 0.0).view(np.int64) != (again[:length] + 0.0).view(np.int64)
    )
    if not len(places):
        return ""
    k = int(places[0])
    return f", first at iteration {k + 1}: {float(again[k])!r}, stored {float(stored[k])!r}"


def _difference(one: NDArray[np.float64], other: NDArray[np.float64]) -> float:
    """Return the largest difference relative to the larger value; infinite between shapes."""
    if one.shape != other.shape:
        return float("inf")
    with np.errstate(invalid="ignore"):
        gap, scale = np.abs(one - other), np.maximum(np.abs(one), np.abs(other))
        ratio = np.where(one == other, 0.0, gap / np.where(scale > 0.0, scale, 1.0))
    return float(np.where(np.isnan(ratio), np.inf, ratio).max(initial=0.0))


def _departures(
    environments: Iterable[dict[str, object]], here: dict[str, object]
) -> Iterable[str]:
    seen = {
        f"{part} was {was}, is {now}"
        for environment in environments
        for name in DECISIVE
        for part, was, now in _other_parts(name, environment.get(name), here.get(name))
    }
    return sorted(seen)


def _other_parts(name: str, was: object, now: object) -> Iterator[tuple[str, object, object]]:
    """Yield what differs, a package or a setting by its own name."""
    if isinstance(was, dict) and isinstance(now, dict):
        for key in sorted({*was, *now}):
            yield from _other_parts(f"{name}, {key}", was.get(key), now.get(key))
    elif was != now:
        yield name, "not noted" if was is None else was, "not noted" if now is None else now
