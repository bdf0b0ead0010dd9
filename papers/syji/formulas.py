"""SYJI-0035: the equations that the re-run follows."""

from repro.model.paper import Formula

FORMULAS = (
    Formula(
        label="Eqs. (1) and (2)",
        where="section Seventh order polynomial interpolation mathematical model",
        latex=r"""\begin{aligned}
            \theta(t) &= \sum_{j=0}^{7} a_j t^j, & \theta(t_0) &= \theta_0,
                & \theta(t_f) &= \theta_f, \\
            & & \dot{\theta}(t_0) &= \ddot{\theta}(t_0) = \dddot{\theta}(t_0) = 0,
                & \dot{\theta}(t_f) &= \ddot{\theta}(t_f) = \dddot{\theta}(t_f) = 0
            \end{aligned}""",
        says="A joint moves along a polynomial of order 7 whose velocity, acceleration and jerk "
        "are 0 at both ends.",
        code="repro.robotics.polynomials.RestToRestLaw",
    ),
    Formula(
        label="Eqs. (4) and (5)",
        where="sections Objective function and Constraints",
        latex=r"""\begin{aligned}
            T &= \min \sum_{i=1}^{m+1} h_i, \\
            |\dot{\theta}_{ij}(t)| &\le V_{mj}, \quad |\ddot{\theta}_{ij}(t)| \le A_{mj}, \quad
                |\dddot{\theta}_{ij}(t)| \le J_{mj}
            \end{aligned}""",
        says="The least total time of all segments in which no joint breaks a limit.",
        code="repro.robotics.rest_to_rest.MinimumTime",
        departs="the copy has lost the signs of comparison",
    ),
    Formula(
        label="Eqs. (6) to (8)",
        where="section Punitive constraints",
        latex=r"""P_1(H) = \begin{cases}
            1, & \max |\dot{\theta}_{ij}(t)| > V_{mj} \\
            0, & \text{otherwise}
            \end{cases}""",
        says="Whether a limit is broken: of velocity (P1), and likewise of acceleration (P2) and "
        "jerk (P3).",
        code="repro.robotics.rest_to_rest",
        departs="the copy has lost the sign of comparison",
    ),
    Formula(
        label="Eq. (9)",
        where="section Define the fitness function",
        latex=r"F(H) = \min \sum_{i=1}^{m+1} h_i + \lambda_1 P_1(H) + \lambda_2 P_2(H) "
        r"+ \lambda_3 P_3(H)",
        says="The fitness that the search minimises: time, and a fixed price per kind of broken "
        "limit.",
        code="repro.robotics.fixed_penalties",
    ),
    Formula(
        label="Eqs. (10) to (13), (16) and (17)",
        where="sections Encircling prey and Search for prey",
        latex=r"""\begin{aligned}
            X_{d+1} &= X_d^{\ast} - A \cdot |C \cdot X_d^{\ast} - X_d|, & |A| &< 1, \\
            X_{d+1} &= X_{\text{rand}} - A \cdot |C \cdot X_{\text{rand}} - X_d|, & |A| &\ge 1, \\
            A &= 2 a \cdot r - a, & C &= 2 r
            \end{aligned}""",
        says="A whale encircles the best one, or searches about a random one, while a falls from 2 "
        "to 0.",
        code="repro.optimisers.whale",
        departs="as in the program of WOA's authors, A and C are one number per whale, and X_rand "
        "is a new whale for every coordinate",
    ),
    Formula(
        label="Eq. (14)",
        where="section Bubble-net attacking method",
        latex=r"X_{d+1} = |X_d^{\ast} - X_d| \cdot e^{bl} \cdot \cos(2 \pi l) + X_d^{\ast}",
        says="A whale swims along a spiral to the best one, with a chance of one half.",
        code="repro.optimisers.whale",
        departs="as in the program of WOA's authors, l is drawn from a range that widens from "
        "(-1, 1] to (-2, 1]",
    ),
)
