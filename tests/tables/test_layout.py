import pytest

from repro.tables.gathered import Gathered, gathered
from repro.tables.headings import heads_runs, statistics_in
from repro.tables.texts import tables_in

RANK_FIRST = """| Rank | Algorithm | Best | Mean |
|---|---|---|---|
| 1 | GA | 10 | 12 |
| 2 | PSO | 11 | 13 |
"""
BUDGETS = r"""\begin{tabular}{llll}
 & & $f_{1}$ & $f_{2}$ \\
Budget & Category & & \\ \midrule
\multirow{3}{*}{1.0e+03} & Best & 1.5 & 2.5 \\
 & Mean & 1.6 & 2.6 \\
 & Std & 0.1 & 0.2 \\
\multirow{3}{*}{2.0e+03} & Best & 0.5 & 1.5 \\
 & Mean & 0.6 & 1.6 \\
 & Std & 0.1 & 0.2 \\
\end{tabular}
"""


def read(text: str) -> Gathered:
    (grid,) = tables_in(text)
    return gathered(grid, "")


def said(text: str) -> set[tuple[str, str, str, str]]:
    entries = read(text).entries
    return {(e.problem, e.algorithm, e.statistic, e.number.printed.text) for e in entries}


def test_names_that_stand_right_of_a_column_of_ranks_name_their_lines() -> None:
    assert ("", "PSO", "mean", "13") in said(RANK_FIRST)
    assert ("", "PSO", "rank", "2") in said(RANK_FIRST)
    assert {(e.i, e.j) for e in read(RANK_FIRST).entries if e.statistic == "mean"} == {
        (1, 3),
        (2, 3),
    }


def test_all_columns_up_to_one_of_names_of_statistics_are_labels() -> None:
    found = said(BUDGETS)

    assert ("f_1", "1.0e+03", "best", "1.5") in found
    assert ("f_2", "2.0e+03", "std", "0.2") in found
    assert len(read(BUDGETS).entries) == 12


@pytest.mark.parametrize("heading", ["Jumlah Run", "num_runs", "Number of runs", "Total runs"])
def test_a_column_of_numbers_of_runs_is_known(heading: str) -> None:
    assert heads_runs(heading)


def test_words_of_statistics_in_a_few_names_of_algorithms_are_no_statistics() -> None:
    text = "Algorithm,F1,F2\nGA,1.0(0.1),2.0(0.2)\nPSO,1.1(0.1),2.1(0.2)\nBest-of-two,1.0(0),2(0)\n"

    assert ("F1", "Best-of-two", "mean", "1.0") in said(text)


@pytest.mark.parametrize(
    "name", ["DE/current-to-best/1", "DE_best_1", "DE/best/1/bin", "Max-Min AS"]
)
def test_names_of_variants_beside_headings_of_statistics_stay_names(name: str) -> None:
    text = f"Function,{name} Mean,{name} Std\nF1,1.0,0.1\nF2,2.0,0.2\n"

    assert {(algorithm, statistic) for _, algorithm, statistic, _ in said(text)} == {
        (name, "mean"),
        (name, "std"),
    }


def test_numbers_that_count_lines_or_vary_beside_statistics_alone_are_labels() -> None:
    counted = "fid,A,B\n1,0.5,0.7\n2,0.6,0.8\n3,0.1,0.9\n"
    varied = "Penalty,Mean,Std\n1,0.5,0.1\n10,0.6,0.1\n100,0.7,0.2\n"

    assert ("2", "B", "value", "0.8") in said(counted)
    assert ("10", "", "mean", "0.6") in said(varied)


def test_a_sign_of_percent_behind_a_statistic_names_no_algorithm() -> None:
    found = said("F,Mean,SR %\nF1,1.5,100%\nF2,2.5,90%\n")

    assert ("F1", "", "success rate", "100%") in found


def test_what_a_heading_says_beside_its_statistic_has_single_spaces() -> None:
    assert statistics_in("Average number of function evaluations")[1] == "number evaluations"
