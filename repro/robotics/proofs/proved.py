"""What is proved of the time of a motion."""

from dataclasses import dataclass

from repro.robotics.polynomial_motion import COMPUTED

GAP = 1e-5  # share of its time: a motion that is nearer to the bound is a minimum
FREE = COMPUTED  # s: where nobody says how long a segment may last


@dataclass(frozen=True, slots=True, kw_only=True)
class LeastTime:
    """The proved minimum time of one problem, in s.

    `lower_bound` is proved, `attained` is the time of a motion checked to obey; `at` are its
    durations; `binding` names the joint and limit that hold each segment back; `box` is the
    (shortest, longest) duration allowed, and both bound and motion are those of it. There is a
    `minimum` only where bound and motion are within GAP. Where a search is
    better off breaking limits there is no `minimum`; `lower_bound` then holds for every motion
    that obeys, `at` is where the search is led, and `explanation` says why.
    """

    minimum: float | None
    lower_bound: float | None
    attained: float | None
    method: str
    at: tuple[float, ...]
    binding: tuple[str, ...]
    box: tuple[float, float] | None = None
    explanation: str = ""

    @property
    def gap(self) -> float | None:
        """By which share of its time the motion may be slower than the minimum."""
        return gap(self.lower_bound, self.attained)


def gap(lower: float | None, attained: float | None) -> float | None:
    """Return the distance from a bound to a motion as a share of the motion; None without both."""
    if lower is None or attained is None:
        return None
    return max(0.0, 1.0 - lower / attained)


def closed(lower: float | None, attained: float | None) -> float | None:
    """Return the time attained where it is a minimum, else None."""
    found = gap(lower, attained)
    return attained if found is not None and found <= GAP else None


def box_in_words(box: tuple[float, float], before: str = " ") -> str:
    """Return " from 0.1 to 5 s" after words of its own; nothing where durations are free."""
    return "" if box == FREE else f"{before}from {box[0]:g} to {box[1]:g} s"
