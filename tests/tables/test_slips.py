"""Single slips that close a sum: every one, with their number."""

import re
from itertools import chain

from hypothesis import given
from hypothesis import strategies as st

from papers.syji import PAPER as SYJI
from repro.audit import Grade, audit
from repro.tables.arithmetic import IN_DOUBLES
from repro.tables.digit_slips import slips
from repro.tables.published import Printed
from repro.tables.relations import Less, Sum
from tests.tables.test_relations import rows_of, text


def explained(total: str, *addends: str) -> str:
    (row,) = rows_of(Sum(total=text(total), addends=tuple(map(text, addends))))
    return row.explanation


def test_every_single_slip_that_closes_the_durations_of_syji_is_listed_and_counted() -> None:
    (row,) = [row for row in audit(SYJI) if row.check == "sum"]
    exact, rounded = row.explanation.partition("off by 0.0495. ")[2].split("). ")
    assert exact.startswith("3 single slips, any one of them, would close it with the other")
    assert rounded.startswith("6 single slips, any one of them, would close it only with the")
    found = re.findall(r"([\d.]+) for ([\d.]+)", f"{exact} {rounded}")
    durations = ("0.2308", "0.845", "0.9166", "0.258")
    # by hand: what the others leave for each, exactly, is 0.2803, 0.8945, 0.9661, 0.3075
    assert {("0.2803", "0.2308"), ("0.8945", "0.845"), ("0.9661", "0.9166")} <= set(found)
    assert {printed for _, printed in found} <= {*durations, "2.2999"}
    assert len(found) == len(set(found)) == 9


def test_a_digit_too_many_and_an_exchange_of_distant_digits_close_a_sum() -> None:
    assert "1.25 for 1.225 (one digit too many)" in explained("3.75", "1.225", "2.50")
    assert "1.253 for 3.251 (two digits exchanged)" in explained("3.253", "3.251", "2.000")


def test_a_slip_that_needs_the_rounding_of_the_others_is_told_apart() -> None:
    found = explained("6.00", "1.2", "3.714")
    assert "4.714 for 3.714" in found.partition("only with the rounding of the others: ")[2]


@given(st.from_regex(r"[1-9][0-9]{0,2}(\.[0-9]{1,3})?", fullmatch=True))
def test_slips_are_numbers_each_once_and_never_the_printed_one(printed: str) -> None:
    found = [slip.meant.text for slip in slips(Printed(printed))]
    assert len(found) == len(set(found))
    assert printed not in found


@given(st.from_regex(r"[1-9][0-9]\.[0-9]{2}", fullmatch=True), st.integers(0, 4), st.data())
def test_a_digit_that_came_in_on_the_way_to_the_print_is_found_again(
    meant: str, place: int, data: st.DataObject
) -> None:
    digit = data.draw(st.sampled_from("0123456789"))
    printed = meant[:place] + digit + meant[place:]
    found = {slip.meant.text for slip in slips(Printed(printed))}
    assert meant in found | {printed}


def test_multiples_of_pi_have_no_slips() -> None:
    assert list(chain(slips(Printed("π/2", "rad")), slips(Printed("-3π/4", "rad")))) == []


def test_a_sum_or_difference_that_single_precision_may_miss_holds_for_doubles_only() -> None:
    sums = [
        Sum(total=text(total), addends=(text("10000000.1"), text("1.1")))
        for total in ("10000001.5", "10000099.5")
    ]
    less = Less(printed=text("10000000.5"), before=text("10000001.3"), after=text("1.1"))
    rows = rows_of(*sums, less)
    assert [row.condition for row in rows] == [IN_DOUBLES, None, IN_DOUBLES]
    assert {row.grade for row in rows} == {Grade.INCONSISTENT}
