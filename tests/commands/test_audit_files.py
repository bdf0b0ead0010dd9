import io
import json
import os
import sys
import zipfile
from pathlib import Path

import openpyxl
import pandas as pd
import pytest

import repro
from repro.__main__ import main
from repro.errors import InputError

TABLE = "Function,Algorithm,Best,Mean,Worst,Std\nF1,WOA,1.0,2.0,3.0,0.5\nF2,WOA,1.0,0.5,3.0,0.5\n"
TRUE = TABLE.replace("0.5,3.0", "2.5,3.0")


@pytest.fixture
def table(tmp_path: Path) -> Path:
    path = tmp_path / "table.csv"
    path.write_text(TABLE, encoding="utf-8")
    return path


def test_paragraph_says_what_was_read_and_what_cannot_be(
    table: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code = main(["audit", str(table), "--runs", "30"])

    out = capsys.readouterr().out
    assert code == 1
    assert "checked 8 of 8 numbers in 2 blocks; 0 skipped; n = 30 as told; 1 cannot be: " in out
    assert "the mean 0.5, at most 0.6 with rounding, lies below the best 1.0" in out
    assert "guess: minimisation (--maximise)" in out


def test_true_table_exits_with_0(table: Path, capsys: pytest.CaptureFixture[str]) -> None:
    table.write_text(TRUE, encoding="utf-8")

    assert main(["audit", str(table)]) == 0
    assert (
        "without n, 0 of 2 blocks can be from n = 2 on; F1 of WOA from n = "
        in capsys.readouterr().out
    )


def test_json_has_one_object_a_table(table: Path, capsys: pytest.CaptureFixture[str]) -> None:
    main(["audit", str(table), str(table), "--runs", "30", "--json"])

    first, second = json.loads(capsys.readouterr().out)
    assert first == second
    assert set(first) == {"file", "read", "rows"}
    assert set(first["read"]) == {"cells", "skipped", "guesses"}
    assert not [says for says in first["read"]["guesses"] if "told" in says]
    (row,) = first["rows"]
    assert (row["check"], row["row"], row["column"]) == ("mean-bound", "F2 WOA", "Mean")
    assert (row["grade"], row["condition"]) == ("impossible", None)


def test_page_holds_the_table_with_its_flags_and_escapes_it(table: Path, tmp_path: Path) -> None:
    table.write_text(TABLE.replace("WOA", "<b>&<script>x"), encoding="utf-8")
    html = tmp_path / "page.html"

    main(["audit", str(table), "--runs", "30", "--html", str(html)])

    text = html.read_text(encoding="utf-8")
    assert '<td class="proof">0.5' in text
    assert "<script" not in text
    assert "://" not in text


def test_settings_beside_a_file_are_told_and_the_command_line_goes_before(
    table: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    table.with_suffix(".toml").write_text("runs = 7\n[minimum]\nF1 = 1.5\n", encoding="utf-8")

    main(["audit", str(table)])
    main(["audit", str(table), "--runs", "9"])

    first, second = (
        line for line in capsys.readouterr().out.splitlines() if line.startswith(str(table))
    )
    assert "n = 7 as told; 2 cannot be" in first
    assert "n = 9 as told; 2 cannot be" in second


def test_minimum_and_function_bound_the_values(
    table: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    table.write_text(TRUE, encoding="utf-8")

    assert main(["audit", str(table), "--runs", "9", "--minimum", "F1=1.5"]) == 1
    assert "below" in capsys.readouterr().out
    assert main(["audit", str(table), "--runs", "9", "--minimum", "F1=0.5"]) == 0
    table.write_text(TRUE.replace("3.0", "3e9"), encoding="utf-8")
    assert main(["audit", str(table), "--runs", "9", "--function", "F1=sphere@30"]) == 1


@pytest.mark.parametrize(
    ("options", "says"),
    [
        (["--runs", "0"], "runs 0 is no whole number from 1"),
        (["--minimum", "F1=x"], "'x' is not a number"),
        (["--function", "F1=spehre"], "unknown function 'spehre'; known: "),
        (["--function", "F1=sphere@x"], "its dimension 'x' is no whole number"),
        (["--alpha", "2"], "alpha 2.0 does not lie between 0 and 1"),
        (["--html", "/nowhere/page.html"], "/nowhere/page.html cannot be written"),
    ],
)
def test_wrong_option_is_one_line(
    table: Path, options: list[str], says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    code = main(["audit", str(table), *options])

    error = capsys.readouterr().err
    assert code == 2
    assert says in error
    assert error.count("\n") == 1


def _zip(parts: dict[str, bytes]) -> bytes:
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in parts.items():
            archive.writestr(name, content)
    return packed.getvalue()


def _workbook(*rows: tuple[object, ...]) -> bytes:
    book, packed = openpyxl.Workbook(), io.BytesIO()
    for row in rows:
        book.active.append(row)
    book.save(packed)
    return packed.getvalue()


ENTITY = b'<!DOCTYPE a [<!ENTITY b SYSTEM "file:///etc/passwd">]><a>&b;</a>'


@pytest.mark.parametrize(
    ("name", "content", "says"),
    [
        ("a.csv", b"", "it is empty"),
        ("a.csv", b" \n\n ", "it is empty"),
        ("a.csv", b"%PDF-1.7 ...", "it is a PDF"),
        ("a.csv", bytes(range(256)) * 9, "bytes that no text has"),
        ("a.csv", b"\xff\xfe\x00\xd8 odd", "no utf-16 text"),
        ("a.csv", b"a,b\nc,d\n", "no table with numbers in it was found"),
        ("a.html", b"<html>nothing</html>", "no table with numbers in it was found"),
        ("a.xlsx", b"no archive", "it is no workbook"),
        ("a.xlsx", _zip({"a.xml": b"<a/>"}), "it is no workbook"),
        ("a.xlsx", _zip({"xl/a.xml": b"0" * (65 * 2**20)}), "it unpacks to more than 64 MB"),
        ("a.xlsx", _zip({"xl/workbook.xml": ENTITY}), "declares entities"),
        ("a.xlsx", _workbook(("F", "Mean"), ("F1", 1.5))[:900], "it is no workbook"),
        ("a.txt", _workbook(("F", "Mean"), ("F1", 1.5)), "a workbook is named .xlsx"),
    ],
)
def test_bad_file_is_one_line(
    tmp_path: Path, name: str, content: bytes, says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / name
    path.write_bytes(content)

    code = main(["audit", str(path)])

    error = capsys.readouterr().err
    assert code == 2
    assert says in error
    assert error.count("\n") == 1


def test_missing_file_is_one_line_and_the_others_are_audited(
    table: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code = main(["audit", str(table.with_name("none.csv")), str(table)])

    out, error = capsys.readouterr()
    assert code == 2
    assert error.endswith("none.csv: cannot be read: No such file or directory\n")
    assert "checked 8 of 8 numbers" in out


@pytest.mark.skipif(sys.platform == "win32", reason="pipes of this kind are no files there")
def test_a_pipe_that_nobody_writes_to_is_no_file(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    os.mkfifo(tmp_path / "a.csv")

    assert main(["audit", str(tmp_path / "a.csv")]) == 2
    assert "it is no file" in capsys.readouterr().err


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "cp1252"])
def test_every_encoding_gives_the_same_numbers(
    tmp_path: Path, encoding: str, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "table.csv"
    path.write_bytes(TABLE.replace("Std", "Écart-type").encode(encoding))

    assert main(["audit", str(path), "--runs", "30"]) == 1
    assert "checked 8 of 8 numbers in 2 blocks" in capsys.readouterr().out


def test_standard_input_is_read(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(TABLE.encode())))

    assert main(["audit", "-"]) == 1
    assert capsys.readouterr().out.startswith("standard input, table 1: checked 8 of 8")


def test_sheet_shows_the_digits_of_its_formats_and_runs_no_formula(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    book = openpyxl.Workbook()
    book.active.append(["F", "Best", "Mean", "Worst"])
    book.active.append(["F1", 1.0004, 0.99996, "=1+1"])
    book.active["C2"].number_format = "0.00E+00"
    book.save(tmp_path / "a.xlsx")

    code = main(["audit", str(tmp_path / "a.xlsx"), "--json"])

    (found,) = json.loads(capsys.readouterr().out)
    assert code == 0
    assert found["read"]["cells"] == 2
    assert [each["because"] for each in found["read"]["skipped"]] == [
        "it is a formula, which is not run"
    ]


def test_frame_and_file_are_audited_from_python(table: Path) -> None:
    frame = pd.DataFrame({"F": ["F1", "F2"], "best": ["1.0"] * 2, "mean": ["2.0", "0.5"]})

    of_frame = repro.audit_table(frame, runs=30)
    of_file = repro.audit_table(table, runs=30)

    assert list(of_frame["check"]) == list(of_file["check"]) == ["mean-bound"]
    assert list(of_file["row"]) == ["F2 WOA"]
    assert bool(of_file["is_proof"].all())
    assert of_frame.attrs["read"][0]["cells"] == 4


def test_unknown_option_of_python_is_named() -> None:
    with pytest.raises(InputError, match="unknown option 'run'; known: maximise, "):
        repro.audit_table(pd.DataFrame(), run=30)
    with pytest.raises(InputError, match="int is neither a DataFrame nor a path"):
        repro.audit_table(5)
