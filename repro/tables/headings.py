"""What the words of headings mean: statistics, runs, roles, in the ways that tables write them."""

import re
from collections.abc import Iterator
from functools import lru_cache

from repro.tables.markup import plain

_SEPARATOR = r"[\s._-]*"
# In this order: "mean rank" is no mean, "mean of the best" is one.
_COUNT = r"(?:#\s?|no\.?\sof\s|number\sof\s)?"
_PATTERNS = {
    "average rank": r"(?:av(?:era)?g?e?|mean|overall|friedman)\.?\s?-?(?:friedman\s?)?"
    r"rank(?:ing|s)?"
    r"|friedman(?:'s)?(?:\s(?:test|value|mean))?|rank(?:ing)?\s?(?:mean|average|avg)",
    "total rank": r"(?:total|final|sum\sof)\s?rank(?:ing|s)?|rank\s?sum",
    "rank": r"rank(?:ing|s)?|rk|排名|排序",
    "success rate": r"suc(?:c|cess)?\.?(?:ess(?:ful)?)?\s?(?:rate|ratio|%)|sr|hit\s?rate|success"
    r"|成功率",
    "sem": r"sem|std\.?\sof\s(?:the\s)?mean|s\.e\.m?\.?|std\.?\s?err(?:or|\.)?"
    r"|standard\serror(?:\sof\sthe\smean)?|标准误",
    "variance": r"var(?:iance|\.)?|σ\s?(?:\^2|²)|std\.?\s?\^2|方差|varianz|varianza",
    "std": r"st(?:andar)?d?\.?[\s_-]*dev(?:iations?|s|\.)?|std[ae]?v?(?:dev)?\.?|stdv\.?|stdev"
    r"|s\.d\.?|sd|^standard$|st\.?\s?d(?:ev)?\.?|σ|sigma|标准差|均方差|écart[\s-]type"
    r"|desv(?:iación|\.)?(?:\s(?:estándar|típica|est\.?))?"
    r"|desvio(?:[\s-]padrão)?|standardabweichung|deviazione(?:\sstandard)?|ско|deviation|dev\.?|標準偏差|표준편차|standart\ssapma|odchylenie(?:\sstandardowe)?|standaardafwijking|standardavvikelse",
    "median": r"median[aeo]?|med\.?|médiane|中位数|中值|中央値|중앙값|medyan|mediaan|медиана",
    "mean": r"mean|avg?\.?|average[ds]?|ave\.?|media|média|moy(?:enne|\.)?|mittel(?:wert)?|mw|µ|x̄"
    r"|平均[值値]?|均值|평균값?|ortalama|średnia|gemiddelde|medelvärde|среднее|mean\svalue",
    "worst": r"worst|peor|pire|schlechteste[rs]?|pior|peggiore|最差值?|最坏值?|худшее|wst\.?"
    r"|最悪値?|최악값?|en\skötü|najgorsz[yae]|slechtste",
    "highest": r"max(?:imum|imal|\.)?|máx(?:imo|\.)?|massimo|最大值?|макс(?:имум|\.)?|highest",
    "best": r"best|mejor|meilleure?|beste[rs]?|bestwert|melhor|migliore|最优值?|最好值?|最佳值?"
    r"|最良値?|최적값?|en\siyi|najlepsz[yae]"
    r"|лучшее|bst\.?",
    "lowest": r"min(?:imum|imal|\.)?|mín(?:imo|\.)?|minimo|最小值?|мин(?:имум|\.)?|lowest",
    "iqr": r"iqr|inter[\s-]?quartile(?:\srange)?|rango\sintercuart[ií]lico|四分位距",
    "p-value": r"p[\s-]*val(?:ue|\.)?s?|p",
    "z": r"z[\s-]*(?:val(?:ue|\.)?s?|score)?",
    "h": r"h",
    # these words mean counts and effects only where nothing else stands in the heading
    "r": r"^(?:effect\ssize(?:\s\(?r\)?)?|r)$",
    "ties": rf"^{_COUNT}(?:ties?|draws?)$",
    "losses": rf"^{_COUNT}(?:loss(?:es)?)$",
    "wins": r"\+/[=≈~]/-|w/[td]/l|wins?/(?:ties?|draws?)/loss(?:es)?|\(?w\|t\|l\)?|\+/-/[=≈~]|w/l/t"
    r"|[=≈]/\+/-|win/tie/loss|b/s/w|better/(?:equal|similar)/worse"
    rf"|^{_COUNT}wins?$",
    "q1": r"q1|first\squartile|lower\squartile|25th\spercentile",
    "q3": r"q3|third\squartile|upper\squartile|75th\spercentile",
    "time": r"(?:cpu\s|run\s?|elapsed\s|comp(?:utation(?:al)?|uting)?\.?\s)?times?|cpu|runtime"
    r"|耗时|时间|zeit|tiempo",
}
_KNOWN = {
    name: re.compile(rf"(?<![a-z0-9])(?:{pattern})(?![a-z0-9])")
    for name, pattern in _PATTERNS.items()
}
_CAMEL = re.compile(r"(?<=[a-z])(?=[A-Z])")
_FILLERS = re.compile(
    r"(?<![a-z0-9])(?:values?|val\.?|of|the|fitness|cost|objective|obj\.?|function|results?|score"
    r"|solutions?|index|errors?|runs?|value|[=:])(?![a-z0-9])",
    re.IGNORECASE,
)
# algorithms whose names have the word of a statistic in them: DE/current-to-best/1, max-min ants
_NAMED_SO = re.compile(
    r"to[\s_/-]+p?best(?:[\s_/-]*\d)?|best\s?/\s?\d|de[\s/-]+p?best[\s/-]+\d|max[_-]?min|min[_-]?max"
)
_SPACES = re.compile(r"\s+")
_UNIT = re.compile(r"[\[(][^\[\]()]*[\])]")
_RUNS = re.compile(
    r"(?P<before>\d{1,6})\s*(?:independent|separate|different|random|repeated|trial|test|times\sof"
    r"|successive|consecutive|statistical|individual)*\s*(?:[^\W\d_]+\s)?"
    r"(?:runs?\b|trials?\b|repetitions?\b|repeats?\b|replications?\b|times\b|executions?\b|experiments\b|次"
    r"|ejecuciones\b|corridas\b|repeticiones\b|execuções\b|repetições\b|exécutions\b|läufen?\b|прогон)"
    r"|\b(?:runs?|trials?|repetitions?|repeats?|n_?runs|number\sof\sruns|ejecuciones(?:\sindependientes)?)"
    r"\s*(?:=|:|was|is)\s*(?P<after>\d{1,6})\b",
    re.IGNORECASE,
)
_SIZE = re.compile(r"\bn\s*=\s*(?P<after>\d{1,6})\b", re.IGNORECASE)
_COLUMN_OF_RUNS = re.compile(
    r"(?:n_?|no\.?\s(?:of\s)?|num(?:ber)?[\s_](?:of[\s_])?|#\s?|(?:total|independent|jumlah|anzahl)[\s_])?"
    r"(?:runs?|trials?|rep(?:eat|etition)?s?|counts?|läufe)",
    re.IGNORECASE,
)
_QUANTITY = re.compile(
    r"(?<![a-z])(?:times?|cpu|runtime|evaluations?|evals?|n?fes?|iterations?|iters?|epochs?|generations?"
    r"|gens?|seconds?|memory|calls|gap|length|error\srate)(?![a-z])",
    re.IGNORECASE,
)
_NUMBER_WORDS = {
    "ten": 10,
    "fifteen": 15,
    "twenty": 20,
    "twenty-five": 25,
    "thirty": 30,
    "forty": 40,
    "fifty": 50,
    "fifty-one": 51,
    "hundred": 100,
    "one hundred": 100,
}
_RUN_WORDS = re.compile(
    rf"\b(?P<word>{'|'.join(sorted(_NUMBER_WORDS, key=len, reverse=True))})\s+"
    r"(?:independent\s|different\s)?"
    r"(?:runs|trials|times|repetitions|executions)\b",
    re.IGNORECASE,
)
_PROBLEM = re.compile(
    r"(?:bench.*|func?t?i?o?n?s?|fun\.?|fn|f|test(?:\s?func.*|\s?prob.*)?|problems?|prob\.?|instances?|no\.?|#"
    r"|fun(?:ci[óo]n(?:es)?|[çc][ãa]o|ktion(?:en)?|zione)|fonctions?|inst[aâ]n(?:cias?|z(?:en?)?)"
    r"|probl[eè]m(?:as?|es?)?|f(?:unc(?:tion)?)?[\s_-]?id|функция|задача"
    r"|id|case|task|data\s?sets?|name|cec.*|函数|関数|함수|fonksiyon|funkcja|测试函数|dim(?:ensions?|\.)?|d|size|f\s?\(x\)|map|scenario|f#|type)",
    re.IGNORECASE,
)
_ALGORITHM = re.compile(
    r"(?:alg(?:o(?:rithm(?:us|en|e)?|r[ií]tm[oa])?s?)?\.?|m[eé]t(?:hod[es]?|odos?|hodes)|verfahren|алгоритм|метод|optimi[sz]ers?|approach(?:es)?|techniques?|models?|solvers?|算法|variant)",
    re.IGNORECASE,
)
_STATISTIC = re.compile(
    r"(?:ind(?:ex|icator)e?s?|metrics?|stat(?:istic)?s?\.?|measures?|items?|criteri(?:on|a)|values?|指标|type|result)",
    re.IGNORECASE,
)
_PROBLEM_NAME = re.compile(
    r"(?:(?:cec[\s_-]?\d*[\s_-]*)?f(?:un(?:c|ction)?)?[\s_-]?\(?\d{1,3}\)?(?:\s*\(.*\))?|g\d{1,2}|tf\d+|c\d{2}|p\d{1,2}"
    r"|sphere.*|rastrigin.*|ackley.*|griewank.*|rosenbrock.*|schwefel.*|.*\bproblem|.*\bdesign)",
    re.IGNORECASE,
)


@lru_cache(maxsize=1 << 14)
def statistics_in(label: str) -> tuple[tuple[str, ...], str]:
    """Return the statistics that a heading names, in its order, and what else it says."""
    text = _CAMEL.sub(" ", plain(label))[:200]
    lowered = text.lower().replace("_", " ")
    if len(lowered) != len(text):  # a few letters have longer lower forms
        text = lowered
    lowered = _NAMED_SO.sub(lambda name: "x" * len(name[0]), lowered)
    found: list[tuple[int, int, str]] = []
    for name, pattern in _KNOWN.items():
        for match in pattern.finditer(lowered):
            if all(match.end() <= start or match.start() >= end for start, end, _ in found):
                found.append((match.start(), match.end(), name))
    names = {name for *_, name in found}
    if "time" in names and len(names) > 1:  # the mean of times, say
        found = [each for each in found if each[2] != "time"]
    rest = text
    for start, end, _ in sorted(found, reverse=True):
        rest = rest[:start] + " " + rest[end:]
    rest = _FILLERS.sub(" ", _UNIT.sub(" ", rest) if found else rest) if found else rest
    rest = _SPACES.sub(" ", rest)
    return tuple(dict.fromkeys(name for *_, name in sorted(found))), rest.strip(
        " .,:;_-/|±()[]+=&%\t"
    )


def is_statistic(label: str) -> bool:
    """Say whether a heading names statistics and nothing else."""
    names, rest = statistics_in(label)
    return bool(names) and not rest


def runs_in(text: str) -> Iterator[tuple[int, str]]:
    """Yield every number of runs that a text tells, with the words that tell it."""
    for match in _RUNS.finditer(text):
        yield int(match["before"] or match["after"]), match[0].strip()
    for match in _RUN_WORDS.finditer(text):
        yield _NUMBER_WORDS[match["word"].lower()], match[0].strip()


def sizes_in(text: str) -> Iterator[tuple[int, str]]:
    """Yield every n of "n = 30" in a text, with those words."""
    for match in _SIZE.finditer(text):
        yield int(match["after"]), match[0].strip()


def heads_runs(heading: str) -> bool:
    """Say whether a heading stands over numbers of runs."""
    return _COLUMN_OF_RUNS.fullmatch(plain(heading).strip()) is not None


def names_quantity(text: str) -> bool:
    """Say whether what a heading says beside its statistic is what was measured, a time say."""
    return _QUANTITY.search(text) is not None


def heads_problems(heading: str) -> bool:
    """Say whether a heading stands over names of problems, their numbers or sizes."""
    return _PROBLEM.fullmatch(plain(heading).strip(" .:")) is not None


def heads_algorithms(heading: str) -> bool:
    """Say whether a heading stands over names of algorithms."""
    return _ALGORITHM.fullmatch(plain(heading).strip(" .:")) is not None


def heads_statistics(heading: str) -> bool:
    """Say whether a heading stands over names of statistics."""
    return _STATISTIC.fullmatch(plain(heading).strip(" .:")) is not None


def is_problem_name(label: str) -> bool:
    """Say whether a label looks like the name of a test function or problem."""
    return _PROBLEM_NAME.fullmatch(plain(label).strip(" .:")) is not None
