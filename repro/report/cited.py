"""What a paper is called in a sentence: first author and year."""

import re
from textwrap import shorten

from repro.model.paper import Source

_TWO = 2
LONGEST = 44  # letters of a title that stands for names


def cited(key: str, source: Source) -> str:
    """Return "Liang et al. (2026)"; the key's year where the copy at hand prints none.

    A source that names nobody is called by the first words of its title.
    """
    authors = re.split(r",|;|\band\b|&|\bet al\b", source.authors)
    names = [name.split()[-1] for name in authors if name.strip(" .")]
    if not names or not names[0][0].isupper():  # "authors not on the copy" names nobody
        called = shorten(source.title, LONGEST, placeholder=" …") or key
        return f"{called} ({source.year})" if source.year else called
    own = re.search(r"(\d{4})\D*$", key)
    year = source.year or (own and own[1])
    others = len(names) > _TWO or "et al" in source.authors
    called = f"{names[0]} et al." if others else " and ".join(names)
    return f"{called} ({year})" if year else called
