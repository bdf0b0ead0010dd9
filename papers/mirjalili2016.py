"""WOA: the whale optimization algorithm on 23 functions, by its equations and by its program."""

from dataclasses import replace

from repro.model import (
    Between, CellClaim, Experiment, FromMinimum, Gap, PublishedTable, as_one, every_cell,
    prose, runs_of, says_in_words,
)  # fmt: skip
from repro.functions import FUNCTIONS, classical
from repro.optimisers import WOA, HybridWOA

TEXT = prose(__file__)
# A dash stands for N/A.
TABLE_6 = PublishedTable.read("""
    Table 6, sections 3.1 and 3.2 (30 runs)
    F  ||WOA ave |WOA std |PSO ave |PSO std |GSA ave |GSA std |DE ave  |DE std   |FEP ave |FEP std
    F1 ||1.41E-30|4.91E-30|0.000136|0.000202|2.53E-16|9.67E-17|8.2E-14 |5.9E-14  |0.00057 |0.00013
    F2 ||1.06E-21|2.39E-21|0.042144|0.045421|0.055655|0.194074|1.5E-09 |9.9E-10  |0.0081  |0.00077
    F3 ||5.39E-07|2.93E-06|70.12562|22.11924|896.5347|318.9559|6.8E-11 |7.4E-11  |0.016   |0.014
    F4 ||0.072581|0.39747 |1.086481|0.317039|7.35487 |1.741452|0       |0        |0.3     |0.5
    F5 ||27.86558|0.763626|96.71832|60.11559|67.54309|62.22534|0       |0        |5.06    |5.87
    F6 ||3.116266|0.532429|0.000102|8.28E-05|2.5E-16 |1.74E-16|0       |0        |0       |0
    F7 ||0.001425|0.001149|0.122854|0.044957|0.089441|0.04339 |0.00463 |0.0012   |0.1415  |0.3522
    F8 ||-5080.76|695.7968|-4841.29|1152.814|-2821.07|493.0375|-11080.1|574.7    |-12554.5|52.6
    F9 ||0       |0       |46.70423|11.62938|25.96841|7.470068|69.2    |38.8     |0.046   |0.012
    F10||7.4043  |9.897572|0.276015|0.50901 |0.062087|0.23628 |9.7E-08 |4.2E-08  |0.018   |0.0021
    F11||0.000289|0.001586|0.009215|0.007724|27.70154|5.040343|0       |0        |0.016   |0.022
    F12||0.339676|0.214864|0.006917|0.026301|1.799617|0.95114 |7.9E-15 |8E-15    |9.2E-06 |3.6E-06
    F13||1.889015|0.266088|0.006675|0.008907|8.899084|7.126241|5.1E-14 |4.8E-14  |0.00016 |0.000073
    F14||2.111973|2.498594|3.627168|2.560828|5.859838|3.831299|0.998004|3.3E-16  |1.22    |0.56
    F15||0.000572|0.000324|0.000577|0.000222|0.003673|0.001647|4.5E-14 |0.00033  |0.0005  |0.00032
    F16||-1.03163|4.2E-07 |-1.03163|6.25E-16|-1.03163|4.88E-16|-1.03163|3.1E-13  |-1.03   |4.9E-07
    F17||0.397914|2.7E-05 |0.397887|0       |0.397887|0       |0.397887|9.9E-09  |0.398   |1.5E-07
    F18||3       |4.22E-15|3       |1.33E-15|3       |4.17E-15|3       |2E-15    |3.02    |0.11
    F19||-3.85616|0.002706|-3.86278|2.58E-15|-3.86278|2.29E-15|–       |–        |-3.86   |0.000014
    F20||-2.98105|0.376653|-3.26634|0.060516|-3.31778|0.023081|–       |–        |-3.27   |0.059
    F21||-7.04918|3.629551|-6.8651 |3.019644|-5.95512|3.737079|-10.1532|0.0000025|-5.52   |1.59
    F22||-8.18178|3.829202|-8.45653|3.087094|-9.68447|2.014088|-10.4029|3.9E-07  |-5.53   |2.12
    F23||-9.34238|2.414737|-9.95291|1.782786|-10.5364|2.6E-15 |-10.5364|1.9E-07  |-6.57   |3.14
""")
TABLE_7 = PublishedTable.read("""
    Table 7, section 3.3 (30 runs)
    F  ||WOA ave |WOA std |PSO ave|PSO std|GSA ave |GSA std |DE ave |DE std |CMA-ES ave|CMA-ES std
    F24||0.568846|0.505946|100    |81.65  |6.63E-17|2.78E-17|6.75E-2|1.11E-1|100       |188.56
    F25||75.30874|43.07855|155.91 |13.176 |200.6202|67.72087|28.759 |8.6277 |161.99    |151
    F26||55.65147|21.87944|172.03 |32.769 |180     |91.89366|144.41 |19.401 |214.06    |74.181
    F27||53.83778|21.621  |314.3  |20.066 |170     |82.32726|324.86 |14.784 |616.4     |671.92
    F28||77.8064 |52.02346|83.45  |101.11 |200     |47.14045|10.789 |2.604  |358.3     |168.26
    F29||57.88445|34.44601|861.42 |125.81 |142.0906|88.87141|490.94 |39.461 |900.26    |8.32E-02
""")

EQUATIONS = HybridWOA(
    leader="per whale",  # Eqs. (2.7)-(2.8)
    spiral_range="symmetric",  # Eq. (2.5)
    coefficients="vector",  # Eqs. (2.3)-(2.4)
)
BENCHMARK = Experiment(
    name="benchmark", where="section 3", proposed="WOA", problems=classical(),
    algorithms={"WOA": EQUATIONS}, population=30, iterations=500, runs=30,
)  # fmt: skip

OTHERS = ("PSO", "GSA", "DE", "FEP")
QUOTED = TEXT.gap("quoted")
LEFT = {
    **{row: TEXT.gap("composite") for row in TABLE_7.row_names},
    **dict.fromkeys((*OTHERS, "CMA-ES"), QUOTED),
}
# Declared before any run of this paper: costs count by their distance from the least one.
WITHIN = FromMinimum(percent=25)


def _left_in(table: PublishedTable) -> dict[str, Gap]:
    """Return what of a table is left to gaps."""
    names = {*table.row_names, *(name.rpartition(" ")[0] for name in table.column_names)}
    return {name: gap for name, gap in LEFT.items() if name in names}


def cells(table: PublishedTable) -> tuple[CellClaim, ...]:
    """Return the claims of a table whose columns are headed by an algorithm and a statistic."""
    return tuple(
        replace(claim, counts=claim.gap != QUOTED)
        for heading, statistic in (("ave", "mean"), ("std", "std"))
        for claim in every_cell(
            table, of=BENCHMARK, rows=("problem",), columns="algorithm", within=WITHIN,
            given={"statistic": statistic}, without=_left_in(table),
            names={name: name.rpartition(" ")[0] for name in table.column_names})
        if claim.column.endswith(heading)
    )  # fmt: skip


def most_efficient(function: str) -> tuple[str, Between]:
    """Return the least mean that is printed for the others, and the band from 0 to it."""
    least = min((TABLE_6[function, f"{name} ave"] for name in OTHERS), key=lambda cell: cell.value)
    return least.text, Between(0, least.value)


BEST = "WOA is the most efficient optimiser on F1 and F2"
IN_WORDS = (
    *as_one(BEST, (
        says_in_words(
            f"{BEST} (read as: its mean is below the least that Table 6 prints for the others, "
            f"which are quoted), on {function}", "section 3.1, Table 6", least,
            runs_of(BENCHMARK, "WOA", problem=function)("cost"), within=band)
        for function in ("F1", "F2") for least, band in (most_efficient(function),))),
    *(says_in_words(claim, where, "2 rank", TEXT.gap("places"), within=Between(1, 2))
      for claim, where in (
          ("WOA is at least the second best in most unimodal problems", "section 3.1, Table 6"),
          ("WOA is the most efficient or the second best in the majority of F8 to F23",
           "section 3.2, Table 6"))),
    says_in_words("WOA is the best on three of the composite functions", "section 3.3, Table 7",
                  "3", TEXT.gap("best of composite"), within=Between(3, 3)),
)  # fmt: skip

PAPER = TEXT.paper(
    control=True,
    experiments=(BENCHMARK,),
    inputs=(),
    results=(TABLE_6, TABLE_7),
    claims=(*cells(TABLE_6), *cells(TABLE_7), *IN_WORDS),
    changes={
        "the authors' program": {"algorithms": {("benchmark", "WOA"): WOA()}},
        "scalar coefficients": {"algorithms": {("benchmark", "WOA"): {"coefficients": "scalar"}}},
        "one draw": {"algorithms": {("benchmark", "WOA"): {"shared_draw": True}}},
        "steps in F6": {"problems": {("benchmark", "F6"): FUNCTIONS["step_floor"].problem(30)}},
    },
)  # fmt: skip
