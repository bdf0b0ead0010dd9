import pytest

from repro.errors import DeclarationError
from repro.model.cells import computed_cells, every_cell
from repro.model.claims import CellClaim, Sentence, lowest_everywhere, says, says_in_words
from repro.model.measures.measure import Computed, Statistic
from repro.model.open_points import Gap
from repro.model.tolerances import Absolute, Between, Percent
from repro.tables.published import Printed, PublishedTable
from tests.small_papers import CLAIMS, EXPERIMENT, PAPER, TABLE

MIXED = PublishedTable.read("""
    Table 2, p. 4
    statistic | guess | winner [text] | wide
    Mean      | 0.05  | guess         | 0.5
    Std       | 0.02  | guess         | 0.4
""")


def measured(claim: CellClaim) -> Statistic:
    assert isinstance(claim.measure, Statistic)
    return claim.measure


def test_every_cell_claims_each_number_once_in_the_order_of_the_page() -> None:
    assert [(claim.row, claim.column) for claim in CLAIMS] == list(TABLE.places())
    assert [claim.printed.text for claim in CLAIMS] == ["0.05", "0.5", "0.02", "0.4"]


def test_headings_say_what_a_cell_measures() -> None:
    assert measured(CLAIMS[3]) == Statistic(
        experiment="search", problem="bowl", algorithm="wide", statistic="std"
    )


def test_printed_headings_are_translated_and_completed() -> None:
    claims = every_cell(
        MIXED,
        of=EXPERIMENT,
        rows=("statistic",),
        columns="algorithm",
        given={"problem": "bowl", "quantity": "total"},
        names={"Mean": "mean", "Std": "std"},
        within=Percent(1),
        std_within=Percent(9),
    )

    assert [claim.column for claim in claims] == ["guess", "wide"] * 2  # words are no numbers
    assert {measured(claim).quantity for claim in claims} == {"total"}
    assert [claim.accepted for claim in claims] == [Percent(1)] * 2 + [Percent(9)] * 2


def test_only_keeps_the_named_rows() -> None:
    claims = every_cell(
        TABLE,
        of=EXPERIMENT,
        rows=("problem", "statistic"),
        columns="algorithm",
        within=Percent(1),
        only=("bowl std",),
    )

    assert {claim.row for claim in claims} == {"bowl std"}


@pytest.mark.parametrize(
    ("old", "new", "fault"),
    [
        ("bowl ", "ball ", "row 'ball mean', column 'guess': problem 'ball' is none of bowl"),
        ("wide", "far", "row 'bowl mean', column 'far': algorithm 'far' is none of guess, wide"),
        ("std", "Std", "column 'guess': statistic 'Std' is none of best, worst, mean, std"),
    ],
)
def test_heading_that_names_nothing_is_refused_with_the_alternatives(
    old: str, new: str, fault: str
) -> None:
    page = """
        Table 3, p. 5
        problem | statistic || guess | wide
        bowl    | mean      || 0.05  | 0.5
                | std       || 0.02  | 0.4
    """

    with pytest.raises(DeclarationError, match="Table 3, row") as error:
        every_cell(
            PublishedTable.read(page.replace(old, new)),
            of=EXPERIMENT,
            rows=("problem", "statistic"),
            columns="algorithm",
            within=Percent(1),
        )

    assert fault in str(error.value)


def test_roles_that_are_not_one_per_row_heading_are_refused() -> None:
    with pytest.raises(DeclarationError, match=r"Table 1 has the row headings .*'statistic'"):
        every_cell(TABLE, of=EXPERIMENT, rows=("problem",), columns="algorithm", within=Percent(1))


def test_computed_cells_are_measured_by_what_their_place_gives() -> None:
    def measure(row: str, column: str) -> Computed:
        return Computed(how=f"{row}, {column}", value=lambda: 1.0)

    claims = computed_cells(MIXED, measure=measure, within=Absolute(0), only=("Std",))

    assert [claim.measure and claim.measure.words for claim in claims] == [
        "Std, guess",
        "Std, wide",
    ]


def test_lowest_everywhere_claims_the_first_rank_on_each_problem() -> None:
    (claim,) = lowest_everywhere(
        EXPERIMENT, algorithm="guess", statistic="mean", claim="guessing wins", where="p. 4"
    )

    assert claim.claim == "guessing wins, on bowl"
    assert (claim.printed, claim.accepted) == (Printed("1", "rank"), Between(1, 1))
    assert claim.measure is not None
    assert claim.measure.cells() == (("search", "bowl", "guess"), ("search", "bowl", "wide"))


@pytest.mark.parametrize("both", [True, False])
def test_sentence_has_either_a_measure_or_a_gap(both: bool) -> None:  # noqa: FBT001
    gap = Gap(what="the arm", where="p. 9", because="it is not here")
    measure = Computed(how="one", value=lambda: 1.0)

    with pytest.raises(DeclarationError, match="claim 'it works' needs either a measure or a Gap"):
        Sentence(
            claim="it works",
            where="p. 9",
            printed=Printed("1"),
            measure=measure if both else None,
            gap=gap if both else None,
            accepted=Absolute(0),
        )


def test_cell_stands_where_its_table_stands() -> None:
    assert CLAIMS[0].where == "Table 1, p. 3 (3 runs)"
    assert CLAIMS[0].place == ("Table 1", "bowl mean", "guess")
    assert PAPER.claims == CLAIMS


def test_sentence_of_words_shows_no_number_and_keeps_what_it_comes_closest_to() -> None:
    measure = Computed(how="one", value=lambda: 1.0)

    number = says("it takes 5 s", "p. 9", Printed("5", "s"), measure, within=Absolute(0))
    words = says_in_words("it wins", "p. 9", "1 rank", measure, within=Between(1, 1))

    assert (number.printed, number.in_words) == (Printed("5", "s"), False)
    assert (words.printed, words.in_words) == (Printed("1", "rank"), True)


def test_sentence_that_cannot_be_measured_has_its_gap() -> None:
    gap = Gap(what="the arm", where="p. 9", because="it is not here")

    found = says("it works", "p. 9", Printed("5", "s"), gap, within=Absolute(0))

    assert (found.measure, found.gap) == (None, gap)
