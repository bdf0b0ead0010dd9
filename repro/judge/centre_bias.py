"""How much worse each algorithm gets when the optimum leaves the centre of the box.

J. Kudela, The evolutionary computation methods no one should use, arXiv:2301.01984 (2023), after
Nature Machine Intelligence 4 (2022) 1238-1245, doi:10.1038/s42256-022-00579-0: the mean error on
the shifted function over that on the function in place, the geometric mean of these ratios over the
functions, and a centre bias where it is above 10.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from repro.determinism.seeds import generator
from repro.model.evidence import Evidence
from repro.model.experiment import Experiment
from repro.model.paper import Paper
from repro.runs.moved_optima import CONTROL, FLOOR, IN_PLACE, SHARES, centred, shift_name
from repro.runs.studies import study_name
from repro.statistics.rank_sum import holm
from repro.statistics.signed_rank import signed_rank_p
from repro.statistics.summary import mean
from repro.statistics.tables import quantile_interval

Vector = NDArray[np.float64]
Costs = Mapping[tuple[float, str, str], Vector]
"""Final costs by (shift, problem, algorithm), 0 being no shift. The k-th run of one algorithm on
one problem has the same seed at every shift."""

FLAG = 10.0
SOLVED = 1e-8
"""Errors below this count as this; the CEC competitions count them as 0 (J. J. Liang et al.,
Technical Report 201311, Zhengzhou University, 2013). The floor in the ratio is our choice: it keeps
it finite, and calls no method biased for ending at 1e-40 where it ended at 1e-80."""
RESAMPLES = 1000  # tables of paired runs; their 2.5 % tail then holds 25 of them
LEVEL = 0.95


@dataclass(frozen=True, slots=True, kw_only=True)
class Bias:
    """What one size of shift does to one algorithm.

    `ratios` are those of the mean errors by problem, `ratio` is their geometric mean, `interval`
    the central 95 % of it over tables of paired runs drawn with replacement. `p` is that of the
    one-sided signed-rank test, corrected for the number of tests.
    """

    algorithm: str
    shift: float
    ratios: Mapping[str, float]
    ratio: float
    interval: tuple[float, float]
    p: float

    @property
    def flagged(self) -> bool:
        """Whether the ratio says that there is a centre bias."""
        return self.ratio > FLAG


@dataclass(frozen=True, slots=True, kw_only=True)
class RanksAtShift:
    """Mean ranks of the paper's own algorithms by mean cost at one shift, by algorithm."""

    shift: float
    ranks: Mapping[str, float]

    def place(self, algorithm: str) -> int:
        """Return the place by mean rank, 1 for the lowest; ties share the better place."""
        return 1 + sum(rank < self.ranks[algorithm] for rank in self.ranks.values())


@dataclass(frozen=True, slots=True, kw_only=True)
class CentreBias:
    """What shifts of one experiment's functions do to its algorithms, over `runs` runs each.

    `algorithms` are its own, then control and floor; `left_out` are the problems that are not
    shifted; `ranks` are those of its own algorithms, in place first.
    """

    experiment: Experiment
    algorithms: tuple[str, ...]
    problems: tuple[str, ...]
    left_out: tuple[str, ...]
    runs: int
    biases: tuple[Bias, ...]
    ranks: tuple[RanksAtShift, ...]

    @property
    def flagged(self) -> tuple[str, ...]:
        """The algorithms that have a centre bias at some shift."""
        return tuple(dict.fromkeys(bias.algorithm for bias in self.biases if bias.flagged))


def centre_biases(paper: Paper, evidence: Evidence) -> tuple[CentreBias, ...]:
    """Return the biases of every experiment of the paper whose shifted runs are all there."""
    found = [(e, shift_costs(evidence, e)) for e in paper.experiments if centred(e)]
    return tuple(_centre_bias(each, costs, _company(each)) for each, costs in found if costs)


def users_bias(
    experiment: Experiment,
    evidence: Evidence,
    searches: Mapping[str, Any],
    *,
    against: Sequence[str] = (),
) -> CentreBias | None:
    """Return what shifts do to a user's searches and to whatever else was run at every shift.

    `against` are the others that are wanted, all where it is empty. All have as many runs as the
    one with the fewest. None where no search was.
    """
    if not centred(experiment):
        return None
    own = replace(
        experiment,
        algorithms={
            **searches,
            **{n: o for n, o in experiment.algorithms.items() if not against or n in against},
        },
        proposed=next(iter(searches)),
    )
    found = {name: costs for name in _company(own) if (costs := shift_costs(evidence, own, [name]))}
    if not found.keys() & searches.keys():
        return None
    runs = min(values.shape[1] for costs in found.values() for values in costs.values())
    kept = {name: own.algorithms[name] for name in own.algorithms if name in found}
    proposed = next(name for name in searches if name in found)
    costs = {cell: values[:1, :runs] for each in found.values() for cell, values in each.items()}
    return _centre_bias(replace(own, algorithms=kept, proposed=proposed), costs, tuple(found))


def _company(experiment: Experiment) -> tuple[str, ...]:
    return (*experiment.algorithms, CONTROL, FLOOR)


def _centre_bias(experiment: Experiment, costs: Costs, names: tuple[str, ...]) -> CentreBias:
    problems = centred(experiment)
    minima = {problem: experiment.problems[problem].minimum for problem in problems}
    return CentreBias(
        experiment=experiment,
        algorithms=names,
        problems=problems,
        left_out=tuple(name for name in experiment.problems if name not in problems),
        runs=next(iter(costs.values())).size,
        biases=tuple(biases(costs, minima, names)),
        ranks=tuple(standings(costs, problems, tuple(experiment.algorithms))),
    )


def shift_costs(evidence: Evidence, experiment: Experiment, names: Sequence[str] = ()) -> Costs:
    """Return final costs by (shift, problem, algorithm), the same repeats of each; or nothing.

    `names` are all where none is given. In place, the paper's algorithms have the runs of the
    protocol, of which the first repeats count that the shifted ones have too. Nothing is returned
    unless all of them are there.
    """
    costs = {}
    for share in (IN_PLACE, *SHARES):
        aside = study_name(experiment.name, shift_name(share))
        for problem in centred(experiment):
            for name in names or _company(experiment):
                own = share == IN_PLACE and name in experiment.algorithms
                runs = evidence.runs.get((experiment.name if own else aside, problem, name))
                if runs is None:
                    return {}
                costs[share, problem, name] = runs.costs
    repeats = min(len(values) for values in costs.values())
    return {cell: values[:repeats] for cell, values in costs.items()}


def shifts_of(costs: Costs) -> tuple[float, ...]:
    """Return the sizes of shift that were run, the smallest first, 0 aside."""
    return tuple(sorted({shift for shift, _, _ in costs} - {0.0}))


def biases(costs: Costs, minima: Mapping[str, float], algorithms: Sequence[str]) -> list[Bias]:
    """Return the bias of each algorithm at each shift, algorithm by algorithm.

    `minima` holds the true minimum of each problem that counts. The test pairs each run with that
    of the same seed in place, all problems together, by the logarithm of the ratio of their errors;
    Holm's correction is over all algorithms and shifts.
    """
    tested = [
        (name, shift, {p: _pairs(costs, p, name, shift, minima[p]) for p in minima})
        for name in algorithms
        for shift in shifts_of(costs)
    ]
    p_values = holm(np.array([signed_rank_p(_differences(pairs)) for _, _, pairs in tested]))
    return [
        _bias(name, shift, pairs, float(p))
        for (name, shift, pairs), p in zip(tested, p_values, strict=True)
    ]


def standings(
    costs: Costs, problems: Sequence[str], algorithms: Sequence[str]
) -> list[RanksAtShift]:
    """Return the mean ranks of the algorithms in place and at each shift, ties sharing theirs.

    They are ranked by the mean cost itself, as papers rank them, however small it is.
    """
    from scipy.stats import rankdata  # noqa: PLC0415 (slow to load)

    found = []
    for shift in (0.0, *shifts_of(costs)):
        means = [[mean(costs[shift, p, name].ravel()) for name in algorithms] for p in problems]
        ranks = rankdata(means, axis=1).mean(axis=0)
        found.append(
            RanksAtShift(shift=shift, ranks=dict(zip(algorithms, ranks.tolist(), strict=True)))
        )
    return found


def _pairs(costs: Costs, problem: str, algorithm: str, shift: float, minimum: float) -> Vector:
    """Return errors in place and shifted, paired by seed, shape (2, runs)."""
    values = [costs[size, problem, algorithm].ravel() for size in (0.0, shift)]
    return np.maximum(np.array(values) - minimum, SOLVED)


def _differences(pairs: Mapping[str, Vector]) -> Vector:
    return np.concatenate(
        [np.log10(shifted) - np.log10(plain) for plain, shifted in pairs.values()]
    )


def _bias(algorithm: str, shift: float, pairs: Mapping[str, Vector], p: float) -> Bias:
    ratios = {
        problem: float(np.divide(*errors[::-1].mean(axis=1))) for problem, errors in pairs.items()
    }
    rng = generator("centre bias", algorithm, shift)
    logs = []
    for errors in pairs.values():
        runs = errors.shape[1]
        picked = errors[:, rng.integers(0, runs, size=(RESAMPLES, runs))].mean(axis=-1)
        logs.append(np.log10(picked[1]) - np.log10(picked[0]))
    low, high = quantile_interval(np.mean(logs, axis=0), LEVEL)
    return Bias(
        algorithm=algorithm,
        shift=shift,
        ratios=ratios,
        ratio=float(10 ** np.mean(np.log10(list(ratios.values())))),
        interval=(10**low, 10**high),
        p=p,
    )
