"""Errors planted beside statistics: in ranks, tallies, tests and success rates."""

from collections.abc import Callable, Mapping, Sequence

import numpy as np
from scipy import stats

from repro.tables.audit_options import AuditOptions
from repro.tables.auditing import audit_text
from repro.tables.rows import Grade
from tests.true_tables.samples import Generator, named_rng

SEED = "planted errors beside statistics"
METHODS = ("GWO", "PSO", "DE", "WOA", "ABC")
PROBLEMS = 8
RUNS = 30
Lines = list[list[str]]


def _ranked(rng: Generator) -> tuple[Lines, np.ndarray]:
    values = rng.lognormal(0, 1, (PROBLEMS, len(METHODS)))
    ranks = stats.rankdata(values, axis=1).astype(int)
    lines = [["Function", "Index", *METHODS]]
    for k, (row, own) in enumerate(zip(values.tolist(), ranks.tolist(), strict=True), 1):
        lines.append([f"F{k}", "Mean", *(f"{value:.3e}" for value in row)])
        lines.append([f"F{k}", "Rank", *map(str, own)])
    return lines, ranks


def _exchanged_ranks(rng: Generator) -> Lines:
    lines, _ = _ranked(rng)
    line = lines[2 * int(rng.integers(1, PROBLEMS + 1))]
    line[2], line[3] = line[3], line[2]
    return lines


def _one_rank_off(rng: Generator) -> Lines:
    lines, _ = _ranked(rng)
    line = lines[2 * int(rng.integers(1, PROBLEMS + 1))]
    line[2] = str(int(line[2]) % len(METHODS) + 1)
    return lines


def _sum_one_off(rng: Generator) -> Lines:
    lines, ranks = _ranked(rng)
    sums = ranks.sum(axis=0)
    sums[int(rng.integers(len(METHODS)))] += 1
    return [*lines, ["All", "Total rank", *map(str, sums)]]


def _mean_one_off(rng: Generator) -> Lines:
    lines, ranks = _ranked(rng)
    means = ranks.mean(axis=0)
    means[int(rng.integers(len(METHODS)))] += 1 / PROBLEMS
    return [*lines, ["All", "Average rank", *(f"{mean:.2f}" for mean in means)]]


def _places_exchanged(rng: Generator) -> Lines:
    lines, ranks = _ranked(rng)
    means = ranks.mean(axis=0)
    places = stats.rankdata(means, method="ordinal")
    order = np.argsort(means)
    one, other = order[0], order[-1]
    places[one], places[other] = places[other], places[one]
    lines.append(["All", "Average rank", *(f"{mean:.2f}" for mean in means)])
    return [*lines, ["All", "Final rank", *map(str, places)]]


def _tally_one_off(rng: Generator) -> Lines:
    problems = int(rng.integers(10, 31))
    counts = rng.multinomial(problems, (0.5, 0.2, 0.3), size=len(METHODS))
    counts[int(rng.integers(len(METHODS))), int(rng.integers(3))] += 1
    cells = ("/".join(map(str, own)) for own in counts)
    return [[f"Results on {problems} functions"], ["Index", *METHODS], ["+/=/-", *cells],
            ["Mean", *(f"{value:.3e}" for value in rng.lognormal(0, 1, len(METHODS)))]]  # fmt: skip


def _tests(rng: Generator) -> tuple[np.ndarray, np.ndarray]:
    z = rng.normal(0, 2, PROBLEMS)
    return z, 2 * stats.norm.sf(np.abs(z))


def _decision_turned(rng: Generator) -> Lines:
    _, ps = _tests(rng)
    decided = ps < 0.05
    k = int(rng.integers(PROBLEMS))
    decided[k] = not decided[k]
    return [["Function", "p-value", "h"]] + [
        [f"F{k}", f"{p:.3e}", str(int(h))]
        for k, (p, h) in enumerate(zip(ps, decided, strict=True), 1)
    ]


def _p_of_another_row(rng: Generator) -> Lines:
    zs, ps = _tests(rng)
    ps[:2] = ps[1::-1]
    return [["Function", "p-value", "z"]] + [
        [f"F{k}", f"{p:.3e}", f"{z:.3f}"] for k, (p, z) in enumerate(zip(ps, zs, strict=True), 1)
    ]


def _rate_of_other_runs(rng: Generator) -> Lines:
    runs = int(rng.choice((25, 51, 20, 50)))
    rates = 100 * rng.integers(1, runs, PROBLEMS) / runs
    return [["Function", "SR (%)"]] + [[f"F{k}", f"{r:.2f}"] for k, r in enumerate(rates, 1)]


def _mean_above_threshold(rng: Generator) -> Lines:
    lines = [["Success: an error below 1e-4"], ["Function", "Mean", "SR (%)"]]
    means = 10 ** rng.uniform(-3.9, 4, PROBLEMS)
    return lines + [[f"F{k}", f"{mean:.2e}", "100"] for k, mean in enumerate(means, 1)]


BESIDE: Mapping[str, Callable[[Generator], Sequence[Sequence[str]]]] = {
    "two ranks of a line exchanged": _exchanged_ranks,
    "one rank of a line off": _one_rank_off,
    "a sum of ranks one off": _sum_one_off,
    "an average rank as if one rank were one off": _mean_one_off,
    "first and last place exchanged": _places_exchanged,
    "a win, tie or loss too many": _tally_one_off,
    "a decision turned, p beside it": _decision_turned,
    "two p exchanged, z beside them": _p_of_another_row,
    "success rates of another number of runs": _rate_of_other_runs,
    "100 % success, means above the threshold": _mean_above_threshold,
}


def power_beside(kind: str, errors: int, seed: str = SEED) -> float:
    """Return the share of tables with one such error in which something cannot be."""
    found = 0
    for k in range(errors):
        lines = BESIDE[kind](named_rng(seed, kind, k))
        text = "\n".join(",".join(line) for line in lines)
        tables = audit_text(text, AuditOptions(runs=RUNS))
        found += any(row.grade is not Grade.NOTED for table in tables for row in table.rows)
    return found / errors
