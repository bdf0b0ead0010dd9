from pathlib import Path

import pytest

from repro.determinism import compiled


@pytest.fixture
def package(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a package with a room that compiles and one that does not."""
    texts = {
        "kernels/cost.py": f"from {compiled.__name__} import jit",
        "kernels/choices.py": "LIMIT = 3",
        "pages/page.py": "WIDTH = 80",
    }
    for name, text in texts.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)
    monkeypatch.setattr(compiled, "_PACKAGE", tmp_path)
    return tmp_path


@pytest.mark.parametrize(
    ("name", "counts"),
    [("kernels/cost.py", True), ("kernels/choices.py", True), ("pages/page.py", False)],
)
def test_compiled_code_is_kept_under_all_sources_of_the_rooms_that_compile(
    package: Path, name: str, *, counts: bool
) -> None:
    before = compiled._digest()

    (package / name).write_text((package / name).read_text() + "\nMORE = 1")

    assert (compiled._digest() != before) is counts


def test_rooms_that_compile_are_found() -> None:
    marker = f"from {compiled.__name__} import"
    package = Path(compiled.__file__).parents[1]
    rooms = {p.parent.name for p in package.rglob("*.py") if marker in p.read_text("utf-8")}

    assert rooms == {"determinism", "functions", "optimisers", "robotics"}
