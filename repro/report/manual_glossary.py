"""The words as a page of the manual: python -m repro.report.manual_glossary FILE."""

import sys
from pathlib import Path

from repro.report.glossary import glossary
from repro.report.rendering import render


def main() -> None:
    """Write the page."""
    text = render("manual-glossary.md", {"terms": glossary().terms})
    Path(sys.argv[1]).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
