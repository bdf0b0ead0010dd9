"""Liang et al.: the equations that the re-run follows."""

from repro.model.paper import Formula

FORMULAS = (
    Formula(
        label="Eqs. (1) and (2)",
        where="section II-A",
        latex=r"""\begin{aligned}
            \theta_i(t) &= \sum_{j=0}^{5} a_j t^j, & \theta_i(t_0) &= \theta_0,
                & \theta_i(t_f) &= \theta_f, \\
            & & \dot{\theta}_i(t_0) &= \dot{\theta}_i(t_f) = 0,
                & \ddot{\theta}_i(t_0) &= \ddot{\theta}_i(t_f) = 0
            \end{aligned}""",
        says="A joint moves along a quintic polynomial, at rest at both ends of a segment.",
        code="repro.robotics.polynomials.RestToRestLaw",
    ),
    Formula(
        label="Eqs. (5) to (7)",
        where="section II-B",
        latex=r"""\begin{aligned}
            \min T &= \sum_{i=1}^{n-1} (t_{i+1} - t_i), \\
            |\dot{\theta}_i| &\le v_{i,\max}, \quad |\ddot{\theta}_i| \le a_{i,\max}
            \end{aligned}""",
        says="The least total time of all segments in which no joint breaks a limit.",
        code="repro.robotics.rest_to_rest.MinimumTime",
        departs="the limit on angles in Eq. (7) is not used: no range is printed, and a joint "
        "stays between the angles of two waypoints",
    ),
    Formula(
        label="Eqs. (8), (9), (11) and (12)",
        where="section III-A",
        latex=r"""\begin{aligned}
            \vec{X}(t+1) &= \vec{X}^{\ast}(t) - \vec{A} \cdot
                |\vec{C} \cdot \vec{X}^{\ast}(t) - \vec{X}(t)|, & |A| &< 1, \\
            \vec{X}(t+1) &= \vec{X}_{\text{rand}} - \vec{A} \cdot
                |\vec{C} \cdot \vec{X}_{\text{rand}} - \vec{X}(t)|, & |A| &\ge 1
            \end{aligned}""",
        says="A whale encircles the best one, or searches about a random one, by A = 2a·r - a and "
        "C = 2r.",
        code="repro.optimisers.hybrid_whale",
    ),
    Formula(
        label="Eqs. (10) and (15)",
        where="sections III-A and III-B 2)",
        latex=r"""\begin{aligned}
            \vec{X}(t+1) &= |\vec{X}^{\ast}(t) - \vec{X}(t)| \cdot e^{b_t l} \cdot
                \cos(2 \pi l) + \vec{X}^{\ast}(t), \\
            b_t &= 1 + 1.5 \left( 1 - \frac{t}{T} \right)
            \end{aligned}""",
        says="A whale swims along a spiral to the best one, tighter with every iteration.",
        code="repro.optimisers.hybrid_whale",
    ),
    Formula(
        label="Eq. (13)",
        where="section III-B 1)",
        latex=r"""x_{k+1} = \begin{cases}
            \frac{x_k}{0.5}, & 0 \le x_k < 0.5 \\
            \frac{1 - x_k}{0.5}, & 0.5 \le x_k \le 1
            \end{cases}""",
        says="The Tent map, along whose orbit the population starts.",
        code="repro.optimisers.tent_map",
    ),
    Formula(
        label="Eqs. (14) and (16)",
        where="section III-B 2)",
        latex=r"""\begin{aligned}
            a_t &= 2 \left( 1 - \left( \frac{t}{T} \right)^2 \right), \\
            p_t &= 0.5 + 0.5 \cos \left( \pi \frac{t}{T} \right)
            \end{aligned}""",
        says="How far whales may jump, and how often they encircle or search; t counts from 0.",
        code="repro.optimisers.hybrid_whale",
    ),
    Formula(
        label="Eqs. (17) to (19)",
        where="section III-B 3)",
        latex=r"""\begin{aligned}
            V_i &= X_{r1} + F \cdot (X_{r2} - X_{r3}), \\
            U_{i,j} &= \begin{cases}
                V_{i,j}, & \text{rand} \le CR \\
                X_{i,j}, & \text{otherwise}
                \end{cases} \\
            X' &= \alpha X_i + (1 - \alpha) X_j, \quad \alpha \in [0, 1]
            \end{aligned}""",
        says="Differential evolution of some whales, arithmetic crossover of others.",
        code="repro.optimisers.hybrid_whale",
        departs="which whales, and the Gaussian perturbation that the text adds to Eq. (19), are "
        "assumptions",
    ),
    Formula(
        label="Eq. (20)",
        where="section IV-A",
        latex=r"""{}^{i}_{i+1}A = \begin{bmatrix}
            \cos\theta_{i+1} & -\sin\theta_{i+1} & 0 & a_i \\
            \sin\theta_{i+1} \cos\alpha_i & \cos\theta_{i+1} \cos\alpha_i & -\sin\alpha_i
                & -\sin\alpha_i d_{i+1} \\
            \sin\theta_{i+1} \sin\alpha_i & \cos\theta_{i+1} \sin\alpha_i & \cos\alpha_i
                & \cos\alpha_i d_{i+1} \\
            0 & 0 & 0 & 1
            \end{bmatrix}""",
        says="From one frame of the arm to the next, in the modified convention.",
        code="repro.robotics.kinematics",
        departs="the audit tries it, with the last entry 1 (printed: 0); all else uses the "
        "standard convention, which meets the waypoints of Table IV",
    ),
)
