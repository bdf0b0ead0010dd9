"""How verdicts, numbers and differences are shown: by word and symbol, never colour alone."""

import math
import re
import shlex

from markupsafe import Markup, escape

from repro.judge.verdict import Unseen, Verdict
from repro.report.escapes import markdown_text
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
    Verdict.REPRODUCED: "95 of 100 tables of such runs, or more, lie within the tolerance",
    Verdict.CONSISTENT: "a table of such runs gives this number, but others outside the tolerance, "
    "too, so the number could be off by as much and would not be found out",
    Verdict.UNDECIDED: "a table of such runs hardly gives this number, but may give one within the "
    "tolerance",
    Verdict.DEPENDS: "a reading that the text allows, or a setting that it does not print, turns "
    "it between held (reproduced or consistent) and contradicted",
    Verdict.CONTRADICTED: "a table of such runs hardly comes within the tolerance, and no reading "
    "that the text allows, nor any setting, of those that were tried makes the number hold",
    Verdict.NOT_REPRODUCIBLE: "the paper does not print what a re-run needs",
    Verdict.NOT_RUN: "the runs are not in the store",
}
IMPOSSIBLE = (
    "no runs in single or double precision, summed in any usual order, rounded or cut off, give "
    "what is printed"
)
RESULTS = (
    "What one sentence, one constraint or one slip decides is one result, however many numbers "
    "show it, and as a whole it has the gravest verdict among them. Inputs, and what is true by "
    "definition, are shown and not counted."
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


def count_of(many: int, noun: str) -> str:
    """Return how many there are of what a noun names."""
    return f"{many} {noun}{'s' * (many != 1)}"


def digits_for(printed: Printed) -> int:
    """Return one significant digit more than is printed, and at least four."""
    return max(4, len(re.sub(r"\D", "", printed.mantissa).lstrip("0")) + 1)


def interval(pair: tuple[float, float] | None, digits: int = 4) -> str:
    """Return two numbers as an interval, or one where they are equal to the digits shown.

    Ends that are not there are infinite.
    """
    if pair is None:
        return "–"
    low, high = (_end(end, digits) for end in pair)
    return low if low == high else f"{low} … {high}"


def _end(end: float, digits: int) -> str:
    if math.isinf(end):
        return "∞" if end > 0 else "−∞"
    return number(end, digits)


def difference(printed: Printed, value: float | None) -> str:
    """Return how a reproduced value differs: in percent, or as a factor where it is large.

    A value that is greater has a "+" or a factor, of negative numbers, too; of these a large
    difference is shown as it is, since a factor would not say on which side it lies.
    """
    if value is None:
        return ""
    if value == printed.value or (printed.value and abs(value - printed.value) <= printed.rounding):
        return "as printed"
    ratio = value / printed.value if printed.value else 0.0
    if ratio <= 0 or (printed.value < 0 and not 0.1 < ratio <= 2):
        sign = "+" if value > printed.value else "−"
        return f"{sign}{number(abs(value - printed.value))}"
    if not 0.1 < ratio < 10:
        return f"{math.log10(ratio):+.1f} decades".replace("-", "−")
    if ratio > 2:
        return f"×{ratio:.2f}"
    percent = math.copysign(100, printed.value) * (ratio - 1)
    text = f"{percent:+.1f}" if abs(percent) >= 1 else f"{percent:+.1g}"
    return f"{text} %".replace("-", "−")


def raised(text: object) -> Markup:
    """Return text, safe for HTML, with its powers of ten raised."""
    return Markup(re.sub(r"10\^(-?)(\d+)", _power, str(escape(text))))  # noqa: S704 (escaped)


def seconds_raised(text: str) -> str:
    """Return text with rad/s^2 as rad/s²."""
    return re.sub(r"(?<=/s)\^([234])\b", lambda power: "²³⁴"[int(power[1]) - 2], text)


def _power(match: re.Match[str]) -> str:
    return f"10<sup>{'−' if match[1] else ''}{match[2]}</sup>"


def verdict_words(verdict: str, side: str | None) -> str:
    """Return symbol and words of a verdict, with the side on which the re-run lies of it."""
    word = Verdict(verdict)
    return f"{SYMBOLS[word]} {word}" + (f" (re-run {side})" if side else "")


def share(quantile: float | None, tables: int) -> str:
    """Return in words how many of so many tables that may come next are below what is printed."""
    if quantile is None:
        return "–"
    if quantile <= 0:
        return f"none of {tables} tables that may come next lies below the printed number"
    if quantile >= 1:
        return f"all of {tables} tables that may come next lie below the printed number"
    percent = 100 * quantile
    digits = 1 if 1 <= percent <= 99 else 2
    return f"{percent:.{digits}f} % of the tables that may come next lie below it"


def could_be_off(factor: Unseen, *, in_words: bool = False) -> str:
    """Return in words by how much a consistent number could be off and stay consistent.

    A statement `in_words` prints no number.
    """
    if in_words:
        return "other tables of such runs go against the statement"
    if factor == "unbounded":
        return "nothing bounds by how much the number could be off unseen"
    return f"the number could be off by a factor of {number(factor, 3)} unseen"


def counted(group: str | None, others: int) -> str:
    """Return in words what a finding counts with; nothing where it counts by itself."""
    if group is None:
        return "input or true by definition: shown, not counted"
    if not others:
        return ""
    return f"counts once with {others} other{'s' if others > 1 else ''}: {group}"


def markdown_cell(text: object) -> Markup:
    """Return text that stays one cell of a Markdown table and can open no tag and no link."""
    plain = re.sub(r"\r\n?|\n", " ", str(text))
    # a backslash before a bar would escape our own
    cell = re.sub(r"(\\*)\|", r"\1\1\|", plain)
    return Markup(markdown_text(cell))  # noqa: S704 (escaped once)


def again_command(paper: str, called: str, name: str, master_seed: str) -> str:
    """Return what to type to see a number come out again, fit for a shell whatever the seed is."""
    seed = ("--master-seed", master_seed) if master_seed else ()
    return command("again", paper, called, name, *seed)


def command(verb: str, paper: str, called: str, *more: str) -> str:
    """Return what to type: with what a paper from elsewhere is `called`, else in a checkout."""
    given = ("repro", verb, called) if called else ("nox", "-s", verb, "--", paper)
    return shlex.join((*given, *more))
