"""What a paper is called in a sentence: first author and year."""

import re

from repro.model.paper import Source

_TWO = 2


def cited(key: str, source: Source) -> str:
    """Return "Liang et al. (2026)"; the key's year where the copy at hand prints none.

    A source that names nobody is called by its key.
    """
    authors = re.split(r",|;|\band\b|&", source.authors)
    names = [name.split()[-1] for name in authors if name.split()]
    if not names or not names[0][0].isupper():  # "authors not on the copy" names nobody
        return key
    own = re.search(r"(\d{4})\D*$", key)
    year = source.year or (own and own[1])
    others = len(names) > _TWO or names[-1] == "al."
    called = f"{names[0]} et al." if others else " and ".join(names)
    return f"{called} ({year})" if year else called
