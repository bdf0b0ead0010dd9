"""Put the generated table of verdicts into a README: python -m repro.report.readme README TABLE."""

import os
import re
import sys
from pathlib import Path

from repro.errors import InputError

BEGIN = "<!-- verdicts: generated, do not edit -->"
END = "<!-- end of verdicts -->"


def with_verdicts(readme: str, table: str, folder: str) -> str:
    """Return the README with the table between its two marks; InputError without them.

    The links of the table are those of a page in `folder`, seen from the README.
    """
    before, begin, rest = readme.partition(BEGIN)
    _, end, after = rest.partition(END)
    if not (begin and end):
        message = f"the README lacks the line {BEGIN if not begin else END!r}"
        raise InputError(message)
    moved = re.sub(r"\]\((?!\w+:|/)", f"]({folder}/", table.strip())
    return f"{before}{BEGIN}\n{moved}\n{END}{after}"


def main() -> None:
    """Rewrite the README that the command line names."""
    readme, table = (Path(name) for name in sys.argv[1:3])
    folder = Path(os.path.relpath(table.parent, readme.parent)).as_posix()
    text = with_verdicts(
        readme.read_text(encoding="utf-8"), table.read_text(encoding="utf-8"), folder
    )
    readme.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
