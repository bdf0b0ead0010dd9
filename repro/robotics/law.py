"""What a rest-to-rest motion asks of the law that its joints follow."""

import math
from collections.abc import Callable, Mapping
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from repro.errors import DeclarationError
from repro.robotics.motion_checks import shown

Vector = NDArray[np.float64]
SAMPLES = 1001
ROUNDING = 1e-9  # share by which sums and roots of doubles may differ
LEAST = {1: 1.0, 2: 4.0}
"""The least peak factors of any curve at rest at both ends: its mean speed, and full thrust up to
the middle and full brake from there."""


class Law(Protocol):
    """A curve s(τ) that takes every joint from rest to rest: s(0) = 0, s(1) = 1, s' = 0 at both.

    A joint that moves D in time T along it is at D · s(t/T) after t.
    """

    def peak_factor(self, derivative: int) -> float:
        """Return max abs(s^(m)(τ)) on [0, 1] for derivative m = 1, 2 or 3, exactly.

        Proofs rest on it. It is asked for only where a limit is declared on that derivative.
        """

    def sample(self, share: Vector, derivative: int = 0) -> Vector:
        """Return s^(m) at normalised times `share`, same shape."""


def check_law(law: Any, derivatives: Mapping[int, str]) -> None:  # noqa: ANN401 (the user's own)
    """Raise DeclarationError for a law that cannot be, as far as these derivatives are limited."""
    called = type(law).__name__
    if not (callable(getattr(law, "peak_factor", None)) and callable(getattr(law, "sample", None))):
        message = f"law {called} must have peak_factor(derivative) and sample(share, derivative)"
        raise DeclarationError(message)
    share = np.linspace(0.0, 1.0, SAMPLES)
    _check_ends(called, _sampled(law, share, 0))
    for m, kind in derivatives.items():
        factor = _asked(called, f"peak_factor({m})", law.peak_factor, m)
        if not (isinstance(factor, int | float | np.floating) and math.isfinite(factor)):
            message = (
                f"law {called}: the peak factor of its {kind} is {factor!r}, so no duration keeps "
                f"the limit on {kind}: it must be a finite number, or that limit be left out"
            )
            raise DeclarationError(message)
        if factor < LEAST.get(m, 0.0) * (1.0 - ROUNDING) or factor <= 0.0:
            least = LEAST.get(m, "above 0")
            message = (
                f"law {called}: the peak factor of its {kind} is {factor}; from rest to rest it is "
                f"at least {least}"
            )
            raise DeclarationError(message)
        curve = np.abs(_sampled(law, share, m))
        if not curve.max() <= factor * (1.0 + ROUNDING):
            peak, at = curve.max(), share[curve.argmax()]
            message = (
                f"law {called}: its {kind} is {peak:.7g} at τ = {at:.3f}, which is more than its "
                f"peak factor, {factor:.7g}"
            )
            raise DeclarationError(message)


def _sampled(law: Law, share: Vector, derivative: int) -> Vector:
    called = type(law).__name__
    curve: Vector = _asked(called, f"sample(share, {derivative})", _curve, law, share, derivative)
    if curve.shape != share.shape or np.isnan(curve).any():
        message = (
            f"law {called}: sample(share, {derivative}) must return a number for each share, "
            f"shape {share.shape}, not {shown(curve)}"
        )
        raise DeclarationError(message)
    return curve


def _curve(law: Law, share: Vector, derivative: int) -> Vector:
    return np.asarray(law.sample(share, derivative), dtype=np.float64)


def _asked(called: str, what: str, ask: Callable[..., Any], *arguments: object) -> Any:  # noqa: ANN401
    """Return what a law answers; DeclarationError where it raises instead."""
    try:
        return ask(*arguments)
    except Exception as error:
        message = f"law {called}: {what} raises {type(error).__name__}: {shown(str(error))}"
        raise DeclarationError(message) from error


def _check_ends(called: str, curve: Vector) -> None:
    if abs(curve[0]) > ROUNDING or abs(curve[-1] - 1.0) > ROUNDING:
        message = f"law {called} goes from {curve[0]:.7g} to {curve[-1]:.7g}, not from 0 to 1"
        raise DeclarationError(message)
