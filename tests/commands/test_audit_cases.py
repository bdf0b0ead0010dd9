"""Small tables of the kinds that once raised a false alarm, or hid an error, as files."""

from pathlib import Path

import pandas as pd
import pytest

from repro.commands.audit_table import audit_table

RANKS = "Function,A rank,B rank\n" + "".join(f"F{k},1,2\n" for k in range(1, 11))
TIES = (
    "Function,A mean,A rank,B mean,B rank,C mean,C rank\n"
    "F1,1.4003E+03,3,1.40E+03,1,1.40E+03,2\nF2,1.401E+03,3,1.4E+03,1,1.40E+03,2\n"
    "F3,0,1,0,1,1.400E+03,3\nAverage rank,,2.33,,1.00,,2.33\n"
)
SQUARES = {"function": {"F1": "sphere@30"}}


def proofs(tmp_path: Path, text: str, **told: object) -> list[str]:
    """Return the checks that something fails without any condition."""
    found = _found(tmp_path, text, told)
    return [
        check for check, is_proof in zip(found["check"], found["is_proof"], strict=True) if is_proof
    ]


def conditions(tmp_path: Path, text: str, **told: object) -> list[str | None]:
    """Return what each row but a note needs."""
    found = _found(tmp_path, text, told)
    return list(found[found["grade"] != "noted"]["condition"])


def _found(tmp_path: Path, text: str, told: dict[str, object]) -> pd.DataFrame:
    path = tmp_path / "case.csv"
    path.write_text(text, encoding="utf-8")
    return audit_table(path, **told)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("30 runs\nF,Worst,Mean,Best\nF1,1175,1187,1190\n", {}),
        ("30 runs\nF,Min,Mean,Max\nF1,1175,1187,1190\n", {}),
        (TIES, {}),
        ("30 runs\nFunction,Best,Mean,Worst\nsphere,1e4,4.5e8,9e8\n", {}),
    ],
)
def test_true_tables_raise_no_alarm(tmp_path: Path, text: str, told: dict[str, object]) -> None:
    assert conditions(tmp_path, text, **told) == []


@pytest.mark.parametrize(
    ("text", "told", "says"),
    [
        ("2 runs\nF,Best,Worst,Std\nF1,0,1.00E-25,0.00E+00\n", {}, "double precision"),
        ("30 runs\nF,Best,Mean,Worst,Std\nF1,12340,12350,12350,4.123\n", {}, "no digit of a whole"),
        ("30 runs\nF,Best\nF1,1.00E-20\n", {"function": {"F1": "rastrigin@30"}}, "left to right"),
        ("30 runs, threshold 1e-4\nF,Mean,SR %\nF1,9.32e+03,100%\n", {}, "success is told by"),
    ],
)
def test_what_holds_in_one_way_of_computing_says_which(
    tmp_path: Path, text: str, told: dict[str, object], says: str
) -> None:
    (condition,) = conditions(tmp_path, text, **told)

    assert condition
    assert says in condition
    assert proofs(tmp_path, text, **told) == []


@pytest.mark.parametrize(
    ("text", "told", "check"),
    [
        ("30 runs\nF,Mean,Std\nF1,2.99e+10,6.8e+09\n", SQUARES, "above-ceiling"),
        ("51 runs\nF,Mean,Std\nF1,1.0,100\n", {"errors": True}, "std-bound"),
        ("30 runs\nF,Mean,Median,Std\nF1,100,10,1\n", {}, "quantile-bound"),
    ],
)
def test_what_no_runs_can_give_is_proved(
    tmp_path: Path, text: str, told: dict[str, object], check: str
) -> None:
    assert proofs(tmp_path, text, **told) == [check]


@pytest.mark.parametrize(
    ("wrong", "right", "told"),
    [
        ("26 functions\n,W/T/L\nGWO,17/2/9\n", "28 functions\n,W/T/L\nGWO,17/2/9\n", {}),
        ("F,p-value,h\nF1,0.022972544,0\n", "F,p-value,h\nF1,0.022972544,1\n", {"sided": 1}),
        (f"{RANKS}Sum,11,20\n", f"{RANKS}Sum,10,20\n", {}),
    ],
)
def test_places_that_disagree_are_found(
    tmp_path: Path, wrong: str, right: str, told: dict[str, object]
) -> None:
    assert conditions(tmp_path, wrong, **told) == [None]
    assert conditions(tmp_path, right, **told) == []
