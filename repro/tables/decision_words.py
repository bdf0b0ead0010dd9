"""Words and marks that say of a test whether its hypothesis is rejected."""

import re

from repro.tables.markup import plain

_REJECTED = re.compile(
    r"reject(?:ed|s)?(?:\s?h_?0)?|(?:statistically\s)?significant|sig\.?|different|h_?1",
    re.IGNORECASE,
)
_KEPT = re.compile(
    r"(?:(?:not|do(?:es)?\snot|fail(?:s|ed)?\sto)\sreject(?:ed)?|accept(?:ed|s)?|retain(?:ed|s)?)(?:\s?h_?0)?"
    r"|(?:not|non)[\s-]?(?:statistically\s)?sig(?:\.|nificant)?|insignificant|n\.?s\.?"
    r"|no\s(?:significant\s)?difference|not\sdifferent|h_?0",
    re.IGNORECASE,
)
_YES, _NO = re.compile(r"true|yes|✓|✔", re.IGNORECASE), re.compile(r"false|no|✗|✘", re.IGNORECASE)
_WINS, _TIES = re.compile(r"\(?\+\)?"), re.compile(r"\(?[=≈~]\)?")
_LOSES = re.compile(r"\(?-\)?")  # or there is no difference: tables write both so
_OF_REJECTION = re.compile(
    r"(?<![a-z])(?:h|h_?1|reject\w*|(?:non-?)?signific\w*|sig\.?|differen\w+)(?![a-z0-9])",
    re.IGNORECASE,
)
_OF_KEEPING = re.compile(r"(?<![a-z])(?:accept\w*|retain\w*|not|non-?signific\w*)", re.IGNORECASE)
_OF_MARKS = re.compile(
    r"(?<![a-z])(?:h|sign|mark|result|outcome|sig\.?|signific\w*|decision|w)(?![a-z0-9])",
    re.IGNORECASE,
)
MEANS = "whether a hypothesis is rejected"
NOT_TOLD = "it is not told whether that rejects a hypothesis"


def is_decision(text: str, heading: str) -> bool:
    """Say whether a text is a decision, or a yes or no of any kind."""
    simple = plain(text)
    marks = (_WINS, _TIES, _LOSES)
    if _OF_MARKS.search(heading) and any(each.fullmatch(simple) for each in marks):
        return True
    return any(each.fullmatch(simple) for each in (_REJECTED, _KEPT, _YES, _NO))


def deciding(*headings: str) -> str:
    """Return the heading that speaks of a decision, or else the last one."""
    told = (each for each in headings if _OF_REJECTION.search(each) or _OF_MARKS.search(each))
    return next(told, headings[-1])


def rejection(text: str, heading: str) -> bool | None:
    """Return whether a hypothesis is rejected, by a text that `is_decision`; None if not told."""
    simple = plain(text)
    if _KEPT.fullmatch(simple) or _TIES.fullmatch(simple):
        return False
    if _REJECTED.fullmatch(simple) or _WINS.fullmatch(simple):
        return True
    if _LOSES.fullmatch(simple):
        return None
    rejects, keeps = (bool(each.search(heading)) for each in (_OF_REJECTION, _OF_KEEPING))
    if rejects == keeps:
        return None
    return rejects if _YES.fullmatch(simple) else keeps
