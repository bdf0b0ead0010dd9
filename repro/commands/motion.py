"""`repro motion FILE.toml…`: the proved minimum of motions of one's own."""

import sys
import time
from argparse import Namespace
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from repro.commands.motion_files import MotionFile, read_motion
from repro.commands.motion_progress import telling
from repro.commands.shown_rows import show_json, warn
from repro.commands.streams import one_line
from repro.errors import InputError
from repro.judge.outside_planners import OutsideReference, not_asked, references_of
from repro.judge.own_motion import OwnResult, certified, losses, outside_range
from repro.report.own_motion import csv_text, page, row
from repro.robotics import DirectedSpline, MinimumTime, MinimumTimeSpline
from repro.robotics.polynomial_motion import PolynomialMotion
from repro.robotics.proofs.proved import FREE
from repro.robotics.proofs.watch import Watch
from repro.runs.whole_files import write_named

PRINTED = "-"  # as the name of a file: to the standard output
SHARE = 0.25  # of the time allowed, that what limits cost may take besides


def run(options: Namespace) -> int:
    """Print what is proved of each file; what cannot be read is one line and exit code 2."""
    if not 0.0 <= options.seconds < float("inf"):
        message = f"--seconds {options.seconds}: it is 0 or more"
        raise InputError(message)
    for name in ("csv", "html"):
        if getattr(options, name) and len(options.files) > 1:
            given = ", ".join(options.files)
            message = f"--{name} takes one motion, not {len(options.files)}: {given}"
            raise InputError(message)
    printed = [name for name in ("csv", "html") if str(getattr(options, name)) == PRINTED]
    if len(printed) + bool(options.json) > 1:
        message = "--json, --csv - and --html - are all printed: keep one of them"
        raise InputError(message)
    found, refused = [], 0
    for name in options.files:
        try:
            found.append(result(read_motion(Path(name)), options.seconds))
        except InputError as error:
            refused = error.exit_code
            warn(str(error))
    if options.json:
        show_json([row(each) for each in found])
    else:
        stream = sys.stderr if printed else sys.stdout
        stream.writelines(f"{one_line(line)}\n" for each in found for line in lines(each))
    for each in found:  # after what is said, which a file that cannot be written must not take away
        _write(options, each)
    return refused


def result(file: MotionFile, seconds: float) -> OwnResult:
    """Return what is proved of a motion within so many seconds, and what stands beside it."""
    with telling(sys.stderr) as tell:
        watch = Watch(clock=time.monotonic, until=time.monotonic() + seconds, tell=tell)
        certificate = outside_range(
            file.problem, file.limits.get("range"), file.units, title=file.title
        ) or certified(file.problem, watch, title=file.title, units=file.units)
    if certificate.box == FREE:
        certificate = replace(certificate, box=None)
    after = Watch(clock=time.monotonic, until=time.monotonic() + SHARE * seconds)
    return OwnResult(
        title=file.title,
        problem=file.problem,
        units=file.units,
        si=file.si,
        names=file.names,
        limits=file.limits,
        chain=file.robot.chain if file.robot else None,
        certificate=certificate,
        losses=losses(file.problem, certificate, after),
        beside=_beside(file),
    )


def _beside(file: MotionFile) -> tuple[OutsideReference, ...]:
    """Return what other planners say of a motion, or why they are not asked."""
    if isinstance(file.problem, MinimumTime | MinimumTimeSpline):
        found = references_of(file.problem, paper="", name=file.title)
        return tuple(
            replace(each, what=each.what.replace("the paper's own", "the motion's own"))
            for each in found
        )
    return not_asked(_kind(file.problem), paper="", name=file.title)


def _kind(problem: PolynomialMotion | DirectedSpline) -> str:
    if isinstance(problem, DirectedSpline) and problem.jerk is not None:
        return "a spline with a jerk limit"
    if isinstance(problem, PolynomialMotion) and any(
        (*(problem.start or ()), *(problem.end or ()))
    ):
        return "a motion that does not rest at its ends"
    limits = (problem.velocity, problem.acceleration, problem.jerk or ())
    if any(low != -high for pairs in limits for low, high in pairs):
        return "limits that differ by direction"
    return "polynomials of so high a degree"


def lines(found: OwnResult) -> Iterator[str]:
    """Yield what is said of a motion, a line each."""
    own = found.certificate
    if own.minimum is not None:
        yield f"{found.title}: minimum {own.minimum:.9g} s, proved to {_share(own.gap)}"
    elif own.attained is not None:
        yield (
            f"{found.title}: no minimum proved; between {own.lower_bound or 0.0:.9g} s and "
            f"{own.attained:.9g} s, {_share(own.gap)} apart"
        )
    elif own.lower_bound is not None:
        yield f"{found.title}: no minimum; what obeys takes {own.lower_bound:.9g} s or more"
    else:
        yield f"{found.title}: no minimum"
    if own.at:
        yield f"  durations: {' + '.join(f'{each:.6g}' for each in own.at)} s"
    if own.box:
        yield f"  each from {own.box[0]:g} to {own.box[1]:g} s"
    yield from (f"  binds: {each}" for each in own.binding)
    yield from (f"  lost to {each.limit}: {each.seconds:.4g} s" for each in found.losses)
    yield from _planners(found.beside)
    if own.explanation:
        yield f"  {own.explanation}"
    yield f"  proof: {own.method}"


def _share(gap: float | None) -> str:
    return f"{100.0 * (gap or 0.0):.2g} %"


def _planners(beside: Sequence[OutsideReference]) -> Iterator[str]:
    for each in beside:
        what = each.what[:1].lower() + each.what[1:].removesuffix(", in s")
        shown = f"skipped, {each.skipped}" if each.time is None else f"{each.time:.6g} s, {what}"
        yield f"  {each.planner}: {shown}"


def _write(options: Namespace, found: OwnResult) -> None:
    if options.csv:
        if not found.certificate.at:
            warn(f"{options.csv}: not written, as no motion is known that obeys")
        else:
            _to(options.csv, csv_text(found))
    if options.html:
        _to(options.html, page(found, says=[line.strip() for line in lines(found)]))


def _to(path: Path, text: str) -> None:
    if str(path) == PRINTED:
        sys.stdout.write(text)
        return
    write_named(path, text)
