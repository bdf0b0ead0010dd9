"""Mousa et al.: what is re-run: six coefficients per joint fitted to a path, by WOA and by GA."""

from collections.abc import Mapping
from dataclasses import replace

from papers.mousa2023.printed import CROSSOVER, MUTATION
from papers.mousa2023.robot import END, START, joint_angles
from repro.model.experiment import Experiment
from repro.optimisers import GA, WOA, Optimiser, SteadyStateGA
from repro.robotics import PathFitting, RestToRestLaw, cubic, quintic, septic

# None of these is printed; each is an Assumption.
DURATION = 2.0  # s
INTERVALS = 100  # M
COEFFICIENT = 50.0  # rad: |a_j| T^j is at most this
SHIFT = 0.01  # rad: a slightly varied start

_CROSSOVER, _MUTATION = CROSSOVER.value / 100, MUTATION.value / 100
AS_TOLD: dict[str, Optimiser] = {
    "WOA": WOA(),
    "GA": SteadyStateGA(crossover=_CROSSOVER, mutation=_MUTATION),  # section III-B
}
ALGORITHMS = {**AS_TOLD, "GA by generations": GA(crossover=_CROSSOVER, mutation=_MUTATION)}
JOINTS = tuple(f"joint {joint}" for joint in range(1, 7))


def paths(law: RestToRestLaw, *, shift: float = 0.0) -> Mapping[str, PathFitting]:
    """Return one fit per joint to the path by `law`, the start moved by `shift` rad."""
    return {
        name: PathFitting(
            start=start + shift,
            end=end,
            law=law,
            duration=DURATION,
            intervals=INTERVALS,
            box=((-COEFFICIENT, COEFFICIENT),) * 6,  # a_0 to a_5, Table III
        )
        for name, start, end in zip(JOINTS, START, END, strict=True)
    }


CUBIC = tuple(paths(cubic).values())
QUINTIC = tuple(paths(quintic).values())
ARM_QUINTIC, ARM_CUBIC = (
    tuple(
        replace(path, start=start, end=end)
        for path, start, end in zip(fits, joint_angles(START), joint_angles(END), strict=True)
    )
    for fits in (QUINTIC, CUBIC)
)
SEPTIC = tuple(paths(septic).values())
SHIFTED = tuple(paths(quintic, shift=SHIFT).values())

FIT = Experiment(
    name="quintic path",
    where="section IV, Tables III and IV",
    proposed="WOA",
    problems=paths(quintic),
    algorithms=ALGORITHMS,
    population=30,
    iterations=500,
    runs=30,
)
_OTHER_PATH = replace(FIT, algorithms=AS_TOLD)
CUBIC_FIT = replace(_OTHER_PATH, name="cubic path", problems=paths(cubic))
SEPTIC_FIT = replace(_OTHER_PATH, name="septic path", problems=paths(septic))
SHIFTED_FIT = replace(_OTHER_PATH, name="shifted start", problems=paths(quintic, shift=SHIFT))
EXPERIMENTS = (FIT, CUBIC_FIT, SEPTIC_FIT, SHIFTED_FIT)
