"""SMWOA: where the print cannot be meant, and what the paper keeps to itself."""

from repro.model.open_points import Erratum, Gap

UNOPTIMISED = Gap(
    what="time of the motion before optimisation (39.526 s)",
    where="section 4.3, Fig. 3",
    because="neither the segment times before optimisation nor how they were chosen is printed",
)
GAPS = (
    UNOPTIMISED,
    Gap(
        what="low energy consumption of the trajectory",
        where="abstract",
        because="no energy is defined, measured or printed; the cost is time alone",
    ),
    Gap(
        what="computing time, of order d + T N (1 + log N + d)",
        where="section 3.2",
        because="no computing times are printed; it is an estimate on paper, not a result",
    ),
    Gap(
        what="a greater probability of finding the global optimum, and faster convergence",
        where="abstract, sections 1.2 and 3.1",
        because="no rate of success, no threshold of it and no curve of convergence on the "
        "functions is printed",
    ),
)

_FUNCTIONS = (
    Erratum(
        where="Table 2, F3",
        printed="Schwefel 1.12",
        used="Schwefel 1.2",
        because="the formula is that of Schwefel's problem 1.2",
    ),
    Erratum(
        where="Table 2, F6",
        printed="cos(2πx)",
        used="cos(2πx_k)",
        because="the index is missing",
    ),
    Erratum(
        where="Table 2, F7",
        printed="20 exp(-0.2 √(…) - exp(…)): the second exponential inside the first",
        used="Ackley's function, two separate exponentials",
        because="the printed form is 21.3985 at the optimum, where 0 is printed",
    ),
    Erratum(
        where="Table 2, F9",
        printed="10 sin(π y_1), not squared, and (y_k - 1)² outside any sum",
        used="10 sin²(π y_1) and (y_D - 1)² (Yao, Liu & Lin 1999)",
        because="the printed form falls to -1.0215, below the printed optimum 0",
    ),
    Erratum(
        where="Table 2, F9 and F10",
        printed="μ(x_k, p, a, m) = p (x_k - a)^m, called as μ(x_k, 10, 100, 4) and μ(x_k, 5, 100, "
        "4)",
        used="arguments in the order a, p, m: the penalty 100 (x_k - a)^4 outside ±10 and ±5",
        because="as printed a is 100, and the penalty is 0 in the whole box of ±50, where "
        "2.56×10^8 is meant at an edge (F9)",
    ),
    Erratum(
        where="Table 2, F9 and F10",
        printed="-a < x_k < a",
        used="-a ≤ x_k ≤ a",
        because="at ±a none of the three cases holds",
    ),
    Erratum(
        where="Table 2, F10",
        printed="Σ over D terms (x_k - 1)² [1 + sin²(3π x_k + 1)], then (x_k - 1)² [1 + sin²(2π "
        "x_k)]",
        used="Σ over D - 1 terms with sin²(3π x_{k+1}), then (x_D - 1)² [1 + sin²(2π x_D)]",
        because="that is Yao, Liu & Lin's function; at the optimum both forms are 0",
    ),
    Erratum(
        where="Table 2, F11",
        printed="Michalewicz, without the sixth power, 1/(l + …) where the sum runs over k",
        used="Shekel's Foxholes, (x_k - a_kl)^6 and 1/(l + …) summed over l",
        because="formula and box are those of the foxholes; the printed form is 3.068 at their "
        "minimiser",
    ),
    Erratum(
        where="Table 2, F11",
        printed="optimal value 1",
        used="0.9980",
        because="that is the minimum of the function",
    ),
    Erratum(
        where="Table 2, F15",
        printed="[(X - a_k)(X - a_k)^T c_k]^-1",
        used="[(X - a_k)(X - a_k)^T + c_k]^-1",
        because="the plus is lost: as printed the function has no lower bound, and is -2.6×10^8 at "
        "the minimiser",
    ),
)
_EQUATIONS = (
    Erratum(
        where="Eq. (8), first case",
        printed="r_1 (UB - LB) + LB if r_1 < z",
        used="two draws, as SMA's program",
        because="one draw would restart moulds in the lowest z of the box only; it concerns SMA",
    ),
    Erratum(
        where="Eq. (8), second and third case",
        printed="r_1 ≥ z ∪ r_2 < p",
        used="r_1 ≥ z and r_2 < p",
        because="with a union the cases overlap; it concerns SMA",
    ),
    Erratum(
        where="Eq. (8), v_c",
        printed="v_c falls linearly from 1 to 0",
        used="a number drawn for every coordinate from -v_c to v_c, as SMA's program",
        because="the column SMA is its authors' program; the falling number is tried as a reading",
    ),
    Erratum(
        where="section 2.1",
        printed="where |A| < 1, a whale is far from the random individual and surrounds the prey",
        used="|A| < 1 surrounds the prey, |A| ≥ 1 follows a random whale",
        because="section 3.1 and the WOA paper say so",
    ),
    Erratum(
        where="section 3.2",
        printed="the start costs O(d)",
        used="no use is made of it",
        because="a start of N whales in d dimensions costs O(N d)",
    ),
    Erratum(
        where="Eq. (26)",
        printed="the right side of Eq. (24)",
        used="the second derivative (1-u) V_{i-1} + (3u-2) V_i + (1-3u) V_{i+1} + u V_{i+2}",
        because="Eq. (26) is the derivative of Eq. (24), not Eq. (24) itself",
    ),
)
_RESULTS = (
    Erratum(
        where="section 3.3 against Table 3, F12",
        printed="second in the text, fourth by the averages of the table",
        used="both, each as a claim",
        because="DE, GSA and PSO have lower averages in the table",
    ),
    Erratum(
        where="section 3.3 against Table 3, F14",
        printed="second in the text, first by the averages of the table",
        used="both, each as a claim",
        because="-3.8563 is the lowest of the six",
    ),
    Erratum(
        where="Table 3, average ranking",
        printed="1.4000 for SMWOA and 5.1333 for PSO",
        used="as printed",
        because="the averages of the table give 1.4667 and 5.0667; with the cells of both on F12 "
        "exchanged they give the printed ranks",
    ),
)

ERRATA = (*_FUNCTIONS, *_EQUATIONS, *_RESULTS)
