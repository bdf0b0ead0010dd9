import pytest

from repro.model.paper import Source
from repro.report.cited import cited


@pytest.mark.parametrize(
    ("key", "authors", "year", "called"),
    [
        ("liang2026", "Caiping Liang, Hao Yuan, Chen Wang", None, "Liang et al. (2026)"),
        ("doe", "Jane Doe and R. Roe", 2021, "Doe and Roe (2021)"),
        ("doe", "Jane Doe", None, "Doe"),
        ("doe", "Jane Doe et al.", 2021, "Doe et al. (2021)"),
    ],
)
def test_a_paper_is_called_by_its_authors_and_its_year(
    key: str, authors: str, year: int | None, called: str
) -> None:
    assert cited(key, Source(authors=authors, title="A title", year=year)) == called


@pytest.mark.parametrize(
    ("title", "called"),
    [
        ("Whales of the sea", "“Whales of the sea”"),
        (
            "Joints Trajectory Planning of Robot Based on Slime Mould Whale Optimization Algorithm",
            "“Joints Trajectory Planning of Robot …”",
        ),
        ("Interpolation, and optimisation: of the whales", "“Interpolation, and optimisation …”"),
        ("x" * 60, f"“{'x' * 60}”"),
    ],
)
@pytest.mark.parametrize("authors", ["authors not on the copy", ""])
def test_where_nobody_is_named_it_is_called_by_the_head_of_its_title(
    title: str, called: str, authors: str
) -> None:
    assert cited("syji", Source(authors=authors, title=title)) == called
