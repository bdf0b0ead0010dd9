"""A listing of papers as text for a terminal."""

from collections.abc import Iterable, Iterator
from typing import Any

from repro.commands.streams import one_line

Row = dict[str, Any]
_SHOWN = 4  # changed parts that a line names


def _changes(changed: Iterable[Row]) -> Iterator[str]:
    """Yield a line for each set of parts that is another than when runs were made of it."""
    cells: dict[tuple[str, ...], list[str]] = {}
    for each in changed:
        place = f"{each['algorithm']} on {each['problem']}"
        cells.setdefault(tuple(each["parts"]), []).append(place)
    for parts, places in cells.items():
        yield f"    changed since they ran: {in_words(parts)} (of {in_words(places)})"


def listing_text(rows: list[Row]) -> str:
    """Return the listing as text for a terminal."""
    lines = []
    for row in rows:
        lines.append(f"{row['key']}: {row['title']}")
        lines.append(f"  tables: {', '.join(row['tables']) or 'none'}; claims: {row['claims']}")
        for experiment in row["experiments"]:
            lines.append(
                f"  {experiment['name']}: {' '.join(experiment['algorithms'])} on "
                f"{' '.join(experiment['problems'])}, {experiment['done']} runs done, "
                f"{experiment['missing']} missing"
            )
            lines.extend(_changes(experiment["changed"]))
        if not row["experiments"]:
            lines.append("  no experiments: nothing to run")
        if others := row["studies"]:
            noun = "study" if len(others) == 1 else "studies"
            done, missing = (sum(o[state] for o in others) for state in ("done", "missing"))
            lines.append(f"  {len(others)} {noun} besides: {done} runs done, {missing} missing")
    return "".join(f"{one_line(line)}\n" for line in lines)


def in_words(changed: Iterable[str]) -> str:
    """Return changed parts as the end of "changed since: …"."""
    names = list(dict.fromkeys(changed))
    more = f" and {len(names) - _SHOWN} more" if len(names) > _SHOWN else ""
    return ", ".join(names[:_SHOWN]) + more
