"""What a page says, whichever of its words are links."""

import re


def unlinked(page: str) -> str:
    """Return a page, HTML or Markdown, with the texts of its links in their place."""
    return re.sub(r"\[([^\]\n]*)\]\([^)\n]*\)", r"\1", re.sub(r"</?a\b[^>]*>", "", page))
