import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from repro.errors import DeclarationError
from repro.optimisers import DE
from repro.robotics import MinimumTime, quintic
from repro.robotics.proofs.least_time import least_time
from tests.doe2021 import ARM

Vector = NDArray[np.float64]
CYCLOID = (2.0, 2 * math.pi, 4 * math.pi**2)


@dataclass(frozen=True, kw_only=True)
class Cycloid:
    """s = τ - sin(2πτ) / 2π, whose jerk is greatest at its ends."""

    factors: tuple[Any, ...] = CYCLOID
    end: float = 1.0

    def peak_factor(self, derivative: int) -> float:
        """Return the greatest value of a derivative."""
        value: float = self.factors[derivative - 1]
        return value

    def sample(self, share: Vector, derivative: int = 0) -> Vector:
        """Return the curve or a derivative of it."""
        angle = 2 * math.pi * share
        curves = (
            self.end * (share - np.sin(angle) / (2 * math.pi)),
            1 - np.cos(angle),
            2 * math.pi * np.sin(angle),
            4 * math.pi**2 * np.cos(angle),
        )
        return np.asarray(curves[derivative])


def along(law: Any, **changes: Any) -> MinimumTime:  # noqa: ANN401
    """Return the small arm's motion along a law."""
    return replace(ARM, law=law, **changes)


def test_motion_along_a_law_of_ones_own_is_certified_and_found() -> None:
    problem = along(Cycloid())

    certificate = least_time(problem)
    found = DE().minimise(problem, population=20, iterations=100, rng=np.random.default_rng(1))

    assert certificate.minimum == pytest.approx(problem.shortest().sum())
    assert found.cost == pytest.approx(certificate.minimum, rel=1e-6)


def test_law_is_asked_only_for_what_is_limited() -> None:
    endless = Cycloid(factors=(*CYCLOID[:2], math.inf))

    assert along(endless).shortest().tobytes() == along(Cycloid()).shortest().tobytes()
    assert np.isfinite(along(endless).data).sum() == len(along(endless).data) - 2  # no jerk limits


@pytest.mark.parametrize(
    ("law", "fault"),
    [
        (3, "law int must have peak_factor"),
        (
            Cycloid(factors=(math.inf, 7.0, 1.0)),
            "peak factor of its velocity is inf, so no duratio",
        ),
        (Cycloid(factors=(math.nan, 7.0, 1.0)), "peak factor of its velocity is nan"),
        (Cycloid(factors=(None, 7.0, 1.0)), "peak factor of its velocity is None"),
        (Cycloid(factors=(0.5, 7.0, 1.0)), "velocity is 0.5; from rest to rest it is at least 1.0"),
        (
            Cycloid(factors=(1.9, 7.0, 1.0)),
            "its velocity is 2 at τ = 0.500, which is more than its",
        ),
        (Cycloid(factors=(2.0, -7.0, 1.0)), "acceleration is -7.0; from rest to rest"),
        (Cycloid(end=2.0), "law Cycloid goes from 0 to 2, not from 0 to 1"),
    ],
)
def test_law_that_cannot_be_is_refused_where_it_is_declared(law: Any, fault: str) -> None:  # noqa: ANN401
    with pytest.raises(DeclarationError, match=fault):
        along(law)


def test_limit_on_a_jerk_that_is_infinite_is_refused() -> None:
    endless = Cycloid(factors=(*CYCLOID[:2], math.inf))

    with pytest.raises(DeclarationError, match="no duration keeps the limit on jerk"):
        along(endless, jerk=(60.0, 60.0))


def test_law_that_stands_is_unchanged_by_the_check() -> None:
    assert along(quintic) == ARM
