"""The contract that every paper module meets, whatever it declares."""

import ast
import csv
import importlib
import re
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import pytest

from repro.errors import DeclarationError
from repro.model.claims import CellClaim
from repro.model.contract import contract_faults
from repro.model.experiment import Experiment
from repro.model.paper import Paper
from repro.runs.readings import claims_under, readings
from repro.tables.published import WORDS, Printed, PublishedTable
from tests.house import PAPERS

ROOT = Path(__file__).parents[2]
SECOND_READING = Path(__file__).parents[1] / "second_reading"

# Files of the second reading that no table of the paper module stands for, with the reason.
NOT_DECLARED = {
    ("liang2026", "table-i"): "formulas and boxes: code in repro.functions, misprints as errata",
    ("smwoa2022", "table-1"): "earlier work, no results",
}
# Columns of words that are left out of the comparison, with the reason.
NOT_COMPARED = {
    ("smwoa2022", "table-2", "Expression"): "formulas are for reading, not for comparing as text",
}

READ_TWICE = {key: paper for key, paper in PAPERS.items() if paper.read_twice}

each_paper = pytest.mark.parametrize("paper", PAPERS.values(), ids=PAPERS)
each_read_twice = pytest.mark.parametrize("paper", READ_TWICE.values(), ids=READ_TWICE)


def tables(paper: Paper) -> tuple[PublishedTable, ...]:
    return (*paper.inputs, *paper.results)


TABLES = {
    (key, re.sub(r"[^a-z0-9]+", "-", table.label.lower()).strip("-")): table
    for key, paper in PAPERS.items()
    if paper.read_twice
    for table in tables(paper)
}


def read(*path: str) -> list[list[str]]:
    with SECOND_READING.joinpath(*path).open(encoding="utf-8", newline="") as file:
        return list(csv.reader(file))


def plain(text: str) -> str:
    """Return a text without blanks, units, and marks of lower position."""
    return re.sub(r"\[.*?\]|[\s_{}()°]", "", text.replace("−", "-"))


def unit(heading: str) -> str:
    """Return the unit of a heading of the second reading as our tables write it."""
    printed = heading.partition("[")[2].rstrip("]")
    return printed.replace("degree", "deg").replace("°", "deg")


@each_paper
def test_key_is_the_name_of_the_module(paper: Paper) -> None:
    module = importlib.import_module(f"papers.{paper.key}")

    assert module.PAPER is paper


@each_paper
def test_what_any_paper_must_satisfy_holds(paper: Paper) -> None:
    assert list(contract_faults(paper)) == []


@each_paper
def test_every_number_of_a_result_table_has_one_claim(paper: Paper) -> None:
    printed = Counter((t.label, *place) for t in paper.results for place in t.places())
    claimed = Counter(claim.place for claim in paper.claims if isinstance(claim, CellClaim))

    assert claimed == printed
    assert set(printed.values()) <= {1}


@each_paper
def test_claims_of_an_alternative_stand_for_claims_of_the_paper(paper: Paper) -> None:
    for reading in readings(paper):
        brought = sum(len(alternative.claims) for alternative in reading.alternatives)
        under = claims_under(paper, reading)

        own = under[: len(paper.claims)]  # the others are gaps, which nothing stands for
        replaced = [new for old, new in zip(paper.claims, own, strict=True) if new is not old]
        assert len(replaced) == brought
        assert all(claim.measure is not None for claim in replaced)


@each_paper
def test_alternatives_that_can_be_tried_together_are_named(paper: Paper) -> None:
    assert len(paper.together) in {0, 2, 3}
    assert len(readings(paper)) > len(paper.together)


@each_paper
def test_every_claim_has_a_band_around_what_is_printed_and_says_what_it_measures(
    paper: Paper,
) -> None:
    for claim in paper.claims:
        low, high = claim.accepted.band(claim.printed)
        assert low <= high
        assert claim.accepted.words
        assert claim.measure is None or claim.measure.words


@each_paper
def test_paper_says_truly_whether_its_tables_were_read_twice(paper: Paper) -> None:
    assert paper.read_twice == (SECOND_READING / paper.key).is_dir()


@pytest.mark.parametrize(("key", "name"), TABLES)
def test_table_is_the_second_reading_cell_by_cell(key: str, name: str) -> None:
    table = TABLES[key, name]
    headings, *rows = read(key, f"{name}.csv")
    compared = [j for j, h in enumerate(headings) if (key, name, h) not in NOT_COMPARED]

    ours = [
        [*row, *(cell.text if isinstance(cell, Printed) else cell for cell in cells)]
        for row, cells in zip(table.rows, table.cells, strict=True)
    ]

    assert len(ours) == len(rows)
    for own, second in zip(ours, rows, strict=True):
        assert [plain(text) for text in own] == [plain(second[j]) for j in compared]


@pytest.mark.parametrize(("key", "name"), TABLES)
def test_headings_are_words_of_the_second_reading_in_the_printed_unit(key: str, name: str) -> None:
    table = TABLES[key, name]
    headings = [h for h in read(key, f"{name}.csv")[0] if (key, name, h) not in NOT_COMPARED]

    ours = [*table.headings, *table.column_names]
    units = [*[WORDS] * len(table.headings), *(column.unit for column in table.columns)]

    assert len(ours) == len(headings)
    for own, own_unit, second in zip(ours, units, headings, strict=True):
        assert set(map(plain, own.split())) <= set(map(plain, second.split()))
        assert own_unit == WORDS or unit(second) in {"", own_unit}


@pytest.mark.parametrize("key", READ_TWICE)
def test_every_table_that_was_read_twice_is_declared_or_left_out_for_a_reason(key: str) -> None:
    second = {(key, path.stem) for path in (SECOND_READING / key).glob("*.csv")}

    assert second
    assert second - TABLES.keys() <= NOT_DECLARED.keys()
    assert not TABLES.keys() & NOT_DECLARED.keys()


def fits(experiment: Experiment, protocol: dict[str, str]) -> bool:
    sizes = ("population", "iterations", "runs")
    return all(protocol[s] in {"", str(getattr(experiment, s))} for s in sizes)


@each_read_twice
def test_every_experiment_has_the_sizes_of_the_second_reading(paper: Paper) -> None:
    heading, *rows = read("protocols.csv")
    protocols = [dict(zip(heading, row, strict=True)) for row in rows if row[0] == paper.key]
    assumed = " ".join(assumption.what for assumption in paper.assumptions)

    for experiment in paper.experiments:
        fitting = [protocol for protocol in protocols if fits(experiment, protocol)]
        assert fitting, f"{experiment.name} is none of {protocols}"
        silent = {size for size, printed in fitting[0].items() if not printed}
        assert [size for size in silent if size not in assumed] == []


def constants(node: ast.AST) -> Iterator[object]:
    """Yield what is typed in the code; prose, which may repeat a printed number, stands beside."""
    if isinstance(node, ast.Constant):
        yield node.value
    for child in ast.iter_child_nodes(node):
        yield from constants(child)


def typed(key: str) -> list[object]:
    module = (ROOT / "papers" / key).with_suffix(".py")
    return list(constants(ast.parse(module.read_text(encoding="utf-8"))))


def telling(text: object) -> bool:
    """Whether a text is a number of three digits or more, which nobody types twice by chance."""
    try:
        Printed(str(text))
    except DeclarationError:
        return False
    mantissa = re.match(r"[-+−]?[0.]*([\d.]*)", str(text))
    digits = mantissa[1] if mantissa else ""
    return len(digits.replace(".", "") if "." in digits else digits.rstrip("0")) >= 3


@each_paper
def test_no_printed_number_is_typed_twice(paper: Paper) -> None:
    code = typed(paper.key)
    single = [c for c in code if isinstance(c, str) and telling(c)]
    cells = [t[place].text for t in tables(paper) for place in t.places() if telling(t[place].text)]

    assert [text for text, times in Counter(single).items() if times > 1] == []
    assert sorted(set(single) & set(cells)) == []
    values = {abs(Printed(text).value) for text in (*single, *cells)}
    numbers = [c for c in code if type(c) in {int, float} and telling(c)]
    assert [number for number in numbers if number in values] == []


def test_numbers_that_are_typed_are_found() -> None:
    code = 'A = Printed("4.69", "s")\nB = 0.5\nD = "Table 1, p. 2"'

    found = list(constants(ast.parse(code)))

    assert found == ["4.69", "s", 0.5, "Table 1, p. 2"]
    assert [c for c in found if telling(c)] == ["4.69"]
    assert telling("2.50×10^3")
    assert telling(2.297)
    assert telling("165")
    assert not telling(100)
    assert not telling("0.01")
    assert not telling("π/2")
