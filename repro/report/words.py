"""How verdicts, numbers and differences are shown: by word and symbol, never colour alone."""

import math
import re
import shlex

from markupsafe import Markup, escape

from repro.judge.verdict import Verdict
from repro.tables.published import Printed

SYMBOLS = {
    Verdict.REPRODUCED: "✔",
    Verdict.CONSISTENT: "≈",
    Verdict.UNDECIDED: "?",
    Verdict.DEPENDS: "◐",
    Verdict.CONTRADICTED: "✖",
    Verdict.NOT_REPRODUCIBLE: "∅",
    Verdict.NOT_RUN: "○",
}
MEANINGS = {
    Verdict.REPRODUCED: "whatever such a table shows, it is within the tolerance",
    Verdict.CONSISTENT: "such a table gives this number, and others outside the tolerance, too",
    Verdict.UNDECIDED: "such a table does not give this number, but may give one within its "
    "tolerance",
    Verdict.DEPENDS: "a reading that the text allows, or a setting that it does not print, turns "
    "it between held and contradicted",
    Verdict.CONTRADICTED: "no such table comes within the tolerance, under any reading or "
    "setting that was tried",
    Verdict.NOT_REPRODUCIBLE: "the paper does not print what a re-run needs",
    Verdict.NOT_RUN: "the runs are not in the store",
}
IMPOSSIBLE = (
    "no runs in single or double precision, summed in any usual order, rounded or cut off, give "
    "what is printed"
)


def number(value: float | None, digits: int = 4) -> str:
    """Return a number with so many significant digits; powers of ten are written out."""
    if value is None or not math.isfinite(value):
        return "–"
    if value == 0:
        return "0"
    if abs(value) < 1e5 and value == int(value):
        return f"{value:.0f}"
    if 1e-3 <= abs(value) < 1e5:
        whole = abs(value) >= 10**digits
        text = f"{value:.0f}" if whole else f"{value:#.{digits}g}".rstrip(".")
        return f"{value:.0f}" if "e" in text else text  # 999.96 rounds up to a whole thousand
    mantissa, _, power = f"{value:.{digits - 1}e}".partition("e")
    return f"{mantissa}×10^{int(power)}"


def digits_for(printed: Printed) -> int:
    """Return one significant digit more than is printed, and at least four."""
    mantissa = re.split(r"[×xeE]", printed.text)[0]
    return max(4, len(re.sub(r"\D", "", mantissa).lstrip("0")) + 1)


def interval(pair: tuple[float, float] | None, digits: int = 4) -> str:
    """Return two numbers as an interval, or one where they are equal to the digits shown."""
    if pair is None:
        return "–"
    low, high = number(pair[0], digits), number(pair[1], digits)
    return low if low == high else f"{low} … {high}"


def difference(printed: Printed, value: float | None) -> str:
    """Return how a reproduced value differs: in percent, or as a factor where it is large."""
    if value is None:
        return ""
    if value == printed.value or (printed.value and abs(value - printed.value) <= printed.rounding):
        return "as printed"
    if printed.value == 0 or value == 0 or (printed.value < 0) != (value < 0):
        sign = "+" if value > printed.value else "−"
        return f"{sign}{number(abs(value - printed.value))}"
    ratio = value / printed.value
    if not 0.1 < ratio < 10:
        return f"{math.log10(ratio):+.1f} decades".replace("-", "−")
    if ratio > 2:
        return f"×{ratio:.2f}"
    percent = 100 * (ratio - 1)
    text = f"{percent:+.1f}" if abs(percent) >= 1 else f"{percent:+.1g}"
    return f"{text} %".replace("-", "−")


def raised(text: object) -> Markup:
    """Return text, safe for HTML, with its powers of ten raised."""
    return Markup(re.sub(r"10\^(-?)(\d+)", _power, str(escape(text))))  # noqa: S704 (escaped)


def _power(match: re.Match[str]) -> str:
    return f"10<sup>{'−' if match[1] else ''}{match[2]}</sup>"


def verdict_words(verdict: str, side: str | None) -> str:
    """Return symbol and words of a verdict, with the side of a contradicted number."""
    word = Verdict(verdict)
    return f"{SYMBOLS[word]} {word}" + (f" ({side})" if side else "")


def share(quantile: float | None, tables: int) -> str:
    """Return in words how many of so many re-run tables lie below the printed number."""
    if quantile is None:
        return "–"
    if quantile <= 0:
        return f"none of the {tables} re-run tables lies below the printed number"
    if quantile >= 1:
        return f"all of the {tables} re-run tables lie below the printed number"
    percent = 100 * quantile
    return f"{percent:.{1 if 1 <= percent <= 99 else 2}f} % of the re-run tables lie below it"


def markdown_cell(text: object) -> str:
    """Return text that stays one cell of a Markdown table and can open no tag and no link."""
    plain = " ".join(str(text).split("\n"))
    return plain.replace("|", "\\|").replace("<", "&lt;").replace("](", "]\\(")


def again_command(paper: str, name: str, master_seed: str) -> str:
    """Return what to type to see a number come out again, fit for a shell whatever the seed is."""
    seed = ("--master-seed", master_seed) if master_seed else ()
    return shlex.join(("nox", "-s", "again", "--", paper, name, *seed))
