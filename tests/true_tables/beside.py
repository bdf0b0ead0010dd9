"""True tables of what is printed beside statistics: ranks, success rates, tests and tallies."""

import math
from typing import Any, Literal

import numpy as np
from scipy import stats

from repro.tables.audit_options import AuditOptions
from repro.tables.counts import ALL_COUNTED, ALL_SHOWN
from repro.tables.decisions import NORMAL
from repro.tables.facts import Decision, WinsAndLosses
from repro.tables.printed import Printed
from repro.tables.relations import PlacedNumber
from tests.true_tables.pipelines import drawn_pipeline, printed, statistics_of, texts_of
from tests.true_tables.samples import Generator, Vector, number_of_runs, runs_of
from tests.true_tables.written import TrueTable, written

TIES: tuple[Literal["average", "min", "max", "dense", "ordinal"], ...] = (
    *("average", "min", "max", "dense", "ordinal"),
)
METHODS = ("GWO", "PSO", "DE", "WOA", "SSA", "ABC")
THRESHOLDS = (1e-4, 0.1, 1e-8, 100.0, 0.3, 1.0, 5e-3)
DECISIONS = (("0", "1"), ("False", "True"), ("no", "yes"), ("not rejected", "rejected"))
LEVELS = (0.05, 0.05, 0.01, 0.1)


def rank_table(rng: Generator) -> TrueTable:
    """Return means with their ranks by problem, and the sums, means and places of these."""
    problems, methods = int(rng.integers(2, 7)), METHODS[: int(rng.integers(2, 7))]
    ties = TIES[int(rng.integers(len(TIES)))]
    how = ("scientific", "fixed", "cut off", "general")[int(rng.integers(4))]
    values = rng.lognormal(0, rng.uniform(0.01, 4), (problems, len(methods)))
    if rng.random() < 0.5:  # some reach the optimum
        values = np.where(rng.random(values.shape) < 0.3, 0.0, values)
    digits = int(rng.integers(1, 6))
    texts = [[printed(v, how, digits) for v in row] for row in values.tolist()]
    if rng.random() < 0.5:  # ranked as printed
        values = np.array([[float(text) for text in row] for row in texts])
    maximise = rng.random() < 0.2
    ranks = stats.rankdata(-values if maximise else values, method=ties, axis=1)
    word = ("Mean", "Median", "Best")[int(rng.integers(3))]
    lines = [["Function", "Index", *methods]]
    for k, (row, own) in enumerate(zip(texts, ranks.tolist(), strict=True), 1):
        lines += [[f"F{k}", word, *row], [f"F{k}", "Rank", *(f"{rank:g}" for rank in own)]]
    lines += _totals(rng, ranks)
    told: dict[str, Any] = {"ties": ties} if rng.random() < 0.3 else {}
    if maximise and rng.random() < 0.5:
        told["maximise"] = True
    made = f"ranks {ties} of {word}, {how} {digits}{', maximise' if maximise else ''}"
    return TrueTable(made=made, text=written(rng, "Results", lines), options=AuditOptions(**told))


def _totals(rng: Generator, ranks: Vector) -> list[list[str]]:
    """Return the lines below ranks: their sums or means, and the places of these."""
    kind = rng.random()
    if kind < 0.25:
        return []
    totals = ranks.sum(axis=0)
    means = totals / len(ranks)
    digits = int(rng.integers(1, 5))
    first = ("", "All")[int(rng.integers(2))]
    lines = (
        [[first, "Total rank", *(f"{each:g}" for each in totals.tolist())]]
        if kind < 0.5
        else [[first, "Average rank", *(f"{each:.{digits}f}" for each in means.tolist())]]
    )
    if rng.random() < 0.6:
        by = totals if rng.random() < 0.5 else np.round(means, digits)
        places = stats.rankdata(by, method=TIES[int(rng.integers(1, len(TIES)))])
        lines.append([first, "Final rank", *(f"{each:g}" for each in places.tolist())])
    return lines


def success_table(rng: Generator) -> TrueTable:
    """Return statistics of runs with the share of them that reach a threshold."""
    n, threshold = number_of_runs(rng), THRESHOLDS[int(rng.integers(len(THRESHOLDS)))]
    pipeline = drawn_pipeline(rng)
    names = ("best", "mean", "median", "worst", "std")
    strict, decimals = rng.random() < 0.3, int(rng.integers(0, 4))
    lines = [["Function", "Best", "Mean", "Median", "Worst", "Std", "Success rate (%)"]]
    for k in range(1, int(rng.integers(2, 5))):
        runs = runs_of(rng, n, "errors")
        kind = rng.random()
        if kind < 0.3:  # searches that stop as soon as they are there
            runs = np.where(rng.random(n) < rng.random(), threshold, runs)
        elif kind < 0.6:
            runs = rng.lognormal(math.log(threshold), 2, n)
        kept = runs if pipeline.precision == "double" else runs.astype(np.float32)
        limit = kept.dtype.type(threshold)
        reached = 100 * int(((kept < limit) if strict else (kept <= limit)).sum()) / n
        texts = texts_of(statistics_of(runs, pipeline, names), pipeline, rng)
        rate = printed(reached, "fixed cut" if rng.random() < 0.3 else "fixed", decimals)
        lines.append([f"F{k}", *(texts.get(name, "inf") for name in names), rate])
    title = f"{n} runs; success: an error below {threshold:g}"
    return TrueTable(
        made=f"success, {pipeline.words}",
        text=written(rng, title, lines),
        options=AuditOptions(errors=True),
        broken=pipeline.broken,
    )


def test_table(rng: Generator) -> TrueTable:
    """Return p of rank tests of two methods with z, effect sizes and decisions."""
    n, sides = int(rng.integers(4, 61)), 2 if rng.random() < 0.7 else 1
    test: Literal["ranksum", "signedrank"] = "ranksum" if rng.random() < 0.6 else "signedrank"
    alpha = LEVELS[int(rng.integers(len(LEVELS)))]
    columns = [name for name in ("z", "h", "r") if rng.random() < 0.6]
    digits, how = int(rng.integers(2, 7)), "scientific" if rng.random() < 0.6 else "fixed"
    lines = [["Function", "p-value", *columns]]
    corrected, marks = rng.random() < 0.5, rng.random() < 0.3 and "h" not in columns
    words = DECISIONS[int(rng.integers(len(DECISIONS)))]
    exact = rng.random() < 0.3  # z beside it is that of the normal approximation
    for k in range(1, int(rng.integers(2, 6))):
        one, other = runs_of(rng, n, "errors"), runs_of(rng, n, "errors")
        if rng.random() < 0.5:
            other = one * rng.lognormal(rng.normal(0, 0.3), 0.5, n)
        z, p = _tested(one, other, test, corrected=corrected, sides=sides)
        if exact and n <= 12:
            p = _exact_p(one, other, test, sides)
        effect = z / math.sqrt(n if rng.random() < 0.5 else 2 * n)
        beside = {
            "z": printed(z, how, digits),
            "h": words[p < alpha],
            "r": f"{abs(effect):.{digits}f}",
        }
        mark = ("+" if p < alpha else "=") if marks else ""
        lines.append([f"F{k}", printed(p, how, digits) + mark, *(beside[name] for name in columns)])
    title = f"{n} runs, {'two' if sides == 2 else 'one'}-sided tests at α = {alpha}"
    return TrueTable(
        made=f"{test}, {sides} sides, n = {n}, {'exact' if exact else 'normal'}",
        text=written(rng, title, lines),
        options=AuditOptions(test=test if rng.random() < 0.5 else None),
        broken=frozenset({NORMAL} if exact else ()),
    )


def _tested(
    one: Vector, other: Vector, test: str, *, corrected: bool, sides: int
) -> tuple[float, float]:
    """Return z and p by the normal approximation, the variance corrected for ties."""
    n = len(one)
    if test == "ranksum":
        ranks = stats.rankdata(np.concatenate((one, other)))
        apart = ranks[:n].sum() - n * (2 * n + 1) / 2
        times = np.unique(ranks, return_counts=True)[1].astype(float)
        ties = (times**3 - times).sum() / (2 * n * (2 * n - 1))
        variance = n * n / 12 * (2 * n + 1 - ties)
    else:
        less = (one - other)[one != other]
        ranks = stats.rankdata(np.abs(less))
        apart = (ranks * np.sign(less)).sum() / 2
        variance = (ranks**2).sum() / 4
    if variance <= 0:
        return 0.0, sides / 2
    if corrected:
        apart = math.copysign(max(0.0, abs(apart) - 0.5), apart)
    z = float(apart / math.sqrt(variance))
    return z, (math.erfc(abs(z) / math.sqrt(2)) if sides == 2 else math.erfc(z / math.sqrt(2)) / 2)


def _exact_p(one: Vector, other: Vector, test: str, sides: int) -> float:
    way = "two-sided" if sides == 2 else "less"
    if test == "ranksum":
        return float(stats.mannwhitneyu(one, other, alternative=way, method="exact").pvalue)
    if np.all(one == other):
        return 1.0
    return float(stats.wilcoxon(one, other, alternative=way, method="exact").pvalue)


def tally_table(rng: Generator) -> TrueTable:
    """Return counts of wins, ties and losses against rivals, of all problems or of a part."""
    rivals, problems = METHODS[: int(rng.integers(1, 6))], int(rng.integers(5, 31))
    title = f"Results on {problems} functions"
    broken = frozenset[str]()
    counted = problems
    if rng.random() < 0.3:  # those of one group, say
        counted, broken = int(rng.integers(1, problems + 1)), frozenset({ALL_COUNTED})
    counts = [rng.multinomial(counted, rng.dirichlet((1, 1, 1))).tolist() for _ in rivals]
    kind = rng.random()
    if kind < 0.4:
        lines = [["Algorithm", "Wins", "Ties", "Losses"]]
        lines += [[name, *map(str, own)] for name, own in zip(rivals, counts, strict=True)]
    elif kind < 0.8:
        lines = [["Index", *rivals], ["+/=/-", *("/".join(map(str, own)) for own in counts)]]
        lines.append(["Mean", *(f"{v:.3e}" for v in rng.lognormal(0, 1, len(rivals)))])
    else:  # below the lines of some problems, of which it may count others
        shown = counted if rng.random() < 0.5 else int(rng.integers(2, 31))
        values = rng.lognormal(0, 1, (shown, len(rivals))).tolist()
        lines = [["Function", *rivals]]
        lines += [[f"F{k}", *(f"{v:.3e}" for v in row)] for k, row in enumerate(values, 1)]
        lines.append(["+/=/-", *("/".join(map(str, own)) for own in counts)])
        title, broken = "Means", frozenset({ALL_SHOWN})
    return TrueTable(
        made=f"tally of {counted} of {problems}",
        text=written(rng, title, lines),
        options=AuditOptions(),
        broken=broken,
        facts=_sign_test(rng),
    )


def _sign_test(rng: Generator) -> tuple[Decision]:
    """Return p of a sign test with the counts that it is of, ties left out."""
    wins, ties, losses = rng.multinomial(int(rng.integers(5, 60)), (0.45, 0.1, 0.45)).tolist()
    sides: Literal[1, 2] = 2 if rng.random() < 0.7 else 1
    if wins + losses == 0:
        wins = 1
    if rng.random() < 0.5:
        way = "two-sided" if sides == 2 else "greater"
        p = float(stats.binomtest(wins, wins + losses, alternative=way).pvalue)
    else:
        z = (wins - losses) / math.sqrt(wins + losses)
        p = math.erfc(abs(z) / math.sqrt(2)) if sides == 2 else math.erfc(z / math.sqrt(2)) / 2
    text = printed(p, "scientific", int(rng.integers(2, 6)))
    return (
        Decision(
            p=_cell(text, "p"),
            rejects=p < 0.05,
            sides=sides if rng.random() < 0.5 else None,
            tally=WinsAndLosses(
                wins=_cell(str(wins), "+"),
                ties=_cell(str(ties), "="),
                losses=_cell(str(losses), "-"),
                problems=wins + ties + losses,
            ),
        ),
    )


def _cell(text: str, column: str) -> PlacedNumber:
    return PlacedNumber(printed=Printed(text), label="t", row="F1", column=column)
