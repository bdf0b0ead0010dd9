"""How often the checks of a table accuse true ones, and how often they find planted errors.

Run as `python -m tests.false_alarms [TABLES]`, it writes docs/false_alarms.md.
"""

import pathlib
import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from decimal import ROUND_DOWN, ROUND_HALF_EVEN, Context, Decimal
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from repro.tables.blocks import Block, known_minimum
from repro.tables.checks import block_rows, fact_rows
from repro.tables.facts import RankedRows, Success
from repro.tables.printed import Printed
from repro.tables.relations import PlacedNumber
from repro.tables.rows import AuditRow, Grade

Vector = NDArray[Any]
PAGE = pathlib.Path(__file__).parents[1] / "docs" / "false_alarms.md"
TABLES = 100_000
MOST = 2**24  # whole numbers below it are exact in single precision
PLANTED = 300  # errors per kind and set of statistics
SETS = (
    ("mean", "std"),
    ("best", "mean", "std"),
    ("best", "mean", "worst", "std"),
    ("best", "mean", "median", "worst", "std"),
)
PRINTS = ("scientific", "fixed", "four digits of R", "cut off", "mixed digits", "rounded twice")
ERRORS = (
    *("a digit of the mean", "mean and worst exchanged", "std × 10", "std × 100", "std / 10"),
    *("std / 100", "sign of the mean", "exponent of the mean lost", "variance for std"),
    *("standard error for std", "a tenth of the runs", "std of another row"),
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Table:
    """One printed block, its pipeline in words, and the runs behind it."""

    block: Block
    pipeline: str
    runs: Vector


def sample(rng: np.random.Generator) -> Vector:
    """Return the final costs of 2 to 60 runs of one of nine kinds."""
    n = int(rng.integers(2, 61))
    scale = 10.0 ** rng.uniform(-8, 6)
    kinds = (
        lambda: np.exp(rng.normal(0, rng.uniform(0.1, 15), n)) * scale,
        lambda: rng.exponential(scale, n),
        lambda: np.where(rng.random(n) < 0.6, 0.0, rng.exponential(scale, n)),
        lambda: scale + rng.exponential(scale * 10.0 ** rng.uniform(-12, 0), n),
        lambda: np.full(n, scale),
        lambda: rng.integers(0, 10 ** int(rng.integers(1, 6)), n).astype(float),
        lambda: rng.normal(-scale, scale / 3, n),
        lambda: 10.0 ** rng.uniform(-300, 2, n),
        lambda: np.maximum(rng.standard_cauchy(n), -1.0) * scale,
    )
    return kinds[int(rng.integers(len(kinds)))]()


def statistics_of(
    runs: Vector, *, single: bool, one_pass: bool, ddof: int, reverse: bool
) -> dict[str, float]:
    """Return the statistics that a program computes, of its runs as it keeps them."""
    kind: Any = np.float32 if single else np.float64
    kept = runs.astype(kind)[:: -1 if reverse else 1]
    n = kind(len(kept))
    total = np.cumsum(kept, dtype=kind)[-1]  # one after the other
    mean = kind(total / n)
    if one_pass:
        squares = np.cumsum(kept * kept, dtype=kind)[-1] - n * mean * mean
    else:
        squares = np.cumsum((kept - mean) ** 2, dtype=kind)[-1]
    quartiles = np.percentile(kept, [25, 50, 75])
    found = {
        "best": kept.min(),
        "mean": mean,
        "q1": quartiles[0],
        "median": quartiles[1],
        "q3": quartiles[2],
        "worst": kept.max(),
        "std": np.sqrt(np.maximum(squares, 0) / kind(len(kept) - ddof)),
    }
    return {name: float(value) for name, value in found.items() if np.isfinite(value)}


def text(value: float, how: str, digits: int) -> str:
    """Return a number as a table prints it."""
    if how == "fixed" and abs(value) < 1e15:
        return f"{value:.{digits}f}"
    if how == "four digits of R":
        return f"{float(f'{value:.3e}'):.15g}"
    if how == "rounded twice":
        value = float(f"{value:.{digits}e}")
    rounding = ROUND_DOWN if how == "cut off" else ROUND_HALF_EVEN
    number = Context(prec=digits, rounding=rounding).create_decimal(Decimal(value))
    return f"{number:.{digits - 1}e}"


def block_of(
    texts: dict[str, str], n: int, *, floor: bool, maximise: bool = False, whole: bool = False
) -> Block:
    """Return the block that a table with these texts is read as."""
    return Block(
        problem_name="F1",
        algorithm="A",
        quantity="cost",
        n=n,
        cells={name: cell(each, column=name) for name, each in texts.items()},
        scientific=any("e" in each for each in texts.values()),
        function=known_minimum("an error", Fraction(0)) if floor else None,
        maximise=maximise,
        whole_numbers=whole,
    )


def cell(printed: str, *, column: str) -> PlacedNumber:
    """Return a number in a column of the one row."""
    return PlacedNumber(printed=Printed(printed), label="t", row="F1", column=column)


def true_table(rng: np.random.Generator, names: tuple[str, ...] | None = None) -> Table:
    """Return a table of a real sample, through a pipeline drawn at random."""
    runs = sample(rng)
    if rng.random() < 0.3:  # as a table of sorted runs is summed
        runs = np.sort(runs)
    whole = bool(np.all(runs == np.floor(runs)) and abs(runs).max() < MOST)
    single, one_pass, maximise, reverse = (bool(each) for each in rng.integers(0, 2, 4))
    how, digits = PRINTS[int(rng.integers(len(PRINTS)))], int(rng.integers(2, 9))
    ddof = int(rng.integers(0, 2))
    with np.errstate(all="ignore"):
        values = statistics_of(runs, single=single, one_pass=one_pass, ddof=ddof, reverse=reverse)
    kept = [name for name in values if (rng.random() < 0.7 if names is None else name in names)]
    kept = kept or ["mean"]
    texts = {
        name: text(values[name], how, int(rng.integers(2, 9)) if how.startswith("mix") else digits)
        for name in kept
    }
    floor = bool(runs.min() >= 0) and not maximise
    if maximise:
        ends = {"best": "worst", "worst": "best"}
        texts = {ends.get(name, name): each for name, each in texts.items()}
    words = (
        f"{'single' if single else 'double'}, {'one' if one_pass else 'two'} pass, {how}"
        f"{', maximised' if maximise else ''}"
    )
    block = block_of(texts, len(runs), floor=floor, maximise=maximise, whole=whole)
    return Table(block=block, pipeline=words, runs=runs)


def true_facts(rng: np.random.Generator) -> Iterator[AuditRow]:
    """Yield the rows of a true success rate, and of true ranks of rounded values."""
    n = int(rng.integers(2, 61))
    rate = f"{100 * int(rng.integers(0, n + 1)) / n:.{int(rng.integers(0, 4))}f}"
    yield from fact_rows("", Success(rate=cell(rate, column="SR"), runs=n))
    values = np.round(rng.exponential(1.0, (4, 5)), int(rng.integers(0, 4)))
    places = np.argsort(np.argsort(values, axis=1), axis=1) + 1  # ties in order
    tied = (values[:, :, None] > values[:, None, :]).sum(axis=2) + 1  # ties share the best place
    ranks = places if rng.random() < 0.5 else tied
    columns = "ABCDE"
    printed = tuple(
        {
            name: cell(f"{v:.{int(rng.integers(1, 4))}g}", column=name)
            for name, v in zip(columns, row, strict=True)
        }
        for row in values
    )
    given = tuple(
        {name: cell(str(rank), column=name) for name, rank in zip(columns, row, strict=True)}
        for row in ranks
    )
    sums = {
        name: cell(str(total), column=name)
        for name, total in zip(columns, ranks.sum(axis=0), strict=True)
    }
    yield from fact_rows("", RankedRows(values=printed, ranks=given, sums=sums))


def alarms(tables: int, seed: int = 0) -> Counter[str]:
    """Return how many true tables are called impossible without a condition, or inconsistent."""
    rng = np.random.default_rng(seed)
    count: Counter[str] = Counter()
    for _ in range(tables):
        table = true_table(rng)
        rows = [*block_rows("", table.block), *true_facts(rng)]
        count["tables"] += 1
        for name, found in (
            ("impossible", any(row.is_proof for row in rows)),
            ("inconsistent", any(row.grade is Grade.INCONSISTENT for row in rows)),
            ("with a condition", any(row.grade is Grade.IMPOSSIBLE for row in rows)),
        ):
            count[name] += found
        for row in rows:
            if row.is_proof or row.grade is Grade.INCONSISTENT:
                sys.stderr.write(f"{table.pipeline}: {row.check}: {row.explanation}\n")
    return count


def with_error(kind: str, texts: dict[str, str], n: int, other: str) -> tuple[dict[str, str], int]:
    """Return the texts of a block with one error in it, and the number of runs it tells."""
    std, mean = float(texts["std"]), float(texts["mean"])
    new = dict(texts)
    factors = {"std × 10": 10, "std × 100": 100, "std / 10": 0.1, "std / 100": 0.01}
    if kind in factors:
        new["std"] = f"{std * factors[kind]:.3e}"
    elif kind == "a digit of the mean":
        lead = texts["mean"].lstrip("-")[0]
        new["mean"] = texts["mean"].replace(lead, str((int(lead) + 4) % 9 + 1), 1)
    elif kind == "mean and worst exchanged" and "worst" in texts:
        new["mean"], new["worst"] = texts["worst"], texts["mean"]
    elif kind == "sign of the mean":
        new["mean"] = f"{-mean:.3e}"
    elif kind == "exponent of the mean lost":
        new["mean"] = texts["mean"].partition("e")[0]
    elif kind == "variance for std":
        new["std"] = f"{std**2:.3e}"
    elif kind == "standard error for std":
        new["std"] = f"{std / n**0.5:.3e}"
    elif kind == "std of another row":
        new["std"] = other
    return new, max(2, n // 10) if kind == "a tenth of the runs" else n


def power(kind: str, names: tuple[str, ...], errors: int, seed: int = 1) -> float:
    """Return the share of tables with one such error in which something impossible is found."""
    rng = np.random.default_rng(seed)
    found = planted = 0
    while planted < errors:
        runs = rng.lognormal(rng.uniform(-8, 8), rng.uniform(0.1, 3), 30)
        values = statistics_of(runs, single=False, one_pass=False, ddof=1, reverse=False)
        texts = {name: f"{values[name]:.3e}" for name in names}
        wrong, n = with_error(kind, texts, 30, f"{rng.lognormal(0, 6):.3e}")
        if (wrong, n) == (texts, 30):
            return float("nan")
        planted += 1
        rows = block_rows("", block_of(wrong, n, floor=True))
        found += any(row.grade is Grade.IMPOSSIBLE for row in rows)
    return found / errors


def page(count: Counter[str], errors: int) -> str:
    """Return the page of the manual."""
    lines = [
        "# False alarms and power of the checks",
        "",
        f"Of {count['tables']:,} true tables (heavy tails, zeros, floors, equal runs, whole",
        "numbers; single and double precision, one and two passes, n and n − 1, rounded, cut off,",
        "R's four digits, rounded twice, mixed digits, fixed decimals, powers of ten, both senses,",
        f"sorted runs, tied ranks, success rates), {count['impossible']} are called impossible",
        "without a condition,",
        f"{count['inconsistent']} inconsistent, and {count['with a condition']} impossible under a",
        "condition that is said, such as double precision.",
        "",
        f"The share of {errors} planted errors that are found (impossible, with a condition or",
        "without; 30 runs of lognormal costs, four digits, no value below 0):",
        "",
        "| error | " + " | ".join(", ".join(names) for names in SETS) + " |",
        "| --- | " + " | ".join("---" for _ in SETS) + " |",
    ]
    for kind in ERRORS:
        shares = [power(kind, names, errors) for names in SETS]
        cells = ("–" if share != share else f"{100 * share:.0f} %" for share in shares)  # noqa: PLR0124 (nan)
        lines.append(f"| {kind} | {' | '.join(cells)} |")
    return "\n".join([*lines, ""])


if __name__ == "__main__":
    counted = alarms(int(sys.argv[1]) if len(sys.argv) > 1 else TABLES)
    PAGE.write_text(page(counted, PLANTED), encoding="utf-8")
    sys.stdout.write(f"{dict(counted)}\n")
