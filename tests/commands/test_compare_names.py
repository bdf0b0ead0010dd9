"""What searches may be called: a page of its own for each name, or one line."""

import html
import json
import re
import tempfile
import unicodedata
from collections.abc import Iterator, Sequence
from pathlib import Path
from urllib.parse import unquote

import pandas as pd
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from repro.__main__ import main
from repro.commands.compare_entrants import check_name, stem
from repro.errors import InputError
from repro.report.escapes import csv_value
from tests.commands.own_searches import Run, let_be_trusted, standing_in
from tests.hostile import ragged, tags
from tests.small_papers import PAPER

MODULE = "def centre(cost, bounds, budget, rng): return bounds.mean(axis=1)\n"
KINDS = ("html", "md", "json", "csv")
HOSTILE = ("鲸鱼", "沙猫", "$(touch x)", "`touch x`", "a;b", "'", '"', "-x", "--", "..", "...",
           ".a", "a.", "CON", "results", "Results.json", "index.html", "own", "Own", "OWN",
           "own.md", "own.csv", "café", "cafe\u0301", "ﬁ", "fi", "ＯＷＮ", "ß", "ss", "a" * 300,
           "a" * 301, "a b", "a-b", "a\tb", "a\nb", "a/b", "\u202egnp", "\x00", "\ud800",
           " ")  # fmt: skip
NAME = st.sampled_from(HOSTILE) | st.text(max_size=12)


def allowed(name: str) -> bool:
    try:
        check_name(name, [PAPER])
    except InputError:
        return False
    return True


def write(folder: Path, names: Sequence[str]) -> str:
    """Write the files of a comparison as far as they decide names; return what they are called."""
    called = stem(folder, names)
    for kind in KINDS:
        place = folder / f"{called}.{kind}"
        place.write_text(json.dumps({"names": names}) if kind == "json" else "", encoding="utf-8")
    (folder / called).mkdir(exist_ok=True)
    return called


@settings(max_examples=100)
@given(found=st.lists(st.lists(NAME, min_size=1, max_size=3), min_size=2, max_size=5))
@example(found=[["鲸鱼"], ["沙猫"]])
@example(found=[["own"], ["Own"], ["own.md"], ["OWN"]])
@example(found=[["own.md"], ["own"]])
@example(found=[["cafe\u0301"], ["café"], ["ﬁ"], ["fi"]])
@example(found=[["results.json"], ["x"]])
@example(found=[["a_b"], ["a-b"], ["<a b>"], ["<a;b>"], ["results"]])
def test_no_two_comparisons_share_a_file_on_any_disk(found: list[list[str]]) -> None:
    asked = {tuple(names): None for names in found if all(map(allowed, names))}
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        called = {names: write(folder, names) for names in asked}

        files = [(each, *(f"{each}.{kind}" for kind in KINDS)) for each in called.values()]
        folded = [unicodedata.normalize("NFKC", name).casefold() for own in files for name in own]
        assert len(folded) == len({*folded})
        assert {names: write(folder, names) for names in asked} == called
        for each in called.values():
            assert re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9._-]{0,120}", each)
        assert not (folder / "results.json").exists()


def test_a_page_has_the_plain_name_of_its_search(tmp_path: Path) -> None:
    assert [write(tmp_path, [name]) for name in ("a_b", "a-b")] == ["a_b", "a-b"]


def test_files_of_somebody_else_under_a_name_are_left(tmp_path: Path) -> None:
    for kind in ("html", "CSV", "svg"):
        (tmp_path / f"own-{kind}.{kind}").write_text("somebody else's")
    (tmp_path / "own").mkdir()

    found = [stem(tmp_path, [name]) for name in ("own", "own-html", "own-CSV", "own-svg")]

    assert [name.rpartition("-")[0] for name in found] == ["own", "own-html", "own-CSV", "own"]


@pytest.fixture
def run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> Iterator[Run]:
    """Yield what compares one search under a name."""

    def command(name: str) -> tuple[int, str, str]:
        options = ("--runs", "1", "--workers", "1", "--quiet", "--no-centre-bias")
        code = main(("compare", "mine:centre", f"--name={name}", *options))
        return (code, *capfd.readouterr())

    with standing_in(tmp_path, monkeypatch, module=MODULE, paper=PAPER):
        yield command


def test_a_page_is_whole_whatever_its_search_is_called(run: Run) -> None:
    name = f"-- 鲸鱼 $(touch x); `touch x` '\"|& {'.' * 99}"

    code, out, _ = run(name)

    page = Path(out.removeprefix("page: ").strip())
    links = re.findall(r'(?:href|src)="(?!#|data:|http)([^"]+)"', page.read_text())
    assert code == 0
    assert page.parent == Path("reports-private")
    assert len(links) > 3
    assert all((page.parent / unquote(link)).is_file() for link in links)
    assert json.loads(page.with_suffix(".json").read_text())["names"] == [name]
    assert {path.name for path in Path().iterdir()} <= {".repro", "mine.py", "reports-private",
                                                         "__pycache__"}  # fmt: skip


def test_no_name_of_a_search_is_markup_a_link_or_a_formula(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    let_be_trusted(monkeypatch)
    found = {}
    for name in ("x", '"><img src=x onerror=alert(1)>', "[x](javascript:alert(1))", "a\\|b`c`*d*",
                 "{{ 7 * 7 }}{% raw %}", "=1+1", "$\\frac{$_^"):  # fmt: skip
        code, out, err = run(name)
        page = Path(out.removeprefix("page: ").strip())
        found[name] = tags(page.read_text())

        assert code == 0, err
        assert found[name] == found["x"], name
        assert name in html.unescape(page.read_text()), name
        twin = page.with_suffix(".md").read_text()
        assert not re.search(r"\]\(javascript:|<img|<script", twin), name
        assert "&amp;lt;" not in twin, name
        assert ragged(twin) == [], name
        column = pd.read_csv(page.with_suffix(".csv"))["algorithm"]
        assert {*column} == {csv_value(name)}


@pytest.mark.parametrize("name", ["a\nb", "", " ", "a/b", "\x1b[2J"])
def test_a_name_that_cannot_be_shown_is_one_line(run: Run, name: str) -> None:
    code, out, err = run(name)

    assert (code, out, err.count("\n")) == (2, "", 1)
    assert err.startswith("repro: the name ")
