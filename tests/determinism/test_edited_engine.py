"""Keys of runs, when lines of a copy of the engine are edited."""

import ast
import random
import shutil
import subprocess
import sys
from pathlib import Path

import repro

ENGINE = Path(repro.__file__).parent
PROGRAM = """
from repro.determinism.source_digests import told
from repro.functions import FUNCTIONS
from repro.optimisers import WOA
print(told(algorithm=WOA(), problem=FUNCTIONS["sphere"].problem(3)).digest)
"""
REACHED = ("optimisers/whale.py",) * 2
NOT_REACHED = (
    "optimisers/grey_wolf.py",
    "optimisers/dung_beetle.py",
    "optimisers/gravitational.py",
)


def with_another_number(text: str, draw: random.Random) -> str:
    """Return a module in which one number of one function, drawn at random, is another."""
    functions = [each for each in ast.parse(text).body if isinstance(each, ast.FunctionDef)]
    numbers = [
        node
        for function in functions
        for node in ast.walk(function)
        if isinstance(node, ast.Constant) and isinstance(node.value, float)
    ]
    chosen = draw.choice(numbers)
    lines = text.splitlines()
    line = lines[chosen.lineno - 1]
    begun, ended = line[: chosen.col_offset], line[chosen.end_col_offset :]
    lines[chosen.lineno - 1] = f"{begun}1.25 * {chosen.value!r}{ended}"
    return "\n".join(lines) + "\n"


def key_of(folder: Path) -> str:
    """Return the digest that another process finds with the engine in a folder."""
    done = subprocess.run(
        [sys.executable, "-B", "-c", PROGRAM], cwd=folder, env={"PYTHONPATH": str(folder)},
        check=True, capture_output=True, text=True,
    )  # fmt: skip
    return done.stdout


def test_lines_that_a_run_reaches_change_its_key_and_others_do_not(tmp_path: Path) -> None:
    shutil.copytree(ENGINE, tmp_path / "repro", ignore=shutil.ignore_patterns("__pycache__"))
    before = key_of(tmp_path)

    draw = random.Random(16)  # noqa: S311 (no secret)
    for name in REACHED:
        file = tmp_path / "repro" / name
        text = file.read_text(encoding="utf-8")
        file.write_text(with_another_number(text, draw), encoding="utf-8")
        assert key_of(tmp_path) != before, name
        file.write_text(f"# a word\n\n{text}# a last word\n", encoding="utf-8")

    for name in NOT_REACHED:
        file = tmp_path / "repro" / name
        text = file.read_text(encoding="utf-8")
        file.write_text(with_another_number(text, draw), encoding="utf-8")
    assert key_of(tmp_path) == before
