"""Experiments with their optima moved off the centre of the box, made from a paper's own.

A method that draws its points together in the middle of the box, or at the origin, finds an
optimum that lies there without searching for it. J. Kudela runs such methods again on functions
moved by 10 % of the range: A critical problem in benchmarking and analysis of evolutionary
computation methods, Nature Machine Intelligence 4 (2022) 1238-1245, doi:10.1038/s42256-022-00579-0,
and The evolutionary computation methods no one should use, arXiv:2301.01984 (2023).
"""

from dataclasses import replace
from typing import Any

import numpy as np

from repro.errors import InputError
from repro.functions import BenchmarkProblem
from repro.functions.shifted import ShiftedProblem
from repro.model.experiment import Experiment
from repro.optimisers import DE, Optimiser

KUDELA = 0.2  # of the half width: 10 % of the range
SHARES = (KUDELA / 2, KUDELA, 2 * KUDELA)
"""Sizes of shift in half widths of the box: the published one, half of it and twice it.

The published one makes the ratios comparable; the other two show whether what is found hangs on the
size. With the largest every optimum still lies in the middle half of the box, away from its edges.
"""
IN_PLACE = 0.0
CENTRED = 0.05  # a half width's share: how near the centre an optimum is that a bias can find
CONTROL = "DE (control)"
FLOOR = "random search (floor)"


def centred(experiment: Experiment) -> tuple[str, ...]:
    """Return the problems that are benchmark functions with their optimum about the centre.

    An optimum that the paper's own problem has elsewhere already gives a biased method nothing.
    """
    return tuple(name for name, problem in experiment.problems.items() if _is_centred(problem))


def shifted(experiment: Experiment, share: float, *, floor: Optimiser) -> Experiment:
    """Return the experiment on functions moved by `share` half widths, with the same seeds.

    It keeps the problems that are `centred`, and adds to the algorithms differential evolution
    as a control that has no bias, and `floor`, a random search. With `IN_PLACE` it holds these two
    alone, since the paper's algorithms have their runs there. InputError where no problem is left.
    """
    names = centred(experiment)
    if not names:
        message = f"{experiment.name}: no benchmark function with its optimum about the centre"
        raise InputError(message)
    plain = {name: experiment.problems[name] for name in names}
    company: dict[str, Optimiser] = {CONTROL: DE(), FLOOR: floor}
    moved = {name: ShiftedProblem(problem=plain[name], share=share) for name in names}
    in_place = share == IN_PLACE
    return replace(
        experiment,
        problems=plain if in_place else moved,
        algorithms=company if in_place else {**experiment.algorithms, **company},
        drawn_as=experiment.name,
    )


def shift_name(share: float) -> str:
    """Return what an experiment with this shift departs in."""
    return f"shift {share:g}"


def _is_centred(problem: Any) -> bool:  # noqa: ANN401 (any problem)
    if not isinstance(problem, BenchmarkProblem):
        return False
    low, high = problem.bounds.T
    off = np.abs(problem.function.minimiser(problem.dimension) - (low + high) / 2)
    return bool((off <= CENTRED * (high - low) / 2).all())
