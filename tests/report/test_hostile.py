"""Fuzzing with hostile strings: no traceback, no hang, no injection."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.damages import LONG
from tests.hostile import COLUMNS, STRINGS, check_pages, check_store, check_table

pytestmark = pytest.mark.faults
PIECES = st.sampled_from(
    [*STRINGS, "|", "||", "\n", " ", "–", "−", "[", "]", "[s]", "[deg]", "×10^", "π", "/", "1", "-"]
)
ANY_TEXT = st.text(st.characters(exclude_categories=["Cs"]))
TEXT = st.lists(PIECES | ANY_TEXT, max_size=30).map("".join)
LINE = st.lists(PIECES.filter(lambda piece: piece != "\n"), max_size=9).map("".join)
PAGE = st.lists(LINE, min_size=3, max_size=6).map(
    lambda lines: "Table 1, p. 2\n" + "\n".join(lines)
)
VALUE = TEXT | st.binary(max_size=60) | st.floats() | st.integers(-(2**63), 2**63 - 1) | st.none()


@settings(max_examples=20_000 if LONG else 300)
@given(TEXT | PAGE)
def test_any_text_is_a_table_or_refused(text: str) -> None:
    check_table(text)


@settings(max_examples=2_000 if LONG else 40)
@given(st.sampled_from(COLUMNS), VALUE, st.integers(1, 6))
def test_any_value_in_a_store_is_named_and_changes_no_record(
    column: str, value: str | bytes | float | None, number: int
) -> None:
    check_store(column, value, number)


@pytest.mark.parametrize("text", STRINGS)
def test_no_known_attack_reaches_a_page(text: str) -> None:
    check_pages(text)


@settings(max_examples=200 if LONG else 5)
@given(TEXT.filter(str.isprintable))
def test_no_text_reaches_a_page_as_markup(text: str) -> None:
    check_pages(text)
