import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from scipy.stats import mannwhitneyu, rankdata, wilcoxon

from repro.audit import AuditRow, Grade, audit
from repro.errors import DeclarationError
from repro.model.claims import Sentence
from repro.model.measures.measure import Rank, Statistic
from repro.model.tolerances import Absolute
from repro.robotics import Convention, forward_kinematics
from repro.tables.digit_slips import slips
from repro.tables.published import Printed, PublishedTable
from repro.tables.relations import (
    AverageRank,
    EqualSpacing,
    InRange,
    Less,
    PercentLower,
    PrintedPoses,
    PValues,
    RankTest,
    Relation,
    SameNumbers,
    TableCell,
    TextNumber,
    row_sums,
)
from tests.summaries import fixed, paper_of

BLOCK = {"A": {"mean": "2.000", "std": "1.000"}}
TIMES = PublishedTable.read("""
    Table 9, p. 9
    method || first [s] | second [s] | total [s]
    slow   || 4.25      | 3.75       | 8.00
    quick  || 3.150     | 2.85       | 6.00
""")


def text(number: str, unit: str = "s") -> TextNumber:
    return TextNumber(printed=Printed(number, unit), where="section 9")


def rows_of(*relations: Relation) -> tuple[AuditRow, ...]:
    return audit(paper_of(BLOCK, n=30, relations=relations))


def table_of(head: str, body: str) -> PublishedTable:
    return PublishedTable.read(f"Table 9, p. 9\n{head}\n{body}")


@given(
    addends=st.lists(st.floats(0.0, 100.0), min_size=2, max_size=6),
    decimals=st.integers(1, 3),
    cut_off=st.booleans(),
)
def test_a_true_sum_is_never_inconsistent(
    *, addends: list[float], decimals: int, cut_off: bool
) -> None:
    numbers = [fixed(value, decimals, cut_off=cut_off) for value in addends]
    total = fixed(math.fsum(addends), decimals, cut_off=cut_off)
    head = "row || " + " | ".join(f"c{i}" for i in range(len(numbers))) + " | total"
    table = table_of(head, f"r || {' | '.join(numbers)} | {total}")
    columns = tuple(f"c{i}" for i in range(len(numbers)))
    assert rows_of(*row_sums(table, total="total", addends=columns)) == ()


def test_a_sum_that_is_off_is_shown_with_the_slip_that_explains_it() -> None:
    table = table_of("row || a | b | total", "r || 4.25 | 3.57 | 8.00")
    (row,) = rows_of(*row_sums(table, total="total", addends=("a", "b")))
    assert (row.check, row.grade, row.row, len(row.cells)) == ("sum", "inconsistent", None, 3)
    assert "4.25 + 3.57 = 7.82" in row.explanation
    assert "3.75 for 3.57 (two neighbouring digits exchanged)" in row.explanation


def test_a_difference_that_fits_gives_no_row_and_one_that_does_not_gives_one() -> None:
    fits = Less(printed=text("1.85"), before=text("8.00"), after=text("6.15"))
    (row,) = rows_of(fits, Less(printed=text("1.45"), before=text("8.00"), after=text("6.15")))
    assert (row.check, row.table) == ("difference", "section 9")
    assert "1.85 for 1.45 (one digit changed)" in row.explanation


@given(st.from_regex(r"[1-9][0-9]\.[0-9]{2}", fullmatch=True), st.data())
def test_every_lost_changed_or_exchanged_digit_is_found_again(
    meant: str, data: st.DataObject
) -> None:
    place = data.draw(st.sampled_from([0, 1, 3, 4]))
    digit = data.draw(st.sampled_from("0123456789"))
    changed = meant[:place] + digit + meant[place + 1 :]
    exchanged = meant[:3] + meant[4] + meant[3]
    for printed in (changed, exchanged, meant[:3] + meant[4]):
        assert meant in {slip.meant.text for slip in slips(Printed(printed))} | {printed}


def test_a_percentage_that_fits_another_pair_of_the_column_names_it() -> None:
    cell = {row: TableCell(table=TIMES, row=row, column="first") for row in TIMES.row_names}
    total = {row: TableCell(table=TIMES, row=row, column="total") for row in TIMES.row_names}
    fits = PercentLower(printed=text("25", "%"), before=total["slow"], after=total["quick"])
    wrong = PercentLower(printed=text("26", "%"), before=cell["quick"], after=cell["slow"])
    (row,) = rows_of(fits, wrong)
    assert (row.check, row.grade) == ("percentage", Grade.INCONSISTENT)
    assert "(4.25 − 3.150)/4.25 = 25.882 % from slow to quick" in row.explanation


@given(st.lists(st.lists(st.integers(0, 9), min_size=4, max_size=4), min_size=1, max_size=15))
def test_true_average_ranks_are_never_inconsistent(values: list[list[int]]) -> None:
    ranks = np.mean([rankdata(row) for row in values], axis=0)
    lines = [f"F{i} || " + " | ".join(map(str, row)) for i, row in enumerate(values)]
    lines.append("average || " + " | ".join(fixed(rank, 4) for rank in ranks))
    lines.append("total || " + " | ".join(str(int(r)) for r in rankdata(ranks, method="min")))
    assume(len({*ranks}) == len(ranks))
    table = table_of("F || A | B | C | D", "\n".join(lines))
    rows = tuple(f"F{i}" for i in range(len(values)))
    assert rows_of(_average_rank(table, rows)) == ()


def test_two_cells_that_changed_places_are_found_from_the_average_ranks() -> None:
    table = table_of(
        "F || A | B | C | D",
        """F0      || 1   | 2   | 3   | 4
           F1      || 7   | 5   | 1   | 9
           F2      || 2   | 4   | 6   | 8
           average || 1.0 | 2.0 | 3.0 | 4.0
           total   || 1   | 3   | 2   | 4""",
    )
    ranks, *totals = rows_of(_average_rank(table, ("F0", "F1", "F2")))
    assert (ranks.check, len(ranks.cells)) == ("average-rank", 2)
    assert ranks.explanation.endswith("the cells of A and C in F1 change places")
    assert [row.cells[0]["column"] for row in totals] == ["B", "C"]


def _average_rank(table: PublishedTable, rows: tuple[str, ...]) -> AverageRank:
    columns = table.column_names
    return AverageRank(table=table, rows=rows, columns=columns, average="average", total="total")


@pytest.mark.parametrize("n", [5, 15, 30])
@pytest.mark.parametrize("test", ["rank-sum", "signed-rank"])
def test_only_p_values_below_that_of_separated_samples_are_impossible(
    n: int, test: RankTest
) -> None:
    low, high = np.arange(n), np.arange(n) + 1000.0**2
    exact = (
        mannwhitneyu(low, high, method="exact").pvalue
        if test == "rank-sum"
        else wilcoxon(low - high**1.5, method="exact").pvalue
    )
    least = min(exact, _tied(n, test))
    numbers = tuple(text(f"{share * least:.3e}", "") for share in (0.9, 1.1))
    rows = rows_of(PValues(numbers=numbers, test=test, n=n))
    impossible = [row for row in rows if row.grade is Grade.IMPOSSIBLE]
    assert [row.explanation.split()[4] for row in impossible] == [numbers[0].printed.text]


def _tied(n: int, test: RankTest) -> float:
    """Return the normal approximation for samples that are separated and constant."""
    zeros, ones = np.zeros(n), np.ones(n)
    if test == "rank-sum":
        options = {"method": "asymptotic", "use_continuity": False}
        return float(mannwhitneyu(zeros, ones, **options).pvalue)
    return float(wilcoxon(ones, method="asymptotic", correction=False).pvalue)


def test_unequal_steps_and_numbers_outside_their_range_are_inconsistent() -> None:
    even = tuple(text(each) for each in ("0", "11.3", "22.5", "33.8"))
    uneven = (*even[:3], text("34.8"))
    limits = {"low": text("-5"), "high": text("5")}
    rows = rows_of(
        EqualSpacing(numbers=even),
        EqualSpacing(numbers=uneven),
        InRange(value=text("5.2"), **limits),
        InRange(value=text("6.2"), **limits),
    )
    assert [row.check for row in rows] == ["spacing", "range"]
    assert "6.2" in rows[1].explanation


def test_series_that_agree_are_noted_with_what_follows() -> None:
    one, other = (text("1.5"), text("2.5")), (text("1.5"), text("2.6"))
    same = SameNumbers(first=one, second=one, meaning="the limits are the peaks")
    (row,) = rows_of(same, SameNumbers(first=one, second=other, meaning="not these"))
    assert row.grade is Grade.NOTED
    assert row.explanation.endswith("the limits are the peaks")


def _poses(length: float, convention: Convention) -> PrintedPoses:
    """Return tables of a three-joint arm whose first d is printed as 0.300 instead of `length`."""
    dh = [(0.1, math.pi / 2, length), (0.5, 0.0, 0.0), (0.4, 0.0, 0.05)]
    waypoints = {"P": (0.3, -0.7, 1.1), "Q": (-1.2, 0.4, 0.9)}
    lines = [f"{i + 1} || {a:.3f} | {alpha:.4f} | {d:.3f}" for i, (a, alpha, d) in enumerate(dh)]
    lines[0] = lines[0].replace(f"{length:.3f}", "0.300")
    joints = [
        f"{i + 1} || " + " | ".join(fixed(q[i], 4) for q in waypoints.values()) for i in range(3)
    ]
    places = [(name, forward_kinematics(dh, q, convention)[:3, 3]) for name, q in waypoints.items()]
    return PrintedPoses(
        dh=table_of("i || a [m] | alpha [rad] | d [m]", "\n".join(lines)),
        a="a",
        alpha="alpha",
        d="d",
        joints=table_of("i || P [rad] | Q [rad]", "\n".join(joints)),
        positions=table_of(
            "point || x [m] | y [m] | z [m]",
            "\n".join(f"{name} || " + " | ".join(fixed(c, 4) for c in p) for name, p in places),
        ),
    )


@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_poses_that_follow_in_one_convention_give_no_row(convention: Convention) -> None:
    assert rows_of(_poses(0.3, convention)) == ()


@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_a_wrong_link_is_named_with_the_length_that_closes_the_gap(convention: Convention) -> None:
    (row,) = rows_of(_poses(0.307, convention))
    assert f"In the {convention} convention" in row.explanation
    assert "d of joint 1 = 0.307 instead of 0.300 m" in row.explanation
    assert "every coordinate would then agree" in row.explanation


def test_a_rank_in_the_text_is_inconsistent_only_where_the_table_forbids_it() -> None:
    blocks = {"A": {"mean": "2.00", "std": "0.50"}, "B": {"mean": "2.0", "std": "0.40"}}
    claims = [
        Sentence(
            claim=f"A has place {rank} by its {name}",
            where="section 9",
            printed=Printed(rank, "rank"),
            measure=Rank(of=_statistic(name), among=("A", "B")),
            accepted=Absolute(0),
        )
        for name, rank in (("mean", "1"), ("mean", "2"), ("std", "1"), ("std", "2"))
    ]
    (row,) = audit(paper_of(blocks, n=30, claims=claims))
    assert row.check == "rank-in-text"
    assert row.cells == ({"row": "std", "column": "A"}, {"row": "std", "column": "B"})


def test_a_number_of_the_text_is_compared_with_its_cell() -> None:
    claims = [
        Sentence(
            claim="the mean",
            where="section 9",
            printed=Printed(number),
            measure=_statistic("mean"),
            accepted=Absolute(0),
        )
        for number in ("2.0", "2.1")
    ]
    (row,) = audit(paper_of(BLOCK, n=30, claims=claims))
    assert (row.check, row.row, row.column, row.cells) == ("number-in-text", "mean", "A", ())
    assert "2.1" in row.explanation


def _statistic(name: str) -> Statistic:
    return Statistic(experiment="test", problem="F", algorithm="A", statistic=name)


def test_a_relation_on_a_cell_that_is_not_there_is_refused() -> None:
    with pytest.raises(DeclarationError, match="no column 'third'"):
        TableCell(table=TIMES, row="slow", column="third")
    with pytest.raises(DeclarationError, match="no row 'mean'"):
        AverageRank(table=TIMES, rows=("slow",), columns=("first",), average="mean")
    with pytest.raises(DeclarationError, match="series of 1 and 0"):
        SameNumbers(first=(text("1"),), second=(), meaning="nothing")


def test_an_offset_of_a_joint_that_the_table_prints_is_told() -> None:
    plain = _poses(0.3, "standard")
    offset = Printed("-1.2", "rad")
    rows = [
        f"{joint} || "
        + " | ".join(
            fixed(plain.joints[joint, name].value + (1.2 if joint == "2" else 0.0), 4)
            for name in plain.joints.column_names
        )
        for joint in plain.joints.row_names
    ]
    moved = replace(plain, joints=table_of("i || P [rad] | Q [rad]", "\n".join(rows)))
    zero = Printed("0", "rad")

    assert rows_of(plain) == ()
    assert [row.check for row in rows_of(moved)] == ["poses"]
    assert rows_of(replace(moved, offsets=(zero, offset, zero))) == ()
