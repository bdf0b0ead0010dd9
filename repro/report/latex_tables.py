"""Printed tables beside their re-run, in LaTeX as journals want them (package booktabs)."""

import re
import unicodedata

import pandas as pd

from repro.judge.findings import IN_WORDS
from repro.report.words import digits_for, number
from repro.tables.published import Printed

_SPECIAL = {
    "\\": r"\textbackslash{}", "{": r"\{", "}": r"\}", "$": r"\$", "&": r"\&", "#": r"\#",
    "_": r"\_", "%": r"\%", "^": r"\textasciicircum{}", "~": r"\textasciitilde{}",
    "<": r"\textless{}", ">": r"\textgreater{}", "|": r"\textbar{}", '"': r"\textquotedbl{}",
    "−": "$-$", "×": r"$\times$", "±": r"$\pm$", "–": "--", "…": r"\dots{}", "°": r"$^\circ$",
    "≤": r"$\leq$", "≥": r"$\geq$", "≈": r"$\approx$", "∞": r"$\infty$", "√": r"$\surd$",
    "µ": r"$\mu$", "·": r"$\cdot$", "→": r"$\rightarrow$", "ο": "o",
    "⁻": "$^-$",
    **{mark: f"$^{k}$" for k, mark in enumerate("⁰¹²³⁴⁵⁶⁷⁸⁹")},
    **{mark: f"$_{k}$" for k, mark in enumerate("₀₁₂₃₄₅₆₇₈₉")},
    # letters that no text font of LaTeX has
    **{letter: rf"$\{unicodedata.name(letter).rpartition(' ')[2].lower()}$"
       for letter in "αβγδεζηθικμνξπρστυφχψω"},
    **{letter: rf"$\{unicodedata.name(letter).rpartition(' ')[2].capitalize()}$"
       for letter in "ΓΔΘΞΠΣΥΦΨΩ"},
    "λ": r"$\lambda$", "Λ": r"$\Lambda$",
}  # fmt: skip
_POWER = re.compile(r"×10\^(-?\d+)")
_LACKS = "--"


def escaped(text: object) -> str:
    """Return text that LaTeX prints as it is."""
    return "".join(_SPECIAL.get(letter, letter) for letter in " ".join(str(text).split()))


def latex_table(findings: pd.DataFrame, name: str) -> str:
    """Return one printed table: of every column what is printed and what came out.

    `findings` are those of the table, `name` its label in LaTeX.
    """
    first = findings.iloc[0]
    columns = list(dict.fromkeys(findings["column"]))
    cells = {(one.row, one.column): one for one in findings.itertuples()}
    lines = [
        " & ".join([escaped(row), *(_pair(cells.get((row, column))) for column in columns)])
        for row in dict.fromkeys(findings["row"])
    ]
    heads = "".join(rf" & \multicolumn{{2}}{{c}}{{{escaped(column)}}}" for column in columns)
    rules = "".join(rf"\cmidrule(lr){{{k}-{k + 1}}}" for k in range(2, 2 * len(columns) + 1, 2))
    caption = f"{escaped(first['table'])} of {escaped(first['paper'])}, as printed and re-run"
    return "\n".join([
        r"\begin{table}",
        r"\centering",
        rf"\caption{{{caption}}}",
        rf"\label{{tab:{name}}}",
        rf"\begin{{tabular}}{{l{'rr' * len(columns)}}}",
        r"\toprule",
        rf"{heads} \\",
        rules,
        " & printed & re-run" * len(columns) + r" \\",
        r"\midrule",
        *(rf"{line} \\" for line in lines),
        r"\bottomrule",
        r"\end{tabular}",
        r"\end{table}",
        "",
    ])  # fmt: skip


def _pair(one: object) -> str:
    """Return what is printed of a cell and what came out, with a dash for what there is not."""
    if one is None:
        return f"{_LACKS} & {_LACKS}"
    printed, unit, value = (getattr(one, name) for name in ("printed", "unit", "value"))
    if pd.isna(value):
        return f"{escaped(printed)} & {_LACKS}"
    digits = 4 if printed == IN_WORDS else digits_for(Printed(printed, unit))
    return f"{escaped(printed)} & {_number(value, digits)}"


def _number(value: float, digits: int) -> str:
    """Return a number in mathematics, where its minus is one."""
    text = _POWER.sub(r"\\times10^{\1}", number(value, digits).replace("−", "-"))
    return f"${text}$"
