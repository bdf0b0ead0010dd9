from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from papers.mousa2023 import PAPER
from repro.determinism.compiled import COST, ready
from repro.errors import DeclarationError
from repro.judge.certificates import certify
from repro.robotics import PathFitting, RestToRestLaw, cubic, quintic, septic
from repro.robotics.path_fitting import _orthogonal

FIT = PathFitting(
    start=0.3, end=-1.1, law=quintic, duration=3.0, intervals=40, box=((-50.0, 50.0),) * 6
)
SEPTIC = replace(FIT, law=septic)
LAWS = pytest.mark.parametrize("law", [cubic, quintic, septic, RestToRestLaw(9)], ids=repr)
ANY_POINT = st.lists(st.floats(-50.0, 50.0), min_size=6, max_size=6)


def cost(fit: PathFitting, coefficients: np.ndarray) -> float:
    point = np.ascontiguousarray(coefficients, dtype=np.float64)
    return float(ready(fit.kernel, COST)(point, fit.data))


def norm_at_every_instant(fit: PathFitting, coefficients: np.ndarray) -> float:
    """Return the norm that the kernel gives, in the words of the definition."""
    squares = 0.0
    for k in range(fit.intervals + 1):
        t = fit.duration * k / fit.intervals
        share = float(fit.law.polynomial(t / fit.duration))
        desired = fit.start + (fit.end - fit.start) * share
        squares += (sum(a * t**j for j, a in enumerate(coefficients)) - desired) ** 2
    return float(squares**0.5)


@LAWS
@given(point=ANY_POINT)
def test_compiled_cost_is_the_norm_of_the_difference_at_every_instant(
    law: RestToRestLaw, point: list[float]
) -> None:
    fit = replace(FIT, law=law)
    coefficients = np.array(point) / fit.duration ** np.arange(6)

    expected = norm_at_every_instant(fit, coefficients)
    assert cost(fit, coefficients) == pytest.approx(expected, rel=1e-11)


@pytest.mark.parametrize("law", [cubic, quintic], ids=repr)
def test_own_coefficients_of_a_polynomial_path_cost_nothing(law: RestToRestLaw) -> None:
    fit = replace(FIT, law=law)

    assert cost(fit, fit.coefficients) == fit.least_cost() == 0.0
    assert norm_at_every_instant(fit, fit.coefficients) < 1e-13


@pytest.mark.parametrize("n", [1, 4, 6, 9])
def test_factors_of_the_powers_are_orthonormal_and_give_them_back(n: int) -> None:
    Q, R = _orthogonal(100, n)

    assert pytest.approx(np.eye(n), abs=1e-14) == Q.T @ Q
    assert pytest.approx(np.vander(np.linspace(0, 1, 101), n, increasing=True), abs=1e-13) == Q @ R
    assert np.tril(R, -1).tolist() == np.zeros((n, n)).tolist()


@LAWS
@given(step=ANY_POINT)
def test_no_step_from_the_nearest_coefficients_costs_less(
    law: RestToRestLaw, step: list[float]
) -> None:
    fit = replace(FIT, law=law)
    coefficients = fit.nearest() + np.array(step)

    assert norm_at_every_instant(fit, coefficients) >= fit.least_cost() * (1 - 1e-12)


def test_nearest_coefficients_are_those_of_a_library() -> None:
    powers = np.vander(SEPTIC.times, 6, increasing=True)
    expected, squares, *_ = np.linalg.lstsq(powers, SEPTIC.desired)

    assert SEPTIC.nearest() == pytest.approx(expected, rel=1e-9, abs=1e-10)
    assert SEPTIC.least_cost() == pytest.approx(float(squares[0]) ** 0.5, rel=1e-9)
    assert cost(SEPTIC, SEPTIC.nearest()) == pytest.approx(SEPTIC.least_cost(), rel=1e-12)


@given(point=ANY_POINT, duration=st.floats(0.1, 20.0))
def test_the_cost_of_a_place_in_the_box_does_not_depend_on_the_duration(
    point: list[float], duration: float
) -> None:
    fit = replace(FIT, duration=duration)
    powers = np.arange(6)

    shown = cost(FIT, np.array(point) / FIT.duration**powers)
    assert cost(fit, np.array(point) / duration**powers) == pytest.approx(shown, rel=1e-9)


def test_bounds_shrink_with_the_power_of_the_duration() -> None:
    assert FIT.bounds[:, 1] == pytest.approx([50.0 / 3.0**j for j in range(6)])
    assert FIT.bounds[:, 0] == pytest.approx(-FIT.bounds[:, 1])


def test_errors_of_a_shifted_path_are_the_shift() -> None:
    shifted = FIT.coefficients + np.array([0.02, 0, 0, 0, 0, 0])

    for name in ("start error", "end error", "rms error"):
        assert FIT.quantity(name, shifted) == pytest.approx(0.02)
    assert FIT.quantity("rms error", shifted) * 41**0.5 == pytest.approx(cost(FIT, shifted))


def test_unknown_quantity_is_refused_with_the_known_ones() -> None:
    with pytest.raises(DeclarationError, match=r"no quantity 'joy'.*'rms error'.*'peak jerk'"):
        FIT.quantity("joy", FIT.coefficients)


@pytest.mark.parametrize(
    ("field", "value", "said"),
    [
        ("duration", 0.0, "duration 0.0 s"),
        ("intervals", 5, "at least the 6 coefficients"),
        ("box", (), "one pair"),
        ("box", ((1.0, 0.0),), "lower <= upper"),
    ],
)
def test_impossible_fit_is_refused(field: str, value: object, said: str) -> None:
    with pytest.raises(DeclarationError, match=said):
        replace(FIT, **{field: value})  # type: ignore[arg-type]


def test_certificate_says_the_least_norm_and_that_it_is_no_time() -> None:
    found = {certificate.problem: certificate for certificate in certify(PAPER)}

    assert list(found) == [experiment.name for experiment in PAPER.experiments]
    assert "norm in rad" in found["quintic path"].explanation
    assert "global one: 0 rad" in found["quintic path"].explanation
    assert "inside the bounds of the search in 6 of 6" in found["quintic path"].explanation
    assert "0.000161 to 0.0322 rad" in found["septic path"].explanation
    assert "inside the bounds of the search in 4 of 6" in found["septic path"].explanation
    assert all(certificate.minimum is None for certificate in found.values())
