import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from repro.errors import InputError
from repro.robotics import RestToRestLaw, cubic, quintic, septic

LAWS = [cubic, quintic, septic, RestToRestLaw(9), RestToRestLaw(11)]

each_law = pytest.mark.parametrize("law", LAWS, ids=lambda law: f"degree {law.degree}")


@pytest.mark.parametrize(
    ("law", "factors"),
    [
        (cubic, (3 / 2, 6, 12)),
        (quintic, (15 / 8, 10 / math.sqrt(3), 60)),
        (septic, (35 / 16, 84 * math.sqrt(5) / 25, 105 / 2)),
    ],
    ids=["cubic", "quintic", "septic"],
)
def test_peak_factors_are_those_of_theory(
    law: RestToRestLaw, factors: tuple[float, float, float]
) -> None:
    assert [law.peak_factor(m) for m in (1, 2, 3)] == pytest.approx(factors, rel=1e-12)


@pytest.mark.parametrize(
    ("law", "coefficients"),
    [
        (cubic, [0, 0, 3, -2]),
        (quintic, [0, 0, 0, 10, -15, 6]),
        (septic, [0, 0, 0, 0, 35, -84, 70, -20]),
    ],
    ids=["cubic", "quintic", "septic"],
)
def test_coefficients_are_those_of_the_textbook(
    law: RestToRestLaw, coefficients: list[float]
) -> None:
    assert law.polynomial.coef == pytest.approx(coefficients, abs=1e-12)


@each_law
def test_law_leads_from_rest_at_0_to_rest_at_1(law: RestToRestLaw) -> None:
    k = (law.degree - 1) // 2

    ends = law.sample(np.array([0.0, 1.0]))
    derivatives = [law.sample(np.array([0.0, 1.0]), m) for m in range(1, k + 1)]

    assert ends == pytest.approx([0.0, 1.0], abs=1e-12)
    # the coefficients grow as 11! / 5!, and their rounding with them
    assert np.array(derivatives) == pytest.approx(np.zeros((k, 2)), abs=1e-7)
    assert law.polynomial.degree() == law.degree


@each_law
@given(share=st.floats(0.0, 1.0))
def test_law_is_symmetric_about_its_middle_and_never_goes_back(
    law: RestToRestLaw, share: float
) -> None:
    there, back = law.sample(np.array([share, 1.0 - share]))

    assert there + back == pytest.approx(1.0, abs=1e-11)
    assert float(law.sample(np.array([share]), 1)[0]) >= -1e-9


@each_law
@pytest.mark.parametrize("derivative", [0, 1, 2, 3, 4])
def test_peak_is_the_greatest_of_many_samples(law: RestToRestLaw, derivative: int) -> None:
    sampled = float(np.abs(law.sample(np.linspace(0.0, 1.0, 20_001), derivative)).max())

    peak = law.peak_factor(derivative)

    assert sampled <= peak * (1 + 1e-12)
    assert sampled == pytest.approx(peak, rel=1e-6)


@each_law
@pytest.mark.parametrize("derivative", [1, 2, 3])
def test_samples_of_a_derivative_are_differences_of_the_one_before(
    law: RestToRestLaw, derivative: int
) -> None:
    share, step = np.linspace(0.1, 0.9, 9), 1e-6

    difference = law.sample(share + step, derivative - 1) - law.sample(share - step, derivative - 1)

    assert law.sample(share, derivative) == pytest.approx(difference / (2 * step), abs=1e-4)


@pytest.mark.parametrize("degree", [-1, 1, 2, 4, 6])
def test_degree_that_allows_no_rest_at_both_ends_is_refused(degree: int) -> None:
    fault = rf"degree {degree}: a rest-to-rest polynomial has degree 3, 5, 7"
    with pytest.raises(InputError, match=fault):
        RestToRestLaw(degree)
