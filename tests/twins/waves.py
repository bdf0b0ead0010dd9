"""The cosine of the compiled loops in plain Python, operation by operation."""

import math


def cosine_of_turns(turns: float) -> float:
    """Return cos(2 pi turns) as 1 - 2 sin² of half the angle, or 2 cos² - 1 where that is steep."""
    part = abs(turns - round(turns))
    sine = _sine(math.pi * (0.5 - part if part > 0.25 else part))
    return 2.0 * sine * sine - 1.0 if part > 0.25 else 1.0 - 2.0 * sine * sine


def _sine(d: float) -> float:
    """Return the Taylor polynomial of degree 15, summed in pairs of its terms."""
    terms = [(-1.0) ** k / math.factorial(2 * k + 1) for k in range(8)]
    z = d * d
    first, second, third, fourth = (terms[k] + terms[k + 1] * z for k in (0, 2, 4, 6))
    square = z * z
    return d * ((first + second * square) + (third + fourth * square) * (square * square))
