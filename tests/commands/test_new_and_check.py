import sys
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from repro.__main__ import main
from repro.model.assumptions import Alternative, Assumption
from tests.small_papers import CLAIMS, PAPER, let_be_known

Run = Callable[..., tuple[int, str, str]]


@pytest.fixture
def run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> Iterator[Run]:
    """Yield what runs a command in an empty folder and returns exit code, output and errors."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "path", [*sys.path])

    def command(*arguments: str) -> tuple[int, str, str]:
        return (main(arguments), *capsys.readouterr())

    yield command
    sys.modules.pop("roe2030", None)


def test_what_new_writes_runs_as_it_stands(run: Run) -> None:
    assert run("new", "roe2030")[0] == 0

    assert run("reproduce", "./roe2030.py", "--repeats", "1")[0] == 0
    for page in ("roe2030.data.html", "roe2030.md", "index.html", "index.md"):
        text = Path("reports", page).read_text(encoding="utf-8")
        assert ("repro reproduce ./roe2030.py" in text, "nox -s" in text) == (True, False)
    assert run("audit", "./roe2030.py")[:2] == (
        0, "roe2030: nothing found; 1 table of 4 numbers is declared\n",
    )  # fmt: skip
    assert run("certify", "./roe2030.py")[:2] == (0, "roe2030: no motion, nothing to certify\n")
    code, out, _ = run("check", "./roe2030.py")
    assert (code, out.splitlines()[0]) == (0, "roe2030: all that a paper must satisfy holds")


def test_new_overwrites_nothing_and_takes_names_of_modules_alone(run: Run) -> None:
    Path("roe2030.toml").write_text("mine")

    assert run("new", "roe2030")[0] == 2
    for key in ("a-b", "../x", "class", "", "2x"):
        code, _, err = run("new", key)
        assert (code, err.count("\n")) == (2, 1)
    assert [path.name for path in Path().iterdir()] == ["roe2030.toml"]
    assert Path("roe2030.toml").read_text() == "mine"


@pytest.mark.parametrize("key", ["syji", "numpy", "json"])
def test_a_key_that_something_else_has_is_refused(run: Run, key: str) -> None:
    code, _, err = run("new", key)

    assert (code, err.count("\n")) == (2, 1)
    assert f"the key {key!r} is taken by " in err
    assert not list(Path().iterdir())


def test_check_exits_with_1_on_what_no_paper_may_do(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    let_be_known(monkeypatch, replace(PAPER, inputs=(replace(PAPER.results[0], where="Table 1"),)))

    code, out, _ = run("check", PAPER.key)

    assert (code, "2 tables are called 'Table 1'" in out) == (1, True)


def test_check_tells_a_caption_of_other_runs_than_the_experiment_has(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    table = replace(PAPER.results[0], where="Table 1, p. 3 (20 runs)")
    claims = tuple(replace(claim, table=table) for claim in CLAIMS)
    let_be_known(monkeypatch, replace(PAPER, results=(table,), claims=claims))

    code, out, _ = run("check", PAPER.key)

    assert (code, out.splitlines()[:2]) == (
        1,
        [
            "small2020: 1 fault",
            "  fault: Table 1: its caption tells 20 runs, experiment 'search' has 3",
        ],
    )


def test_check_builds_what_each_reading_has_run(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    reading = Alternative(
        says="wider", name="wider", algorithms={("search", "wide"): {"width": 4.0}}
    )
    assumption = Assumption(
        what="width", chosen="as is", alternatives=(reading,), because="it is", where="p. 3"
    )
    let_be_known(monkeypatch, replace(PAPER, assumptions=(assumption,)))

    code, out, _ = run("check", PAPER.key)

    assert (code, out.count("fault: ")) == (1, 1)
    assert "reading 'wider', experiment 'search'" in out
    assert "nothing that decides its runs is changed" in out
