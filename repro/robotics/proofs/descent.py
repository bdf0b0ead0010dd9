"""The search for a fast motion that obeys, from which a proof starts.

In each step the cubes of the acceleration limits are replaced by their tangents at the motion so
far, so that the optimum of the linear programme obeys, and is no slower. A convex part of a jerk
limit (see `jolts`) has tangents at all motions looked at so far: of it the optimum may break a
little, which slowing it as a whole makes good. As such a descent ends in the nearest valley, it
starts from the best of many directions (J. H. Halton, Numerische Mathematik 2 (1960) 84-90).
"""

import numpy as np
from numpy.typing import NDArray

from repro.robotics.directed_spline import Spline, jerk_of, sides
from repro.robotics.proofs.jolts import Limit
from repro.robotics.proofs.limit_pool import Limits
from repro.robotics.proofs.linear_programmes import solved
from repro.robotics.proofs.watch import ENDLESS, Watch

Vector = NDArray[np.float64]
ROUNDS = 8  # of added limits in one step
STEPS = 200
GAIN = 1e-10  # share of the total time: the search ends when a step gains less
DIRECTIONS = 2000  # tried from which to start
STARTS = 4  # of them that are gone down from


def just_obeying(problem: Spline, durations: Vector) -> Vector:
    """Return motions (…, segments) as slow as limits and shortest durations need them to be.

    Infinitely slow where time stands still, or where a duration becomes longer than is allowed.
    """
    durations = np.asarray(durations, dtype=np.float64)
    shortest, longest = problem.durations
    peaks = problem.peak_shares(durations)
    whole = np.isfinite(peaks).all(axis=-1) & (durations > 0.0).all(axis=-1)
    needed = np.maximum(peaks[..., 0], np.sqrt(peaks[..., 1]))
    if jerk_of(problem) is not None:
        needed = np.maximum(needed, np.cbrt(peaks[..., 2]))
    scale = np.where(whole, needed, 1.0)[..., None]
    forwards = np.where(durations > 0.0, durations, 1.0)
    found = durations * np.maximum(scale, (shortest / forwards).max(axis=-1, keepdims=True))
    allowed = whole & (found <= longest * (1.0 + GAIN)).all(axis=-1)
    return np.where(allowed[..., None], np.minimum(found, longest), np.inf)


def starts(problem: Spline, first: Vector) -> Vector:
    """Return motions that obey, the fastest first; `first` need not obey and is among the tried."""
    from scipy.stats import qmc  # noqa: PLC0415 (slow to load)

    share = qmc.Halton(problem.segments, scramble=False).random(DIRECTIONS + 1)[1:]
    directions = np.vstack([first, chords(problem), np.ones(problem.segments), -np.log(share)])
    motions = just_obeying(problem, directions)
    total = motions.sum(axis=1)
    order = np.argsort(total, kind="stable")[:STARTS]
    return np.asarray(motions[order[np.isfinite(total[order])]])


def chords(problem: Spline) -> Vector:
    """Return what each segment would take alone, roughly, shape (segments,)."""
    moves = np.diff(np.array(problem.nodes), axis=0)[..., None]
    fast = (moves / np.array(sides(problem.velocity))).max(axis=-1)
    hard = (moves / np.array(sides(problem.acceleration))).max(axis=-1)
    longest = np.maximum(fast, np.sqrt(hard))
    if (jerk := jerk_of(problem)) is not None:
        longest = np.maximum(longest, np.cbrt((moves / np.array(jerk)).max(axis=-1)))
    return np.asarray(longest.max(axis=1))


def descended(
    problem: Spline, limits: Limits, start: Vector, watch: Watch = ENDLESS
) -> tuple[Vector, tuple[Limit, ...]]:
    """Return a motion from which no small change is faster, and the limits that hold it back."""
    best, held = start, np.array([])
    for _ in range(STEPS):
        if watch.over:
            break
        around = np.column_stack([best, best])
        anywhere = np.tile(
            [problem.durations[0], min(problem.durations[1], best.sum())], (len(best), 1)
        )
        for _ in range(ROUNDS):
            found = solved(limits, np.ones(len(best)), around, anywhere)
            if watch.over or not limits.add_worst(found.x):
                break
        motion, held = just_obeying(problem, found.x), found.weights
        gain = best.sum() - motion.sum()
        if gain <= 0.0:
            break
        best = motion
        if gain < GAIN * best.sum():
            break
    known = zip(limits.known, held, strict=False)
    return best, tuple(limit for limit, weight in known if weight > 0.0)
