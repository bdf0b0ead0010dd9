"""GWO: the grey wolf optimizer on 23 functions, beside PSO and GSA."""

from dataclasses import replace

from repro.model import (
    Between, CellClaim, Contest, Experiment, Firsts, FromMinimum, Gap, PublishedTable, Sentence,
    as_one, every_cell, lowest_everywhere, prose, says_in_words,
)  # fmt: skip
from repro.functions import FUNCTIONS, classical
from repro.optimisers import GSA, GWO, PSO

TEXT = prose(__file__)
# A dash stands for N/A.
TABLE_5 = PublishedTable.read("""
    Table 5, section 4.1 (30 runs)
    F ||GWO ave |GWO std |PSO ave |PSO std |GSA ave |GSA std |DE ave |DE std |FEP ave|FEP std
    F1||6.59E-28|6.34E-05|0.000136|0.000202|2.53E-16|9.67E-17|8.2E-14|5.9E-14|0.00057|0.00013
    F2||7.18E-17|0.029014|0.042144|0.045421|0.055655|0.194074|1.5E-09|9.9E-10|0.0081 |0.00077
    F3||3.29E-06|79.14958|70.12562|22.11924|896.5347|318.9559|6.8E-11|7.4E-11|0.016  |0.014
    F4||5.61E-07|1.315088|1.086481|0.317039|7.35487 |1.741452|0      |0      |0.3    |0.5
    F5||26.81258|69.90499|96.71832|60.11559|67.54309|62.22534|0      |0      |5.06   |5.87
    F6||0.816579|0.000126|0.000102|8.28E-05|2.5E-16 |1.74E-16|0      |0      |0      |0
    F7||0.002213|0.100286|0.122854|0.044957|0.089441|0.04339 |0.00463|0.0012 |0.1415 |0.3522
""")
TABLE_6 = PublishedTable.read("""
    Table 6, section 4.2 (30 runs)
    F  ||GWO ave |GWO std |PSO ave |PSO std |GSA ave |GSA std |DE ave  |DE std |FEP ave |FEP std
    F8 ||-6123.1 |-4087.44|-4841.29|1152.814|-2821.07|493.0375|-11080.1|574.7  |-12554.5|52.6
    F9 ||0.310521|47.35612|46.70423|11.62938|25.96841|7.470068|69.2    |38.8   |0.046   |0.012
    F10||1.06E-13|0.077835|0.276015|0.50901 |0.062087|0.23628 |9.7E-08 |4.2E-08|0.018   |0.0021
    F11||0.004485|0.006659|0.009215|0.007724|27.70154|5.040343|0       |0      |0.016   |0.022
    F12||0.053438|0.020734|0.006917|0.026301|1.799617|0.95114 |7.9E-15 |8E-15  |9.2E-06 |3.6E-06
    F13||0.654464|0.004474|0.006675|0.008907|8.899084|7.126241|5.1E-14 |4.8E-14|0.00016 |0.000073
""")
TABLE_7 = PublishedTable.read("""
    Table 7, section 4.2 (30 runs)
    F  ||GWO ave |GWO std |PSO ave |PSO std |GSA ave |GSA std |DE ave  |DE std   |FEP ave|FEP std
    F14||4.042493|4.252799|3.627168|2.560828|5.859838|3.831299|0.998004|3.3E-16  |1.22   |0.56
    F15||0.000337|0.000625|0.000577|0.000222|0.003673|0.001647|4.5E-14 |0.00033  |0.0005 |0.00032
    F16||-1.03163|-1.03163|-1.03163|6.25E-16|-1.03163|4.88E-16|-1.03163|3.1E-13  |-1.03  |4.9E-07
    F17||0.397889|0.397887|0.397887|0       |0.397887|0       |0.397887|9.9E-09  |0.398  |1.5E-07
    F18||3.000028|3       |3       |1.33E-15|3       |4.17E-15|3       |2E-15    |3.02   |0.11
    F19||-3.86263|-3.86278|-3.86278|2.58E-15|-3.86278|2.29E-15|–       |–        |-3.86  |0.000014
    F20||-3.28654|-3.25056|-3.26634|0.060516|-3.31778|0.023081|–       |–        |-3.27  |0.059
    F21||-10.1514|-9.14015|-6.8651 |3.019644|-5.95512|3.737079|-10.1532|0.0000025|-5.52  |1.59
    F22||-10.4015|-8.58441|-8.45653|3.087094|-9.68447|2.014088|-10.4029|3.9E-07  |-5.53  |2.12
    F23||-10.5343|-8.55899|-9.95291|1.782786|-10.5364|2.6E-15 |-10.5364|1.9E-07  |-6.57  |3.14
""")
TABLE_8 = PublishedTable.read("""
    Table 8, section 4.3 (30 runs)
    F  ||GWO ave |GWO std |PSO ave|PSO std|GSA ave |GSA std |DE ave  |DE std  |CMA-ES ave|CMA-ES std
    F24||43.83544|69.86146|100    |81.65  |6.63E-17|2.78E-17|6.75E-02|1.11E-01|100       |188.56
    F25||91.80086|95.5518 |155.91 |13.176 |200.6202|67.72087|28.759  |8.6277  |161.99    |151
    F26||61.43776|68.68816|172.03 |32.769 |180     |91.89366|144.41  |19.401  |214.06    |74.181
    F27||123.1235|163.9937|314.3  |20.066 |170     |82.32726|324.86  |14.784  |616.4     |671.92
    F28||102.1429|81.25536|83.45  |101.11 |200     |47.14045|10.789  |2.604   |358.3     |168.26
    F29||43.14261|84.48573|861.42 |125.81 |142.0906|88.87141|490.94  |39.461  |900.26    |8.32E-02
""")

SWARM = PSO(clip="last particle")  # its PSO.m, which lets the others leave the box
BENCHMARK = Experiment(
    name="benchmark", where="section 4", proposed="GWO", problems=classical(),
    algorithms={"GWO": GWO(), "PSO": SWARM, "GSA": GSA()},
    population=30, iterations=500, runs=30,
)  # fmt: skip
UNIMODAL, MULTIMODAL = tuple(BENCHMARK.problems)[:7], tuple(BENCHMARK.problems)[7:]

COMPOSITE = TEXT.gap("composite")
QUOTED = TEXT.gap("quoted")
LEFT = {
    **dict.fromkeys(TABLE_8.row_names, COMPOSITE),
    **dict.fromkeys(("DE", "FEP", "CMA-ES"), QUOTED),
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
        claim
        for heading, statistic in (("ave", "mean"), ("std", "std"))
        for claim in every_cell(
            table, of=BENCHMARK, rows=("problem",), columns="algorithm", within=WITHIN,
            given={"statistic": statistic}, without=_left_in(table),
            names={name: name.rpartition(" ")[0] for name in table.column_names})
        if claim.column.endswith(heading)
    )  # fmt: skip


BEST_ON = replace(BENCHMARK, problems={f: BENCHMARK.problems[f] for f in ("F1", "F2", "F7")})
BEST = lowest_everywhere(
    BEST_ON, algorithm="GWO", statistic="mean", where="section 4.1, Table 5",
    claim="GWO outperforms all others on F1, F2 and F7 (read as: the lowest mean of GWO, PSO and "
    "GSA, the columns that are run)",
)  # fmt: skip
HALF = len(MULTIMODAL) // 2


def majority(*, at_once: bool = False) -> tuple[Sentence, ...]:
    """Return the claims on most multimodal functions: against each other search, or both at once.

    The first is what the text is taken to say; the second is another reading of it.
    """
    others = ("PSO", "GSA")
    return as_one("GWO outperforms PSO and GSA on the majority of the multimodal functions", (
        says_in_words(
            "GWO outperforms PSO and GSA on the majority of the multimodal functions (read as: a "
            f"lower mean on more than half of F8 to F23), {other}", "section 4.2, Tables 6 and 7",
            f"{HALF + 1}",
            Firsts(algorithm="GWO", contest=Contest(
                experiment=BENCHMARK.name, problems=MULTIMODAL,
                algorithms=("GWO", *(others if at_once else (other,))))),
            within=Between(HALF + 1, len(MULTIMODAL)))
        for other in others))  # fmt: skip


IN_WORDS = (
    *BEST, *majority(),
    says_in_words("GWO is very competitive with DE and FEP and outperforms them occasionally",
                  "section 4.2, Tables 6 and 7", "1 rank", TEXT.gap("competitive"),
                  within=Between(1, 1)),
    says_in_words("GWO outperforms all others on half of the composite functions",
                  "section 4.3, Table 8", "3", TEXT.gap("best of composite"),
                  within=Between(3, 6)),
)  # fmt: skip

PAPER = TEXT.paper(
    control=True,
    experiments=(BENCHMARK,),
    inputs=(),
    results=(TABLE_5, TABLE_6, TABLE_7, TABLE_8),
    claims=(*cells(TABLE_5), *cells(TABLE_6), *cells(TABLE_7), *cells(TABLE_8), *IN_WORDS),
    changes={
        "PSO clipped": {"algorithms": {("benchmark", "PSO"): {"clip": "every particle"}}},
        "steps in F6": {"problems": {("benchmark", "F6"): FUNCTIONS["step_floor"].problem(30)}},
        "printed box of F17": {"problems": {("benchmark", "F17"): replace(
            FUNCTIONS["branin"], box=((-5.0, 5.0), (-5.0, 5.0))).problem()}},
        "both at once": {"claims": majority(at_once=True)},
    },
)  # fmt: skip
