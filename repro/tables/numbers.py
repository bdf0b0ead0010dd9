"""Every form that a number is printed in, and what stands where one is expected and is none."""

import math
import re
from dataclasses import dataclass
from functools import lru_cache

from repro.tables.markup import plain
from repro.tables.units import known_unit

_LONGEST = 60  # characters of a printed number
LONGEST_MARKED_UP = 240  # and with its markup

_DIGITS = (
    r"[-+]?\s?(?:[1-9][0-9]{0,2}(?:(?:,[0-9]{3})+|(?: [0-9]{3})+)(?:\.[0-9]*)?"
    r"|[0-9]+\.?[0-9]*|\.[0-9]+)"
)
_POWER = (
    r"\s?(?:[eEdD]\s?(?P<e>[-+]?\s?[0-9]+)"
    r"|[×xX·*]\s?10\s?(?:(?:\^|\*\*)\s?\(?(?P<power>[-+]?\s?[0-9]+)\)?|(?P<lowered>[-+]\s?[0-9]+))?"
    r"(?P<run_together>[0-9]*))"
)
_DECIMAL = re.compile(rf"(?P<digits>{_DIGITS})(?:{_POWER})?")
_TEN = re.compile(r"(?P<sign>[-+]?)10\s?(?:\^|\*\*)\s?(?P<power>[-+]?\s?[0-9]+)")
_PI = re.compile(
    r"(?P<sign>[-+]?)\s?(?P<times>[0-9]*)\s?[*·×]?\s?(?:π|pi)\s?(?:/\s?(?P<over>[1-9][0-9]*))?"
)
_SHARE = re.compile(r"(?P<part>[0-9]+)\s?/\s?(?P<whole>[1-9][0-9]*)")
_SIGN = r"[-+=≈~†‡*§¶#↑↓▲▼△▽]"
_MARK = re.compile(
    rf"(?P<rest>.*?[0-9.πi%°\)])\s?(?P<mark>/\s?[-+=≈~]|\(\s?{_SIGN}{{1,3}}\s?\)|\[\s?{_SIGN}{{1,3}}\s?\]"
    rf"|\^?(?:{_SIGN}\s?){{1,4}}|\^\(?[a-z]\)?)"
)
_LEADING_MARK = re.compile(r"(?P<mark>[†‡*§¶])\s?(?P<rest>[-+.0-9].*)")
_UNIT = re.compile(
    r"(?P<rest>.*[0-9]\.?|.*π)\s?(?P<unit>[^\W\d_%°][^0-9()±]*(?:\^?[23])?|[%°][^0-9()±]*(?:\^[23])?)"
)
_PAIR = re.compile(
    r"(?P<first>.*?[0-9.](?:\s?[†‡*§¶])?)\s?(?:(?:±|\+/-|\+-|\+ ?/ ?-)\s?(?P<after>[^()\[\]]+)"
    r"|\(\s?(?P<round>[-+.0-9][^()]*)\)|\[\s?(?P<square>[-+.0-9][^\[\]]*)\])\s?(?P<mark>[^0-9]*|\([0-9]{1,2}\))"
)
_BRACKETED = re.compile(
    r"\((?P<first>[^()±]+)(?:±|\+/-)(?P<after>[^()±]+)\)\s?(?P<power>[×xX·*eE].*|%)"
)
_SPREAD_AFTER = re.compile(r"(?P<first>.+?)\s?(?:±|\+/-)\s?(?P<after>.+)")
_NO_VALUE = re.compile(
    r"-{0,4}|[—–―/·×∅]|n\.?\s?/?\s?[ar]\.?|none|null|nil|\.\.\.|…|blank|missing|fail(?:ed)?|t\.?o\.?"
    r"|timeout|not available",
    re.IGNORECASE,
)
_NOT_A_NUMBER = re.compile(r"[-+]?\s?#?(?:nan|ind|-1\.#ind|num!?|div/0!)", re.IGNORECASE)
_INFINITE = re.compile(r"[-+]?\s?(?:inf(?:inity)?|∞)", re.IGNORECASE)
_TEST_MARK = re.compile(rf"\(?{_SIGN}{{1,3}}\)?|ns|n\.s\.")
_FORMULA = re.compile(r"=.*[\w(].*")
_LOST_SIGN = re.compile(r"[-+0-9.eE]*\(cid:[0-9]{1,4}\)[0-9.]+(?:[eE]\(cid:[0-9]{1,4}\)[0-9]+)?")
_BOUND = re.compile(r"(?:p\s?)?(?P<side><=|>=|<<|[<>≤≥≪≫])\s?(?P<rest>.+)")
_ABOUT = re.compile(r"[~≈]\s?[-+.0-9].*|(?:ca\.|about|approx\.?)\s.*")
_SPACED = re.compile(r"[0-9][ \t\r\n]+[0-9]")  # narrow spaces alone part groups of digits
_LOST_DIGIT = re.compile(
    r"[12][0-9]{2,}"
)  # what a lost minus is copied as, and the digits after it


@dataclass(frozen=True, slots=True, kw_only=True)
class NumberForm:
    """What a printed text says: `mantissa` × 10^`power`, in `unit`, with a `mark` behind it.

    `power` is None where no power of ten is printed. `value` is in the printed unit, `rounding`
    half a unit of the last printed digit, 0 for multiples of π and shares such as 4/30, which have
    no `mantissa`.
    """

    mantissa: str
    power: int | None
    value: float
    rounding: float
    unit: str = ""
    mark: str = ""


@dataclass(frozen=True, slots=True)
class NoNumber:
    """Why a text is not read as a number; `known` where it is one of the usual stand-ins."""

    because: str
    known: bool = True


@lru_cache(maxsize=1 << 16)
def number_form(text: str) -> NumberForm | NoNumber:
    """Return the number that a text prints, or why it is none.

    One unit and one mark of significance may follow; markup is no part of it. A group of three
    digits after a comma, or after a space narrower than usual, belongs to the number before it.
    """
    if len(text) > LONGEST_MARKED_UP:
        return NoNumber("it is too long", known=False)
    if _SPACED.search(text):
        return NoNumber("two numbers stand in one cell", known=False)
    simple = plain(text)
    if len(simple) > _LONGEST:
        return NoNumber("it is too long", known=False)
    return _bare(simple) or _marked(simple) or _no_number(simple)


def is_word(text: str) -> bool:
    """Say whether a text is neither a number nor a usual stand-in for one."""
    form = number_form(text)
    return isinstance(form, NoNumber) and not form.known


def split_pair(text: str) -> tuple[str, str, str] | None:
    """Return the two numbers of "a ± b" or "a (b)", b's sign "±", "(" or "["; None if it is none.

    A mark behind them is given to the first.
    """
    if len(text) > LONGEST_MARKED_UP:
        return None
    simple = plain(text)
    if whole := _BRACKETED.fullmatch(simple):  # (a ± b) × 10^k
        simple = (
            f"{whole['first'].strip()}{whole['power']} ± {whole['after'].strip()}{whole['power']}"
        )
    pair = _PAIR.fullmatch(simple)
    if pair is None:
        return None
    second = pair["after"] or pair["round"] or pair["square"]
    sign = "±" if pair["after"] else "(" if pair["round"] else "["
    mark = pair["mark"].strip()
    if sign == "±" and isinstance(own := number_form(second.strip()), NumberForm) and own.mark:
        second, mark = second.strip().removesuffix(own.mark).strip(), own.mark
    first, second = f"{pair['first'].strip()}{mark}".strip(), second.strip()
    if second.endswith("%") or mark == "%":
        first, second = (f"{each.rstrip('%').strip()}%" for each in (first, second))
    elif mark[1:-1].isdigit():  # a rank of both
        first = pair["first"].strip()
    if any(isinstance(number_form(each), NoNumber) for each in (first, second)):
        return None
    return first, second, sign


def _bare(text: str, mark: str = "") -> NumberForm | NoNumber | None:
    """Return the number of a text without a mark; None where it is none."""
    found = _value(text, mark=mark)
    if found is not None:
        return found
    parts = _UNIT.fullmatch(text)
    unit = known_unit(parts["unit"]) if parts else None
    return _value(parts["rest"].strip(), mark=mark, unit=unit) if parts and unit else None


def _value(text: str, *, mark: str, unit: str = "") -> NumberForm | NoNumber | None:
    if match := _DECIMAL.fullmatch(text):
        if match["run_together"]:
            return NoNumber(_run_together(match["run_together"]))
        has_power = len(match["digits"]) < len(text)
        power = match["e"] or match["power"] or match["lowered"] or ("1" if has_power else None)
        digits = re.sub(r"[\s,]", "", match["digits"])
        return _decimal(digits, power, mark=mark, unit=unit)
    if match := _TEN.fullmatch(text):
        return _decimal(f"{match['sign']}1", match["power"], mark=mark, unit=unit)
    if match := _PI.fullmatch(text):
        size = math.pi * int(match["times"] or 1) / int(match["over"] or 1)
        return _exact(-size if match["sign"] == "-" else size, mark=mark, unit=unit)
    if match := _SHARE.fullmatch(text):
        return _exact(int(match["part"]) / int(match["whole"]), mark=mark, unit=unit)
    return None


def _decimal(digits: str, power: str | None, *, mark: str, unit: str) -> NumberForm:
    exponent = int(power.replace(" ", "")) if power is not None else 0
    decimals = len(digits.partition(".")[2])
    return NumberForm(
        mantissa=digits,
        power=None if power is None else exponent,
        value=float(f"{digits}e{exponent}"),
        rounding=0.5 * float(f"1e{exponent - decimals}"),
        unit=unit,
        mark=mark,
    )


def _exact(value: float, *, mark: str, unit: str) -> NumberForm:
    return NumberForm(mantissa="", power=None, value=value, rounding=0.0, unit=unit, mark=mark)


def _marked(text: str) -> NumberForm | NoNumber | None:
    """Return the number of a text with a mark behind or before it; None where it is none."""
    for pattern in (_MARK, _LEADING_MARK):
        match = pattern.fullmatch(text)
        found = match and _bare(match["rest"].strip(), mark=match["mark"].strip())
        if found:
            return found
    return None


def _run_together(digits: str) -> str:
    if _LOST_DIGIT.fullmatch(digits):
        return (
            f"the exponent's sign was lost in copying: 10{digits} may stand for 10^{digits} or "
            f"10^-{digits[1:]}"
        )
    return f"the exponent was lost in copying: 10{digits} may stand for 10^{digits} or 10^-{digits}"


def _no_number(text: str) -> NoNumber:
    """Return why a text is no number."""
    usual = (
        (_NO_VALUE, "no value is printed"),
        (_NOT_A_NUMBER, "it is not a number"),
        (_INFINITE, "it is infinite"),
        (_ABOUT, "it is printed as approximate"),
        (_TEST_MARK, "it is a mark of a test"),
        (_FORMULA, "it is a formula, which is not run"),
        (_LOST_SIGN, "a sign was lost in copying, most likely a minus"),
    )
    for pattern, because in usual:
        if pattern.fullmatch(text):
            return NoNumber(because)
    bound = _BOUND.fullmatch(text)
    if bound and isinstance(_bare(bound["rest"].strip()), NumberForm):
        return NoNumber(f"it is a bound ({bound['side']}), not a value")
    two = _SPREAD_AFTER.fullmatch(text)
    known = two and _no_number(two["first"].strip())
    if known and known.known:
        return known
    if two or _PAIR.fullmatch(text):
        return NoNumber("two numbers stand in one cell", known=False)
    return NoNumber("", known=False)
