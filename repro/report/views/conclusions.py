"""The conclusions of a paper as the pages name them, from its entry in results.json.

The index is made of entries alone, also of papers that another call judged, so a paper's own page
takes them from there, too.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from repro.model.identifiers import anchor, identifiers

Json = Mapping[str, Any]
Place = tuple[str, str | None]


@dataclass(frozen=True, slots=True, kw_only=True)
class Concluded:
    """The facts of one paper, and where their evidence is: (section, anchor) of each.

    `findings` are those of the entry, `places` theirs.
    """

    key: str
    facts: Json
    findings: Sequence[Json]
    places: Sequence[Place]
    conditions: tuple[str, ...]

    def finding(self, position: int | None, otherwise: str) -> Place:
        """Return where a finding is, or the section where its numbers are if there is none."""
        return (otherwise, None) if position is None else self.places[position]

    def proof(self, certificate: str) -> Place:
        """Return where a certificate is."""
        return "optimum", anchor("optimum", certificate)

    def row(self, position: int) -> Place:
        """Return where a row of the audit is."""
        return "audit", f"audit-{position + 1}"

    @property
    def one_sided(self) -> list[tuple[str, str, list[Json]]]:
        """Table and side of columns that re-run on one side, with these columns."""
        groups: dict[tuple[str, str], list[Json]] = {}
        for each in self.facts["one_sided"]:
            groups.setdefault((each["table"], each["side"]), []).append(each)
        return [(*place, columns) for place, columns in groups.items()]


def concluded(entry: Json) -> Concluded | None:
    """Return what is concluded of a paper; None where its entry is older than conclusions are."""
    if "conclusions" not in entry:
        return None
    findings, facts = entry["findings"], entry["conclusions"]
    names = identifiers(
        (f["table"] or "claim", f["row"], f["column"], f["claim"]) for f in findings
    )
    rows = [entry["audit"][k] for k in facts["impossible"]["conditional"]]
    return Concluded(
        key=entry["key"],
        facts=facts,
        findings=findings,
        places=[
            ("tables" if finding["table"] else "claims", name)
            for finding, name in zip(findings, names, strict=True)
        ],
        conditions=tuple(dict.fromkeys(row["condition"] for row in rows)),
    )
