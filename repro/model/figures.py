"""Figures of a paper that get a counterpart, as data; the report draws them."""

from dataclasses import dataclass

from repro.errors import DeclarationError
from repro.model.named_robot import NamedRobot
from repro.robotics import Convention, MinimumTime, MinimumTimeSpline, PathFitting
from repro.robotics.kinematics import DHRow
from repro.robotics.shown_motion import Moving, ShowsMotion
from repro.tables.published import PublishedTable


@dataclass(frozen=True, slots=True, kw_only=True)
class Convergence:
    """Best cost against iterations of every algorithm of an experiment, one panel per problem."""

    label: str
    caption: str
    experiment: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Motion:
    """Angle, velocity and acceleration of every joint over time.

    `durations` in s are fixed ones; where None, those that `algorithms` reach on average. A problem
    of one's own is drawn, too, where it is a `ShowsMotion`: `durations` are then a point of it, and
    of each algorithm the best run of the first repeat is shown.
    """

    label: str
    caption: str
    problem: Moving
    durations: tuple[float, ...] | None = None
    experiment: str = ""
    algorithms: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class ToolPath:
    """Path of the last frame in space, with the waypoints.

    Of a `ShowsMotion` the path of one point is drawn, which `durations` must give.
    """

    label: str
    caption: str
    problem: Moving
    dh: tuple[DHRow, ...]
    convention: Convention
    printed_waypoints: tuple[tuple[float, ...], ...]
    durations: tuple[float, ...] | None = None

    def __post_init__(self) -> None:
        """Raise DeclarationError where no point of a problem of one's own is given."""
        _check_point(self.label, self.problem, self.durations)


@dataclass(frozen=True, slots=True, kw_only=True)
class JointCurves:
    """Angle, velocity and acceleration of every joint over time, along polynomial paths.

    `paths` holds one fit per joint, whose desired paths are drawn; before them what each of the
    `algorithms` found in `experiment`, which has these fits among its problems.
    """

    label: str
    caption: str
    paths: tuple[PathFitting, ...]
    experiment: str = ""
    algorithms: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class SplineMotion:
    """Some derivatives of some joints' angles over time, along a B-spline in time and angle.

    Drawn with `durations` in s, with those of the shortest motion that each of `algorithms` finds
    in the first repeat of `experiment`, and with those of the proved optimum. Joints count from 1;
    derivative 0 is the angle, 3 the jerk.
    """

    label: str
    caption: str
    problem: MinimumTimeSpline
    durations: tuple[float, ...]
    experiment: str
    algorithms: tuple[str, ...]
    joints: tuple[int, ...]
    derivatives: tuple[int, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class ArmMotion:
    """One motion that an arm is shown making.

    `problem` says through which angles it goes: path fits, one per joint, mean their desired paths.
    `durations` of the segments are in s, those of the proved optimum where None; path fits have
    a duration of their own. Of a `ShowsMotion` they are the point to show, which must be given.
    """

    name: str
    problem: MinimumTime | MinimumTimeSpline | ShowsMotion | tuple[PathFitting, ...]
    durations: tuple[float, ...] | None = None

    def __post_init__(self) -> None:
        """Raise DeclarationError where no motion is said of a problem that has no proved one."""
        _check_point(f"motion {self.name!r}", self.problem, self.durations)


@dataclass(frozen=True, slots=True, kw_only=True)
class Arm:
    """The robot itself in space, moving along two or more motions on one clock.

    The first motion is drawn solid, the second as its ghost. `assumed` names those of the paper's
    assumptions (by their `what`) that the picture rests on. `table` is the printed one that the
    links are of, None where the paper prints none; `robot` the machine that the paper names, with
    which links, limits and ranges are compared; `limits_at` says where the limits are printed.
    """

    label: str
    caption: str
    dh: tuple[DHRow, ...]
    convention: Convention
    motions: tuple[ArmMotion, ...]
    assumed: tuple[str, ...] = ()
    table: PublishedTable | None = None
    robot: NamedRobot | None = None
    limits_at: str = ""

    def __post_init__(self) -> None:
        """Raise DeclarationError for a robot that has another number of joints than the links."""
        if self.robot is not None and not isinstance(self.robot, NamedRobot):
            message = f"{self.label}: robot is {self.robot!r:.60}, which is no NamedRobot"
            raise DeclarationError(message)
        if self.robot is not None and self.robot.joints != len(self.dh):
            message = (
                f"{self.label}: robot {self.robot.name!r} has {self.robot.joints} joints, the "
                f"links {len(self.dh)}"
            )
            raise DeclarationError(message)


def _check_point(place: str, problem: object, durations: tuple[float, ...] | None) -> None:
    if isinstance(problem, ShowsMotion) and durations is None:
        message = f"{place}: a problem of one's own needs a point in `durations`"
        raise DeclarationError(message)


Figure = Arm | Convergence | JointCurves | Motion | SplineMotion | ToolPath
