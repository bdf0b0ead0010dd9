"""The script of the live views of robots, as it stands in a page."""

from functools import cache
from importlib.resources import files

from markupsafe import Markup


@cache
def viewer() -> Markup:
    """Return the bundled script, whose licence stands at its top; `report/arm` builds it."""
    text = files("repro.report").joinpath("arm", "arm.min.js").read_text(encoding="utf-8")
    return Markup(text)  # noqa: S704 (our own build, which holds nothing that ends a script)
