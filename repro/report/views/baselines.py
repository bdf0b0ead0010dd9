"""What the pages show of the baselines and of the ranking at equal evaluations."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from repro.judge.beside_baselines import (
    ProblemStandings,
    Standing,
    budget_rows,
    mean_ranks,
    standings,
)
from repro.judge.certificates import Certificate
from repro.judge.known_minimum import KnownMinimum
from repro.model.evidence import Cell, Runs
from repro.model.experiment import Experiment
from repro.model.paper import Paper
from repro.report.words import number
from repro.runs.equal_budget import budget

Texts = tuple[str, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Standings:
    """One experiment: a summary row per algorithm, a row per problem, and the two rankings."""

    experiment: Experiment
    evaluations: int
    summary: tuple[Texts, ...]
    headings: Texts
    rows: tuple[Texts, ...]
    budgets: tuple[Texts, ...]


def baselines_view(
    paper: Paper, runs: Mapping[Cell, Runs], certificates: Sequence[Certificate]
) -> tuple[Standings, ...]:
    """Return what is shown of every experiment with runs of baselines or at another budget."""
    found = (
        standings_view(experiment, runs, standings(experiment, runs, certificates))
        for experiment in paper.experiments
    )
    return tuple(view for view in found if view.budgets or _has_baselines(view))


def _has_baselines(view: Standings) -> bool:
    return any(row[1] == "baseline" for row in view.summary)


def standings_view(
    experiment: Experiment, runs: Mapping[Cell, Runs], problems: Sequence[ProblemStandings]
) -> Standings:
    """Return the standings of one experiment in words."""
    names = list(dict.fromkeys((row.algorithm, row.kind) for p in problems for row in p.rows))
    found = {(p.problem, row.algorithm, row.kind): row for p in problems for row in p.rows}
    ranks = mean_ranks(problems)
    own = {
        name: [found[p.problem, *name] for p in problems if (p.problem, *name) in found]
        for name in names
    }
    return Standings(
        experiment=experiment,
        evaluations=budget(experiment),
        summary=tuple(_summary(own[name], ranks.get(name)) for name in names),
        headings=("problem", "known minimum", *(_heading(*name) for name in names)),
        rows=tuple(
            (
                p.problem,
                _minimum(p),
                *(_cell(found.get((p.problem, *name)), p.minimum) for name in names),
            )
            for p in problems
        ),
        budgets=tuple(
            (
                row.algorithm,
                f"{row.evaluations}",
                f"{row.rank:.2f}",
                f"{row.equal_evaluations}",
                f"{row.equal_rank:.2f}",
            )
            for row in budget_rows(experiment, runs)
        ),
    )


def _heading(algorithm: str, kind: str) -> str:
    return f"{algorithm}, {kind}" if kind == "equal evaluations" else algorithm


def _summary(rows: Sequence[Standing], rank: float | None) -> Texts:
    first = rows[0]
    seconds = sum(row.seconds for row in rows) / len(rows)
    return (
        first.algorithm,
        first.kind,
        f"{len(first.costs)}",
        f"{first.evaluations}",
        f"{number(seconds, 2)} s",
        "–" if rank is None else f"{rank:.2f}",
    )


def _minimum(standing: ProblemStandings) -> str:
    if standing.minimum is None:
        return "–"
    return f"{number(standing.minimum.value, 6)} ({standing.minimum.how})"


def _cell(row: Standing | None, minimum: KnownMinimum | None) -> str:
    if row is None:
        return "–"
    value, median = number(row.mean), number(row.median)
    known = row.distance is not None and minimum and minimum.value
    away = f"; {number(row.distance, 3)} away" if known else ""
    place = "" if row.rank is None else f"; rank {row.rank:g}"
    return f"{value} (median {median}){away}{place}"
