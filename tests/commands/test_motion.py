"""`repro motion`: what it prints, writes and refuses; and `repro.certify`."""

import csv
import io
import json
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Any, TextIO, cast

import numpy as np
import pytest

import repro
from repro.__main__ import main
from repro.commands.motion_files import read_motion
from repro.commands.motion_progress import telling
from repro.commands.streams import FitForTerminal
from repro.errors import InputError
from repro.robotics import (
    DirectedSpline,
    MinimumTime,
    MinimumTimeSpline,
    PolynomialMotion,
    quintic,
)
from repro.robotics.proofs.proved import FREE

PICK = {
    "title": '"pick and place"',
    "unit": '"deg"',
    "law": '"quintic"',
    "waypoints": "[[0, 0, 10], [90, -45, 30], [45, 10, 0]]",
    "velocity": "180",
    "acceleration": "[300, 300, 600]",
    "jerk": "4000",
}
SPLINE = {"law": '"spline"', "jerk": ""}
TABLE = "[[0, 0.4, 0.025, -90], [0, 0, 0.315, 0], [0, 0, 0.035, -90]]"


def write(folder: Path, name: str = "pick.toml", /, **changed: str) -> Path:
    """Write a motion with some keys changed, or left out where nothing is given."""
    keys = {key: value for key, value in {**PICK, **changed}.items() if value}
    path = folder / name
    path.write_text("".join(f"{key} = {value}\n" for key, value in keys.items()), encoding="utf-8")
    return path


def asked(capsys: pytest.CaptureFixture[str], *arguments: object) -> tuple[int, str, str]:
    code = main(["motion", *map(str, arguments)])
    out, err = capsys.readouterr()
    return code, out, err


def test_minimum_is_printed_with_what_binds_and_what_limits_cost(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code, out, _ = asked(capsys, write(tmp_path))

    assert code == 0
    assert out.startswith("pick and place: minimum 2.34489639 s, proved to ")
    assert "  binds: segment 1: acceleration of joint 1 (limit 300 deg/s²)" in out
    assert "  lost to acceleration of joint 1: 0.2109 s" in out
    assert "  ruckig: " in out
    assert "  toppra: " in out


def test_json_is_a_list_of_one_row_a_file(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    first, second = write(tmp_path), write(tmp_path, "other.toml", title="")
    code, out, _ = asked(capsys, "--json", first, second)
    rows = json.loads(out)

    assert code == 0
    assert [row["problem"] for row in rows] == ["pick and place", "other"]
    assert rows[0]["minimum"] == rows[0]["attained"] == pytest.approx(2.3448964)
    assert rows[0]["box"] is None
    assert {each["planner"] for each in rows[0]["beside"]} == {"ruckig", "toppra"}
    assert [set(each) for each in rows[0]["lost"]] == [{"limit", "seconds"}] * 2


def test_proof_that_is_cut_short_has_no_minimum_and_is_no_failure(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = write(tmp_path, **SPLINE)
    code, out, _ = asked(capsys, "--json", "--seconds", 0, path)
    (row,) = json.loads(out)

    assert code == 0
    assert row["minimum"] is None
    assert 0 < row["lower_bound"] < row["attained"]
    assert "apart" in asked(capsys, "--seconds", 0, path)[1]


def test_polynomial_that_is_cut_short_has_bound_and_motion_and_is_no_failure(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = write(tmp_path, law="11")
    code, out, _ = asked(capsys, "--json", "--seconds", 0, path)
    (row,) = json.loads(out)

    assert code == 0
    assert row["minimum"] is None
    assert 0 < row["lower_bound"] <= row["attained"]
    assert len(row["at"]) == 2
    assert "no minimum proved; between " in asked(capsys, "--seconds", 0, path)[1]


def test_csv_has_the_columns_of_a_trajectory_and_instants_that_increase(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for law in ({}, {"law": '"cubic"'}, SPLINE, {"start_velocity": "[10, 0, 0]"}):
        out = tmp_path / "out.csv"
        assert asked(capsys, write(tmp_path, **law), "--csv", out)[0] == 0
        heading, *lines = csv.reader(out.read_text(encoding="utf-8").splitlines())
        values = np.array(lines, dtype=float)

        assert heading[:2] == ["time_from_start", "positions.joint_1"]
        assert heading[-1] == "accelerations.joint_3"
        assert len(heading) == 10
        assert values[0, 0] == 0
        assert (np.diff(values[:, 0]) > 0).all()
        assert values[-1, 1:4] == pytest.approx(np.radians([45, 10, 0]), abs=1e-9)
        assert np.abs(values[:, 4:7]).max() <= np.radians(180) * (1 + 1e-9)


@pytest.mark.parametrize("option", ["--csv", "--html"])
def test_file_called_dash_is_printed_and_what_is_said_goes_beside_it(
    option: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    path = write(tmp_path)
    code, out, err = asked(capsys, path, option, "-")

    assert code == 0
    assert out.startswith(("time_from_start,", "<!doctype html>", "<!DOCTYPE html>"))
    assert "pick and place: minimum" in err
    assert not (tmp_path / "-").exists()
    assert asked(capsys, path, option, "-", "--json")[0] == 2


def test_page_needs_nothing_else_and_escapes_what_a_file_says(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "out.html"
    path = write(tmp_path, title='"<script>alert(1)</script>"', dh=TABLE)
    assert asked(capsys, path, "--html", out)[0] == 0
    page = out.read_text(encoding="utf-8")

    assert "<script>alert" not in page
    assert not re.search(r"(src|href)=\"https?:", page)
    assert page.count("<svg") == 2
    assert page.count('class="arm-scene"') == 1


def test_page_tells_how_long_the_arm_is_below_its_base_plane(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A crank of 1 m that turns by 360° on a level axis 0 m high is below it for half the time."""
    out = tmp_path / "out.html"
    path = write(tmp_path, waypoints="[[0], [360]]", acceleration="300", dh="[[0, 0, 0, -90]]")
    turned = write(
        tmp_path,
        "two.toml",
        waypoints="[[0, 0], [0, 360]]",
        acceleration="300",
        dh="[[0, 0, 0, 90], [0, 0, 1, 0]]",
    )
    assert asked(capsys, path, "--html", out)[0] == 0
    assert "below the base plane for" not in out.read_text(encoding="utf-8")

    assert asked(capsys, turned, "--html", out)[0] == 0
    told = re.search(
        r"The tool is below the base plane for (\S+) s of (\S+) s, down to -1 m",
        out.read_text(encoding="utf-8"),
    )
    assert told
    assert float(told[1]) == pytest.approx(float(told[2]) / 2, rel=1e-2)


@pytest.mark.parametrize(("scale", "shown"), [("1e-6", "in 5 s"), ("1e6", "in 5 s"), ("1", None)])
def test_page_plays_a_motion_of_any_length(
    scale: str, shown: str | None, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "out.html"
    limit = str(300 / float(scale) ** 2)
    path = write(tmp_path, acceleration=limit, velocity="1e20", jerk="", dh=TABLE)
    assert asked(capsys, path, "--html", out)[0] == 0
    page = out.read_text(encoding="utf-8")
    found = re.search(r'<script type="application/json" class="arm-scene">(.*?)</script>', page)
    assert found
    times = json.loads(found[1])["motions"][0]["times"]

    assert (np.diff(times) > 0).all()
    assert (shown or "as planned") in re.findall(r"selected>(.*?)<", page)


def test_titles_are_one_line_and_never_empty(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert asked(capsys, write(tmp_path, title='" "'))[1].startswith("pick: minimum")
    assert asked(capsys, write(tmp_path, title='"a\\nb"'))[1].startswith("a b: minimum")


def test_page_of_what_nothing_obeys_says_so(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    page, samples = tmp_path / "out.html", tmp_path / "out.csv"
    path = write(tmp_path, durations="[0.1, 1]")
    code, out, err = asked(capsys, path, "--html", page, "--csv", samples)

    assert code == 0
    assert "No durations from 0.1 to 1 s obey" in out
    assert "No durations from 0.1 to 1 s obey" in page.read_text(encoding="utf-8")
    assert "not written" in err
    assert not samples.exists()


def test_row_of_a_spline_that_nothing_obeys_says_what_it_takes_whatever_the_durations(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    free = repro.certify(write(tmp_path, **SPLINE))
    code, out, _ = asked(capsys, write(tmp_path, **SPLINE, durations="[0.1, 0.6]"))

    assert code == 0
    assert "No durations from 0.1 to 0.6 s obey" in out
    said = re.search(
        r"Whatever the durations, a motion that obeys takes (\S+) s or more; "
        r"with (\S+) \+ (\S+) s one",
        out,
    )
    assert said
    least, *durations = map(float, said.groups())
    assert least == pytest.approx(free.lower_bound, rel=1e-5)
    assert durations == pytest.approx(free.at, rel=1e-5)


@pytest.mark.parametrize(
    ("changed", "kind"),
    [
        ({"law": '"spline"'}, "a spline with a jerk limit"),
        (
            {**SPLINE, "velocity": "[[-90, 180], [-9, 9], [-9, 9]]"},
            "limits that differ by direction",
        ),
        ({"jerk": "[[-90, 180], [-9, 9], [-9, 9]]"}, "limits that differ by direction"),
        ({"end_velocity": "[0, 1, 0]"}, "a motion that does not rest at its ends"),
        ({"law": "11"}, "polynomials of so high a degree"),
    ],
)
def test_row_says_of_what_no_other_planner_is_asked(
    changed: dict[str, str], kind: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    _, out, _ = asked(capsys, write(tmp_path, **changed), "--seconds", 0)

    assert [f"  {planner}: skipped, not asked of {kind}" for planner in ("ruckig", "toppra")] == [
        line for line in out.splitlines() if "skipped" in line
    ]


@pytest.mark.parametrize("changed", [SPLINE, {}])
def test_words_beside_a_motion_of_ones_own_speak_of_no_paper(
    changed: dict[str, str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    _, out, _ = asked(capsys, write(tmp_path, **changed), "--seconds", 0)

    assert "toppra: " in out
    assert "paper" not in out


def test_free_durations_that_nothing_obeys_are_no_box_and_the_segment_at_fault_alone_binds(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = write(
        tmp_path, start_velocity="[-90, 0, 0]", range="[[-0.001, 99], [-99, 99], [-99, 99]]"
    )
    code, out, _ = asked(capsys, path)

    assert code == 0
    assert "  No durations obey: segment 1 (range of joint 1 (limit -0.001 deg))." in out
    assert re.findall(r"binds: (segment \d)", out) == ["segment 1"]


@pytest.mark.parametrize(
    ("changed", "fault"),
    [
        ({"velocty": "3"}, "unknown key 'velocty', 'velocity' perhaps; known are title, unit"),
        ({"unit": ""}, "unit is missing: it is one of deg, rad"),
        ({"unit": '"degree"'}, "unit: 'degree' is not one of deg, rad"),
        ({"law": ""}, "law is missing: cubic, quintic, septic"),
        ({"law": "4"}, "law: 4 is not cubic"),
        ({"law": "1"}, "law: 1 is not cubic"),
        ({"law": "true"}, "law: True is not cubic"),
        ({"waypoints": ""}, "waypoints are missing"),
        ({"waypoints": "[]"}, "waypoints: a motion needs two or more, not 0"),
        ({"waypoints": "[[1, 2, 3]]"}, "two or more, not 1"),
        ({"waypoints": "[[0, 0, 10], [1, 2]]"}, "row 2: 2 numbers where row 1 has 3"),
        ({"waypoints": "[[0, 0, 1], [0, 0, 1]]"}, "waypoints 1 and 2 are equal"),
        ({"waypoints": "[[0, 0, nan], [0, 0, 1]]"}, "joint 3 of number 1 is nan"),
        ({"waypoints": '[["a", 0, 1], [0, 0, 1]]'}, "row 1, number 1: 'a' is no number"),
        ({"waypoints": "[[], []]"}, "waypoints, row 1: there is no number"),
        (
            {"waypoints": f"[[1{'0' * 400}, 0, 1], [0, 0, 1]]"},
            "waypoints: a whole number is beyond",
        ),
        ({"waypoints": "[[1e300, 0, 1], [0, 0, 1]]"}, "1e.300 is beyond what is computed: 0, or"),
        ({"velocity": "[1, 1, 1e-200]"}, "velocity: 1e-200 is beyond what is computed"),
        ({"velocity": "nan"}, "velocity of joint 1: nan is not a finite number"),
        ({"velocity": ""}, "velocity is missing"),
        ({"velocity": "-3"}, "velocity of joint 1: -3 must be above 0"),
        ({"velocity": "[1, 2]"}, "velocity: 2 entries for 3 joints"),
        ({"velocity": '"fast"'}, "velocity: 'fast' is not a number, a list"),
        ({"velocity": "[[1, 2], [1, 2], [1, 2]]"}, "must be low < 0 < high"),
        ({"jerk": "[1, 0, 1]"}, "jerk of joint 2: 0 must be above 0"),
        ({"range": "[[-170, 170], [-40, 120], [-9, 90]]"}, "is -45.0, outside its range"),
        ({"start_velocity": "[1, 2]"}, "start_velocity: 2 numbers for 3 joints"),
        ({"end_velocity": "[1, 2, 999]"}, "end velocity of joint 3 is 999.0, outside its limits"),
        ({"durations": "[1]"}, "durations: .* must be .shortest, longest."),
        ({"durations": "3"}, "durations: 3 must be .shortest, longest."),
        ({"durations": "[2, 1]"}, "durations: .* must be .shortest, longest."),
        ({"ends": '"still"'}, "ends is of a spline alone; law is 'quintic'"),
        ({"law": '"spline"', "jerk": "0"}, "jerk of joint 1: 0 must be above 0"),
        ({"law": '"spline"', "jerk": "nan"}, "jerk of joint 1: nan is not a finite number"),
        ({"law": '"spline"', "jerk": "[9, inf, 9]"}, "jerk of joint 2: inf is not a finite number"),
        ({"law": '"spline"', "jerk": "[9, -9, 9]"}, "jerk of joint 2: -9 must be above 0"),
        ({"law": '"spline"', "jerk": "[9, 9]"}, "jerk: 2 entries for 3 joints"),
        ({**SPLINE, "start_velocity": "[1, 0, 0]"}, "start_velocity: a spline has none of its own"),
        ({**SPLINE, "waypoints": "[[0, 0, 1], [0, 0, 1]]"}, "waypoints 1 and 2 are equal"),
        ({**SPLINE, "ends": '"free"'}, "ends: 'free' is not one of still, repeated, natural"),
        ({"convention": '"standard"'}, "convention belongs to a D-H table"),
        ({"dh": "[[0, 1, 2]]"}, "dh: 3 joints need 3 rows"),
        ({"dh": TABLE, "kinds": '["hinge", "revolute", "revolute"]'}, "kinds: .* must be 3 of"),
        ({"dh": TABLE, "convention": '"other"'}, "convention: 'other' is not one of standard"),
        ({"dh": TABLE, "robot": '"a.urdf"'}, "robot and dh are two arms"),
        ({"robot": '"a.urdf"'}, "a.urdf: there is no such file"),
        ({"title": "3"}, "title: 3 is not a text"),
        ({"unit": '"deg'}, "is no TOML"),
    ],
)
def test_what_cannot_be_is_one_line_with_place_value_and_alternatives(
    changed: dict[str, str], fault: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code, out, err = asked(capsys, write(tmp_path, **changed))

    assert (code, out) == (2, "")
    assert err.count("\n") == 1
    assert re.search(f"^repro: .*pick.toml: .*{fault}", err), err


def test_file_that_is_not_there_stops_no_other(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code, out, err = asked(capsys, tmp_path / "none.toml", write(tmp_path))

    assert code == 2
    assert "none.toml: cannot be read" in err
    assert "pick and place: minimum" in out


@pytest.mark.parametrize("option", ["--csv", "--html"])
def test_one_file_is_written_for_one_motion(
    option: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = write(tmp_path)
    code, _, err = asked(capsys, path, path, option, tmp_path / "out")
    assert (code, err) == (2, f"repro: {option} takes one motion, not 2: {path}, {path}\n")
    assert asked(capsys, path, option, tmp_path / "none" / "out")[0] == 2
    assert asked(capsys, path, "--seconds", -1)[0] == 2


@pytest.mark.parametrize(
    ("changed", "kind"),
    [
        ({}, MinimumTime),
        ({"velocity": "[[-180, 180], [-180, 180], [-180, 180]]"}, MinimumTime),
        ({"velocity": "[[-90, 180], [-180, 180], [-180, 180]]"}, PolynomialMotion),
        ({"start_velocity": "[0, 0, 0]"}, MinimumTime),
        ({"start_velocity": "[0, 1, 0]"}, PolynomialMotion),
        ({"law": "11"}, PolynomialMotion),
        (SPLINE, MinimumTimeSpline),
        ({**SPLINE, "velocity": "[[-180, 180], [-180, 180], [-180, 180]]"}, MinimumTimeSpline),
        ({**SPLINE, "velocity": "[[-90, 180], [-180, 180], [-180, 180]]"}, DirectedSpline),
        ({**SPLINE, "acceleration": "[[-90, 180], [-90, 90], [-9, 9]]"}, DirectedSpline),
        ({"law": '"spline"'}, DirectedSpline),
    ],
)
def test_problem_is_the_plainest_that_says_it(
    changed: dict[str, str], kind: type, tmp_path: Path
) -> None:
    file = read_motion(write(tmp_path, **changed))

    assert type(file.problem) is kind
    assert file.problem.durations == FREE


def test_spline_with_limits_by_direction_is_certified_sampled_and_drawn(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    limits = {
        "velocity": "[[-30, 180], [-90, 180], [-180, 180]]",
        "acceleration": "[200, 300, 600]",
    }
    path = write(tmp_path, **SPLINE, **limits, dh=TABLE)
    samples, page = tmp_path / "out.csv", tmp_path / "out.html"
    code, out, _ = asked(capsys, path, "--csv", samples, "--html", page)
    values = np.genfromtxt(samples, delimiter=",", names=True)
    speed = np.degrees(values["velocitiesjoint_1"])

    assert code == 0
    assert "pick and place: minimum " in out
    assert "velocity of joint 1 (limit -30 deg/s)" in out
    assert "lost to velocity of joint 1: " in out
    assert speed.min() == pytest.approx(-30, abs=0.5)
    assert -30 <= speed.min() < speed.max() <= 180
    assert speed.max() > 30
    assert page.read_text(encoding="utf-8").count("<svg") == 2


def test_spline_whose_jerk_is_limited_is_certified_sampled_and_drawn(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = write(tmp_path, law='"spline"', jerk="[900, 900, 2000]", dh=TABLE)
    page = tmp_path / "out.html"
    code, out, _ = asked(capsys, path, "--html", page)
    (row,) = json.loads(asked(capsys, "--json", path)[1])

    assert code == 0
    assert "pick and place: minimum " in out
    assert re.search(r"binds: segment \d, at u = \S+: jerk of joint 1 \(limit 900 deg/s³\)", out)
    assert "lost to jerk of joint 1: " in out
    assert "a jerk 100 % of its own" in out
    assert "those of the jerk" in row["method"]
    assert row["gap"] <= 1e-5
    assert [each["time"] for each in row["beside"]] == [None, None]
    assert "jerk" in page.read_text(encoding="utf-8")


def test_spline_that_leaves_a_range_between_waypoints_is_said_to_obey_with_no_durations(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = write(tmp_path, **SPLINE, range="[[-9, 91], [-46, 11], [-1, 31]]")
    wide = write(tmp_path, "wide.toml", **SPLINE, range="[[-99, 99], [-99, 99], [-99, 99]]")
    _, out, _ = asked(capsys, path)

    assert "no minimum" in out
    assert re.search(r"No durations obey: in segment \d the path takes joint \d to", out)
    assert "minimum 3.8594" in asked(capsys, wide)[1]


def test_prismatic_joint_is_measured_in_metres(tmp_path: Path) -> None:
    kinds = '["revolute", "revolute", "prismatic"]'
    file = read_motion(write(tmp_path, dh=TABLE, kinds=kinds))

    assert file.units == ("deg", "deg", "m")
    assert file.si[2] == 1.0
    assert file.robot is not None
    low, high = (file.robot.chain.corners((0.0, 0.0, q)) for q in (0.0, 0.25))
    assert np.linalg.norm(high[-1] - low[-1]) == pytest.approx(0.25)


def test_python_certifies_problems_and_files_alike(tmp_path: Path) -> None:
    path = write(tmp_path)
    problem = read_motion(path).problem

    assert repro.certify(path).minimum == repro.certify(problem, seconds=5).minimum
    spline = read_motion(write(tmp_path, **SPLINE)).problem
    cut = repro.certify(spline, seconds=0)
    assert cut.minimum is None
    assert (cut.lower_bound or 9e9) < (cut.attained or 0)


@pytest.mark.parametrize("other", [3, None, quintic])
def test_what_is_no_motion_is_not_certified(other: Any) -> None:  # noqa: ANN401
    with pytest.raises(InputError, match="is no motion that can be certified; those are"):
        repro.certify(other)


def test_progress_is_drawn_on_a_terminal_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    times = iter(range(9))
    monkeypatch.setattr("repro.commands.motion_progress.time.monotonic", lambda: next(times))
    drawn = {}
    for terminal in (True, False):
        stream = io.StringIO()
        monkeypatch.setattr(stream, "isatty", lambda t=terminal: t)
        with telling(cast("TextIO", FitForTerminal(stream))) as tell:
            tell(1.0, 2.0)
        drawn[terminal] = stream.getvalue()

    assert drawn == {True: "\rbetween 1 and 2 s, 50 % apart\033[K\r\033[K", False: ""}


def test_command_runs_without_a_checkout(tmp_path: Path) -> None:
    path = write(tmp_path)
    root = Path(__file__).parents[2]
    done = subprocess.run(
        [sys.executable, "-m", "repro", "motion", str(path)],
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": os.pathsep.join([str(root), *sys.path])},
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert "minimum 2.3448" in done.stdout


@pytest.mark.parametrize("seconds", [-1, float("nan"), "5", None])
def test_seconds_of_a_call_are_a_number(seconds: Any) -> None:  # noqa: ANN401 (what no type allows)
    with pytest.raises(InputError, match="must be a number, 0 or more"):
        repro.certify("no matter.toml", seconds=seconds)
