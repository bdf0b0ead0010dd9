"""What is built, and what it says that it needs."""

import re
import shutil
import subprocess
import sys
import tarfile
import tomllib
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
BUILD = "import sys; from setuptools import build_meta as b; b.build_sdist('d'); b.build_wheel('d')"


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> tuple[set[str], set[str]]:
    """Return the names of the files in an sdist and in a wheel of what is here."""
    copy = tmp_path_factory.mktemp("built") / "repro"
    idle = shutil.ignore_patterns(
        "__pycache__", ".git", ".repro", ".nox", "node_modules", "reports"
    )
    shutil.copytree(ROOT, copy, ignore=idle)
    done = subprocess.run(
        (sys.executable, "-c", BUILD), cwd=copy, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    (source,), (wheel,) = (list((copy / "d").glob(kind)) for kind in ("*.tar.gz", "*.whl"))
    with tarfile.open(source) as packed:
        sources = {name.partition("/")[2] for name in packed.getnames()}
    with zipfile.ZipFile(wheel) as packed_wheel:
        return sources, set(packed_wheel.namelist())


def test_an_sdist_holds_no_tests_as_they_need_the_whole_checkout(
    built: tuple[set[str], set[str]],
) -> None:
    sources, _ = built

    assert not [name for name in sources if name.startswith(("tests", "benchmarks"))]


def test_an_sdist_holds_the_sources_of_the_arms_script(built: tuple[set[str], set[str]]) -> None:
    sources, wheel = built
    folder = ROOT / "repro" / "report" / "arm"
    kept = [p for p in folder.rglob("*") if p.is_file() and "node_modules" not in p.parts]

    assert {str(path.relative_to(ROOT)) for path in kept} <= sources
    assert "repro/report/arm/arm.min.js" in wheel


def test_a_wheel_holds_every_module_and_every_template(built: tuple[set[str], set[str]]) -> None:
    sources, wheel = built
    ours = {
        str(path.relative_to(ROOT))
        for folder in ("repro", "papers")
        for kind in ("*.py", "*.jinja", "*.toml", "*.verdicts.csv")
        for path in (ROOT / folder).rglob(kind)
        if "node_modules" not in path.parts
    }

    assert ours <= wheel
    assert ours <= sources


def test_every_dependency_has_a_lower_bound_that_the_session_lowest_installs() -> None:
    groups = [PROJECT["dependencies"], *PROJECT["optional-dependencies"].values()]
    noxfile = (ROOT / "noxfile.py").read_text(encoding="utf-8")

    assert not [one for group in groups for one in group if not re.search(r">=\d", one)]
    assert '"--resolution", "lowest-direct"' in noxfile


def test_the_readme_and_the_classifiers_name_the_same_systems() -> None:
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    systems = [c for c in PROJECT["classifiers"] if c.startswith("Operating System")]

    assert [name.rpartition(" :: ")[2] for name in sorted(systems)] == ["MacOS", "Linux"]
    assert "Linux and macOS" in readme
    assert "WSL" in readme


def test_the_readme_and_the_classifiers_name_the_same_pythons() -> None:
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    named = [c.rpartition(" :: ")[2] for c in PROJECT["classifiers"] if ":: Python :: 3." in c]

    assert PROJECT["requires-python"] == f">={named[0]}"
    assert f"Tested are {', '.join(named[:-1])} and {named[-1]} on Linux" in readme
