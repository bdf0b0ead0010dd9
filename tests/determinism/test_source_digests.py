import importlib
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from repro.determinism.source_digests import digest_of, told
from repro.errors import DeclarationError
from repro.functions import FUNCTIONS, Known
from repro.optimisers import DE, WOA
from tests.determinism.edited_packages import Package, forget, package

__all__ = ["package"]

# a line that ends in `!` decides what SEARCH gives; no other line does
PAPER = """
'''A paper.'''
from dataclasses import dataclass, field
from functools import cached_property, partial
import math
from . import constants, table
from .laws import Law, shared as common
from .kernels import *
try:
    from .missing import speed
except ImportError:
    speed = 2.0  #!

TITLE = "a title"
NOTES = ["a note"]
NOTES.append("another")
unused = lambda: 3.0


def ignored(x):
    return constants.UNUSED * x


def scaled(x, by=constants.SCALE):
    '''Return x, scaled.'''
    from .deep import twice
    return twice(by * x)  #!


def made(power):
    offset = 0.5  #!

    def inner(x):
        return x ** power + offset  #!

    return inner


class Parent:
    bound = 4.0  #!


@dataclass(frozen=True)
class Search(Parent):
    '''A search.'''

    law: Law
    cost: object
    width: float = field(default=1.0)  #!
    steps = 7  #!

    def minimise(self, problem, **budget):
        '''Search.'''
        # a comment
        rate: float = math.cos(self.width)  #!
        for key in table.REGISTRY:
            rate += table.REGISTRY[key](rate)
        return scaled(rate) * speed + area(rate) + common(rate) + self.bound

    @cached_property
    def kept(self):
        return 3  #!


table.ROWS.append(5)  #!
constants.CHANGED = 12  #!
RATES = {"a": 1.5}
SEARCH = Search(law=Law(peak=3.0), cost=partial(made(2), 3.0), width=1.25)  #!
OTHER = Search(law=Law(peak=9.0), cost=None)
"""
FILES = {
    "paper.py": PAPER,
    "constants.py": """
SCALE = 2.0  #!
UNUSED = 5.0
CHANGED = 1  #!
STEP = SCALE / 2  #!
""",
    "deep.py": """
from .constants import STEP as step
from . import constants as values
def twice(x):
    return 2.0 * x + step + values.CHANGED  #!
def thrice(x):
    return 3.0 * x
""",
    "laws.py": """
import dataclasses
from . import table as tables
@dataclasses.dataclass(frozen=True)
class Law:
    '''A law.'''
    peak: float
    def sample(self, x):
        return self.peak * x + _share(x)  #!
def _share(x):
    return 0.25 * x + tables.ROWS[0]  #!
def shared(x):
    total = 0.0  #!
    for k in range(3):  #!
        total += k * x  #!
    return total
def lonely(x):
    return -x
""",
    "kernels.py": """
__all__ = ["area"]
if __debug__:
    FACTOR = 1.5  #!
def area(x):
    global _CALLS
    _CALLS = 1  #!
    return FACTOR * x  #!
def volume(x):
    return x ** 3
_CALLS = 0  #!
""",
    "table.py": """
ROWS = []
for _row in (1, 2):  #!
    ROWS.append(_row)  #!
REGISTRY = {}
def register(function):
    REGISTRY[function.__name__] = function  #!
    return function
@register
def entry(x):
    return x / 3.0  #!
def stray(x):
    return x / 4.0
""",
}  # fmt: skip
LINES = [
    (name, number)
    for name, text in FILES.items()
    for number, line in enumerate(text.splitlines())
    if line.strip() and not line.lstrip().startswith(("#", '"""', "@", "from", "import", "try"))
]


def edited(name: str, number: int) -> dict[str, str] | None:
    """Return the files with one number of a line another; None where the line has none."""
    lines = FILES[name].splitlines()
    code, mark, rest = lines[number].partition("#")
    digits = [k for k, letter in enumerate(code) if letter.isdigit()]
    if not digits:
        return None
    k = digits[-1]
    changed = "7" if code[k] != "7" else "8"
    lines[number] = f"{code[:k]}{changed}{code[k + 1 :]}{mark}{rest}"
    return FILES | {name: "\n".join(lines) + "\n"}


CHANGES = [
    pytest.param(texts, FILES[name].splitlines()[number].endswith("#!"),
                 id=f"{name}:{number}")
    for name, number in LINES
    if (texts := edited(name, number))
]  # fmt: skip


@pytest.mark.parametrize(("texts", "counts"), CHANGES)
def test_a_line_counts_where_what_is_digested_reaches_it(
    package: Package, texts: dict[str, str], *, counts: bool
) -> None:
    before = digest_of(package.load(FILES).SEARCH)

    assert (digest_of(package.load(texts).SEARCH) != before) is counts


def test_lines_of_both_kinds_were_tried() -> None:
    assert sum(bool(change.values[1]) for change in CHANGES) > 20
    assert sum(not change.values[1] for change in CHANGES) > 6


@pytest.mark.parametrize(
    ("name", "old", "new"),
    [
        ("paper.py", "'''A search.'''", "'''Another.'''"),
        ("paper.py", "        '''Search.'''\n", ""),
        ("paper.py", "# a comment", "# another"),
        ("paper.py", "rate: float", "rate: object"),
        ("paper.py", '"a title"', '"another title"'),
        ("paper.py", "def scaled(x, by", "def scaled(x: float, by"),
        ("paper.py", "\n\n\nclass", "\n\nclass"),
        ("paper.py", "import math", "import math\nimport statistics"),
        ("paper.py", "twice(by * x)", "twice((by * x))"),
        ("laws.py", "'''A law.'''", "'''The law.'''"),
        ("constants.py", "UNUSED = 5.0", "# nothing"),
        ("deep.py", "def thrice", "MORE = 3\n\n\ndef thrice"),
    ],
)
def test_words_layout_and_annotations_do_not_count(
    package: Package, name: str, old: str, new: str
) -> None:
    assert old in FILES[name]
    before = digest_of(package.load(FILES).SEARCH)

    after = package.load(FILES | {name: FILES[name].replace(old, new)})

    assert digest_of(after.SEARCH) == before


@pytest.mark.parametrize(
    ("name", "old", "new"),
    [
        ("paper.py", "from .laws import Law, shared as", "from .laws import Law, lonely as"),
        ("paper.py", "import math", "import cmath as math"),
        ("deep.py", "import STEP as step", "import SCALE as step"),
        ("table.py", "def stray", "@register\ndef stray"),
        ("table.py", "ROWS = []", "ROWS = [3]"),
        ("kernels.py", "FACTOR * x", "x * FACTOR"),
        ("constants.py", "CHANGED = 1", "SCALE = 1.0 + SCALE\nCHANGED = 1"),
        ("laws.py", "    peak: float\n", "    peak: float\n    power: float = 2.0\n"),
    ],
)
def test_what_a_name_stands_for_counts(package: Package, name: str, old: str, new: str) -> None:
    assert old in FILES[name]
    before = digest_of(package.load(FILES).SEARCH)

    after = package.load(FILES | {name: FILES[name].replace(old, new)})

    assert digest_of(after.SEARCH) != before


DISPATCHING = """
from functools import singledispatch
@singledispatch
def f(x):
    return 1
@f.register
def _(x: int):
    return 2
SEARCH = f
"""
SLOTTED = """
class S:
    __slots__ = ('a', '__b')
    def __init__(self):
        self.a = 1
        self.__b = [self]
SEARCH = S()
SEARCH.a = 5
"""


def of_object(package: Package, text: str, **more: str) -> str:
    return digest_of(package.load({"paper.py": text, **more}).SEARCH)


@pytest.mark.parametrize(
    ("text", "old", "new"),
    [
        ("f = lambda x: x + 1\nclass S:\n    pass\nSEARCH = S()\nSEARCH.f = f", "+ 1", "+ 2"),
        ("SEARCH = [lambda x: x + 1, 2]", "+ 1", "+ 2"),
        ("A, B = 1, 2\ndef f():\n    return A, B\nSEARCH = f", "1, 2", "2, 1"),
        ("A = 1\nB = A\nA = 2\ndef f():\n    return A, B\nSEARCH = f",
         "B = A\nA = 2", "A = 2\nB = A"),
        ("class S:\n    x = 1\ndef f():\n    return S.x\nS.x = 3\nSEARCH = f", "= 3", "= 4"),
        ("class S:\n    x = 1\ndef f():\n    return S.x\nsetattr(S, 'x', 3)\nSEARCH = f", "3", "4"),
        ("def f():\n    return globals()['A']\nA = 3\nSEARCH = f", "= 3", "= 4"),
        ("import sys\ndef f():\n    return sys.modules[__name__]\nA = 3\nSEARCH = f", "= 3", "= 4"),
        ("class M(type):\n    y = 1\nclass S(metaclass=M):\n    pass\nSEARCH = S()", "= 1", "= 2"),
        ("def g(x):\n  return x\nA = 3\ndef f():\n    return g(A).real\nSEARCH = f", "= 3", "= 4"),
        (DISPATCHING, "return 2", "return 3"),
        (DISPATCHING, "x: int", "x: float"),
        (SLOTTED, "= 5", "= 6"),
        ("class S(dict):\n    pass\nSEARCH = S(a=1)", "a=1", "a=2"),
        ("class S(float):\n    pass\nSEARCH = S(1.5)", "1.5", "2.5"),
        ("import enum\nclass E(enum.Enum):\n    A = 1\n    B = 2\nSEARCH = E.A", "E.A", "E.B"),
        ("import numpy as np\nSEARCH = np.array([1.0, 2.0])", "2.0", "2.5"),
        ("import numpy as np\nSEARCH = np.zeros(3)", "np.zeros(3)", "np.zeros(3, dtype=int)"),
        ("import decimal\nSEARCH = decimal.Decimal('1.5')", "1.5", "1.6"),
        ("import collections\nSEARCH = collections.deque([1, 2])", "2]", "3]"),
        ("from fractions import Fraction\nSEARCH = Fraction(1, 3)", "1, 3", "2, 3"),
        ("class S:\n    identity = property(lambda self: (1,))\nSEARCH = S()", "(1,)", "(2,)"),
    ],
)  # fmt: skip
def test_every_kind_of_object_is_told_by_what_it_is(
    package: Package, text: str, old: str, new: str
) -> None:
    assert old in text

    assert of_object(package, text) == of_object(package, text)
    assert of_object(package, text) != of_object(package, text.replace(old, new))


def test_a_value_that_is_read_from_a_file_counts(package: Package, tmp_path: Path) -> None:
    file = tmp_path / "numbers.txt"
    text = (
        f"from pathlib import Path\nN = Path({str(file)!r}).read_text()\n"
        "def f():\n    return N\nSEARCH = f"
    )
    file.write_text("3")
    before = of_object(package, text)

    file.write_text("4")

    assert of_object(package, text) != before


def test_what_runs_change_does_not_count(package: Package) -> None:
    text = "MEMORY = {}\ndef f(x):\n    MEMORY[x] = 1\n    return x\nSEARCH = f"
    module = package.load({"paper.py": text})
    before = digest_of(module.SEARCH)

    module.SEARCH(3)
    forget()

    assert digest_of(module.SEARCH) == before


def test_caches_of_an_object_do_not_count(package: Package) -> None:
    module = package.load(FILES)
    before = digest_of(module.SEARCH)

    assert module.SEARCH.kept == 3
    vars(module.SEARCH)["_cached_rows"] = [1]

    assert digest_of(module.SEARCH) == before


INLINE = """
from repro.functions import BoxProblem
from repro.model import Experiment
from repro.optimisers import WOA
def own(x):
    return 2.0 * float((x ** 2).sum())
TEST = Experiment(
    name="test", where="section 1", proposed="WOA",
    problems={"Own": BoxProblem(cost=own, box=[(-1, 2)] * 3)},
    algorithms={"WOA": WOA()}, population=10, iterations=20, runs=5,
)
SEARCH = TEST.problems["Own"]
"""


@pytest.mark.parametrize(
    ("old", "new", "counts"),
    [
        ("section 1", "section 2", False),
        ("runs=5", "runs=6", False),
        ('{"WOA": WOA()}', '{"WOA": WOA(), "Other": WOA(b=2.0)}', False),
        ("2.0 * float", "3.0 * float", True),
        ("(-1, 2)", "(-1, 3)", True),
    ],
)
def test_words_around_a_problem_that_is_made_among_them_do_not_count(
    package: Package, old: str, new: str, *, counts: bool
) -> None:
    assert old in INLINE
    before = digest_of(package.load({"paper.py": INLINE}).SEARCH)

    after = digest_of(package.load({"paper.py": INLINE.replace(old, new)}).SEARCH)

    assert (after != before) is counts


STRANGER = """
from . import paper, table, constants
for _note in ("more",):
    paper.NOTES.append(_note)
{act}
"""


@pytest.mark.parametrize(
    ("act", "counts"), [("", False), ("table.ROWS[0] = 4", True), ("constants.STEP = 3.0", True)]
)
def test_a_module_beside_counts_by_what_it_sets_and_not_by_being_loaded(
    package: Package, act: str, *, counts: bool
) -> None:
    search = package.load(FILES | {"stranger.py": STRANGER.format(act=act)}).SEARCH
    before = digest_of(search)

    importlib.import_module(f"{package.name}.stranger")
    forget()

    assert (digest_of(search) != before) is counts


@pytest.mark.parametrize(
    ("place", "value"),
    [
        ("repro.optimisers.differential_evolution._LEAST", 5),
        ("repro.optimisers.differential_evolution.DE", WOA),
    ],
)
def test_a_name_of_the_engine_that_is_set_from_outside_counts(
    place: str, value: object, monkeypatch: pytest.MonkeyPatch
) -> None:
    search = DE()
    before = digest_of(search)

    monkeypatch.setattr(place, value)
    forget()
    after = digest_of(search)
    monkeypatch.undo()
    forget()

    assert after != before == digest_of(search)


def test_what_is_but_said_of_a_function_does_not_count() -> None:
    sphere = FUNCTIONS["sphere"]
    before = digest_of(sphere.problem(3))

    renamed = replace(sphere, title="A bowl", source="A book", known=Known())
    assert digest_of(renamed.problem(3)) == before
    assert digest_of(replace(sphere, minimum=1.0).problem(3)) != before


@pytest.mark.parametrize(
    ("make", "says"),
    [
        (
            lambda: eval("lambda x: x"),  # noqa: S307 (as one types at a prompt)
            "rests on the function <lambda>, whose source cannot be",
        ),
        (
            lambda: eval("lambda x: x", {}),  # noqa: S307 (of no module)
            "whose source cannot be found: define it by name in a file",
        ),
        (lambda: sys.__stdout__, "whose value cannot be told: make it a frozen"),
        (lambda: (x for x in [1]), "whose value cannot be told"),
        (type("Made", (), {}), "rests on the class Made"),
        (lambda: __import__("numpy").random.default_rng(1), "holds random numbers"),
        (lambda: __import__("threading").Lock(), "an `identity`"),
    ],
)
def test_what_cannot_be_told_is_refused_with_the_remedy(
    package: Package, make: Callable[[], Any], says: str
) -> None:
    search = package.load(FILES).SEARCH
    object.__setattr__(search, "cost", {"a": [make()]})

    with pytest.raises(DeclarationError, match=r"^algorithm\.cost\['a'\]\[0\] .*") as raised:
        told(algorithm=search)
    assert says in str(raised.value)


def test_parts_name_the_definitions_and_fields_that_differ(package: Package) -> None:
    before = told(algorithm=package.load(FILES).SEARCH).parts

    changed = {"constants.py": FILES["constants.py"].replace("SCALE = 2.0", "SCALE = 3.0")}
    after = told(algorithm=package.load(FILES | changed).SEARCH).parts
    differing = {
        name for name in before.keys() | after.keys() if before.get(name) != after.get(name)
    }

    assert f"SCALE of {package.name}.constants" in differing
    assert not any("Law" in name or "twice" in name for name in differing)
