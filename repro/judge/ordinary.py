"""The proposed algorithm beside ordinary optimisers, and where the optimum leaves the centre."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Literal

from repro.judge.beside_baselines import ExperimentStandings, ProblemStandings, Standing
from repro.judge.centre_bias import SOLVED, CentreBias
from repro.judge.judgement import Judgement
from repro.model.experiment import Experiment
from repro.model.tolerances import Interval
from repro.runs.equal_budget import budget, unequal
from repro.runs.moved_optima import CONTROL, KUDELA


@dataclass(frozen=True, slots=True, kw_only=True)
class Ordinary:
    """The proposed algorithm against a baseline of an experiment, at equal evaluations.

    The baseline is the one that is `lower` in mean cost on the most problems beyond those on which
    it is `higher`; on the rest of `problems` they are equal, as are errors below 1e-8. Where there
    is one problem, `own` and `other` are the two means, in `unit`. `runs` are the fewer of either.
    """

    experiment: str
    proposed: str
    baseline: str
    baselines: int
    problems: int
    lower: int
    higher: int
    evaluations: int
    runs: int
    own: float | None
    other: float | None
    unit: str


@dataclass(frozen=True, slots=True, kw_only=True)
class OffCentre:
    """What becomes of an experiment's algorithms when the optimum leaves the centre by `shift`.

    `ratio`, with its `interval`, is that of the proposed algorithm's mean errors, `control` that of
    differential evolution; `places` are the proposed algorithm's by mean rank, in place and moved.
    All of this is None where it is not re-run. `biased` names every algorithm that is flagged.
    `equal` says whether all of them spend the same evaluations; `ranks` are mean ranks of the
    proposed one in place, as printed and at equal evaluations, where it spends another number.
    """

    experiment: str
    proposed: str
    algorithms: int
    shift: float
    ratio: float | None
    interval: Interval | None
    control: float | None
    places: tuple[int, int] | None
    biased: tuple[str, ...]
    equal: bool
    ranks: tuple[float, float] | None


def ordinary(judgement: Judgement) -> tuple[Ordinary, ...]:
    """Return the comparison with a baseline of each experiment whose proposed one is run."""
    found = (_ordinary(each) for each in judgement.standings)
    return tuple(each for each in found if each)


def _ordinary(found: ExperimentStandings) -> Ordinary | None:
    experiment = found.experiment
    kind = "equal evaluations" if experiment.proposed in unequal(experiment) else "printed protocol"
    pairs = [pair for each in found.problems for pair in _pairs(experiment, kind, each)]
    names = list(dict.fromkeys(other.algorithm for _, other in pairs))
    if not names:
        return None

    def won(name: str) -> tuple[int, int]:
        signs = [_sign(own, other) for own, other in pairs if other.algorithm == name]
        return signs.count(1), signs.count(-1)

    best = max(names, key=lambda name: won(name)[0] - won(name)[1])
    own, other = next(pair for pair in pairs if pair[1].algorithm == best)
    lower, higher = won(best)
    problems = sum(other.algorithm == best for _, other in pairs)
    return Ordinary(
        experiment=experiment.name,
        proposed=experiment.proposed,
        baseline=best,
        baselines=len(names),
        problems=problems,
        lower=lower,
        higher=higher,
        evaluations=budget(experiment),
        runs=min(own.costs.size, other.costs.size),
        own=own.mean if problems == 1 else None,
        other=other.mean if problems == 1 else None,
        unit="s" if found.problems[0].minimum and found.problems[0].minimum.is_time else "",
    )


def _pairs(
    experiment: Experiment, kind: str, problem: ProblemStandings
) -> Iterator[tuple[Standing, Standing]]:
    own = [r for r in problem.rows if (r.algorithm, r.kind) == (experiment.proposed, kind)]
    for row in problem.rows:
        if own and row.kind == "baseline":
            yield own[0], row


def _sign(own: Standing, other: Standing) -> Literal[-1, 0, 1]:
    """Return 1 where the other ends lower, -1 where it ends higher, 0 where both have solved it."""
    if own.distance is None or other.distance is None:
        mine, its = own.mean, other.mean
    else:
        mine, its = (max(each.distance or 0.0, SOLVED) for each in (own, other))
    return 1 if its < mine else -1 if its > mine else 0


def off_centre(judgement: Judgement) -> tuple[OffCentre, ...]:
    """Return what is known of each experiment whose functions were moved."""
    return tuple(_off_centre(each, judgement.standings) for each in judgement.centre_biases)


def _off_centre(found: CentreBias, standings: Sequence[ExperimentStandings]) -> OffCentre:
    experiment = found.experiment
    own = experiment.proposed
    moved = {bias.algorithm: bias for bias in found.biases if bias.shift == KUDELA}
    mine = moved.get(own)
    places = {each.shift: each.place(own) for each in found.ranks if own in each.ranks}
    budgets = [
        row
        for each in standings
        if each.experiment.name == experiment.name
        for row in each.budgets
        if row.algorithm == own
    ]
    return OffCentre(
        experiment=experiment.name,
        proposed=own,
        algorithms=len(experiment.algorithms),
        shift=KUDELA,
        ratio=mine.ratio if mine else None,
        interval=mine.interval if mine else None,
        control=moved[CONTROL].ratio if CONTROL in moved else None,
        places=(places[0.0], places[KUDELA]) if mine else None,
        biased=found.flagged,
        equal=not unequal(experiment),
        ranks=(budgets[0].rank, budgets[0].equal_rank) if budgets else None,
    )
