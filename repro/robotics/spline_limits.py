"""Greatest velocity and acceleration on a span whose time and angle are both cubic in u.

With p = dq/du and s = dt/du quadratic in u and s > 0, the velocity is p/s. Its derivative in u is
N/s² with N = p's - ps', of degree 2, so it turns at the roots of N. The acceleration is N/s³ and
turns at the roots of N's - 3Ns', of degree 3. Both are found to the last bits: nothing is
sampled. A quadratic is given by its coefficients of 1, u and u².
"""

import math

from repro.determinism.compiled import jit

_OUTSIDE = -1.0  # stands for a root that is not real
_HALVINGS = 54  # of a piece of [0, 1], until its ends are neighbouring doubles


@jit
def least(c0, c1, c2):
    """Return the least value of a quadratic on [0, 1]."""
    low = min(c0, c0 + c1 + c2)
    if c2 > 0.0 and 0.0 < -c1 < 2.0 * c2:
        low = min(low, c0 - 0.25 * c1 * c1 / c2)
    return low


@jit
def roots(c0, c1, c2):
    """Return the two roots of a quadratic, a negative number for each that is not real."""
    square = c1 * c1 - 4.0 * c0 * c2
    if square < 0.0:
        return _OUTSIDE, _OUTSIDE
    half = -0.5 * (c1 + math.copysign(math.sqrt(square), c1))
    return (half / c2 if c2 != 0.0 else _OUTSIDE), (c0 / half if half != 0.0 else _OUTSIDE)


@jit
def turning(p0, p1, p2, s0, s1, s2):
    """Return the coefficients of N = p's - ps', whose cubic term vanishes."""
    return p1 * s0 - p0 * s1, 2.0 * (p2 * s0 - p0 * s2), p2 * s1 - p1 * s2


@jit
def fastest(p0, p1, p2, s0, s1, s2):
    """Return max |p/s| on [0, 1]; s must be positive there."""
    peak = max(abs(p0 / s0), abs((p0 + p1 + p2) / (s0 + s1 + s2)))
    n0, n1, n2 = turning(p0, p1, p2, s0, s1, s2)
    for u in roots(n0, n1, n2):
        if 0.0 < u < 1.0:
            peak = max(peak, abs((p0 + u * (p1 + u * p2)) / (s0 + u * (s1 + u * s2))))
    return peak


@jit
def largest_turning(n0, n1, n2):
    """Return a bound on |N| on [0, 1]: its greatest Bernstein coefficient."""
    return max(abs(n0), abs(n0 + 0.5 * n1), abs(n0 + n1 + n2))


@jit
def hardest(n0, n1, n2, s0, s1, s2):
    """Return max |N/s³| on [0, 1]; s must be positive there."""
    k0 = n1 * s0 - 3.0 * n0 * s1
    k1 = 2.0 * (n2 * s0 - n1 * s1 - 3.0 * n0 * s2)
    k2 = -5.0 * n1 * s2 - n2 * s1
    k3 = -4.0 * n2 * s2
    first, second = roots(k1, 2.0 * k2, 3.0 * k3)
    low, high = min(first, second), max(first, second)
    peak = 0.0
    start = 0.0
    # between its own turning points a cubic has one root at most; where two of them are so close
    # that rounding hides the change of sign, the turning point itself is as good
    for end in (low, high, 1.0):
        if not start < end <= 1.0:
            continue
        u = _crossing(k0, k1, k2, k3, start, end)
        for place in (start, u, end):
            s = s0 + place * (s1 + place * s2)
            peak = max(peak, abs((n0 + place * (n1 + place * n2)) / (s * s * s)))
        start = end
    return peak


@jit
def extremes(n0, n1, n2, s0, s1, s2, power):
    """Return the least and greatest N/s^power on [0, 1], N quadratic; s must be positive there."""
    k0 = n1 * s0 - power * n0 * s1
    k1 = 2.0 * (n2 * s0 - power * n0 * s2) + (1.0 - power) * n1 * s1
    k2 = (1.0 - 2.0 * power) * n1 * s2 + (2.0 - power) * n2 * s1
    k3 = 2.0 * (1.0 - power) * n2 * s2
    first, second = roots(k1, 2.0 * k2, 3.0 * k3)
    least_found = most_found = n0 / s0**power
    start = 0.0
    for end in (min(first, second), max(first, second), 1.0):  # as in `hardest`
        if not start < end <= 1.0:
            continue
        for u in (_crossing(k0, k1, k2, k3, start, end), end):
            value = (n0 + u * (n1 + u * n2)) / (s0 + u * (s1 + u * s2)) ** power
            least_found, most_found = min(least_found, value), max(most_found, value)
        start = end
    return least_found, most_found


@jit
def _crossing(k0, k1, k2, k3, start, end):
    """Return where a cubic that is monotone from `start` to `end` changes sign, else `end`."""
    rising = k0 + start * (k1 + start * (k2 + start * k3)) < 0.0
    if (k0 + end * (k1 + end * (k2 + end * k3)) < 0.0) == rising:
        return end
    for _ in range(_HALVINGS):
        middle = 0.5 * (start + end)
        if (k0 + middle * (k1 + middle * (k2 + middle * k3)) < 0.0) == rising:
            start = middle
        else:
            end = middle
    return end
