import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from repro.__main__ import main
from tests.commands.own_searches import Run, standing_in
from tests.determinism.edited_packages import forget
from tests.small_papers import PAPER

MODULE = """
def centre(cost, bounds, budget, rng): return bounds.mean(axis=1)
def sample(cost, bounds, budget, rng):
    points = rng.uniform(*bounds.T, size=(budget, len(bounds)))
    return min(points, key=cost)
def lost(cost, bounds, budget, rng): raise ValueError("no way\\nhome")
"""


@pytest.fixture
def run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> Iterator[Run]:
    """Yield what runs a command in a folder with a module of searches."""

    def command(*arguments: str) -> tuple[int, str, str]:
        code = main(arguments)
        return (code, *capsys.readouterr())

    with standing_in(tmp_path, monkeypatch, module=MODULE, paper=PAPER):
        yield command


def page(name: str) -> str:
    return Path(f"reports-private/{name}").read_text(encoding="utf-8")


def test_search_has_its_row_beside_the_algorithms_of_the_store(run: Run) -> None:
    run("reproduce", "--repeats", "1")

    code, out, _ = run("compare", "mine:centre", "--workers", "1")

    assert (code, out) == (0, "page: reports-private/centre.html\n")
    assert "| centre | yours | 3 | 1 |" in page("centre.md")
    assert "| guess | printed protocol | 3 | 20 |" in page("centre.md")
    assert "| bowl | guess 0.05; wide 0.5 |" in page("centre.md")
    assert "| bowl | wide | printed protocol |" in page("centre.md")


def test_same_search_is_not_run_again_and_a_changed_one_is(run: Run) -> None:
    first = run("compare", "mine:sample", "--workers", "1")
    again = run("compare", "mine:sample", "--workers", "1")
    Path("mine.py").write_text(MODULE.replace("budget, len", "budget // 2, len"))
    sys.modules.pop("mine")
    forget()
    changed = run("compare", "mine:sample", "--workers", "1")

    assert "3/3 runs" in first[2]
    assert "runs (" not in again[2]
    assert "3/3 runs" in changed[2]


def test_published_pages_are_left_alone(run: Run) -> None:
    run("reproduce", "--repeats", "1", "--reports", "elsewhere")
    before = {path: path.read_bytes() for path in Path("elsewhere").rglob("*.*")}

    refused = [
        run("compare", "mine:centre", "--reports", name) for name in ("elsewhere", "reports")
    ]

    assert [code for code, *_ in refused] == [2, 2]
    assert "holds published pages" in refused[0][2]
    assert {path: path.read_bytes() for path in Path("elsewhere").rglob("*.*")} == before
    assert not Path("reports").exists()


@pytest.mark.parametrize(
    ("arguments", "fault"),
    [
        (("mine:nothing",), "'mine' has no 'nothing'"),
        (("mine:centre", "--name", "wide"), "'wide' belongs to another algorithm"),
        (("mine:centre", "--name", "CMA-ES (cmaes)"), "belongs to another algorithm"),
        (("mine:centre", "--name", "a/b"), "must be printable, with no '/'"),
        (("mine:centre", "--name", "a\nb"), "must be printable"),
        (("mine:centre", "--name", " "), "must be printable"),
        (("mine:centre", "nobody1900"), "unknown paper 'nobody1900'"),
        (("mine:centre", "--repeats", "0"), "repeats is 0"),
        (("mine:centre", "--workers", "0"), "workers is 0"),
        (("mine:centre", "--reports", "mine.py"), "the reports folder mine.py cannot be used"),
    ],
)
def test_bad_input_is_one_line_and_exit_code_2(
    run: Run, arguments: tuple[str, ...], fault: str
) -> None:
    code, out, err = run("compare", *arguments)

    assert (code, out) == (2, "")
    assert fault in err
    assert err.count("\n") == 1
    assert {path.name for path in Path().iterdir()} <= {"mine.py", "__pycache__"}


def test_failed_runs_are_named_with_exit_code_1_and_on_the_page(run: Run) -> None:
    code, _, err = run("compare", "mine:lost", "--workers", "1")

    assert code == 1
    assert "repro: run small2020/search/bowl/lost/1/3 failed: ValueError: no way" in err
    assert "Traceback" not in err
    assert "no way" in page("lost.html")
