"""A paper of an installed package is known by its key, wherever the command is called."""

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

import pytest

ROOT = Path(__file__).parents[2]
COMMANDS = """
import io, json, sys
from contextlib import redirect_stderr, redirect_stdout
from repro.__main__ import main
told = []
for call in json.loads(sys.argv[1]):
    with redirect_stdout(io.StringIO()) as out, redirect_stderr(io.StringIO()) as err:
        code = main(call)
    told.append((code, out.getvalue(), err.getvalue()))
print(json.dumps(told))
"""
RUN = ("reproduce", "travels2019", "--repeats", "1", "--workers", "1", "--protocol-only")

MODULE = '''
"""A made-up paper that an installed package brings along."""

from repro.functions import FUNCTIONS
from repro.model import Experiment, Paper, Percent, PublishedTable, Source, every_cell

from travels.steps import REACH

TABLE = PublishedTable.read("""
    Table 1, p. 2 (3 runs)
    problem | statistic || walk
    F1      | best      || 1.5
            | mean      || 1.2
            | worst     || 2.5
""")


def walk(cost, bounds, budget, rng):
    """Return the best of some points near the middle."""
    points = [REACH * rng.uniform(*bounds.T) for _ in range(budget)]
    return min(points, key=cost)


SEARCH = Experiment(
    name="search", where="p. 2", proposed="walk",
    problems={"F1": FUNCTIONS["sphere"].problem(2)}, algorithms={"walk": walk},
    population=2, iterations=3, runs=3,
)

PAPER = Paper(
    key="travels2019",
    source=Source(authors="A. Nobody", title="Travels"),
    summary="A walk.",
    experiments=(SEARCH,),
    results=(TABLE,),
    claims=every_cell(
        TABLE, of=SEARCH, rows=("problem", "statistic"), columns="algorithm", within=Percent(20)
    ),
)
'''


class Said(NamedTuple):
    """What a command printed, and its exit code."""

    code: int
    out: str
    err: str


class Installed(NamedTuple):
    """Where a package is installed, and an empty folder."""

    site: Path
    folder: Path

    def repro(self, *calls: tuple[str, ...]) -> list[Said]:
        """Return what each command says, one after another in one process in the empty folder."""
        found = subprocess.run(
            [sys.executable, "-c", COMMANDS, json.dumps(calls)],
            cwd=self.folder,
            env=os.environ | {"PYTHONPATH": f"{self.site}{os.pathsep}{ROOT}"},
            capture_output=True,
            text=True,
            check=True,
            timeout=900,
        )
        return [Said(*each) for each in json.loads(found.stdout)]


@pytest.fixture
def installed(tmp_path: Path) -> Installed:
    site, folder = tmp_path / "site", tmp_path / "empty"
    package, info = site / "travels", site / "travels-1.0.dist-info"
    for each in (package, info, folder):
        each.mkdir(parents=True)
    (package / "__init__.py").touch()
    (package / "steps.py").write_text("REACH = 0.01\n", encoding="utf-8")
    (package / "paper.py").write_text(MODULE, encoding="utf-8")
    (package / "lost.py").write_text("from travels.steps import FAR\n", encoding="utf-8")
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: travels\nVersion: 1.0\n")
    (info / "entry_points.txt").write_text(
        "[repro.papers]\ntravels2019 = travels.paper\nlost2019 = travels.lost:PAPER\n"
    )
    return Installed(site, folder)


def test_an_installed_paper_is_listed_audited_and_reproduced_by_its_key(
    installed: Installed,
) -> None:
    listed, audited, reproduced, again = installed.repro(
        ("list", "travels2019"),
        ("audit", "travels2019"),
        RUN,
        ("list", "travels2019", "--repeats", "1", "--json"),
    )

    assert [each.code for each in (listed, audited, reproduced, again)] == [0, 0, 0, 0]
    assert listed.out.startswith("travels2019: Travels\n  tables: Table 1; claims: 3\n")
    assert "the mean 1.2, at most 1.3 with rounding, lies below the best 1.5" in audited.out
    assert "travels2019" in reproduced.out
    (row,) = json.loads(again.out)[0]["experiments"]
    assert (row["done"], row["missing"]) == (3, 0)
    assert sorted(path.name for path in installed.folder.iterdir()) == [".repro", "reports"]
    assert (installed.folder / "reports" / "travels2019.html").is_file()


def test_a_module_that_it_reads_is_followed_into_the_keys_of_its_runs(
    installed: Installed,
) -> None:
    installed.repro(RUN)
    (installed.site / "travels" / "steps.py").write_text("REACH = 0.02\n", encoding="utf-8")

    (said,) = installed.repro(("list", "travels2019", "--repeats", "1"))

    assert "0 runs done, 3 missing" in said.out
    assert "travels.steps" in said.out


def test_its_broken_sibling_is_one_line_and_stops_only_itself(installed: Installed) -> None:
    both, alone, sound = installed.repro(
        ("list", "travels2019", "lost2019"), ("list", "lost2019"), ("list", "travels2019")
    )

    assert both.out.startswith("travels2019: Travels\n")
    assert alone.out == ""
    for said in (both, alone):
        (line,) = said.err.splitlines()
        assert said.code == 2
        assert "lost2019 = travels.lost:PAPER" in line
        assert "cannot import name 'FAR' from 'travels.steps'" in line
    assert (sound.code, sound.err) == (0, "")
