"""What the pages say of the algorithms when the optimum leaves the centre of the box."""

from dataclasses import dataclass

from repro.judge.centre_bias import Bias, CentreBias
from repro.model.identifiers import anchor
from repro.report.drawings.centre_bias import bias_plot
from repro.report.drawings.draw import Drawing, drawing
from repro.report.words import number
from repro.runs.moved_optima import shift_name

FLAGGED = "biased"


@dataclass(frozen=True, slots=True, kw_only=True)
class CentreBiasView:
    """What shifts of one experiment's functions do to its algorithms.

    `rows` holds algorithm and, for each of the `headings`, one text on its ratio; `ranks` holds
    algorithm and its mean rank in place and at each shift; `place` says where the proposed
    algorithm stands.
    """

    found: CentreBias
    headings: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    ranks: tuple[tuple[str, ...], ...]
    place: str
    drawing: Drawing


def centre_bias_view(paper: str, found: CentreBias) -> CentreBiasView:
    """Return what is shown of one experiment."""
    shifts = dict.fromkeys(bias.shift for bias in found.biases)
    return CentreBiasView(
        found=found,
        headings=tuple(map(shift_name, shifts)),
        rows=tuple(
            (name, *(_words(b) for b in found.biases if b.algorithm == name))
            for name in found.algorithms
        ),
        ranks=tuple(
            (name, *(f"{each.ranks[name]:.2f}" for each in found.ranks))
            for name in found.experiment.algorithms
        ),
        place=_places(found),
        drawing=drawing(
            lambda: bias_plot(found.algorithms, found.biases),
            title=f"Error when the optimum leaves the centre, {found.experiment.name}",
            identifier=anchor(paper, "bias", found.experiment.name),
        ),
    )


def _words(bias: Bias) -> str:
    low, high = (number(end, 3) for end in bias.interval)
    flag = f", {FLAGGED}" if bias.flagged else ""
    return f"{number(bias.ratio, 3)} [{low}, {high}], p = {number(bias.p, 2)}{flag}"


def _places(found: CentreBias) -> str:
    """Return the places of the proposed algorithm as a sentence."""
    name, algorithms = found.experiment.proposed, len(found.experiment.algorithms)
    problems = len(found.problems)
    if algorithms < 2:
        return ""
    if not found.experiment.runs_proposed:
        return f"{name} is not re-run: {found.experiment.left_out[name].because}."
    places = [
        f"{each.place(name)} of {algorithms} "
        + (f"with shift {each.shift:g}" if each.shift else "in place")
        for each in found.ranks
    ]
    over = f"{problems} problem{'s' * (problems > 1)}"
    return f"{name} stands {', '.join(places)} by mean rank over {over}."
