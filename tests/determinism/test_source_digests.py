import importlib
import textwrap
from collections.abc import Callable
from pathlib import Path

import pytest

from repro.determinism import source_digests as sources
from repro.determinism.source_digests import source_digest

Digest = Callable[[str], str]

CODE = '''
"""A module."""

LIMIT = 3
"""A limit."""


def cost(x):
    """Return the cost."""
    # twice
    return 2.0 * x
'''


def forget() -> None:
    for cached in (source_digest, sources._path, sources._tree, sources._imports, sources._meaning):
        cached.cache_clear()
    importlib.invalidate_caches()


@pytest.fixture
def digest_of(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Digest:
    """Return what gives the digest of a module `borrowed` with some text."""
    monkeypatch.syspath_prepend(tmp_path)

    def digest(text: str) -> str:
        (tmp_path / "borrowed.py").write_text(textwrap.dedent(text), encoding="utf-8")
        forget()
        return source_digest("borrowed")

    return digest


def test_digest_is_the_same_every_time(digest_of: Digest) -> None:
    assert digest_of(CODE) == digest_of(CODE)


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("# twice", "# 2.0"),
        ("\n    # twice", ""),
        ("Return the cost.", "Return what it costs."),
        ('    """Return the cost."""\n', ""),
        ("A limit.", "The limit."),
        ('"""A module."""', ""),
        ("\n\n\ndef", "\n\ndef"),
        ("2.0 * x", "(2.0 * x)"),
    ],
)
def test_comments_layout_and_docstrings_do_not_count(digest_of: Digest, old: str, new: str) -> None:
    assert old in CODE
    assert digest_of(CODE.replace(old, new)) == digest_of(CODE)


@pytest.mark.parametrize(
    ("old", "new"),
    [("2.0 * x", "2 * x"), ("2.0 * x", "x * 2.0"), ("LIMIT = 3", "LIMIT = 4"), ("cost(", "price(")],
)
def test_anything_that_runs_counts(digest_of: Digest, old: str, new: str) -> None:
    assert old in CODE
    assert digest_of(CODE.replace(old, new)) != digest_of(CODE)


@pytest.mark.parametrize(
    ("line", "module"),
    [
        ("from repro.determinism.draws import uniform", "repro.determinism.draws"),
        ("from repro.statistics import tables", "repro.statistics.tables"),
        ("import repro.determinism.draws", "repro.determinism.draws"),
        ("import repro.determinism.draws as drawing", "repro.determinism.draws"),
        ("def f():\n    from repro.determinism.draws import uniform", "repro.determinism.draws"),
        ("from repro.optimisers.whale import WOA", "repro.determinism.compiled"),
    ],
)
def test_imported_modules_of_the_engine_count(digest_of: Digest, line: str, module: str) -> None:
    digest_of(line)

    assert module in sources._closure(("borrowed",))


def test_change_in_an_imported_module_changes_the_digest(
    digest_of: Digest, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = "from repro.optimisers.whale import WOA"
    before = digest_of(text)
    meaning = sources._meaning

    def changed(name: str) -> str:
        return meaning(name) + ("!" if name == "repro.determinism.draws" else "")

    changed.cache_clear = meaning.cache_clear  # type: ignore[attr-defined]
    monkeypatch.setattr(sources, "_meaning", changed)

    assert digest_of(text) != before


def test_other_packages_do_not_count(digest_of: Digest) -> None:
    digest_of("import json\nfrom scipy.stats import rankdata\nfrom numpy import zeros")

    assert sources._closure(("borrowed",)) == {"borrowed"}


def test_names_that_are_no_modules_of_python_count_as_nothing() -> None:
    forget()

    assert sources._path("repro.determinism.draws.uniform") is None
    assert sources._path("itertools") is None
    assert sources._path("repro.nothing") is None


@pytest.mark.parametrize(
    "module", ["repro.optimisers.whale", "repro.optimisers.hybrid_whale", "repro.functions.fixed"]
)
def test_compiled_code_rests_on_its_draws_and_its_compilation(module: str) -> None:
    found = sources._closure((module,))

    assert module in found
    assert "repro.determinism.compiled" in found
    assert ("repro.determinism.draws" in found) == ("optimisers" in module)
    assert not any(name.startswith(("repro.report", "repro.audit")) for name in found)
