"""The whale algorithm with each addition alone, and with all of them."""

from dataclasses import replace

from repro.optimisers import HybridWOA, SlimeWOA

ADDITIONS = (
    HybridWOA(start="tent"),
    HybridWOA(start="tent across"),
    HybridWOA(start="tent chain"),
    HybridWOA(control="quadratic"),
    HybridWOA(spiral=(2.0, 0.5)),
    HybridWOA(probability="cosine"),
    HybridWOA(probability_selects="spiral"),
    HybridWOA(coefficients="vector"),
    HybridWOA(leader="per whale"),
    HybridWOA(spiral_range="symmetric"),
    HybridWOA(differential=0.4),
    HybridWOA(genetic=0.3),
    HybridWOA(genetic=0.3, partner="best"),
    HybridWOA(disturbance=0.2),
    HybridWOA(disturbance=0.2, chain="going on"),
    HybridWOA(disturbance=0.2, perturbs="in proportion"),
    HybridWOA(genetic=0.3, perturbs="in proportion"),
    HybridWOA(shared_draw=True),
    HybridWOA(bounds="re-initialise"),
    HybridWOA(bounds="reflect"),
)
TOGETHER = HybridWOA(
    start="tent across",
    control="quadratic",
    spiral=(1.5, 0.5),
    probability="cosine",
    probability_selects="spiral",
    coefficients="vector",
    leader="per whale",
    spiral_range="symmetric",
    differential=0.6,
    scale=0.7,
    crossover=0.4,
    genetic=0.6,
    mutation=0.1,
    greedy=False,
    disturbance=0.3,
)
SLIME_PARTS = (
    SlimeWOA(b=0.5),
    SlimeWOA(control="arctanh"),
    SlimeWOA(weight="of the whale"),
    SlimeWOA(weight="of the leader"),
    SlimeWOA(swing="per dimension"),
    SlimeWOA(swing="per whale"),
    SlimeWOA(coefficients="vector"),
    SlimeWOA(shared_draw=True),
    SlimeWOA(leader="per whale"),
    SlimeWOA(spiral_range="symmetric"),
    SlimeWOA(restart=0.2),
    SlimeWOA(moves="at once"),
    SlimeWOA(greedy=True),
    SlimeWOA(bounds="reflect"),
)
SLIME_TOGETHER = SlimeWOA(
    b=0.7,
    control="arctanh",
    weight="of the whale",
    swing="per dimension",
    leader="per whale",
    spiral_range="symmetric",
    restart=0.1,
)
SLIME_DETAILS = (
    replace(SLIME_TOGETHER, weights="per whale"),
    replace(SLIME_TOGETHER, logarithm="natural"),
    replace(SLIME_TOGETHER, weight="of the leader", leader="per dimension"),
    replace(SLIME_TOGETHER, swing="per whale", weights="per whale", shared_draw=True),
    replace(SLIME_TOGETHER, coefficients="vector"),
    replace(SLIME_TOGETHER, moves="at once", greedy=True),
    replace(SLIME_TOGETHER, bounds="re-initialise"),
    replace(SLIME_TOGETHER, coefficients="vector", shared_draw=True, leader="per dimension"),
)
SLIME = (*SLIME_PARTS, SLIME_TOGETHER, *SLIME_DETAILS)
"""The slime mould whale with each part alone, with all, and with other readings of them."""
