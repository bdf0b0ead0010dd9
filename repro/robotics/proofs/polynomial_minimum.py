"""Proved minimum time of a motion of polynomials that may start and end moving.

Segments are independent. At one τ a limit on the m-th derivative is a polynomial of the duration T
of degree m or less: A + B·T <= limit·T^m. From the shortest duration allowed on, the limit that is
broken most is followed to the next root of its polynomial: in between no T obeys, which is proved
by Bernstein coefficients in rational numbers, as is that the T where this ends obeys at every τ.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from repro.robotics.polynomial_motion import KINDS, PolynomialMotion, bernstein_curve, extremes
from repro.robotics.proofs.positivity import none_negative, positive
from repro.robotics.proofs.proved import FREE, LeastTime, box_in_words, closed
from repro.robotics.proofs.watch import ENDLESS, Watch

STEPS = 200  # from root to root
TRIES = 20  # likewise, where the time is over: bound and motion are found, and nothing proved of it
TINY = 1e-300  # share of the largest: a last coefficient below it bears on no root up to FAR
FAR = 1e60
SLACK = 1e-11  # share of a limit by which a motion may seem to break it when the search ends
SHORTER = 1e-12  # share by which a root is shortened for the proof
LONGER = (1e-10, 1e-9, 1e-8, 1e-7, 1e-6)  # shares by which the last T is lengthened for the proof
FURTHER = (1e-5, 1e-4, 1e-3)  # where roots come ever closer, as of a motion that starts at a limit
METHOD = (
    "cuts: at one instant of a segment a limit is a polynomial of the segment's duration, which "
    "rules out all durations up to its root; the longest ruled out bounds the time from below, and "
    "the motion is proved to keep every limit by Bernstein coefficients in rational numbers"
)


@dataclass(frozen=True, slots=True, kw_only=True)
class BrokenLimit:
    """A limit on a derivative of a joint, upper (sign 1) or lower (-1), at one τ."""

    derivative: int
    joint: int
    sign: int
    at: float


@dataclass(frozen=True, slots=True, kw_only=True)
class SegmentProof:
    """Duration of one segment: proved bound, the time of a motion proved to obey, what binds.

    The bound is infinite where no duration allowed obeys, which `needed` is the least that the
    limit leaves, infinite for none; `time` is None where none was found; `early` says that there
    was no time left to prove more.
    """

    lower: float
    time: float | None
    cut: BrokenLimit | None
    needed: float = math.inf
    early: bool = False


def polynomial_minimum(
    problem: PolynomialMotion, units: tuple[str, ...], watch: Watch = ENDLESS
) -> LeastTime:
    """Return the least time of every motion that obeys and whose durations are allowed.

    It is proved as far as it can be until the watch is over.
    """
    parts = [_segment(problem, k, watch) for k in range(problem.segments)]
    least = math.fsum(part.lower for part in parts)
    at = [part.time for part in parts if part.time is not None]
    whole = len(at) == len(parts) and problem.obeys(np.array(at))
    attained = math.fsum(at) if whole else None
    bound = math.nextafter(least, 0.0) if math.isfinite(least) else None
    binds = _at_fault(parts) or [part for part in parts if not part.early]
    early = any(part.early for part in parts)
    return LeastTime(
        minimum=None if early else closed(bound, attained),
        lower_bound=bound,
        attained=attained,
        method=METHOD,
        at=tuple(at) if whole else (),
        binding=tuple(
            f"segment {k}: {_words(problem, part.cut, units)}"
            for k, part in enumerate(parts, 1)
            if part in binds
        ),
        box=problem.durations,
        explanation=_explanation(problem, parts, units),
    )


def _explanation(
    problem: PolynomialMotion, parts: list[SegmentProof], units: tuple[str, ...]
) -> str:
    faults = _at_fault(parts)
    over = [
        f"segment {k} ({_words(problem, part.cut, units)})"
        for k, part in enumerate(parts, 1)
        if part in faults
    ]
    if not over:
        return _left(parts)
    box = box_in_words(problem.durations)
    if problem.durations == FREE and any(math.isfinite(part.needed) for part in faults):
        box = f" up to {FREE[1]:g} s"
    proved = all(math.isinf(part.lower) for part in faults)
    found = "obey" if proved else "were found that obey"
    return f"No durations{box} {found}: {'; '.join(over)}."


def _at_fault(parts: list[SegmentProof]) -> list[SegmentProof]:
    """Return the segments in which no duration obeys, else those in which none was found."""
    never = [part for part in parts if math.isinf(part.lower)]
    return never or [part for part in parts if part.time is None and not part.early]


def _left(parts: list[SegmentProof]) -> str:
    early = [k for k, part in enumerate(parts, 1) if part.early]
    if not early:
        return ""
    which, were = ("segment", "was") if len(early) == 1 else ("segments", "were")
    shown = all(part.time is not None for part in parts)
    checked = "; that the motion obeys there is checked in doubles alone" if shown else ""
    return f"The time was over before {which} {', '.join(map(str, early))} {were} proved{checked}."


def _words(problem: PolynomialMotion, cut: BrokenLimit | None, units: tuple[str, ...]) -> str:
    if cut is None:
        return f"shortest duration allowed ({problem.durations[0]:g} s)"
    low, high = problem.bounds(cut.derivative, cut.joint)
    unit = units[cut.joint] + ("", "/s", "/s²", "/s³")[cut.derivative]
    return (
        f"{KINDS[cut.derivative]} of joint {cut.joint + 1} "
        f"(limit {high if cut.sign > 0 else low:g} {unit})"
    )


def _segment(problem: PolynomialMotion, segment: int, watch: Watch) -> SegmentProof:
    shortest, longest = problem.durations
    time = proved = shortest
    cut: BrokenLimit | None = None
    left = STEPS
    while left > 0:
        left = min(left - 1, TRIES) if watch.over else left - 1
        worst, excess = _worst(problem, segment, time)
        if excess <= SLACK:
            shares = LONGER if cut else (0.0, *LONGER)  # as it is where the box binds
            found = _lengthened(problem, segment, time, watch, shares)
            if found is not None:
                return SegmentProof(lower=proved, time=found, cut=cut)
            if watch.over and (shown := _barely_lengthened(problem, segment, time)) is not None:
                return SegmentProof(lower=proved, time=shown, cut=cut, early=True)
            if excess <= 0.0:
                break
        cut = worst
        room = _room(problem, segment, cut)
        after = _next_root(room, time)
        if after > longest:
            never = positive(_mapped(room, proved, longest))
            bound = math.inf if never else proved
            return SegmentProof(lower=bound, time=None, cut=cut, needed=after)
        reached = after * (1.0 - SHORTER)
        if reached > proved and positive(_mapped(room, proved, reached)):
            proved = reached
        time = max(after, time * (1.0 + SHORTER))
    found = None if watch.over else _lengthened(problem, segment, time, watch, FURTHER)
    return SegmentProof(lower=proved, time=found, cut=cut, early=watch.over)


def _barely_lengthened(problem: PolynomialMotion, segment: int, time: float) -> float | None:
    """Return a duration little longer that obeys in doubles, without a proof."""
    longer = (min(time * (1.0 + share), problem.durations[1]) for share in LONGER)
    return next((each for each in longer if _worst(problem, segment, each)[1] <= 0.0), None)


def _worst(problem: PolynomialMotion, segment: int, time: float) -> tuple[BrokenLimit, float]:
    """Return the limit that is broken most, as a share of it, or kept most barely."""
    found = (BrokenLimit(derivative=1, joint=0, sign=1, at=0.0), -math.inf)
    for joint, m in _limited(problem):
        low, high = problem.bounds(m, joint)
        least, most, at_least, at_most = extremes(problem, segment, joint, m, time)
        size = high - low if m == 0 else 1.0
        above = (most - high) / (size if m == 0 else high) if high < math.inf else -math.inf
        below = (low - least) / (size if m == 0 else -low) if low > -math.inf else -math.inf
        for excess, sign, at in ((above, 1, at_most), (below, -1, at_least)):
            if excess > found[1]:
                found = (BrokenLimit(derivative=m, joint=joint, sign=sign, at=at), excess)
    return found


def _room(problem: PolynomialMotion, segment: int, cut: BrokenLimit) -> list[Fraction]:
    """Return by how much a limit is broken at one τ, times T^m, as a polynomial of T."""
    m = cut.derivative
    still, moving = problem.value(segment, cut.joint, m, Fraction(cut.at))
    low, high = problem.bounds(m, cut.joint)
    room = [cut.sign * still, cut.sign * moving, Fraction(0), Fraction(0)]
    room[m] -= Fraction(high if cut.sign > 0 else -low)
    return room


def _next_root(room: list[Fraction], time: float) -> float:
    """Return the least root above a time, infinite where there is none.

    Where it is so far that doubles do not hold it, return a time on the way there.
    """
    # in a unit in which the time is 1, so that no coefficient is lost
    scaled = np.polynomial.Polynomial(
        [float(entry * Fraction(time) ** power) for power, entry in enumerate(room)]
    ).trim()
    near = scaled.trim(TINY * abs(scaled.coef).max())
    roots = near.roots()
    real = roots.real[(abs(roots.imag) <= 1e-9 * abs(roots)) & (roots.real > 1.0)]
    if real.size:
        return time * float(real.min())
    return time * FAR if near.degree() < scaled.degree() else math.inf


def _mapped(room: list[Fraction], start: float, end: float) -> list[Fraction]:
    """Return the polynomial of u where T = start + u·(end - start)."""
    low, width = Fraction(start), Fraction(end) - Fraction(start)
    return [
        sum((room[j] * math.comb(j, i) * low ** (j - i) for j in range(i, len(room))), Fraction(0))
        * width**i
        for i in range(len(room))
    ]


def _lengthened(
    problem: PolynomialMotion, segment: int, time: float, watch: Watch, shares: Sequence[float]
) -> float | None:
    """Return a duration little longer that is proved to obey."""
    for share in shares:
        longer = min(time * (1.0 + share), problem.durations[1])
        if all(_kept(problem, segment, limit, longer, watch) for limit in _limited(problem)):
            return longer
    return None


def _limited(problem: PolynomialMotion) -> list[tuple[int, int]]:
    return [
        (joint, m)
        for joint in range(problem.joints)
        for m in KINDS
        if any(map(math.isfinite, problem.bounds(m, joint)))
    ]


def _kept(
    problem: PolynomialMotion, segment: int, limited: tuple[int, int], time: float, watch: Watch
) -> bool:
    if watch.over:
        return False
    joint, m = limited
    least, most, *_ = extremes(problem, segment, joint, m, time)
    low, high = problem.bounds(m, joint)
    if not low <= least <= most <= high:
        return False
    duration = Fraction(time)
    curve = bernstein_curve(problem, segment, joint, m, duration)
    for sign, limit in ((1, high), (-1, -low)):
        if math.isfinite(limit):
            room = Fraction(limit) * duration**m
            if not none_negative([room - sign * entry for entry in curve], watch):
                return False
    return True
