"""What no declaration may say of experiments and claims: a line a fault, all in one pass."""

import dataclasses
import math
from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np

from repro.errors import ReproError
from repro.model.claims import CellClaim, Claim
from repro.model.experiment import Experiment
from repro.model.known_words import known_words, shown_value
from repro.model.measures.measure import Statistic
from repro.model.open_points import Gap
from repro.optimisers.search import (
    DeclaresSpending,
    TellsQuantities,
    every_agent_once,
    hands_to_search,
)
from repro.statistics.named import KNOWN, is_known

_COUNTS = ("population", "iterations", "runs")
_DEPTH = 8  # measures of measures
_MANY = 2**20  # agents: enough for any search


class _Point:
    """A problem without any coordinate, which nothing can search."""

    bounds = data = np.empty(0)
    kernel = None
    identity = ()


def text_faults(place: str, of: object, names: Iterable[str]) -> Iterator[str]:
    """Yield the texts that are none, or empty."""
    for name in names:
        value = getattr(of, name)
        if not isinstance(value, str) or not value.strip():
            yield f"{place}, {name} is {shown_value(value)}; it must be a text"


def experiment_faults(experiment: Experiment) -> Iterator[str]:
    """Yield what is wrong with an experiment by itself."""
    name = f"experiment {experiment.name!r}"
    for count in _COUNTS:
        yield from _count_faults(f"{name}, {count}", getattr(experiment, count))
    if experiment.evaluations is not None:
        yield from _count_faults(f"{name}, evaluations", experiment.evaluations)
    for algorithm, gap in experiment.left_out.items():
        if not isinstance(gap, Gap):
            yield f"{name}, left_out {algorithm!r}: {shown_value(gap)} is no Gap"
        if algorithm in experiment.algorithms:
            yield f"{name}, left_out: {algorithm!r} is one of its algorithms, too"
    for problem, subject in experiment.problems.items():
        yield from _problem_faults(f"{name}, problem {problem!r}", subject)
    if not [count for count in _COUNTS if _is_no_count(getattr(experiment, count))]:
        yield from _budget_faults(name, experiment)


def protocol_faults(experiment: Experiment) -> Iterator[str]:
    """Yield what is wrong with an experiment as the protocol of a paper: it must run something."""
    name = f"experiment {experiment.name!r}"
    for kind in ("problems", "algorithms"):
        if not getattr(experiment, kind):
            yield f"{name} has no {kind}: leave out an experiment that runs nothing"
    known = {**experiment.algorithms, **experiment.left_out}
    if experiment.algorithms and experiment.proposed not in known:
        words = known_words(experiment.proposed, known)
        yield f"{name}, proposed: {experiment.proposed!r} is no algorithm of it; {words}"


def claim_faults(claim: Claim, experiments: Iterable[Experiment]) -> Iterator[str]:
    """Yield what is wrong with a claim: what it measures, where, and what it accepts."""
    place = claim.where if isinstance(claim, CellClaim) else claim.claim
    where = (
        f"{claim.table.label}, {claim.row}, {claim.column}"
        if isinstance(claim, CellClaim)
        else place
    )
    if claim.measure is None and claim.gap is None:
        yield f"{where}: it needs a measure, or a gap that says why nothing is measured"
    yield from _tolerance_faults(where, claim)
    if claim.measure is None or claim.gap is not None:
        return
    runs = {experiment.name: experiment for experiment in experiments}
    faults = list(dict.fromkeys(_cell_faults(where, claim.measure.cells(), runs)))
    yield from faults
    if not faults:
        for statistic in _statistics(claim.measure):
            yield from _statistic_faults(where, statistic, runs)


def _count_faults(place: str, value: object) -> Iterator[str]:
    if _is_no_count(value):
        yield f"{place} is {value!r}; it must be a whole number, 1 or more"


def _is_no_count(value: object) -> bool:
    is_whole = isinstance(value, (int, np.integer)) and not isinstance(value, bool)
    return not (is_whole and value >= 1)  # type: ignore[operator]


def _problem_faults(place: str, problem: Any) -> Iterator[str]:  # noqa: ANN401 (any problem)
    lacking = [part for part in ("bounds", "kernel", "data") if not _has(problem, part)]
    if isinstance(problem, type) or lacking:
        kind = "a class: give an object of it" if isinstance(problem, type) else repr(problem)[:60]
        yield f"{place} is {kind}; a problem has bounds, kernel, data and identity"
        return
    try:
        bounds = np.asarray(problem.bounds, dtype=np.float64)
    except (TypeError, ValueError):
        bounds = np.empty(0)
    if bounds.ndim != 2 or bounds.shape[1] != 2 or not len(bounds):
        yield f"{place}: its bounds are {problem.bounds!r:.80}, not pairs of shape (n, 2)"
    elif not (np.isfinite(bounds).all() and (bounds[:, 0] <= bounds[:, 1]).all()):
        yield f"{place}: its bounds {bounds.tolist()!r:.80} are not finite pairs lower <= upper"


def _has(problem: object, part: str) -> bool:
    try:
        return hasattr(problem, part)
    except ReproError:
        return False


def _budget_faults(name: str, experiment: Experiment) -> Iterator[str]:
    """Yield what each search cannot work with, as it says itself."""
    population, evaluations = experiment.population, experiment.evaluations
    for algorithm, optimiser in experiment.algorithms.items():
        if refused := _refused_population(optimiser, population):
            yield f"{name}, algorithm {algorithm!r}: {refused}"
        elif evaluations is not None and not _is_no_count(evaluations):
            own = isinstance(optimiser, DeclaresSpending)
            cost = optimiser.spending(population) if own else every_agent_once(population)
            if evaluations < cost.start + cost.each:
                yield (
                    f"{name}, evaluations is {evaluations}; one iteration of {algorithm!r} takes "
                    f"{cost.start + cost.each}"
                )


def _refused_population(optimiser: Any, population: int) -> str:  # noqa: ANN401 (any search)
    """Return why a search refuses a population; nothing where it does not, or cannot be asked.

    It is asked without any budget, so that it never runs, and of a great population besides: what
    it says of that is of the budget.
    """
    if not hands_to_search(optimiser):
        return ""
    own, of_many = (_refusal(optimiser, each) for each in (population, _MANY))
    return "" if own == of_many else own


def _refusal(optimiser: Any, population: int) -> str:  # noqa: ANN401 (any search)
    try:
        optimiser.minimise(_Point(), population=population, rng=np.random.default_rng(0))
    except ReproError as error:
        return str(error)
    except Exception:  # noqa: BLE001 (a search of one's own, which may look at its budget first)
        return ""
    return ""


def _tolerance_faults(where: str, claim: Claim) -> Iterator[str]:
    band = getattr(claim.accepted, "band", None)
    if not callable(band):
        yield f"{where}: {claim.accepted!r:.60} is no tolerance, such as Percent(10)"
        return
    low, high = band(claim.printed)
    if math.isnan(low) or math.isnan(high) or low > high:
        yield f"{where}: nothing lies in the accepted band from {low:g} to {high:g}"


def _cell_faults(
    where: str, cells: Iterable[tuple[str, str, str]], runs: dict[str, Experiment]
) -> Iterator[str]:
    for name, problem, algorithm in cells:
        experiment = runs.get(name)
        if experiment is None:
            yield f"{where}: no experiment {name!r}; {known_words(name, runs)}"
            continue
        if problem not in experiment.problems:
            known = known_words(problem, experiment.problems)
            yield f"{where}: experiment {name!r} has no problem {problem!r}; {known}"
        if algorithm in experiment.left_out:
            yield (
                f"{where}: {algorithm!r} of experiment {name!r} is left out, so nothing is "
                "measured of it: leave this to its gap"
            )
        elif algorithm not in experiment.algorithms:
            known = known_words(algorithm, experiment.algorithms)
            yield f"{where}: experiment {name!r} has no algorithm {algorithm!r}; {known}"


def _statistics(measure: object, depth: int = 0) -> Iterator[Statistic]:
    """Yield the statistics that a measure is made of."""
    if isinstance(measure, Statistic):
        yield measure
    elif isinstance(measure, (tuple, list)):
        for part in measure:
            yield from _statistics(part, depth)
    elif dataclasses.is_dataclass(measure) and depth < _DEPTH:
        for field in dataclasses.fields(measure):
            yield from _statistics(getattr(measure, field.name), depth + 1)


def _statistic_faults(
    where: str, statistic: Statistic, runs: dict[str, Experiment]
) -> Iterator[str]:
    if not is_known(statistic.statistic):
        known = known_words(statistic.statistic, KNOWN)
        yield f"{where}: no statistic {statistic.statistic!r}; {known}"
    quantity = statistic.quantity
    problem = runs[statistic.experiment].problems[statistic.problem]
    if quantity == "cost" or statistic.follows:
        return
    if not isinstance(problem, TellsQuantities):
        yield f"{where}: problem {statistic.problem!r} has no quantity {quantity!r}, only the cost"
        return
    try:
        problem.quantity(quantity, np.asarray(problem.bounds, dtype=np.float64).mean(axis=1))  # type: ignore[attr-defined]
    except ReproError as error:
        yield f"{where}: {' '.join(str(error).split())}"
