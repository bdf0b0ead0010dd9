"""Mousa et al.: what the paper misprints or keeps to itself."""

from repro.model.open_points import Erratum, Gap

GAPS = (
    Gap(
        what="velocity and acceleration of the cubic are continuous, its motion seamless",
        where="section IV, Fig. 2",
        because="one polynomial has no jump between its ends, whatever its coefficients; the text "
        "claims zero acceleration at the ends of the quintic alone",
    ),
    Gap(
        what="the curves of Figs. 2 to 6 themselves",
        where="section IV and section V",
        because="they are printed as pictures without data, and neither the duration nor the "
        "settings of the searches are given; the re-run draws counterparts",
    ),
    Gap(
        what="polynomials are easier to implement",
        where="abstract, sections V and VI",
        because="no measure of ease is named; that Eq. (9) needs no search is claimed and checked",
    ),
    Gap(
        what="GA is the less complex algorithm, and both need more of it for more constraints",
        where="abstract and section VI",
        because="no measure of complexity is named and none printed; both spend one evaluation per "
        "agent and iteration. Read as complexity of the path it is claimed and checked",
    ),
    Gap(
        what="WOA and GA suit unstable environments and unpaved paths, unlike polynomials",
        where="section IV with Figs. 4 and 5, section V",
        because="no environment, disturbance or obstacle is defined, and no data are printed",
    ),
    Gap(
        what="WOA and GA reject paths that collide or cannot be executed",
        where="section V",
        because="no step of Tables III and IV rejects anything, and no obstacle is defined",
    ),
    Gap(
        what="WOA and GA balance time, energy and collisions where polynomials may struggle",
        where="section V",
        because="the one fitness is the norm of a difference; no second objective is printed",
    ),
    Gap(
        what="polynomials may be held to suboptimal paths",
        where="section V",
        because="no criterion by which a path would be better is printed, other than the norm, in "
        "which a polynomial has the least value there is",
    ),
    Gap(
        what="WOA is better because of its spiral",
        where="abstract",
        because="no search without the spiral is reported",
    ),
    Gap(
        what="choose polynomials for simple paths and WOA as surroundings grow complex",
        where="section V, end",
        because="it is advice; the statements under it are claims or gaps of their own",
    ),
)

ERRATA = (
    Erratum(
        where="the second Table IV, column θ",
        printed="q_1 in five rows and q with a dotless i in one, on the copy at hand",
        used="q_1 to q_6",
        because="every joint has its own angle, and the page may have an index that the copy lost; "
        "the column is not used otherwise",
    ),
    Erratum(
        where="number of the table of link parameters",
        printed="Table IV a second time, after the pseudo-code of GA",
        used="the second Table IV is the one with numbers",
        because="both carry the number IV",
    ),
    Erratum(
        where="Eqs. (4) and (9)",
        printed="t_final",
        used="t_1 - t_0, and time counted from t_0",
        because="Tables I and II have ΔT = t_1 - t_0; with powers of t the coefficients hold only "
        "for t_0 = 0",
    ),
    Erratum(
        where="Tables I to IV",
        printed="M points, at t_0, t_0 + ΔT/M, …, t_0 + ΔT",
        used="M + 1 points",
        because="that series has M + 1 members",
    ),
    Erratum(
        where="Table II, step 1",
        printed="cubic coefficients",
        used="quintic",
        because="the step gives six coefficients, those of Eq. (9)",
    ),
    Erratum(
        where="Table III, steps 1 to 5",
        printed="W[j,i] with i for the whale and j for the coefficient, q̂_{j,t} with j for the "
        "instant, f(j,i) with j for the coefficient, and i elsewhere the joint",
        used="one population of six coefficients, and one fitness per whale, for each joint",
        because="the indices change their meaning from step to step and the joint has none in W",
    ),
    Erratum(
        where="Table IV (the first), inputs and step 1",
        printed="WOA parameters; number of generations N_g and number of iterations N; matrix P "
        "of N_w rows, filled as G[j,i] with i up to N_g",
        used="GA parameters; N_g chromosomes, N generations, one matrix",
        because="the block repeats Table III; the copy at hand has lost what follows step 2, at "
        "the end of a page",
    ),
    Erratum(
        where="abstract and section III-A",
        printed="conical spiral; operators that encircle, lure and shrink",
        used="logarithmic spiral; encircling, spiral and search",
        because="those are the operators of WOA (Mirjalili & Lewis 2016)",
    ),
)
