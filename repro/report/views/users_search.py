"""What the private report shows of a user's search beside the others."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from repro.judge.beside_baselines import ProblemStandings, Standing, standings
from repro.judge.certificates import Certificate
from repro.model.claims import CellClaim
from repro.model.evidence import Cell, Runs
from repro.model.experiment import Experiment
from repro.model.measures.measure import Statistic
from repro.model.paper import Paper
from repro.report.views.baselines import Standings, standings_view
from repro.report.words import number
from repro.statistics.effect_size import win_probability
from repro.statistics.rank_sum import holm, rank_sum_p
from repro.tables.published import Printed

Texts = tuple[str, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Comparison:
    """The user's search in one experiment: standings, places among the printed, and tests."""

    experiment: Experiment
    standings: Standings
    printed: tuple[Texts, ...]
    tests: tuple[Texts, ...]


def comparison(
    paper: Paper,
    experiment: Experiment,
    runs: Mapping[Cell, Runs],
    certificates: Sequence[Certificate],
    *,
    name: str,
) -> Comparison:
    """Return where the search of that name stands, as far as it and the others were run."""
    problems = standings(experiment, runs, certificates, yours=(name,))
    return Comparison(
        experiment=experiment,
        standings=standings_view(experiment, runs, problems),
        printed=tuple(_printed(paper, experiment, standing) for standing in problems),
        tests=_tests(problems),
    )


def printed_means(paper: Paper, experiment: str, problem: str) -> Mapping[str, Printed]:
    """Return the mean, or only, cost or time that the paper prints, by algorithm."""
    found = {}
    for claim in paper.claims:
        measure = claim.measure
        if (
            isinstance(claim, CellClaim)
            and isinstance(measure, Statistic)
            and measure.cell[:2] == (experiment, problem)
            and measure.statistic in ("mean", "single")
            and measure.quantity in ("cost", "total")
        ):
            found[measure.algorithm] = claim.printed
    return found


def _printed(paper: Paper, experiment: Experiment, standing: ProblemStandings) -> Texts:
    """Return problem, printed means, the search's own mean, and its place among them."""
    printed = printed_means(paper, experiment.name, standing.problem)
    own = next((row for row in standing.rows if row.kind == "yours"), None)
    texts = "; ".join(f"{name} {p.text} {p.unit}".strip() for name, p in printed.items())
    if own is None or not printed:
        return standing.problem, texts or "none", "–" if own is None else number(own.mean), "–"
    place = 1 + sum(p.si < own.mean for p in printed.values())
    return standing.problem, texts, number(own.mean), f"{place} of {len(printed) + 1}"


def _tests(problems: Sequence[ProblemStandings]) -> tuple[Texts, ...]:
    """Return the rank-sum test of the search against each other one, Holm over the experiment."""
    pairs = [
        (standing.problem, own, other)
        for standing in problems
        for own in standing.rows
        for other in standing.rows
        if own.kind == "yours" and other.kind != "yours"
    ]
    p_values = np.array([rank_sum_p(own.costs, other.costs) for _, own, other in pairs])
    return tuple(
        _test_row(*pair, float(p), float(q))
        for pair, p, q in zip(pairs, p_values, holm(p_values), strict=True)
    )


def _test_row(problem: str, own: Standing, other: Standing, p: float, corrected: float) -> Texts:
    return (
        problem,
        other.algorithm,
        other.kind,
        number(own.mean),
        number(other.mean),
        number(p),
        number(corrected),
        f"{win_probability(own.costs, other.costs):.2f}",
    )
