"""What the pages say of the algorithms when the optimum leaves the centre of the box."""

from collections.abc import Sequence
from dataclasses import dataclass

from repro.judge.centre_bias import Bias, Costs, RanksAtShift, biases, shifts_of, standings
from repro.model.evidence import Evidence
from repro.model.experiment import Experiment
from repro.report.drawings.centre_bias import bias_plot
from repro.report.drawings.draw import Drawing, drawing
from repro.report.words import anchor, number
from repro.runs.moved_optima import CONTROL, FLOOR, IN_PLACE, SHARES, centred, shift_name
from repro.runs.studies import study_name

FLAGGED = "⚑ biased"


@dataclass(frozen=True, slots=True, kw_only=True)
class CentreBias:
    """What shifts of one experiment's functions do to its algorithms.

    `rows` holds algorithm and, for each of the `headings`, one text on its ratio; `ranks` holds
    algorithm and its mean rank in place and at each shift; `place` says where the proposed
    algorithm stands; `left_out` are the problems that are not shifted.
    """

    experiment: Experiment
    problems: tuple[str, ...]
    left_out: tuple[str, ...]
    runs: int
    headings: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    flagged: tuple[str, ...]
    ranks: tuple[tuple[str, ...], ...]
    place: str
    drawing: Drawing


def centre_biases(evidence: Evidence) -> tuple[CentreBias, ...]:
    """Return what is shown of every experiment whose shifted runs are all there."""
    found = [(e, shift_costs(evidence, e)) for e in evidence.paper.experiments if centred(e)]
    return tuple(_view(evidence.paper.key, each, costs) for each, costs in found if costs)


def shift_costs(evidence: Evidence, experiment: Experiment) -> Costs:
    """Return final costs by (shift, problem, algorithm), the same repeats of each; or nothing.

    In place, the paper's algorithms have the runs of the protocol, of which the first repeats
    count that the shifted ones have too. Nothing is returned unless all of them are there.
    """
    costs = {}
    for share in (IN_PLACE, *SHARES):
        aside = study_name(experiment.name, shift_name(share))
        for problem in centred(experiment):
            for name in (*experiment.algorithms, CONTROL, FLOOR):
                own = share == IN_PLACE and name in experiment.algorithms
                runs = evidence.runs.get((experiment.name if own else aside, problem, name))
                if runs is None:
                    return {}
                costs[share, problem, name] = runs.costs
    repeats = min(len(values) for values in costs.values())
    return {cell: values[:repeats] for cell, values in costs.items()}


def _view(paper: str, experiment: Experiment, costs: Costs) -> CentreBias:
    problems = centred(experiment)
    names = (*experiment.algorithms, CONTROL, FLOOR)
    minima = {problem: experiment.problems[problem].function.minimum for problem in problems}
    found = biases(costs, minima, names)
    standing = standings(costs, problems, tuple(experiment.algorithms))
    flagged = tuple(dict.fromkeys(bias.algorithm for bias in found if bias.flagged))
    return CentreBias(
        experiment=experiment,
        problems=problems,
        left_out=tuple(name for name in experiment.problems if name not in problems),
        runs=next(iter(costs.values())).size,
        headings=tuple(shift_name(shift) for shift in shifts_of(costs)),
        rows=tuple((name, *(_words(b) for b in found if b.algorithm == name)) for name in names),
        flagged=flagged,
        ranks=tuple(
            (name, *(f"{each.ranks[name]:.2f}" for each in standing))
            for name in experiment.algorithms
        ),
        place=_places(experiment, standing),
        drawing=drawing(
            lambda: bias_plot(names, found),
            title=f"Error when the optimum leaves the centre, {experiment.name}",
            identifier=anchor(paper, "bias", experiment.name),
        ),
    )


def _words(bias: Bias) -> str:
    low, high = (number(end, 3) for end in bias.interval)
    flag = f" {FLAGGED}" if bias.flagged else ""
    return f"{number(bias.ratio, 3)} [{low}, {high}], p = {number(bias.p, 2)}{flag}"


def _places(experiment: Experiment, standing: Sequence[RanksAtShift]) -> str:
    """Return the places of the proposed algorithm as a sentence."""
    name, algorithms = experiment.proposed, len(experiment.algorithms)
    problems = len(centred(experiment))
    places = [
        f"{each.place(name)} of {algorithms} "
        + (f"with shift {each.shift:g}" if each.shift else "in place")
        for each in standing
    ]
    over = f"{problems} problem{'s' * (problems > 1)}"
    return f"{name} stands {', '.join(places)} by mean rank over {over}."
