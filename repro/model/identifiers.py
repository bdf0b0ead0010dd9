"""Names for links and commands, made of letters, digits and hyphens."""

import re
from collections.abc import Iterable

from repro.model.claims import CellClaim, Claim


def anchor(*parts: str | None) -> str:
    """Return an identifier for deep links made of letters, digits and hyphens."""
    text = "-".join(part for part in parts if part).lower()
    return re.sub(r"[^a-z0-9]+", "-", text).strip("-")


def identifiers(places: Iterable[tuple[str | None, ...]]) -> list[str]:
    """Return one identifier per place of a paper, no two alike: links and commands name it."""
    names: dict[str, None] = {}  # as a set that keeps the order
    for place in places:
        first = name = anchor(*place)
        count = 1
        while name in names:
            count += 1
            name = f"{first}-{count}"
        names[name] = None
    return list(names)


def claim_names(claims: Iterable[Claim]) -> list[str]:
    """Return the identifier of each claim of a paper: pages link to it, `repro again` takes it."""
    return identifiers(map(place_of, claims))


def place_of(claim: Claim) -> tuple[str, ...]:
    """Return what the identifier of a claim is made of."""
    if isinstance(claim, CellClaim):
        return claim.table.label, claim.row, claim.column
    return "claim", claim.claim
