"""Mousa et al.: the equations that the re-run follows."""

from repro.model.paper import Formula

FORMULAS = (
    Formula(
        label="Eqs. (1) and (4)",
        where="section II-A",
        latex=r"""\begin{aligned}
            q_i(t) &= a_0 + a_1 t + a_2 t^2 + a_3 t^3, & a_0 &= q_{\text{start}}, & a_1 &= 0, \\
            & & a_2 &= \frac{3 (q_{\text{end}} - q_{\text{start}})}{\Delta T^2},
                & a_3 &= \frac{-2 (q_{\text{end}} - q_{\text{start}})}{\Delta T^3}
            \end{aligned}""",
        says="A joint's cubic polynomial from rest to rest.",
        code="repro.robotics.polynomials.cubic",
        departs="Eq. (4) prints t_final for the duration ΔT of Table I",
    ),
    Formula(
        label="Eqs. (5) and (9)",
        where="section II-B",
        latex=r"""\begin{aligned}
            q_i(t) &= \sum_{j=0}^{5} a_j t^j, & a_0 &= q_{\text{start}}, & a_1 &= a_2 = 0, \\
            a_3 &= \frac{10 (q_{\text{end}} - q_{\text{start}})}{\Delta T^3},
                & a_4 &= \frac{-15 (q_{\text{end}} - q_{\text{start}})}{\Delta T^4},
                & a_5 &= \frac{6 (q_{\text{end}} - q_{\text{start}})}{\Delta T^5}
            \end{aligned}""",
        says="A joint's quintic polynomial from rest to rest.",
        code="repro.robotics.polynomials.quintic",
        departs="Eq. (9) prints t_final for the duration ΔT of Table II",
    ),
    Formula(
        label="Table III, step 1",
        where="section III-A",
        latex=r"W_{j,i} = a_{j,\text{low}} + \text{rand} \times "
        r"(a_{j,\text{high}} - a_{j,\text{low}})",
        says="The coefficients with which a search starts, between their bounds.",
        code="repro.optimisers.population.uniform_population",
    ),
    Formula(
        label="Table III, steps 3 and 4",
        where="section III-A",
        latex=r"""\begin{aligned}
            \hat{q}_t &= \sum_{j=0}^{5} a_j t^j, \quad
                t \in \left\{ t_0, t_0 + \frac{\Delta T}{M}, \dots, t_0 + \Delta T \right\}, \\
            f &= \left\| \hat{q}_t - q_t \right\|
            \end{aligned}""",
        says="The fitness: the norm of the difference between the curve that a whale stands for "
        "and the desired path.",
        code="repro.robotics.path_fitting.PathFitting",
        departs="one fitness per whale and joint, over all instants: the printed indices change "
        "their meaning from step to step",
    ),
)
