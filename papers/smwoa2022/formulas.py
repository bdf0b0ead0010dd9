"""SMWOA: the equations that the re-run follows."""

from repro.model.paper import Formula

FORMULAS = (
    Formula(
        label="Eq. (10)",
        where="section 2.2",
        latex=r"a = \operatorname{arctanh} \left( -\frac{t}{t_{\max}} + 1 \right)",
        says="How far whales may jump; t counts from 1, since a is infinite at 0.",
        code="repro.optimisers.slime_whale",
    ),
    Formula(
        label="Eq. (11)",
        where="section 2.2",
        latex=r"""\omega(\text{sort}(F_i)) = \begin{cases}
            1 + r \cdot \log \left( \frac{bF - F_i}{bF - wF} + 1 \right), & \text{first half} \\
            1 - r \cdot \log \left( \frac{bF - F_i}{bF - wF} + 1 \right), & \text{others}
            \end{cases}""",
        says="The weight of a whale by its rank; bF and wF are the best and the worst fitness.",
        code="repro.optimisers.slime_whale",
    ),
    Formula(
        label="Eqs. (12) to (14)",
        where="section 3.1",
        latex=r"""\begin{aligned}
            X_{n(t+1)} &= X_t^{\Delta} - A \cdot D, & P &< 0.5,\quad |A| < 1, \\
            X_{n(t+1)} &= X_t^{\Delta} + v_b \cdot e^{bl} \cdot \cos(2 \pi l) \cdot D',
                & P &\ge 0.5, \\
            X_{n(t+1)} &= X_t^{r} - A \cdot D'', & P &< 0.5,\quad |A| \ge 1
            \end{aligned}""",
        says="A whale encircles the best one, swims along a spiral to it, or searches about a "
        "random one; v_b is uniform in [-a, a].",
        code="repro.optimisers.slime_whale",
    ),
    Formula(
        label="Eq. (15)",
        where="section 3.1",
        latex=r"""\begin{aligned}
            A &= 2 a \cdot r_{\text{rand}} - a,
                & D &= |2 r_{\text{rand}} \cdot X_t^{\Delta} - X_t|, \\
            D' &= |\omega \cdot X_t^{\Delta} - X_t|, & D'' &= |\omega \cdot X_t^{r} - X_{nt}|
            \end{aligned}""",
        says="The step lengths of the three moves, with a of Eq. (10).",
        code="repro.optimisers.slime_whale",
        departs="A and D have draws of their own",
    ),
    Formula(
        label="Eqs. (18) to (20)",
        where="section 4.1",
        latex=r"""\begin{aligned}
            \theta_i(u) &= \frac{1}{6} \begin{bmatrix} u^3 & u^2 & u & 1 \end{bmatrix}
                \begin{bmatrix}
                -1 & 3 & -3 & 1 \\ 3 & -6 & 3 & 0 \\ -3 & 0 & 3 & 0 \\ 1 & 4 & 1 & 0
                \end{bmatrix}
                \begin{bmatrix} V_{i-1} \\ V_i \\ V_{i+1} \\ V_{i+2} \end{bmatrix}, \\
            P_i &= \frac{1}{6} (V_{i-1} + 4 V_i + V_{i+1}), \quad V_0 = V_1, \quad V_n = V_{n+1}
            \end{aligned}""",
        says="The cubic B-spline of a segment, through all nodes P; time is such a spline too, by "
        "Eq. (22).",
        code="repro.robotics.bsplines",
    ),
    Formula(
        label="Eq. (23)",
        where="section 4.2",
        latex=r"T = \min \sum_{i=1}^{n-1} h_i = \min \sum_{i=1}^{n-1} (t_{i+1} - t_i)",
        says="The least total time of all segments.",
        code="repro.robotics.spline_motion.MinimumTimeSpline",
    ),
    Formula(
        label="Eqs. (25), (27) and (28)",
        where="section 4.2",
        latex=r"""\begin{aligned}
            \dot{\theta}_i &= \frac{q'}{t'}, & |\dot{\theta}_i| &\le \dot{\theta}_{\max}, \\
            \ddot{\theta}_i &= \frac{q'' t' - q' t''}{t'^3},
                & |\ddot{\theta}_i| &\le \ddot{\theta}_{\max}
            \end{aligned}""",
        says="Velocity and acceleration along the spline, primes being derivatives in u, and their "
        "limits.",
        code="repro.robotics.spline_limits",
        departs="Eq. (28) prints no bars: the limits are kept in both directions",
    ),
)
