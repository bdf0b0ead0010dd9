"""The script of the live views of robots, as it stands in a page."""

from functools import cache
from importlib.resources import files

from markupsafe import Markup

from repro.report.packing import packed


@cache
def viewer() -> str:
    """Return the bundled script, whose licence stands at its top; `report/arm` builds it."""
    return files("repro.report").joinpath("arm", "arm.min.js").read_text(encoding="utf-8")


@cache
def packed_viewer() -> str:
    """Return the script as it stands in a page."""
    return packed(viewer())


@cache
def viewer_licence() -> Markup:
    """Return the comment at the top of the script, which packing would hide."""
    return Markup(viewer()[: viewer().index("*/") + 2])  # noqa: S704 (our own build)
