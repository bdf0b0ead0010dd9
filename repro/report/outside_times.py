"""What other planners say of the papers' motions, which is package data, beside a certificate."""

import json
from collections.abc import Iterator
from importlib.resources import files
from typing import Any

from repro.judge.certificates import Certificate
from repro.robotics.proofs.proved import GAP


def planners() -> dict[str, Any]:
    """Return what the package ships of other planners; all empty where there is nothing.

    `rows` are those of `repro references`, each with the `minimum` that was certified beside it;
    `versions` are those of the planners.
    """
    found: dict[str, Any] = {"rows": [], "versions": {}}
    data = files("repro.judge").joinpath("planners.json")
    if data.is_file():
        found |= json.loads(data.read_text(encoding="utf-8"))
    return found


def outside_times(certificate: Certificate) -> Iterator[tuple[str, float, float]]:
    """Yield label, time in s and ratio to the minimum of each planner's answer to this problem.

    An answer is of this problem where the minimum is the one that was certified beside it.
    """
    known = planners()
    for row in known["rows"]:
        minimum = certificate.minimum
        same = (row["paper"], row["problem"]) == (certificate.paper, certificate.problem)
        if same and minimum and abs(row["minimum"] / minimum - 1.0) <= GAP:
            what = row["what"].removesuffix(", in s")
            planner = f"{row['planner']} {known['versions'][row['planner']]}"
            yield f"{planner}: {what[:1].lower()}{what[1:]}", row["time"], row["time"] / minimum
