import math
import re
import shlex

import pytest

from repro.judge.verdict import Unseen, Verdict
from repro.model.identifiers import anchor, identifiers
from repro.report.words import (
    MEANINGS,
    SYMBOLS,
    again_command,
    could_be_off,
    counted,
    difference,
    digits_for,
    interval,
    markdown_cell,
    number,
    raised,
    share,
    verdict_words,
)
from repro.tables.published import Printed


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (None, "–"),
        (math.nan, "–"),
        (math.inf, "–"),
        (0.0, "0"),
        (5.0, "5"),
        (2.33951, "2.340"),
        (44791.6, "44792"),
        (9999.96, "10000"),
        (1e-5, "1.000×10^-5"),
        (2e9, "2.000×10^9"),
    ],
)
def test_numbers_have_four_digits_and_written_powers(value: float | None, text: str) -> None:
    assert number(value) == text


def test_a_reproduced_number_shows_one_digit_more_than_the_printed_one() -> None:
    assert digits_for(Printed("2.344")) == 5
    assert digits_for(Printed("0.1")) == 4
    assert digits_for(Printed("7.294×10^-287")) == 5


def test_an_interval_of_equal_digits_is_one_number() -> None:
    assert interval((1.00001, 1.00002)) == "1.000"
    assert interval((1.0, 2.0)) == "1 … 2"
    assert interval(None) == "–"


def test_an_end_that_is_not_there_is_infinite() -> None:
    assert interval((-math.inf, 2.0)) == "−∞ … 2"
    assert interval((0.0, math.inf)) == "0 … ∞"


def test_every_verdict_has_a_symbol_of_its_own_and_a_meaning() -> None:
    assert set(SYMBOLS) == set(MEANINGS) == set(Verdict)
    assert len(set(SYMBOLS.values())) == len(Verdict)


@pytest.mark.parametrize(
    ("factor", "words"),
    [
        (3.2, "the number could be off by a factor of 3.20 unseen"),
        ("unbounded", "nothing bounds by how much the number could be off unseen"),
    ],
)
def test_how_far_a_consistent_number_could_be_off_is_said(factor: Unseen, words: str) -> None:
    assert could_be_off(factor) == words


def test_a_statement_in_words_is_off_by_no_factor() -> None:
    assert could_be_off(2.0, in_words=True) == "other tables of such runs go against the statement"


@pytest.mark.parametrize(
    ("group", "others", "words"),
    [
        (None, 0, "input or true by definition: shown, not counted"),
        ("limits", 0, ""),
        ("limits", 1, "counts once with 1 other: limits"),
        ("limits", 2, "counts once with 2 others: limits"),
    ],
)
def test_what_a_finding_counts_with_is_said(group: str | None, others: int, words: str) -> None:
    assert counted(group, others) == words


@pytest.mark.parametrize(
    ("printed", "value", "text"),
    [
        ("4.69", 4.694, "as printed"),
        ("4.69", 4.478, "−4.5 %"),
        ("2.5", 10.0, "×4.00"),
        ("19.68", 19.6875, "+0.04 %"),
        ("1.0×10^-3", 1.0, "+3.0 decades"),
        ("0", 0.0, "as printed"),
        ("0", 1e-5, "+1.000×10^-5"),
        ("1", -1.0, "−2"),
        ("-100", -64.0, "+36.0 %"),
        ("-100", -136.0, "−36.0 %"),
        ("-2.5", -10.0, "−7.500"),
        ("-100", -1.0, "+99"),
    ],
)
def test_differences_are_in_percent_or_decades(printed: str, value: float, text: str) -> None:
    assert difference(Printed(printed), value) == text


def test_a_verdict_names_the_side() -> None:
    assert verdict_words("contradicted", "lower") == "✖ contradicted (re-run lower)"


def test_an_anchor_has_letters_digits_and_hyphens_only() -> None:
    assert anchor("Table II", "F1 Best", None, "IWOA") == "table-ii-f1-best-iwoa"


def test_powers_are_raised_and_markup_is_not_let_through() -> None:
    assert raised("<b> 2×10^-5") == "&lt;b&gt; 2×10<sup>−5</sup>"


def test_identifiers_are_all_different_whatever_the_names_are() -> None:
    places = [
        ("Table 1", "F1", "WOA"),
        ("Table 1", "F1", "WOA+"),
        ("claim", None, "鲸"),
        ("claim",),
    ]

    assert identifiers(places) == ["table-1-f1-woa", "table-1-f1-woa-2", "claim", "claim-2"]


@pytest.mark.parametrize(
    ("quantile", "words"),
    [
        (None, "–"),
        (0.0, "none of 2000 tables that may come next lies below the printed number"),
        (1.0, "all of 2000 tables that may come next lie below the printed number"),
        (0.25, "25.0 % of the tables that may come next lie below it"),
        (0.99975, "99.98 % of the tables that may come next lie below it"),
    ],
)
def test_a_quantile_is_said_as_a_share_of_tables(quantile: float | None, words: str) -> None:
    assert share(quantile, 2000) == words


@pytest.mark.parametrize("text", ["a | b", "<b>", "[x](javascript:alert)", "two\nlines"])
def test_text_in_a_markdown_cell_opens_nothing(text: str) -> None:
    safe = markdown_cell(text)

    assert not re.search(r"(?<!\\)\||<|\]\(|\n", safe)
    assert "&amp;" not in raised(safe)


@pytest.mark.parametrize("seed", ["", "2", "two words", "'; rm -r ~"])
def test_what_is_to_be_typed_names_the_master_seed_as_one_word(seed: str) -> None:
    typed = again_command("doe2021", "", "table-2-f1-mean-woa", seed)

    words = ["nox", "-s", "again", "--", "doe2021", "table-2-f1-mean-woa"]
    assert shlex.split(typed) == words + (["--master-seed", seed] if seed else [])


def test_a_paper_from_elsewhere_is_run_by_the_command_and_its_path() -> None:
    typed = again_command("mine", "./my papers/mine.py", "table-1-f1-best-woa", "")

    assert shlex.split(typed) == ["repro", "again", "./my papers/mine.py", "table-1-f1-best-woa"]
