"""The whale algorithm with each addition alone, and with all of them."""

from repro.optimisers import HybridWOA

ADDITIONS = (
    HybridWOA(start="tent"),
    HybridWOA(start="tent across"),
    HybridWOA(control="quadratic"),
    HybridWOA(spiral=(2.0, 0.5)),
    HybridWOA(probability="cosine"),
    HybridWOA(probability_selects="spiral"),
    HybridWOA(coefficients="vector"),
    HybridWOA(leader="per whale"),
    HybridWOA(spiral_range="symmetric"),
    HybridWOA(differential=0.4),
    HybridWOA(genetic=0.3),
    HybridWOA(disturbance=0.2),
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
