"""Motion files with anything in them: a certificate, or one clear line and code 2."""

import datetime as dt
import io
import json
import math
import re
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from repro.__main__ import main
from repro.commands.motion_files import KEYS

Content = dict[str, Any]
ROWS = [[0, 0, 10], [90, -45, 30], [45, 10, 0]]
FILE: Content = {
    "title": "pick", "unit": "deg", "law": "quintic", "waypoints": ROWS, "velocity": 180,
    "acceleration": [300, 300, 600],
}  # fmt: skip
BOX: Content = {"range": [[-170, 170]] * 3, "durations": [0.01, 10]}
ARM: Content = {
    "dh": [[0, 0.4, 0.025, -90], [0, 0, 0.315, 0], [0, 0, 0.035, -90]],
    "convention": "modified",
    "kinds": ["revolute", "revolute", "prismatic"],
}
FILES = (
    {**FILE, "jerk": 4000, **BOX, **ARM},
    {**FILE, "law": 9, "velocity": [[-90, 180]] * 3, "start_velocity": [1, 0, 0], **BOX},
    {**FILE, "law": "spline", "ends": "natural", "time_ends": "repeated", **BOX, **ARM},
    {**FILE, "law": "spline", "acceleration": [[-9, 300], [-300, 9], [-300, 300]]},
    {**FILE, "law": "spline", "jerk": 4000},
)
LISTS: list[Any] = [[], {}]
for _ in range(200):
    LISTS = [[LISTS[0]], {"a": LISTS[1]}]
SIZES = (0.0, 1e-300, 5e-324, 1e-99, 1e-9, 1e9, 1e60, 1e99, 1e101, 1e308, math.inf, math.nan)
NUMBERS = (
    st.sampled_from([sign * size for size in SIZES for sign in (1.0, -1.0)])
    | st.sampled_from([0, 1, -1, 2**63, 10**40, 10**400, -(10**4000)])
    | st.floats()
    | st.integers(-9, 400)
)
WORDS = st.sampled_from(["spline", "rad", "nan", "", "\0", "\u200b", "٣", "²", "\ud7ff", "𝟗"])
LEAVES = (
    NUMBERS
    | WORDS
    | st.booleans()
    | st.text(max_size=9)
    | st.sampled_from([dt.date(2026, 1, 2), dt.time(3, 4), dt.datetime(2026, 1, 2, tzinfo=dt.UTC)])
)
VALUES = st.recursive(
    LEAVES, lambda inner: st.lists(inner, max_size=4) | st.dictionaries(WORDS, inner, max_size=2)
)


def toml(value: object) -> str:
    """Return a value as TOML has it."""
    if isinstance(value, list):
        return f"[{', '.join(map(toml, value))}]"
    if isinstance(value, dict):
        return f"{{{', '.join(f'{toml(key)} = {toml(own)}' for key, own in value.items())}}}"
    if isinstance(value, str):
        return '"' + "".join(f"\\U{ord(sign):08x}" for sign in value) + '"'
    if isinstance(value, bool | float):
        return repr(value).lower()
    return str(value)


def changed(data: st.DataObject, value: Any) -> Any:  # noqa: ANN401 (any value of a file)
    """Return a value with one of its parts, or all of it, made another one."""
    if isinstance(value, list) and value and data.draw(st.booleans()):
        place = data.draw(st.integers(0, len(value) - 1))
        if data.draw(st.integers(0, 5)) == 0:
            return [*value[:place], *value[place + data.draw(st.integers(0, 1)) :], *value[:1]]
        return [*value[:place], changed(data, value[place]), *value[place + 1 :]]
    if isinstance(value, int | float) and data.draw(st.booleans()):
        return data.draw(NUMBERS)
    return data.draw(VALUES)


def hostile(data: st.DataObject) -> Content:
    content = dict(data.draw(st.sampled_from(FILES)))
    for _ in range(data.draw(st.integers(1, 3))):
        key = data.draw(st.sampled_from(KEYS) | st.sampled_from(list(content)))
        if data.draw(st.integers(0, 7)) == 0:
            content.pop(key, None)
        elif data.draw(st.integers(0, 15)) == 0:
            content[data.draw(st.text(max_size=9))] = data.draw(VALUES)
        else:
            content[key] = changed(data, content.get(key, 1))
    return content


def refused(constant: str) -> float:
    pytest.fail(f"{constant} is no JSON")


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow])
@given(st.data())
def test_whatever_a_file_holds_is_a_certificate_or_one_line(
    tmp_path: Path, data: st.DataObject
) -> None:
    content = hostile(data)
    path, samples = tmp_path / "own.toml", tmp_path / "own.csv"
    samples.unlink(missing_ok=True)
    lines = (f"{toml(key)} = {toml(own)}\n" for key, own in content.items())
    path.write_text("".join(lines), encoding="utf-8")
    out, err = io.StringIO(), io.StringIO()
    with redirect_stdout(out), redirect_stderr(err):
        code = main(["motion", "--json", "--seconds", "0.1", "--csv", str(samples), str(path)])

    rows = json.loads(out.getvalue(), parse_constant=refused)
    if code == 2:
        assert rows == []
        assert err.getvalue().startswith(f"repro: {path}: ")
        assert err.getvalue().count("\n") == 1
        assert len(err.getvalue()) < 500 + len(str(path))
        return
    (row,) = rows
    assert code == 0
    assert row["minimum"] is None or 0.0 < row["lower_bound"] <= row["minimum"]
    assert samples.exists() == bool(row["at"])
    if row["at"]:
        times = np.genfromtxt(samples, delimiter=",", skip_header=1)[:, 0]
        assert (np.diff(times) > 0.0).all()
        assert times[-1] == pytest.approx(row["attained"])


@pytest.mark.parametrize(
    ("line", "fault"),
    [
        (f"jerk = {'9' * 5000}", "cannot be read: a number of too many digits"),
        (f"jerk = {'[' * 5000}{']' * 5000}", "cannot be read: .* too many lists in lists"),
        (f'robot = "{"a" * 300}"', "there is no such file"),
        (f"convention = {'[' * 300}{']' * 300}", "convention belongs to a D-H table"),
        (f"ends = {'[' * 300}{']' * 300}", r"ends is of a spline alone"),
        (f'"{"a" * 5000}" = 1', "unknown key 'a+…; known are"),
    ],
    ids=["digits", "nested", "name", "other", "ends", "key"],
)
def test_what_no_reader_holds_is_one_short_line(
    line: str, fault: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "own.toml"
    path.write_text(
        "".join(f"{key} = {toml(own)}\n" for key, own in FILE.items()) + line, encoding="utf-8"
    )

    assert main(["motion", str(path)]) == 2
    told = capsys.readouterr().err.removeprefix(f"repro: {path}: ")
    assert re.search(fault, told)
    assert told.count("\n") == 1
    assert len(told) < 800


@pytest.mark.parametrize("key", ["title", "law", "unit", "waypoints", "velocity"])
@pytest.mark.parametrize("value", ["9" * 5000, *LISTS], ids=["digits", "lists", "tables"])
def test_what_stands_for_a_value_is_cut_short(
    key: str, value: object, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "own.toml"
    content = {**FILE, key: value}
    path.write_text("".join(f"{key} = {toml(own)}\n" for key, own in content.items()), "utf-8")
    code = main(["motion", "--json", str(path)])
    told = capsys.readouterr().err

    assert code == (0 if (key, value) == ("title", "9" * 5000) else 2)
    assert told.count("\n") <= 1
    assert len(told) < 300 + len(str(path))
