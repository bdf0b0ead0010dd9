import re
import subprocess
import sys
from pathlib import Path

import pytest

from repro.commands.arguments import _TEXTS, parser
from repro.errors import InputError
from repro.report.pages import index_files
from repro.report.readme import BEGIN, END, with_part

ROOT = Path(__file__).parents[2]
COMMANDS = (ROOT / "docs" / "commands.md").read_text(encoding="utf-8")
README = (ROOT / "README.md").read_text(encoding="utf-8")


def marked(text: str, name: str = "verdicts") -> str:
    return f"{BEGIN.format(name)}\n{text}\n{END.format(name)}"


def test_a_readme_without_the_marks_is_refused() -> None:
    with pytest.raises(InputError, match=r"lacks the line .*verdicts"):
        with_part("# a project", "verdicts", "| table |", "reports")


def test_the_text_around_a_part_is_kept_and_so_is_another_part() -> None:
    readme = f"a\n{marked('old')}\nb\n{marked('4.69 s', 'finding')}\nc"

    found = with_part(readme, "verdicts", "new", "reports")

    assert found == f"a\n{marked('new')}\nb\n{marked('4.69 s', 'finding')}\nc"


def test_links_of_a_part_are_moved_and_addresses_are_not() -> None:
    table = "[a](a.md) [b](https://example.org/b) [c](/c)"

    found = with_part(marked(""), "verdicts", table, "some/pages")

    assert "[a](some/pages/a.md) [b](https://example.org/b) [c](/c)" in found


def test_what_the_readme_shows_is_written_with_the_pages() -> None:
    written = index_files({"papers": []})

    (picture,) = re.findall(r'src="reports/([^"]+)"', README)
    assert picture in written
    for name in re.findall(r"<!-- (\w+): generated", README):
        assert f"{name}.md" in written


def test_every_python_example_of_the_readme_runs() -> None:
    examples = re.findall(r"```python\n(.*?)```", README, flags=re.DOTALL)
    assert examples
    for example in examples:
        subprocess.run([sys.executable, "-c", example], check=True, cwd=ROOT, capture_output=True)


def test_every_command_of_the_manual_is_known_and_every_command_is_there() -> None:
    lines = re.findall(r"^    repro (\w+)", COMMANDS, flags=re.MULTILINE)
    assert set(lines) == set(_TEXTS)
    for line in lines:
        needed = {
            "compare": ["module:object"],
            "again": ["key", "name"],
            "flips": ["a", "b"],
            "motion": ["a.toml"],
            "new": ["key"],
            "check": ["key"],
        }
        assert parser().parse_args([line, *needed.get(line, [])]).command


def test_every_file_that_the_readme_links_to_exists() -> None:
    without = with_part(README, "verdicts", "", "reports")  # the table is of the last run
    without = with_part(without, "finding", "", "reports")
    for link in re.findall(r"\]\(([^)#:]+)\)", without):
        assert (ROOT / link).exists(), link
