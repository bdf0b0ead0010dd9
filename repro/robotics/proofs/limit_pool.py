"""The limits of a spline motion that a linear programme looks at, growing where they are broken."""

import itertools
from collections.abc import Sequence
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from repro.robotics.proofs.jolts import Jolt, Limit, doubles, jolt, jolt_rows
from repro.robotics.proofs.limit_rows import Bend, Cut, Exact, bend, cut

Vector = NDArray[np.float64]
SAMPLES = 64  # of a span, and again of the neighbourhood of the worst of them
BREACH = 1e-9  # share of a limit, by which it is worth adding
STRAIGHT_AND_BENT = 3  # kinds of limits before those of the jerk
TINY = 1e-30  # of a slope of time: where time stands still, every share is huge


class Limits:
    """The limits looked at so far, exact and as arrays of doubles."""

    def __init__(self, model: Exact, cuts: Sequence[Cut]) -> None:
        """Start with the cuts and with the acceleration limits of a few points of each span."""
        self.model = model
        self.known: list[Limit] = list(cuts)
        self._doubles = [_doubles(each) for each in cuts]
        self._jolts: list[tuple[float, ...]] = []
        self._places = {(each.span, each.joint, each.u, 0) for each in cuts}
        self._ratios: set[tuple[int, int, Fraction, int, Fraction]] = set()
        self.time = np.array(model.time, dtype=np.float64)
        self.angle = np.array(model.angle, dtype=np.float64)
        self.velocity = np.array(model.velocity, dtype=np.float64)
        self.acceleration = np.array(model.acceleration, dtype=np.float64)
        self.jerk = None if model.jerk is None else np.array(model.jerk, dtype=np.float64)
        for span, joint in np.ndindex(self.angle.shape[:2]):
            for quarter, sign in itertools.product(range(5), (-1, 1)):
                self.add(span, joint, Fraction(quarter, 4), sign)

    def add(self, span: int, joint: int, u: Fraction, sign: int) -> bool:
        """Add the velocity (sign 0) or acceleration limit at one u; return whether it is new."""
        place = (span, joint, u, sign)
        if place in self._places:
            return False
        self._places.add(place)
        limit = (
            bend(self.model, span, joint, u, sign=sign) if sign else cut(self.model, span, joint, u)
        )
        self.known.append(limit)
        self._doubles.append(_doubles(limit))
        return True

    def add_jolt(self, span: int, joint: int, u: Fraction, sign: int, *, ratio: float) -> bool:
        """Add the jerk limit at one u, sharp near a ratio s'/s; return whether it is new."""
        limit = jolt(self.model, span, joint, u, sign=sign, ratio=ratio)
        place = (span, joint, u, sign, limit.ratio)
        if place in self._ratios:
            return False
        self._ratios.add(place)
        self.known.append(limit)
        self._jolts.append(doubles(limit))
        return True

    def rows(self, box: Vector) -> tuple[Vector, Vector, Vector]:
        """Return weights (n, durations) and least values (n,) of the limits' rows in a box.

        The third is the slope of time at each limit, which its row depends on through the box; of a
        Jolt on the ratio of two such, too (see `jolt_rows`).
        """
        rows = self._straight_and_bent(box)
        if not self._jolts:
            return rows
        jolted = np.array([isinstance(limit, Jolt) for limit in self.known])
        both = []
        for own, other in zip(rows, jolt_rows(self._jolts, box), strict=True):
            merged = np.empty((len(jolted), *own.shape[1:]))
            merged[~jolted], merged[jolted] = own, other
            both.append(merged)
        return both[0], both[1], both[2]

    def _straight_and_bent(self, box: Vector) -> tuple[Vector, Vector, Vector]:
        n = len(box)
        table = np.array(self._doubles)
        slope, turn, floor, curved = table[:, :n], table[:, n : 2 * n], table[:, -2], table[:, -1]
        up, down = np.maximum(slope, 0.0), np.minimum(slope, 0.0)
        low = np.maximum(floor, up @ box[:, 0] + down @ box[:, 1])
        high = np.maximum(low, up @ box[:, 1] + down @ box[:, 0])
        steep = high * high + high * low + low * low
        weights = np.where(curved[:, None], steep[:, None] * slope - turn, slope)
        return weights, np.where(curved, steep * low - low**3, floor), slope

    def add_worst(self, durations: Vector) -> int:
        """Add the limits that a motion breaks most, span by span; return how many are new."""
        grid = np.linspace(0.0, 1.0, SAMPLES + 1)
        coarse = self._excess(durations, np.tile(grid, (*self._shape, 1)))
        middle = grid[coarse.argmax(axis=-1)]
        around = middle[..., None] + np.linspace(-1.0, 1.0, 2 * SAMPLES + 1) / SAMPLES
        places = np.clip(around, 0.0, 1.0)
        fine = self._excess(durations, places)
        broken = np.argwhere(fine.max(axis=-1) > BREACH)
        return sum(
            self._add_kind(span, joint, kind, places[span, joint, kind, peak], durations)
            for span, joint, kind in broken.tolist()
            for peak in [int(fine[span, joint, kind].argmax())]
        )

    def _add_kind(self, span: int, joint: int, kind: int, u: float, durations: Vector) -> bool:
        if kind < STRAIGHT_AND_BENT:
            return self.add(span, joint, Fraction(u), kind - 1)
        sign = 1 if kind > STRAIGHT_AND_BENT else -1
        s0, s1, s2 = self.time[span] @ durations
        ratio = (s1 + 2 * u * s2) / max(s0 + u * (s1 + u * s2), TINY)
        return self.add_jolt(span, joint, Fraction(u), sign, ratio=ratio)

    @property
    def _shape(self) -> tuple[int, int, int]:
        spans, joints, _ = self.angle.shape
        return spans, joints, STRAIGHT_AND_BENT + (0 if self.jerk is None else 2)

    def _excess(self, durations: Vector, u: Vector) -> Vector:
        """Return by which share limits are broken at u (spans, joints, kinds, n).

        The kinds are acceleration downwards, velocity, acceleration upwards and, where it is
        limited, jerk downwards and upwards.
        """
        s0, s1, s2 = np.moveaxis(self.time @ durations, -1, 0)[..., None, None, None]
        p0, p1, p2 = np.moveaxis(self.angle, -1, 0)[..., None, None]
        s, s1 = s0 + u * (s1 + u * s2), s1 + 2 * u * s2
        p, p1 = p0 + u * (p1 + u * p2), p1 + 2 * u * p2
        turn = p1 * s - p * s1
        slope = np.maximum(s, TINY)
        least, most = np.moveaxis(self.velocity, -1, 0)[..., None, None]
        slow = (np.maximum(p / most, p / least) - s) / np.maximum(abs(s), TINY)
        least, most = np.moveaxis(self.acceleration, -1, 0)[..., None, None]
        parts: tuple[Vector, ...]
        parts = (turn / least / slope**3 - 1.0, slow, turn / most / slope**3 - 1.0)
        if self.jerk is not None:
            p2, s2 = 2 * p2, 2 * s2
            jolted = p2 * s * s - 3 * p1 * s * s1 - p * s * s2 + 3 * p * s1 * s1
            least, most = np.moveaxis(self.jerk, -1, 0)[..., None, None]
            with np.errstate(over="ignore"):  # where time stands still
                parts += (jolted / least / slope**5 - 1.0, jolted / most / slope**5 - 1.0)
        return np.stack([part[:, :, k] for k, part in enumerate(parts)], axis=2)


def _doubles(limit: Cut | Bend) -> tuple[float, ...]:
    """Return slope, turn, least slope, and whether the limit is curved."""
    if isinstance(limit, Cut):
        numbers = (*limit.weights, *[Fraction(0)] * len(limit.weights), limit.least, Fraction(0))
    else:
        numbers = (*limit.slope, *limit.turn, limit.least, Fraction(1))
    return tuple(map(float, numbers))
