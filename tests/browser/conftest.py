"""A Chromium for the tests, and the pages that it looks at."""

import importlib
import os
import re
import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

import pytest
from xdist.scheduler import LoadScopeScheduling

from tests.browser.made_pages import make_pages
from tests.house import PAPERS as HOUSE
from tests.made_once import made_once

if TYPE_CHECKING:
    from playwright.sync_api import Browser, BrowserContext, Page

QUIET = (
    *("--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking"),
    *("--disable-component-update", "--disable-sync"),
)
KNOWN = ("chromium", "chromium-browser", "google-chrome")
PAPERS = (*HOUSE, "doe2021")
DRAWN = (*PAPERS, "how-verdicts-are-made")
PAGES = (*DRAWN, "index")
"""Each stands for all pages whose names begin with it: of a paper the door and its rooms."""
PHONE = 360  # px
VIEWS = ("light", "dark", "phone")
"""Fixtures, whose names stand in those of their tests."""
ALONE = ("test_audit_page", "test_arm", "test_questions")
"""Files of tests that look at pages of their own."""
OWN = ("file:", "data:", "about:")


@dataclass(frozen=True, slots=True)
class Visit:
    """An open page with what it complained of and what it asked the network for."""

    page: "Page"
    complaints: list[str] = field(default_factory=list)
    requests: list[str] = field(default_factory=list)


Open = Callable[..., Visit]
Rooms = dict[str, Visit]


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Mark every test of this folder, so that a session without a browser can leave it out.

    While a worker makes the pages for the first view, others have the files that need none of
    them; what is short comes last.
    """
    own = [item for item in items if Path(__file__).parent in item.path.parents]
    for item in own:
        item.add_marker("browser")
    groups = dict.fromkeys(group_of(item.nodeid) for item in own)
    views = [group for group in groups if group.startswith(VIEWS)]
    ranks = {group: rank for rank, group in enumerate((*views[:1], *ALONE, *views[1:]))}
    others = [item for item in items if item not in set(own)]
    own.sort(key=lambda item: ranks.get(group_of(item.nodeid), len(ranks)))
    items[:] = [*others, *own]


def group_of(nodeid: str) -> str:
    """Return the view that a test looks at, its file if that has pages of its own, or itself."""
    view = re.search(rf"\[((?:{'|'.join(VIEWS)}) .*)\]$", nodeid)
    stem = Path(nodeid.partition("::")[0]).stem
    return view[1] if view else stem if stem in ALONE else nodeid


# xdist 3.8 cannot do it by its marks: it names groups in a field that pytest 9.2 no longer has
@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: object) -> Any:  # noqa: ANN401 (xdist's)
    """Return what gives one worker all tests of a view, if tests are dealt out by scope."""
    if config.getvalue("dist") != "loadscope":
        return None
    scheduler = LoadScopeScheduling(config, log)
    scheduler._split_scope = group_of
    return scheduler


@pytest.fixture(scope="session")
def launch() -> "Iterator[Callable[..., Browser]]":
    """Yield what starts REPRO_BROWSER or a Chromium on the path, with options of its own.

    Without one, or without playwright, fail in CI and skip elsewhere.
    """
    names = filter(None, (os.environ.get("REPRO_BROWSER"), *KNOWN))
    executable = next(filter(None, map(shutil.which, names)), None)
    playwright = of_extra("playwright.sync_api").sync_playwright
    if executable is None:
        missing("a Chromium: install one, or name it in REPRO_BROWSER")
    with playwright() as driver:
        yield lambda *options: driver.chromium.launch(
            executable_path=executable, args=[*QUIET, *options]
        )


@pytest.fixture(scope="session")
def chromium(launch: "Callable[..., Browser]") -> "Iterator[Browser]":
    """Yield a browser that draws without the graphics card."""
    browser = launch("--disable-gpu")
    yield browser
    browser.close()


def of_extra(name: str) -> Any:  # noqa: ANN401 (a module)
    """Return a module that comes with the extra `browser`."""
    try:
        return importlib.import_module(name)
    except ImportError:
        missing(f"{name}: pip install '.[browser]'")


def missing(what: str) -> NoReturn:
    """Fail in CI, and skip elsewhere, for want of something."""
    message = f"the tests of the pages need {what}"
    if os.environ.get("CI"):
        pytest.fail(message)
    pytest.skip(message)


@pytest.fixture(scope="session")
def reports(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the folder of pages, which no test changes."""
    return made_once(tmp_path_factory, "browsed", make_pages) / "reports"


@contextmanager
def opening(chromium: "Browser", reports: Path) -> Iterator[Open]:
    """Yield what opens a page by its address in the folder; options are a browser context's.

    Pages with the same options share a context, which takes longer to open than they do.
    """
    contexts: dict[object, BrowserContext] = {}

    def opened(address: str, *, width: int = 1280, **options: Any) -> Visit:  # noqa: ANN401
        wanted = (width, *options.items())
        if wanted not in contexts:
            size = {"width": width, "height": 900}
            contexts[wanted] = chromium.new_context(viewport=size, **options)
        one = Visit(contexts[wanted].new_page())
        one.page.on("console", lambda message: one.complaints.extend(_of_the_page(message.text)))
        one.page.on("pageerror", lambda error: one.complaints.append(str(error)))
        one.page.on("request", lambda request: one.requests.append(request.url))
        one.page.goto(f"{reports.as_uri()}/{address}")
        return one

    yield opened
    for context in contexts.values():
        context.close()


def _of_the_page(said: str) -> list[str]:
    """Return a console's message, less what the driver says of its own speed without a card."""
    return [] if "GL Driver Message (OpenGL, Performance" in said else [said]


@pytest.fixture
def visit(chromium: "Browser", reports: Path) -> Iterator[Open]:
    """Yield what opens a page for one test."""
    with opening(chromium, reports) as opened:
        yield opened


def names(reports: Path, page: str) -> list[str]:
    """Return the names of a paper's pages, or of the one page."""
    return [f"{page}.html", *sorted(path.name for path in reports.glob(f"{page}.*.html"))]


def opened_in(
    chromium: "Browser", reports: Path, page: str, width: int, **options: object
) -> Iterator[Rooms]:
    with opening(chromium, reports) as opened:
        yield {name: opened(name, width=width, **options) for name in names(reports, page)}


# of the session, so that pytest runs together what looks at the same view
@pytest.fixture(scope="session", params=PAGES, ids="light {}".format)
def light(request: pytest.FixtureRequest, chromium: "Browser", reports: Path) -> Iterator[Rooms]:
    yield from opened_in(chromium, reports, request.param, 1280)


@pytest.fixture(scope="session", params=PAGES, ids="dark {}".format)
def dark(request: pytest.FixtureRequest, chromium: "Browser", reports: Path) -> Iterator[Rooms]:
    yield from opened_in(chromium, reports, request.param, 1280, color_scheme="dark")


@pytest.fixture(scope="session", params=PAGES, ids="phone {}".format)
def phone(request: pytest.FixtureRequest, chromium: "Browser", reports: Path) -> Iterator[Rooms]:
    yield from opened_in(chromium, reports, request.param, PHONE)
