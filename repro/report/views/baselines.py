"""What the pages show of the baselines and of the ranking at equal evaluations."""

from collections.abc import Sequence
from dataclasses import dataclass

from repro.judge.beside_baselines import (
    ExperimentStandings,
    ProblemStandings,
    Standing,
    mean_ranks,
)
from repro.judge.known_minimum import KnownMinimum
from repro.model.experiment import Experiment
from repro.report.words import number
from repro.runs.equal_budget import budget

Texts = tuple[str, ...]
_SECONDS = "time of a run"
_SUMMARY = ("algorithm", "run as", "runs", "evaluations of a run", _SECONDS, "mean rank")


@dataclass(frozen=True, slots=True, kw_only=True)
class StandingsView:
    """One experiment: a summary row per algorithm, a row per problem, and the two rankings."""

    experiment: Experiment
    evaluations: int
    summary_headings: Texts
    summary: tuple[Texts, ...]
    headings: Texts
    rows: tuple[Texts, ...]
    budgets: tuple[Texts, ...]


def standings_view(found: ExperimentStandings, *, seconds: bool = False) -> StandingsView:
    """Return the standings of one experiment in words, with `seconds` as they were here if asked.

    Published pages leave them to the provenance, so that equal runs give equal pages.
    """
    problems = found.problems
    names = list(dict.fromkeys((row.algorithm, row.kind) for p in problems for row in p.rows))
    places = {(p.problem, row.algorithm, row.kind): row for p in problems for row in p.rows}
    ranks = mean_ranks(problems)
    own = {
        name: [places[p.problem, *name] for p in problems if (p.problem, *name) in places]
        for name in names
    }
    return StandingsView(
        experiment=found.experiment,
        evaluations=budget(found.experiment),
        summary_headings=_SUMMARY if seconds else tuple(h for h in _SUMMARY if h != _SECONDS),
        summary=tuple(_summary(own[name], ranks.get(name), seconds=seconds) for name in names),
        headings=("problem", "known minimum", *(_heading(*name) for name in names)),
        rows=tuple(
            (
                f"{p.problem} [s]" if p.minimum and p.minimum.is_time else p.problem,
                _minimum(p),
                *(_cell(places.get((p.problem, *name)), p.minimum) for name in names),
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
            for row in found.budgets
        ),
    )


def _heading(algorithm: str, kind: str) -> str:
    return f"{algorithm}, {kind}" if kind == "equal evaluations" else algorithm


def _summary(rows: Sequence[Standing], rank: float | None, *, seconds: bool) -> Texts:
    first = rows[0]
    return (
        first.algorithm,
        first.kind,
        f"{len(first.costs)}",
        f"{first.evaluations}",
        *([f"{number(sum(row.seconds for row in rows) / len(rows), 2)} s"] if seconds else []),
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
