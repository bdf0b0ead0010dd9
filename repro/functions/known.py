"""What is known of a function for certain: bounds that printed costs are held against."""

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

Box = tuple[tuple[float, float], ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Known:
    """Bounds of a function's values, each one proved; what is left out claims nothing.

    They hold of the kernel `of`: a function that has another one has none of them.

    In n dimensions no value exceeds `ceiling(n)` on the box `ceiling_on`, which is given like that
    of the function: each term at its greatest, say. A run that starts inside the box has a best of
    that at most, wherever it goes later. With `least_of_all_space` no value outside the box is
    below the minimum either.

    Where terms of fixed size are added which cancel at the minimum, every value near it is a
    multiple of `step`, the spacing of doubles at the smallest of them, on a `condition` in words.
    `cancelled` is the size of such terms in sum: a value computed in single precision may be below
    the minimum by a few roundings of it. 0 says that none cancel; None, that it is not known.
    """

    of: Any = None
    ceiling: Callable[[int], Fraction] | None = None
    ceiling_on: Box = ()
    least_of_all_space: bool = False
    step: float = 0.0
    condition: str = ""
    cancelled: int | None = None

    def most(self, box: Box, dimension: int) -> Fraction | None:
        """Return the ceiling in so many dimensions, None where it is not known on all of a box."""
        if self.ceiling is None or len(box) != len(self.ceiling_on):
            return None
        sides = zip(box, self.ceiling_on, strict=True)
        if not all(least <= low and high <= most for (low, high), (least, most) in sides):
            return None
        return self.ceiling(dimension)

    def __reduce__(self) -> tuple[type["Known"], tuple[()]]:
        """Stay at home: no run asks for bounds, and a lambda cannot travel to a worker."""
        return Known, ()

    def __copy__(self) -> "Known":
        """Return the same, which nothing can change."""
        return self

    def __deepcopy__(self, memo: object) -> "Known":
        """Return the same, which nothing can change."""
        return self


NOTHING = Known()
