from typing import Any

import numpy as np
import pytest

from papers.liang2026 import IWOA
from papers.smwoa2022 import SMWOA
from repro.errors import InputError
from repro.functions import FUNCTIONS
from repro.optimisers import DBO, GSA, PSO, HybridWOA, SlimeWOA


@pytest.mark.parametrize(
    ("optimiser", "wrong"),
    [
        (DBO, {"groups": "as printed"}),
        (GSA, {"bounds": "bounce"}),
        (PSO, {"clip": "none"}),
        (HybridWOA, {"control": "Quadratic"}),
        (SlimeWOA, {"logarithm": "binary"}),
    ],
)
def test_an_unknown_word_is_refused_with_the_known_ones(
    optimiser: type[Any], wrong: dict[str, str]
) -> None:
    ((name, value),) = wrong.items()
    with pytest.raises(InputError, match=rf"{name}='{value}' is none of '"):
        optimiser(**wrong)


@pytest.mark.parametrize("variant", [IWOA, SMWOA])
def test_a_declared_variant_is_used_as_itself_or_as_a_class(
    variant: HybridWOA | SlimeWOA,
) -> None:
    problem = FUNCTIONS["sphere"].problem(3)

    first, second = (
        each.minimise(problem, population=6, iterations=5, rng=np.random.default_rng(1))
        for each in (variant, variant())
    )

    assert first.cost == second.cost
    assert variant(leader="per dimension").leader == "per dimension"
