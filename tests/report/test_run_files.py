import gzip
from array import array
from pathlib import Path

import pytest

from repro.errors import InputError
from repro.report.run_files import packed_runs, place_of_runs, read_runs
from repro.runs.raw_runs import RawCell

NAMES = ("protocol", 'a "search", twice', "NA", "")


def cell_of(cost: float = 0.1 + 0.2, seconds: float = 0.5) -> RawCell:
    """Return a cell of one run."""
    return RawCell(
        *NAMES, array("q", [1]), array("q", [1]),
        array("d", [cost]), array("q", [20]), array("d", [seconds]),
    )  # fmt: skip


CELL = cell_of()


def written(tmp_path: Path, content: bytes) -> Path:
    path = tmp_path / "a2020.csv.gz"
    path.write_bytes(content)
    return path


def test_equal_runs_give_equal_bytes_whatever_their_seconds() -> None:
    assert packed_runs([CELL]) == packed_runs([cell_of(seconds=9.0)])
    assert packed_runs([CELL])[3:8] == bytes(5)  # no name of a file, no time


@pytest.mark.parametrize("cost", [0.1 + 0.2, 5e-324, 1e22, -0.0, 2.0])
def test_names_and_costs_come_back_as_they_were(tmp_path: Path, cost: float) -> None:
    (row,) = read_runs(written(tmp_path, packed_runs([cell_of(cost)]))).to_dict("records")

    assert row["cost"].hex() == cost.hex()
    assert (row["experiment"], row["problem"], row["algorithm"]) == ('a "search", twice', "NA", "")
    assert (row["repeat"], row["run"], row["evaluations"]) == (1, 1, 20)


def test_a_run_that_is_noted_twice_stands_once_and_runs_stand_in_order(tmp_path: Path) -> None:
    cell = RawCell(
        *NAMES, array("q", [2, 1, 1, 2]), array("q", [1, 2, 1, 1]),
        array("d", [3.0, 2.0, 1.0, 3.0]), array("q", [4] * 4), array("d", [0.5] * 4),
    )  # fmt: skip

    rows = read_runs(written(tmp_path, packed_runs([cell])))

    assert rows["cost"].tolist() == [1.0, 2.0, 3.0]


def test_a_paper_whose_runs_are_all_missing_has_a_file_of_headings(tmp_path: Path) -> None:
    assert read_runs(written(tmp_path, packed_runs([]))).empty


@pytest.mark.parametrize(
    "content",
    [
        b"no archive",
        packed_runs([CELL])[:-9],
        gzip.compress(b"a,b\n1,2\n"),
        gzip.compress(packed_runs([])),
        gzip.compress(gzip.decompress(packed_runs([CELL])).replace(b",20\n", b",many\n")),
    ],
)
def test_a_file_that_holds_no_runs_is_refused_in_one_line(tmp_path: Path, content: bytes) -> None:
    with pytest.raises(InputError, match=r"a2020\.csv\.gz holds no published runs") as error:
        read_runs(written(tmp_path, content))
    assert "\n" not in str(error.value)


def test_a_file_that_is_not_there_is_named_with_the_command_that_writes_it(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="repro report"):
        read_runs(tmp_path / place_of_runs("a2020"))
