"""Least and greatest jerk on a span whose time and angle are both cubic in u.

With p = dq/du and s = dt/du quadratic in u, s > 0 and N = p's - ps', the acceleration is N/s³ and
the jerk M/s⁵ with M = N's - 3Ns', of degree 3. It turns at the roots of M's - 5Ms', of degree 4.
They are found to the last bits, between the roots of that polynomial's derivatives: nothing is
sampled. A quadratic is given by its coefficients of 1, u and u².
"""

from repro.determinism.compiled import jit
from repro.robotics.spline_limits import roots

_HALVINGS = 54  # of a piece of [0, 1], until its ends are neighbouring doubles


@jit
def sharpest(n0, n1, n2, s0, s1, s2):
    """Return the least and greatest (N's - 3Ns')/s⁵ on [0, 1]; s must be positive there."""
    m0 = n1 * s0 - 3.0 * n0 * s1
    m1 = 2.0 * (n2 * s0 - n1 * s1 - 3.0 * n0 * s2)
    m2 = -5.0 * n1 * s2 - n2 * s1
    m3 = -4.0 * n2 * s2
    k0 = m1 * s0 - 5.0 * m0 * s1
    k1 = 2.0 * (m2 * s0 - 2.0 * m1 * s1 - 5.0 * m0 * s2)
    k2 = 3.0 * (m3 * s0 - m2 * s1 - 3.0 * m1 * s2)
    k3 = -2.0 * m3 * s1 - 8.0 * m2 * s2
    k4 = -7.0 * m3 * s2
    first, second = roots(2.0 * k2, 6.0 * k3, 12.0 * k4)
    low = high = _jerk(0.0, m0, m1, m2, m3, s0, s1, s2)
    start = 0.0
    # between the roots of its second derivative a quartic turns once at most, and from there to
    # the next it has one root at most; what rounding hides, the ends of the pieces make up for
    for end in (min(first, second), max(first, second), 1.0):
        if not start < end <= 1.0:
            continue
        turn = _crossing(k1, 2.0 * k2, 3.0 * k3, 4.0 * k4, 0.0, start, end)
        for stop in (turn, end):
            for u in (_crossing(k0, k1, k2, k3, k4, start, stop), stop):
                value = _jerk(u, m0, m1, m2, m3, s0, s1, s2)
                low, high = min(low, value), max(high, value)
            start = stop
    return low, high


@jit
def _jerk(u, m0, m1, m2, m3, s0, s1, s2):
    s = s0 + u * (s1 + u * s2)
    return (m0 + u * (m1 + u * (m2 + u * m3))) / (s * s * s) / (s * s)


@jit
def _quartic(u, k0, k1, k2, k3, k4):
    return k0 + u * (k1 + u * (k2 + u * (k3 + u * k4)))


@jit
def _crossing(k0, k1, k2, k3, k4, start, end):
    """Return where a quartic that is monotone from `start` to `end` changes sign, else `end`."""
    rising = _quartic(start, k0, k1, k2, k3, k4) < 0.0
    if (_quartic(end, k0, k1, k2, k3, k4) < 0.0) == rising:
        return end
    for _ in range(_HALVINGS):
        middle = 0.5 * (start + end)
        if (_quartic(middle, k0, k1, k2, k3, k4) < 0.0) == rising:
            start = middle
        else:
            end = middle
    return end
