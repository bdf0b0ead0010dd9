import pytest

from repro.tables.audit_options import AuditOptions
from repro.tables.auditing import AuditedTable, audit_text

LINES = "Algorithm,F1,F2,F3,F4,Sum\nPSO rank,1,2,1,2,{sum}\nGWO rank,2,1,2,1,6\n"
TITLED = """Ranks
Function,PSO,GWO
F1,1,2
F2,2,1
F3,1,2
F4,2,1
Total,{sum},6
"""
VALUES = """Function,Index,A,B,C
F1,Mean,{first},1.40E+03,1.40E+03
F1,Rank,2,1,3
F2,Mean,1.401E+03,1.4E+03,1.40E+03
F2,Rank,3,2,1
F3,Mean,0,0,1.400E+03
F3,Rank,1,1,3
,Average rank,2.00,1.33,2.33
"""
ACROSS = """Function,A mean,A rank,B mean,B rank
F1,1.0,{first},2.0,2
F2,3.0,1,4.0,2
"""
PLACES = """Function,PSO rank,GWO rank,WOA rank
F1,1,2,3
F2,2,1,3
F3,1,2,3
Average rank,1.33,1.67,3.00
{heading},{places}
"""


def audited(text: str, options: AuditOptions | None = None, **told: str) -> AuditedTable:
    (table,) = audit_text(text.format(**told), options or AuditOptions())
    return table


def said(table: AuditedTable) -> list[str]:
    return [row.explanation for row in table.rows if row.check != "repeat"]


@pytest.mark.parametrize("text", [LINES, TITLED])
def test_whole_ranks_add_up_exactly_in_either_orientation(text: str) -> None:
    right, wrong = audited(text, sum="6"), audited(text, sum="7")

    assert said(right) == []
    assert said(wrong) == ["the 4 printed ranks of PSO have the sum 6; printed is 7"]
    assert right.checked == right.cells == 10


def test_ranks_that_unequal_digits_may_hide_are_no_contradiction() -> None:
    assert said(audited(VALUES, first="1.4003E+03")) == []


def test_ranks_that_no_rounding_allows_are_found() -> None:
    (says,) = said(audited(VALUES, first="1.0E+03"))

    assert "A 1.0E+03 has rank 1, printed 2" in says


def test_ranks_beside_their_values_are_checked_across() -> None:
    assert said(audited(ACROSS, first="1")) == []
    assert len(said(audited(ACROSS, first="2"))) == 1


def test_greatest_values_may_be_first_unless_the_sense_is_told() -> None:
    text = ACROSS.replace("{first},2.0,2", "2,2.0,1").replace("3.0,1,4.0,2", "3.0,2,4.0,1")

    assert said(audited(text)) == []
    assert len(said(audited(text, AuditOptions(maximise=False)))) == 2


@pytest.mark.parametrize("heading", ["Overall rank", "Final rank"])
def test_a_last_line_may_hold_places(heading: str) -> None:
    assert said(audited(PLACES, heading=heading, places="1,2,3")) == []

    wrong = said(audited(PLACES, heading=heading, places="2,1,3"))

    assert [words.partition(" has place ")[0] for words in wrong] == ["1.33 of PSO", "1.67 of GWO"]


def test_ranks_among_more_than_are_printed_are_left_alone() -> None:
    assert said(audited(ACROSS, first="7")) == []


def test_numbers_under_a_title_of_ranks_that_are_none_stay_unread() -> None:
    table = audited(TITLED.replace("F1,1,2", "F1,1,2.7"), sum="7")

    assert said(table) == []
    assert table.checked == 0


ALONE = "f_id,A,B,C,D\n1,{first},2,3,4\n2,2,1,3,4\n3,1.5,1.5,3,4\n4,4,3,2,1\n"


@pytest.mark.parametrize(
    ("first", "says"),
    [
        ("1", []),
        ("3", ["3, 2, 3, 4 are no ranks of 4, whichever way ties are ranked"]),
        ("1.5", ["1.5, 2, 3, 4 are no ranks of 4, whichever way ties are ranked"]),
    ],
)
def test_a_row_of_ranks_without_values_is_one_of_that_many(first: str, says: list[str]) -> None:
    (table,) = audit_text(ALONE.format(first=first), AuditOptions(), file="x/ranks_of_all.csv")

    assert [row.explanation for row in table.rows] == says
    assert table.checked == table.cells == 16


def test_ranks_among_more_than_are_printed_are_not_held_to_be_of_these() -> None:
    text = "Ranks\nF,A,B,C\nF1,1,3,3\nF2,1,2,3\nF3,2,3,1\nF4,1,3,3\nF5,3,3,1\n"

    assert said(audited(text)) == []


BELOW = r"""\begin{{tabular}}{{lrrr}}
 & A & B & C \\
F01 & 0.5 & 2.5 & 1.5 \\
F02 & 0.5 & 1.5 & 2.5 \\
F03 & 0.1 & 1.1 & 2.1 \\
Rank & {first} & 2.33 & 2.67 \\
\end{{tabular}}
"""
LISTED = "algorithm,mean_rank\nA,{first}\nB,2.33\nC,2.67\n"


@pytest.mark.parametrize("text", [BELOW, LISTED])
def test_average_ranks_alone_have_the_sum_of_the_places(text: str) -> None:
    (row,) = audited(text, first="1.20").rows

    assert audited(text, first="1.00").rows == ()
    assert row.explanation == "1.20 + 2.33 + 2.67 = 6.2; the average ranks of 3 have the sum 6"
    assert row.condition == "just these are ranked, and ties share the mean of their places"


def test_ranks_that_stand_twice_under_one_name_are_not_counted_as_checked() -> None:
    table = audited("Rank,Algorithm,Mean\n1,GA,1.5\n2,GA,1.6\n3,PSO,1.7\n")

    assert (table.cells, table.checked) == (6, 3)


def test_places_may_share_the_last_or_the_mean_of_them() -> None:
    lines = ("F,GWO,PSO,DE", "F1 Rank,1,2,3", "F2 Rank,2,1,3", "Average rank,1.5,1.5,3")
    last, mean = ("\n".join([*lines, f"Final rank,{places}"]) for places in ("2,2,3", "1.5,1.5,3"))

    assert said(audited(last)) == said(audited(mean)) == []
    assert len(said(audited(last.replace("2,2,3", "3,2,2")))) == 1


@pytest.mark.parametrize(
    "text",
    [
        "F,A,B,C\nF1,1,2,3\nF2,1,2,3\nF3,2,1,3\nF4,3,1,2\nSum of ranks,7,6,{}\n",
        (
            "F,A,rank,B,rank,C,rank\nF1,.1,1,.2,2,.3,3\nF2,.1,1,.2,2,.3,3\nF3,.2,2,.1,1,.3,3\n"
            "F4,.3,3,.1,1,.2,2\nTotal rank,,7,,6,,{}\n"
        ),
    ],
)
def test_sums_of_ranks_are_exact_wherever_the_ranks_stand(text: str) -> None:
    (right,) = audit_text(text.format(11), AuditOptions())
    (wrong,) = audit_text(text.format(12), AuditOptions())

    assert (right.rows, right.checked) == ((), right.cells)
    assert ["printed is 12" in row.explanation for row in wrong.rows] == [True]
    assert not any("not checked" in guess.says for guess in right.guesses)
