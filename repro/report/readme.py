"""Put generated parts into a README: python -m repro.report.readme README PART.md…."""

import os
import re
import sys
from pathlib import Path

from repro.errors import InputError

BEGIN = "<!-- {}: generated, do not edit -->"
END = "<!-- end of {} -->"


def with_part(readme: str, name: str, text: str, folder: str) -> str:
    """Return the README with a text between the two marks of that name; InputError without them.

    The links of the text are those of a page in `folder`, seen from the README.
    """
    start, stop = BEGIN.format(name), END.format(name)
    before, begin, rest = readme.partition(start)
    _, end, after = rest.partition(stop)
    if not (begin and end):
        message = f"the README lacks the line {start if not begin else stop!r}"
        raise InputError(message)
    moved = re.sub(r"\]\((?!\w+:|/)", f"]({folder}/", text.strip())
    return f"{before}{start}\n{moved}\n{stop}{after}"


def main() -> None:
    """Rewrite the README that the command line names; a part's mark has the name of its file."""
    readme, *parts = (Path(name) for name in sys.argv[1:])
    text = readme.read_text(encoding="utf-8")
    for part in parts:
        folder = Path(os.path.relpath(part.parent, readme.parent)).as_posix()
        text = with_part(text, part.stem, part.read_text(encoding="utf-8"), folder)
    readme.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
