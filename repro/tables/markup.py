"""What a cell says without its markup: Markdown, LaTeX, HTML, and signs that only look different.

What is left has "-" for every minus, one kind of space, "×" for times, "^" before a raised text.
"""

import html
import re

_SPACES = re.compile(r"[\s\u00a0\u2000-\u200a\u202f\u205f\u3000]+")
_NOTHING_SEEN = re.compile("[\u00ad\u200b-\u200f\u2060\ufeff\x00-\x08\x0e-\x1f]")
_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻", "0123456789+-")
_RAISED_RUN = re.compile("[⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻]+")
_SIGNS = str.maketrans(
    {
        **dict.fromkeys("−﹣－‐‑⁃", "-"),
        **dict.fromkeys("＋﹢", "+"),
        **dict.fromkeys("✕✖⨯", "×"),
        **dict.fromkeys("∙⋅•", "·"),
        **dict.fromkeys("º˚", "°"),
        **dict.fromkeys("μ", "µ"),
        **dict.fromkeys("∗＊", "*"),
        "％": "%",
        "＝": "=",
        "．": ".",
        "（": "(",
        "）": ")",
    }
)
_TAG = re.compile(r"</?(?:[a-zA-Z][^<>]{0,200})>")
_RAISED_TAG = re.compile(r"<sup[^<>]{0,100}>\s*(.{0,60}?)\s*</sup>", re.IGNORECASE)
# commands that say how their last argument looks; a first one may be a colour
_COLOURS = re.compile(
    r"\\(?:cellcolor|rowcolor|color|textcolor|colorbox)(?:\[[^\]]{0,20}\])?\{[^{}]{0,60}\}"
)
_LOOKS = re.compile(
    r"\\(?:math(?:bf|rm|it|sf|tt|bb|cal)|text(?:bf|it|rm|sf|tt|sc|sl|normal|up|md)?|emph|underline"
    r"|uline|bm|boldsymbol|num|hl|mbox|hbox|ensuremath|makecell|shortstack|thead|tabincell"
    r"|textsubscript)\*?(?:\[[^\]]{0,60}\])?\s*\{([^{}]*)\}"
)
_STYLES = re.compile(
    r"\\(?:bf|it|rm|tt|em|bfseries|itshape|rmfamily|centering|tiny|scriptsize|footnotesize|small"
    r"|normalsize|large|displaystyle|left|right|B|phantom\{[^{}]*\}|hspace\*?\{[^{}]*\}"
    r"|quad|qquad|rule\{[^{}]*\}\{[^{}]*\}|noindent|relax|unboldmath|boldmath"
    r"|vspace\*?\{[^{}]*\}|label\{[^{}]*\}|cite[tp]?\{[^{}]*\}|footnotemark(?:\[[^\]]*\])?)"
    r"(?![a-zA-Z])"
)
_QUANTITY = re.compile(r"\\(?:SI|qty)(?:\[[^\]]{0,60}\])?\{([^{}]*)\}\{([^{}]*)\}")
_FRACTION = re.compile(r"\\[dt]?frac\{([^{}]*)\}\{([^{}]*)\}")
_WORDS = {
    "times": "×",
    "cdot": "·",
    "pm": "±",
    "mu": "µ",
    "textmu": "µ",
    "micro": "µ",
    "pi": "π",
    "dagger": "†",
    "dag": "†",
    "ddagger": "‡",
    "ddag": "‡",
    "ast": "*",
    "star": "*",
    "S": "§",
    "approx": "≈",
    "sim": "~",
    "infty": "∞",
    "circ": "°",
    "degree": "°",
    "deg": "°",
    "leq": "≤",
    "le": "≤",
    "geq": "≥",
    "ge": "≥",
    "sigma": "σ",
    "alpha": "α",
    "theta": "θ",
    "second": "s",
    "milli": "m",
    "metre": "m",
    "meter": "m",
    "centi": "c",
    "kilo": "k",
    "newton": "N",
    "joule": "J",
    "percent": "%",
    "per": "/",
    "radian": "rad",
    "minute": "min",
    "textminus": "-",
    "minus": "-",
    "textdegree": "°",
    "textpm": "±",
    "texttimes": "×",
    "uparrow": "↑",
    "downarrow": "↓",
    "bullet": "•",
    "textdagger": "†",
    "textsigma": "σ",
    "lt": "<",
    "gt": ">",
    "textless": "<",
    "textgreater": ">",
    "textendash": "–",
    "checkmark": "✓",
    "hour": "h",
    "gram": "g",
    "watt": "W",
    "hertz": "Hz",
    "mathsection": "§",
    "bar": "",
    "overline": "",
    "hat": "",
    "textemdash": "—",
    "nano": "n",
    "equiv": "≈",
}
_LONGEST = 5_000  # characters of a caption; what is longer is cut
_BARE = re.compile(r"[-+]?[A-Za-z0-9.]+(?:[eE][-+][0-9]+)?")
_WORD = re.compile(r"\\([a-zA-Z]+) *")
_ESCAPED = re.compile(r"\\([%$&#_{}])")
_GAP = re.compile(r"\\[,;:! >]|~|\\ ")
_PAIRED = re.compile(r"(\*\*\*|\*\*|\*|___|__|_|~~|`)(.+)\1")
_RAISED_GROUP = re.compile(r"\^\s*\{\s*([^{}]*?)\s*\}")


def plain(text: str) -> str:
    """Return the text without markup; what is no known markup stays as it is."""
    if _BARE.fullmatch(text):  # most cells have none
        return text
    text = text[:_LONGEST]
    if "<" in text or "&" in text:
        text = _TAG.sub(" ", _RAISED_TAG.sub(r"^\1", html.unescape(text)))
    if "\\" in text or "$" in text or "{" in text:
        text = _without_latex(text)
    text = _NOTHING_SEEN.sub("", text).translate(_SIGNS)
    text = _RAISED_RUN.sub(lambda run: "^" + run[0].translate(_RAISED), text)
    text = _SPACES.sub(" ", text).strip()
    while paired := _PAIRED.fullmatch(text):
        text = paired[2].strip()
    return text


def _without_latex(text: str) -> str:
    text = _COLOURS.sub("", text)
    text = _ESCAPED.sub(
        lambda escaped: {"$": "", "{": "", "}": ""}.get(escaped[1], escaped[1]), text
    )
    text = text.replace("$", "").replace("{,}", ",").replace("{.}", ".").replace("{-}", "-")
    for _ in range(6):  # one command inside another, as deep as anyone writes them
        before = text
        text = _FRACTION.sub(r"\1/\2", text)
        text = _QUANTITY.sub(r"\1 \2", text)
        text = _RAISED_GROUP.sub(r"^\1", text)
        text = _LOOKS.sub(r"\1", text)
        text = re.sub(r"\\textsuperscript\{([^{}]*)\}", r"^\1", text)
        text = _STYLES.sub("", text)
        if text == before:
            break
    text = _GAP.sub(" ", text)
    text = _WORD.sub(lambda word: _WORDS.get(word[1], word[0]), text)
    return text.replace("{", "").replace("}", "").replace("^°", "°")
