"""Words of messages: a value as it is shown, and what there is in place of a name that is not."""

import difflib
from collections.abc import Iterable


def shown_value(value: object) -> str:
    """Return a value on one line, cut where it is long."""
    return " ".join(f"{value!r:.60}".split())


def known_words(word: object, among: Iterable[object]) -> str:
    """Return what there is, the nearest first."""
    names = {str(each): each for each in among}
    near = difflib.get_close_matches(str(word), names, n=1)
    hint = f"did you mean {names[near[0]]!r}? " if near else ""
    return f"{hint}there is {', '.join(map(repr, names.values())) or 'none'}"
