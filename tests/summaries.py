"""Tables of invented papers, made from samples as papers make them."""

import math
import statistics
from collections.abc import Callable, Mapping, Sequence
from decimal import ROUND_DOWN, ROUND_HALF_EVEN, Context, Decimal

import numpy as np
from hypothesis import strategies as st
from numpy.typing import NDArray

from repro.audit import AuditRow, Grade, audit
from repro.functions import FUNCTIONS
from repro.model.claims import CellClaim, Sentence
from repro.model.experiment import Experiment
from repro.model.figure_faults import tables_of
from repro.model.measures.measure import Statistic
from repro.model.paper import Paper, Source
from repro.model.tolerances import Percent
from repro.optimisers import WOA
from repro.statistics.summary import standard_deviation
from repro.tables.published import PublishedTable
from repro.tables.relations import Relation

Vector = NDArray[np.float64]
Blocks = Mapping[str, Mapping[str, str]]  # algorithm → statistic → text

# the ways in which programs compute a mean and a standard deviation
MEANS: tuple[Callable[[Vector], float], ...] = (
    lambda x: float(x.mean()),
    lambda x: math.fsum(x) / len(x),
    lambda x: sum(x.tolist()) / len(x),
)
SPREADS: tuple[Callable[[Vector], float], ...] = (
    lambda x: float(x.std(ddof=1)),
    lambda x: float(x.std(ddof=0)),
    lambda x: statistics.stdev(x.tolist()),
    lambda x: float(standard_deviation(x)),
)


def scientific(value: float, digits: int = 4, *, cut_off: bool = False) -> str:
    """Return the value as a paper prints it with a power of ten."""
    rounding = ROUND_DOWN if cut_off else ROUND_HALF_EVEN
    number = Context(prec=digits, rounding=rounding).create_decimal(Decimal(value))
    mantissa, _, power = f"{number:.{digits - 1}e}".partition("e")
    return f"{mantissa}×10^{int(power)}"


def fixed(value: float, decimals: int, *, cut_off: bool = False) -> str:
    """Return the value as a paper prints it with a fixed number of decimals."""
    rounding = ROUND_DOWN if cut_off else ROUND_HALF_EVEN
    step = Decimal(1).scaleb(-decimals)
    return str(Decimal(value).quantize(step, rounding, Context(prec=400)))


def most(function: str) -> float:
    """Return what no run on the function exceeds, as a double that is not above it."""
    ceiling = FUNCTIONS[function].known.ceiling
    assert ceiling is not None
    return float(ceiling(FUNCTIONS[function].fixed_dimension or 30))


def paper_of(
    blocks: Blocks,
    *,
    n: int,
    function: str = "sphere",
    claims: Sequence[Sentence] = (),
    relations: tuple[Relation, ...] = (),
) -> Paper:
    """Return a paper with one table: a row per statistic, a column per algorithm, one problem F."""
    names = list(next(iter(blocks.values())))
    lines = ["Table 1, p. 1", " | ".join(["Index", *blocks])]
    lines += [" | ".join([name, *(block[name] for block in blocks.values())]) for name in names]
    table = PublishedTable.read("\n".join(lines))
    known = FUNCTIONS[function]
    experiment = Experiment(
        name="test",
        where="p. 1",
        proposed=next(iter(blocks)),
        problems={"F": known.problem(None if known.fixed_dimension else 30)},
        algorithms={name: WOA() for name in blocks},
        population=30,
        iterations=500,
        runs=n,
    )
    cells = (
        CellClaim(
            table=table,
            row=row,
            column=column,
            measure=Statistic(experiment="test", problem="F", algorithm=column, statistic=row),
            accepted=Percent(1),
        )
        for row, column in table.places()
    )
    return Paper(
        key="doe2021",
        source=Source(authors="Doe", title="An invented table"),
        summary="",
        experiments=(experiment,),
        inputs=tuple(t for t in dict.fromkeys(tables_of(relations)) if t != table),
        results=(table,),
        claims=(*cells, *claims),
        assumptions=(),
        errata=(),
        gaps=(),
        relations=relations,
    )


def audited(block: Mapping[str, str], *, n: int, function: str = "sphere") -> dict[str, AuditRow]:
    """Return the impossible rows of a table of one block, by check."""
    rows = audit(paper_of({"A": block}, n=n, function=function))
    return {row.check: row for row in rows if row.grade is Grade.IMPOSSIBLE}


def proved(block: Mapping[str, str], *, n: int, function: str = "sphere") -> set[str]:
    """Return the checks that find a table of one block impossible without a condition."""
    found = audited(block, n=n, function=function)
    return {check for check, row in found.items() if row.is_proof}


def condition_of(block: Mapping[str, str], *, n: int, function: str = "sphere") -> str | None:
    """Return the condition of the one impossible row of a table of one block."""
    (row,) = audited(block, n=n, function=function).values()
    return row.condition


def summary(sample: Vector) -> dict[str, float]:
    """Return best, worst, mean and sample standard deviation."""
    return {
        "best": float(sample.min()),
        "worst": float(sample.max()),
        "mean": float(sample.mean()),
        "std": float(sample.std(ddof=1)),
    }


def _powers(low: float, high: float) -> st.SearchStrategy[float]:
    return st.floats(low, high).map(lambda power: float(10.0**power))


VALUES = st.one_of(
    st.just(st.floats(0.0, 1e6)),
    st.just(_powers(-300, 5)),  # heavy tails
    st.just(_powers(-172, -150)),  # squares underflow
    st.just(_powers(-323, -300)),  # subnormal
    st.just(st.sampled_from([0.0, 5e-324, 1e-310, 4.441e-16, 1.0])),  # near zero
    _powers(-300, 5).map(st.just),  # one value in every run
    _powers(-10, 5).map(  # last bits only
        lambda value: st.integers(0, 8).map(lambda k: value + k * math.ulp(value))
    ),
)


@st.composite
def samples(draw: st.DrawFn) -> Vector:
    """Return the final costs of 2 to 50 runs, none below 0."""
    n = draw(st.integers(2, 50))
    kind = draw(VALUES)
    return np.array(draw(st.lists(kind, min_size=n, max_size=n)))


@st.composite
def printed_tables(draw: st.DrawFn) -> tuple[dict[str, str], int, str]:
    """Return a block of printed statistics, its number of runs, and the function's name."""
    sample = draw(samples())
    function = draw(st.sampled_from(["sphere", "hartmann_3"]))
    sample = np.minimum(sample + FUNCTIONS[function].minimum, most(function))
    values = {
        "best": float(sample.min()),
        "worst": float(sample.max()),
        "mean": draw(st.sampled_from(MEANS))(sample),
        "std": draw(st.sampled_from(SPREADS))(sample),
    }
    kept = draw(st.sets(st.sampled_from(list(values)), min_size=2))
    digits, cut_off = draw(st.integers(2, 5)), draw(st.booleans())
    style = draw(st.sampled_from(["scientific", "general", "fixed", "bare zero"]))
    texts = {}
    for name in sorted(kept):
        value = values[name]
        if style == "fixed":
            texts[name] = fixed(value, digits, cut_off=cut_off)
        elif style == "general":
            texts[name] = f"{value:.{digits}g}"
        elif style == "bare zero" and value == 0:
            texts[name] = "0"
        else:
            texts[name] = scientific(value, digits, cut_off=cut_off)
    return texts, len(sample), function
