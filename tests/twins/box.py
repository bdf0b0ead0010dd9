"""What becomes of a coordinate outside the box, in plain Python."""

from collections.abc import Callable, Sequence
from typing import Literal

Box = Sequence[tuple[float, float]]
Rule = Literal["clip", "re-initialise", "reflect"]


def brought_back(x: list[float], box: Box, rule: Rule, uniform: Callable[[], float]) -> list[float]:
    """Return x with every coordinate inside the box."""
    bring = {"clip": _edge, "re-initialise": _new_place, "reflect": _mirror_image}[rule]
    return [
        v if lower <= v <= upper else bring(v, lower, upper, uniform)
        for v, (lower, upper) in zip(x, box, strict=True)
    ]


def _edge(v: float, lower: float, upper: float, uniform: Callable[[], float]) -> float:
    del uniform
    return lower if v < lower else upper


def _new_place(v: float, lower: float, upper: float, uniform: Callable[[], float]) -> float:
    del v
    return lower + (upper - lower) * uniform()


def _mirror_image(v: float, lower: float, upper: float, uniform: Callable[[], float]) -> float:
    image = 2.0 * lower - v if v < lower else 2.0 * upper - v
    return image if lower <= image <= upper else _edge(image, lower, upper, uniform)
