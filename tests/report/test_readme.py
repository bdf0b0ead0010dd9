import re
import subprocess
import sys
from pathlib import Path

import pytest

from repro.commands.arguments import parser
from repro.errors import InputError
from repro.report.readme import BEGIN, END, with_verdicts

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")


def test_a_readme_without_the_marks_is_refused() -> None:
    with pytest.raises(InputError, match="lacks the line"):
        with_verdicts("# a project", "| table |", "reports")


def test_the_text_around_the_table_is_kept() -> None:
    found = with_verdicts(f"a\n{BEGIN}\nold\n{END}\nb", "new", "reports")

    assert found == f"a\n{BEGIN}\nnew\n{END}\nb"


def test_links_of_the_table_are_moved_and_addresses_are_not() -> None:
    table = "[a](a.md) [b](https://example.org/b) [c](/c)"

    found = with_verdicts(f"{BEGIN}\n{END}", table, "some/pages")

    assert "[a](some/pages/a.md) [b](https://example.org/b) [c](/c)" in found


def test_every_python_example_of_the_readme_runs() -> None:
    examples = re.findall(r"```python\n(.*?)```", README, flags=re.DOTALL)
    assert examples
    for example in examples:
        subprocess.run([sys.executable, "-c", example], check=True, cwd=ROOT, capture_output=True)


def test_every_command_of_the_readme_is_known() -> None:
    for line in re.findall(r"^    repro (\w+)", README, flags=re.MULTILINE):
        needed = {
            "compare": ["module:object"],
            "again": ["key", "name"],
            "flips": ["a", "b"],
            "motion": ["a.toml"],
        }
        assert parser().parse_args([line, *needed.get(line, [])]).command


def test_every_file_that_the_readme_links_to_exists() -> None:
    without_table = with_verdicts(README, "", "reports")  # the table is of the last run
    for link in re.findall(r"\]\(([^)#:]+)\)", without_table):
        assert (ROOT / link).exists(), link
