import json
import os
import re
import shutil
import subprocess
import sys
from datetime import date
from pathlib import Path
from typing import Any

import numba
import numpy as np
import pytest

import repro
from repro.determinism.provenance import DECISIVE, provenance
from repro.determinism.seeds import RULE

PACKAGE = Path(repro.__file__).parent
COMPILED = shutil.ignore_patterns("__pycache__")


def test_provenance_says_with_what_runs_are_made() -> None:
    found = provenance()

    packages = found["packages"]
    assert isinstance(packages, dict)
    assert (packages["numpy"], packages["numba"]) == (np.__version__, numba.__version__)
    assert found["seed_rule"] == RULE
    assert date.fromisoformat(str(found["date"]))
    assert all(found[name] for name in ("python", "system", "processor", "cores", "commit"))


def test_provenance_is_json_and_the_same_within_a_process() -> None:
    assert json.loads(json.dumps(provenance())) == provenance()


@pytest.mark.parametrize(
    "fault", [FileNotFoundError("git"), subprocess.CalledProcessError(128, "git")]
)
def test_without_a_commit_version_and_digest_of_the_sources_stand_for_it(
    fault: Exception, monkeypatch: pytest.MonkeyPatch
) -> None:
    def run(*_: Any, **__: Any) -> None:  # noqa: ANN401
        raise fault

    monkeypatch.setattr(subprocess, "run", run)

    found = str(provenance()["commit"])

    assert re.fullmatch(r"version \S+, sources [0-9a-f]{12} \(no git checkout\)", found)


@pytest.fixture
def installed(tmp_path: Path) -> Path:
    """Return a copy of the package in a folder for packages, inside another project's checkout."""
    place = tmp_path / "project" / "venv" / "site-packages"
    shutil.copytree(PACKAGE / "determinism", place / "repro" / "determinism", ignore=COMPILED)
    for name in ("__init__.py", "errors.py"):
        shutil.copy(PACKAGE / name, place / "repro" / name)
    (tmp_path / "project" / "theirs.txt").touch()
    git(tmp_path / "project", "init", "-q")
    git(tmp_path / "project", "add", "theirs.txt")
    git(tmp_path / "project", "commit", "-qm", "theirs")
    return place


def git(folder: Path, *command: str) -> str:
    who = ("-c", "user.name=a", "-c", "user.email=a@b.c")
    call = ("git", *who, *command)
    return subprocess.run(call, cwd=folder, check=True, capture_output=True, text=True).stdout


def commit_told(place: Path, **more: str) -> str:
    """Return what a process that imports the package from a folder says of its commit."""
    code = "from repro.determinism.provenance import _commit; print(_commit())"
    environment = {**os.environ, "PYTHONPATH": str(place), **more}
    call = (sys.executable, "-c", code)
    done = subprocess.run(
        call, cwd=place, env=environment, check=True, capture_output=True, text=True
    )
    return done.stdout.strip()


def test_a_repository_around_the_package_gives_no_commit(installed: Path) -> None:
    assert commit_told(installed).endswith("(no git checkout)")


def test_variables_of_git_name_no_other_repository(installed: Path) -> None:
    project = installed.parents[1]
    git(project, "add", "-A")
    git(project, "commit", "-qm", "ours")
    ours = git(project, "rev-parse", "HEAD").strip()
    other = installed.parents[2] / "other"
    other.mkdir()
    git(other, "init", "-q")

    told = commit_told(installed, GIT_DIR=str(other / ".git"), GIT_WORK_TREE=str(installed))

    assert ours.startswith(told.removesuffix("-dirty"))


def test_commit_is_dirty_where_files_of_the_package_differ_and_not_by_those_around_it(
    installed: Path,
) -> None:
    project = installed.parents[1]
    git(project, "add", "-A")
    git(project, "commit", "-qm", "ours")
    (project / "theirs.txt").write_text("changed", encoding="utf-8")
    assert not commit_told(installed).endswith("-dirty")

    module = installed / "repro" / "errors.py"
    module.write_text(module.read_text(encoding="utf-8") + "\n", encoding="utf-8")
    assert commit_told(installed).endswith("-dirty")


def test_other_sources_have_another_digest(installed: Path) -> None:
    before = commit_told(installed)
    module = installed / "repro" / "determinism" / "seeds.py"
    module.write_text(module.read_text(encoding="utf-8") + "\n", encoding="utf-8")

    assert commit_told(installed) != before


@pytest.mark.parametrize(
    ("variable", "value", "name"),
    [
        ("NUMBA_CPU_NAME", "generic", "vector_instructions"),
        ("NUMBA_OPT", "1", "settings"),
        ("GLIBC_TUNABLES", "glibc.malloc.check=0", "settings"),
    ],
)
def test_what_is_used_is_noted_and_not_what_the_machine_has(
    variable: str, value: str, name: str
) -> None:
    code = "import json, repro.determinism.provenance as p; print(json.dumps(p.provenance()))"
    call = (sys.executable, "-c", code)
    more = {"NUMBA_CPU_FEATURES": ""} if variable == "NUMBA_CPU_NAME" else {}
    texts = [
        subprocess.run(call, env=env, check=True, capture_output=True, text=True).stdout
        for env in ({**os.environ}, {**os.environ, variable: value, **more})
    ]
    before, found = map(json.loads, texts)

    assert found[name] != before[name]
    assert {key for key in DECISIVE if found[key] != before[key]} <= {name, "settings"}
