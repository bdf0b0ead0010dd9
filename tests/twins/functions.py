"""Benchmark functions in plain Python, from their printed formulas with one rounding per sum."""

import math
from collections.abc import Callable, Sequence
from itertools import pairwise
from math import cos, e, exp, fsum, pi, prod, sin, sqrt

Point = Sequence[float]


def _penalty(x: float, a: float, k: float, m: int) -> float:
    return k * max(abs(x) - a, 0.0) ** m


def _schwefel_1_2(x: Point) -> float:
    return fsum(fsum(x[:i]) ** 2 for i in range(1, len(x) + 1))


def _rosenbrock(x: Point) -> float:
    return fsum(100 * (after - v**2) ** 2 + (v - 1) ** 2 for v, after in pairwise(x))


def _ackley(x: Point) -> float:
    n = len(x)
    bowl = 20 * (1 - exp(-0.2 * sqrt(fsum(v**2 for v in x) / n)))
    return bowl + e - exp(fsum(cos(2 * pi * v) for v in x) / n)


def _penalized_1(x: Point) -> float:
    n = len(x)
    y = [1 + (v + 1) / 4 for v in x]
    middle = fsum((y[i] - 1) ** 2 * (1 + 10 * sin(pi * y[i + 1]) ** 2) for i in range(n - 1))
    waves = 10 * sin(pi * y[0]) ** 2 + middle + (y[-1] - 1) ** 2
    return pi * waves / n + fsum(_penalty(v, 10, 100, 4) for v in x)


def _penalized_2(x: Point) -> float:
    n = len(x)
    middle = fsum((x[i] - 1) ** 2 * (1 + sin(3 * pi * x[i + 1]) ** 2) for i in range(n - 1))
    last = (x[-1] - 1) ** 2 * (1 + sin(2 * pi * x[-1]) ** 2)
    waves = sin(3 * pi * x[0]) ** 2 + middle + last
    return waves / 10 + fsum(_penalty(v, 5, 100, 4) for v in x)


def _foxholes(x: Point) -> float:
    holes = [(across, up) for up in range(-32, 33, 16) for across in range(-32, 33, 16)]
    depths = (
        1 / (j + (x[0] - across) ** 6 + (x[1] - up) ** 6)
        for j, (across, up) in enumerate(holes, start=1)
    )
    return 1 / (0.002 + fsum(depths))


def _branin(x: Point) -> float:
    a, b = x
    bowl = b - 5.1 / (2 * pi) ** 2 * a**2 + 5 / pi * a - 6
    return bowl**2 + 10 * (1 - 1 / (8 * pi)) * cos(a) + 10


def _goldstein_price(x: Point) -> float:
    a, b = x
    first = 19 - 14 * a + 3 * a**2 - 14 * b + 6 * a * b + 3 * b**2
    second = 18 - 32 * a + 12 * a**2 + 48 * b - 36 * a * b + 27 * b**2
    return (1 + (a + b + 1) ** 2 * first) * (30 + (2 * a - 3 * b) ** 2 * second)


def _hartmann_3(x: Point) -> float:
    rows = (
        (1.0, (3.0, 10, 30), (0.3689, 0.1170, 0.2673)),
        (1.2, (0.1, 10, 35), (0.4699, 0.4387, 0.7470)),
        (3.0, (3.0, 10, 30), (0.1091, 0.8732, 0.5547)),
        (3.2, (0.1, 10, 35), (0.03815, 0.5743, 0.8828)),
    )
    return -fsum(
        c * exp(-fsum(a_j * (v - p_j) ** 2 for v, a_j, p_j in zip(x, a, p, strict=True)))
        for c, a, p in rows
    )


def _hartmann_6(x: Point) -> float:
    # rows of a and p as fractions: tenths, hundredths and ten-thousandths
    a = (
        "100 30 170 35 17 80",
        "0.5 100 170 1 80 140",
        "30 35 17 100 170 80",
        "170 80 0.5 100 1 140",
    )
    p = ("1312 1696 5569 124 8283 5886", "2329 4135 8307 3736 1004 9991",
         "2348 1415 3522 2883 3047 6650", "4047 8828 8732 5743 1091 381")  # fmt: skip
    return -fsum(
        c * exp(-fsum(
            float(tenths) / 10 * (v - float(place) / 1e4) ** 2
            for v, tenths, place in zip(x, row.split(), places.split(), strict=True)
        ))
        for c, row, places in zip((1.0, 1.2, 3.0, 3.2), a, p, strict=True)
    )  # fmt: skip


SHEKEL = (
    (0.1, "4444"), (0.2, "1111"), (0.2, "8888"), (0.4, "6666"), (0.4, "3737"),
    (0.6, "2929"), (0.3, "5533"), (0.7, "8181"), (0.5, "6262"), (0.5, (7, 3.6, 7, 3.6)),
)  # fmt: skip


def _shekel(x: Point, wells: int) -> float:
    return -fsum(1 / (math.dist(x, list(map(float, a))) ** 2 + c) for c, a in SHEKEL[:wells])


def _griewank(x: Point) -> float:
    waves = prod(cos(v / sqrt(i)) for i, v in enumerate(x, start=1))
    return fsum(v**2 / 4000 for v in x) + (1 - waves)


def _kowalik(x: Point) -> float:
    measured = (1957, 1947, 1735, 1600, 844, 627, 456, 342, 323, 235, 246)
    inverses = (0.25, 0.5, 1, 2, 4, 6, 8, 10, 12, 14, 16)
    # the fraction of Kowalik and Osborne, both halves multiplied by the square of 1 / b
    rates = (x[0] * (1 + q * x[1]) / (1 + q * x[2] + q * q * x[3]) for q in inverses)
    return fsum((k / 1e4 - rate) ** 2 for k, rate in zip(measured, rates, strict=True))


def _six_hump_camel(x: Point) -> float:
    a, b = x
    return fsum((4 * a**2, -2.1 * a**4, a**6 / 3, a * b, -4 * b**2, 4 * b**4))


FORMULAS: dict[str, Callable[[Point], float]] = {
    "sphere": lambda x: math.hypot(*x) ** 2,
    "schwefel_2_22": lambda x: fsum(map(abs, x)) + prod(map(abs, x)),
    "schwefel_1_2": _schwefel_1_2,
    "schwefel_2_21": lambda x: max(map(abs, x)),
    "rosenbrock": _rosenbrock,
    "rastrigin": lambda x: fsum(v**2 - 10 * cos(2 * pi * v) + 10 for v in x),
    "ackley": _ackley,
    "alpine_1": lambda x: fsum(abs(v * sin(v) + 0.1 * v) for v in x),
    "penalized_1": _penalized_1,
    "penalized_2": _penalized_2,
    "foxholes": _foxholes,
    "branin": _branin,
    "goldstein_price": _goldstein_price,
    "hartmann_3": _hartmann_3,
    "shekel_5": lambda x: _shekel(x, 5),
    "step": lambda x: fsum((v + 0.5) ** 2 for v in x),
    "step_floor": lambda x: fsum(math.floor(v + 0.5) ** 2 for v in x),
    "quartic_noise": lambda x: fsum(i * v**4 for i, v in enumerate(x, start=1)),  # without noise
    "schwefel_2_26": lambda x: -fsum(v * sin(sqrt(abs(v))) for v in x),
    "griewank": _griewank,
    "kowalik": _kowalik,
    "six_hump_camel": _six_hump_camel,
    "hartmann_6": _hartmann_6,
    "shekel_7": lambda x: _shekel(x, 7),
    "shekel_10": lambda x: _shekel(x, 10),
}
