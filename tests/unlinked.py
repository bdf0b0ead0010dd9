"""A page without the links to its words, for tests of what its sentences say."""

import re


def unlinked(page: str) -> str:
    """Return a page of either kind without links to the glossary, or to words of its own."""
    page = re.sub(r'<a class="term" href="[^"]*">(.*?)</a>', r"\1", page)
    return re.sub(r"\[([^]]*)\]\((?:glossary\.md#|#word-)[^)]*\)", r"\1", page)
