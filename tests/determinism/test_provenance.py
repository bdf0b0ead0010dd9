import json
import subprocess
from datetime import date
from typing import Any

import numba
import numpy as np
import pytest

from repro.determinism.provenance import provenance
from repro.determinism.seeds import RULE


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
def test_commit_is_unknown_outside_a_checkout(
    fault: Exception, monkeypatch: pytest.MonkeyPatch
) -> None:
    def run(*_: Any, **__: Any) -> None:  # noqa: ANN401
        raise fault

    monkeypatch.setattr(subprocess, "run", run)

    assert provenance()["commit"] == "unknown (no git checkout)"
