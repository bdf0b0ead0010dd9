import re
import warnings
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

import repro
from repro.__main__ import main
from repro.report.frames import RUNS
from repro.report.ioh_files import ioh_files
from repro.report.latex_tables import escaped, latex_table
from tests.small_papers import EXPERIMENT, PAPER, let_be_known
from tests.small_stores import RECORDS, with_pages


@pytest.fixture(scope="module", autouse=True)
def known() -> Iterator[None]:
    with pytest.MonkeyPatch.context() as patch:
        let_be_known(patch, PAPER)
        yield


@pytest.fixture(scope="module")
def place(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with a store and the reports of it."""
    return with_pages(tmp_path_factory.mktemp("exported"))


def exported(place: Path, to: Path, *more: str) -> list[str]:
    """Export and return the names of the files and folders that were made."""
    places = ("--store", str(place / "store"), "--reports", str(place / "reports"))
    assert main(["export", *more, *places, "--to", str(to)]) == 0
    return sorted(path.name for path in to.iterdir())


FILES = ("audit", "certificates", "findings", "runs", "standings", "tests")


def test_csv_files_hold_the_frames(place: Path, tmp_path: Path) -> None:
    assert exported(place, tmp_path, "--format", "csv") == [f"small2020-{n}.csv" for n in FILES]

    runs = pd.read_csv(tmp_path / "small2020-runs.csv", dtype={"seed": object, "cost": str})
    assert list(runs) == list(RUNS)
    assert [float(cost) for cost in runs["cost"]] == [record.cost for record in RECORDS]
    own = repro.load(place / "reports").runs(PAPER.key)["seed"]
    assert [int(seed) for seed in runs["seed"]] == own.tolist()


def test_parquet_files_hold_the_frames_to_the_last_bit(place: Path, tmp_path: Path) -> None:
    exported(place, tmp_path, "--format", "parquet")

    runs = pd.read_parquet(tmp_path / "small2020-runs.parquet")
    own = repro.load(place / "reports").runs(PAPER.key)
    assert runs["cost"].tolist() == own["cost"].tolist()
    assert [int(seed) for seed in runs["seed"]] == own["seed"].tolist()
    findings = pd.read_parquet(tmp_path / "small2020-findings.parquet")
    assert findings["printed"].tolist() == ["0.05", "0.5", "0.02", "0.4"]


def test_without_pyarrow_one_line_says_what_to_install(
    place: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr("repro.commands.export.importlib.util.find_spec", lambda _: None)
    places = ("--reports", str(place / "reports"), "--to", str(tmp_path))

    assert main(["export", "--format", "parquet", *places]) == 2
    assert capsys.readouterr().err == (
        "repro: Parquet needs pyarrow: install it with pip install 'repro-whales[parquet]'\n"
    )


def test_files_of_iohprofiler_open_in_iohinspector(place: Path, tmp_path: Path) -> None:
    assert exported(place, tmp_path, "small2020", "--format", "ioh") == ["small2020-ioh"]

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        from iohinspector import DataManager  # noqa: PLC0415 (its own imports warn)

        read = DataManager()
        read.add_folder(str(tmp_path))
        data = read.load(monotonic=False)
    overview = read.overview.to_dicts()
    assert {row["function_name"] for row in overview} == {"bowl"}
    assert sorted(row["best_y"] for row in overview) == sorted(r.cost for r in RECORDS)
    last = {row["data_id"]: row["raw_y"] for row in data.to_dicts()}
    assert sorted(last.values()) == sorted(record.cost for record in RECORDS)
    assert {row["evals"] for row in overview} == {20}


def test_a_curve_of_iohprofiler_falls_from_1_to_all_evaluations() -> None:
    record = replace(RECORDS[0], history=np.array([np.nan, 4.0, 4.0, 2.0, 1.0]), cost=1.0)

    (data,) = [t for n, t in ioh_files(EXPERIMENT, [record]).items() if n.endswith(".dat")]

    assert data.splitlines() == ["evaluations raw_y", "1 4.0", "16 2.0", "20 1.0"]


def test_names_that_look_alike_have_files_of_their_own() -> None:
    names = {"a b": EXPERIMENT.problems["bowl"], "a-b": EXPERIMENT.problems["bowl"]}
    experiment = replace(EXPERIMENT, problems=names)
    files = [
        ioh_files(experiment, [replace(RECORDS[0], task=replace(RECORDS[0].task, problem=name))])
        for name in names
    ]

    assert not files[0].keys() & files[1].keys()


def test_latex_tables_have_what_is_printed_beside_the_re_run(place: Path, tmp_path: Path) -> None:
    assert exported(place, tmp_path, "--format", "latex") == ["small2020-table-1.tex"]

    text = (tmp_path / "small2020-table-1.tex").read_text(encoding="utf-8")
    assert r"\toprule" in text
    assert r" & \multicolumn{2}{c}{guess} & \multicolumn{2}{c}{wide} \\" in text
    assert r" & printed & re-run & printed & re-run \\" in text
    assert re.search(
        r"^bowl mean & 0\.05 & \$0\.\d+\$ & 0\.5 & \$[\d.]+\$ \\\\$", text, re.MULTILINE
    )
    assert {line.count("&") for line in text.splitlines() if line.startswith("bowl")} == {4}


HOSTILE = r"\input{/etc/passwd} 50% of $x_1^2$ & #1 ~ <b>"


def test_no_text_of_a_paper_is_a_command_of_latex(place: Path) -> None:
    findings = repro.load(place / "reports").findings
    texts = dict.fromkeys(("paper", "table", "row", "column", "printed"), HOSTILE)

    text = latex_table(findings.head(1).assign(**texts, value=np.nan), "a")

    assert r"\input" not in text
    assert text.count(escaped(HOSTILE)) == 5
    plain = text.replace(escaped(HOSTILE), "")
    assert plain.count("{") == plain.count("}")
    for mark in "%$#_^~<>":
        assert mark not in re.sub(r"\\[%$#_{}&]", "", escaped(HOSTILE)).replace("{}", "")


def test_table_is_one_that_latex_sets(place: Path) -> None:
    texts = dict.fromkeys(("paper", "table", "row"), "θ₁ ≤ 10⁻³ m² of λ & Σ")
    text = latex_table(repro.load(place / "reports").findings.assign(**texts), "a")

    body = re.sub(r"\\\\|\\[%$#_{}&]", "", text.replace(r" \\", "\n"))
    assert body.count("{") == body.count("}")
    assert body.count("$") % 2 == 0
    opened = re.findall(r"\\(begin|end)\{(\w+)\}", body)
    assert opened == [("begin", "table"), ("begin", "tabular"), ("end", "tabular"),
                      ("end", "table")]  # fmt: skip
    rules = [line for line in text.splitlines() if line.endswith("rule")]
    assert rules == [r"\toprule", r"\midrule", r"\bottomrule"]
    (columns,) = re.findall(r"\\begin\{tabular\}\{(l[r]+)\}", text)
    rows = text.partition(r"\midrule")[2].partition(r"\bottomrule")[0].strip().splitlines()
    counts = {len(re.findall(r"(?<!\\)&", row)) for row in rows}
    assert counts == {len(columns) - 1}
    assert text.isascii()


@pytest.mark.parametrize(
    ("given", "says"),
    [
        (["--format", "ioh", "--store", "nowhere"], "nothing to export in nowhere"),
        (
            ["--format", "latex", "--store", "no", "--reports", "none"],
            "nothing to export in none nor",
        ),
        (["nobody2020"], "unknown paper 'nobody2020'"),
        (["--to", __file__], f"the folder {__file__} cannot be used: File exists"),
    ],
)
def test_what_cannot_be_exported_is_one_line(
    place: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    given: list[str],
    says: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    reports = [] if "--format" in given else ["--reports", str(place / "reports")]

    assert main(["export", *given, *reports]) == 2
    assert capsys.readouterr().err.startswith(f"repro: {says}")


def test_of_a_store_without_pages_the_runs_are_exported(place: Path, tmp_path: Path) -> None:
    to = tmp_path / "to"

    assert main(["export", "--store", str(place / "store"), "--reports", str(tmp_path / "none"),
                 "--to", str(to)]) == 0  # fmt: skip
    assert [path.name for path in to.iterdir()] == ["small2020-runs.csv"]


@pytest.mark.parametrize(
    ("format_", "name"), [("csv", "small2020-runs.csv"), ("ioh", "small2020-ioh")]
)
def test_papers_that_were_never_run_are_named_and_stop_no_other(
    place: Path, tmp_path: Path, format_: str, name: str, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    let_be_known(monkeypatch, replace(PAPER, key="never2021"), PAPER)
    asked = ["export", "--store", str(place / "store"), "--reports", "none", "--to", str(tmp_path),
             "--format", format_]  # fmt: skip

    assert main(asked) == 0
    written, said = capsys.readouterr()
    assert [Path(line).name for line in written.split()] == [name]
    assert all(Path(line).exists() for line in written.split())
    assert said.count("\n") == 1
    assert "has no run of never2021 as it stands" in said
    assert main([*asked, "never2021"]) == 2
