"""The figures of a comparison: convergence, targets reached, average ranks, centre bias."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

import numpy as np

from repro.judge.comparison import Comparison, Part
from repro.model.evidence import Evidence
from repro.model.figures import Convergence
from repro.model.identifiers import anchor
from repro.report.drawings.draw import Drawing, draw, drawing
from repro.report.drawings.ecdf import ecdf_plot
from repro.report.drawings.ranks import rank_plot
from repro.report.frames import DIGITS, csv_text
from repro.report.views.centre_bias import CentreBiasView, centre_bias_view
from repro.runs.baseline_study import STUDY_OF
from repro.runs.equal_budget import EQUAL_BUDGET
from repro.runs.studies import study_name
from repro.statistics.friedman import Friedman, friedman

MOST_PANELS = 24  # of a drawing of curves: more are no longer looked at


@dataclass(frozen=True, slots=True, kw_only=True)
class Pictured:
    """The figures of one experiment: each with the name of its files, and the view of a bias."""

    drawings: Mapping[str, Drawing]
    bias: CentreBiasView | None
    bias_name: str


def pictured(found: Comparison) -> dict[tuple[str, str], Pictured]:
    """Return the figures of each experiment, by paper and experiment."""
    return {
        (part.paper.key, part.experiment.name): _pictured(part, k, found)
        for k, part in enumerate(found.parts)
    }


def figure_files(pictures: Mapping[tuple[str, str], Pictured]) -> Iterator[tuple[str, str]]:
    """Yield the name and the text of each figure's picture and of its data."""
    for each in pictures.values():
        drawings = dict(each.drawings)
        if each.bias:
            drawings[each.bias_name] = each.bias.drawing
        for name, drawn in drawings.items():
            # by itself a picture has no page to take its ground from
            alone = drawn.svg.replace('style="', 'style="background: #ffffff; ', 1)
            yield f"{name}.svg", f"{alone}\n"
            yield f"{name}.csv", csv_text(drawn.frame, DIGITS)


def _pictured(part: Part, number: int, found: Comparison) -> Pictured:
    place = f"{number + 1}-{anchor(part.paper.key, part.experiment.name)}"
    drawings = dict(_drawn(part, place, found))
    bias = part.bias and centre_bias_view(f"c{number}", part.bias)
    return Pictured(drawings=drawings, bias=bias or None, bias_name=f"{place}-centre-bias")


def _drawn(part: Part, place: str, found: Comparison) -> Iterator[tuple[str, Drawing]]:
    """Yield convergence, targets reached, and average ranks, as far as there are runs."""
    evidence = shown(part, found)
    (experiment,) = evidence.experiments
    name = experiment.name
    if not evidence.runs:
        return
    figure = Convergence(label=name, caption="median run in the range of its runs", experiment=name)
    yield f"{place}-convergence", draw(figure, evidence, f"c{place}v")
    yield f"{place}-targets", drawing(
        lambda: ecdf_plot(experiment, evidence), title=f"{name}: share of targets reached",
        identifier=f"c{place}e",
    )  # fmt: skip
    names, ranks = average_ranks(evidence, part)
    if ranks:
        yield f"{place}-ranks", drawing(
            lambda: rank_plot(names, ranks, {}), title=f"{name}: average ranks",
            identifier=f"c{place}r",
        )  # fmt: skip


def shown(part: Part, found: Comparison) -> Evidence:
    """Return the runs that stand beside each other, as of one experiment: searches of all kinds.

    Names are those of the standings; the first of the user's own is drawn as the proposed one.
    """
    standings = part.found.standings
    places = {(row.algorithm, row.kind): None for p in standings.problems for row in p.rows}
    names = {place: _shown_name(*place) for place in places}
    runs = {
        (part.experiment.name, problem, name): part.evidence.runs[cell]
        for place, name in names.items()
        for problem in list(part.experiment.problems)[:MOST_PANELS]
        if (cell := (_study(part, *place), problem, place[0])) in part.evidence.runs
    }
    first = next(iter(found.asked.searches))
    own = next(iter(found.asked.searches.values()))
    known = {name: part.experiment.algorithms.get(place[0], own) for place, name in names.items()}
    problems = dict(list(part.experiment.problems.items())[:MOST_PANELS])
    experiment = replace(
        part.experiment, algorithms={first: own, **known}, proposed=first, problems=problems
    )
    return Evidence(part.paper.key, (experiment,), runs)


def _study(part: Part, algorithm: str, kind: str) -> str:
    """Return the name of the experiment that a standing's runs are of."""
    departs = {"equal evaluations": EQUAL_BUDGET, "baseline": STUDY_OF.get(algorithm)}.get(kind)
    return study_name(part.experiment.name, departs) if departs else part.experiment.name


def _shown_name(algorithm: str, kind: str) -> str:
    return f"{algorithm}, {kind}" if kind == "equal evaluations" else algorithm


def average_ranks(evidence: Evidence, part: Part) -> tuple[tuple[str, ...], Friedman | None]:
    """Return who was run on every problem at equal budgets, and Friedman's test of them if any."""
    (experiment,) = evidence.experiments
    fair = {
        _shown_name(row.algorithm, row.kind)
        for problem in part.found.standings.problems
        for row in problem.rows
        if row.rank is not None
    }
    names = tuple(
        name for name in experiment.algorithms
        if name in fair
        and all((experiment.name, p, name) in evidence.runs for p in experiment.problems)
    )  # fmt: skip
    if len(names) < 3 or len(experiment.problems) < 2:
        return names, None
    means = [
        [float(evidence.runs[experiment.name, p, name].costs[0].mean()) for name in names]
        for p in experiment.problems
    ]
    return names, friedman(np.array(means))
