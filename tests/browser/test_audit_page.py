"""The page of the manual where a table is pasted, over loopback."""

import json
import subprocess
import sys
import zipfile
from collections.abc import Iterator
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from threading import Thread
from typing import TYPE_CHECKING, Any

import pytest

from tests.browser.conftest import Visit, missing

if TYPE_CHECKING:
    from playwright.sync_api import Browser

ROOT = Path(__file__).parents[2]
MANUAL = ROOT / "docs" / "_build" / "html"
PLANTED = """Table 2: Results of 30 runs
Function,Statistic,WOA,PSO
F1,Best,1.20E-03,4.10E+00
F1,Mean,2.50E-03,3.00E+00
F1,Worst,4.00E-03,6.20E+00
F1,Std,9.00E-04,5.00E-01
F2,Best,<script>alert(1)</script>,1.00E+00
F2,Mean,N/A,2.00E+00
F2,Worst,7.00E+00,2.50E+00
F2,Std,-1.00E+00,9.00E+00
"""
EMPTY = """() => {
  document.getElementById("asked").reset();
  for (const name of ["answer", "state"]) document.getElementById(name).replaceChildren();
}"""


class Quiet(SimpleHTTPRequestHandler):
    """Serves a folder and says nothing of it."""

    def log_message(self, *_: object) -> None:
        """Keep what was asked for out of what the tests print."""


@pytest.fixture(scope="module")
def manual() -> Iterator[str]:
    """Yield the address of a manual that was built from these sources."""
    packed = MANUAL / "pyodide" / "repro.zip"
    if not packed.exists():
        missing("the manual: nox -s docs")
    with zipfile.ZipFile(packed) as found:
        if {name: found.read(name) for name in found.namelist()} != sources():
            missing("the manual of these sources: nox -s docs")
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(Quiet, directory=str(MANUAL)))
    thread = Thread(target=server.serve_forever)
    thread.start()
    yield f"http://127.0.0.1:{server.server_port}"
    server.shutdown()
    server.server_close()
    thread.join()


def sources() -> dict[str, bytes]:
    """Return what the page is to be made of, as the script beside it says."""
    spec = spec_from_file_location("bundle", ROOT / "docs" / "pyodide" / "bundle.py")
    assert spec is not None
    assert spec.loader is not None
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    found: dict[str, bytes] = module.sources()
    return found


@pytest.fixture(scope="module")
def loaded(chromium: "Browser", manual: str) -> Iterator[Visit]:
    """Yield the page on a phone, with Python loaded: that takes longer than all that is asked."""
    context = chromium.new_context(viewport={"width": 360, "height": 800}, color_scheme="dark")
    one = Visit(context.new_page())
    context.route("**/favicon.ico", lambda route: route.fulfill(status=204))
    context.on("request", lambda request: one.requests.append(request.url))
    one.page.on("console", lambda message: one.complaints.append(message.text))
    one.page.on("pageerror", lambda error: one.complaints.append(str(error)))
    one.page.goto(f"{manual}/audit_here.html")
    one.page.wait_for_selector("#audit:enabled", timeout=180_000)
    yield one
    context.close()


@pytest.fixture
def page(loaded: Visit) -> Visit:
    """Return the page with nothing chosen and nothing answered."""
    loaded.page.evaluate(EMPTY)
    return loaded


def audited(visit: Visit, text: str) -> None:
    """Paste the text and wait for what the page says of it, by keyboard alone."""
    visit.page.get_by_label("The table").fill(text)
    visit.page.locator("#audit").focus()
    visit.page.keyboard.press("Enter")
    visit.page.wait_for_selector("#audit:enabled", timeout=180_000)


def by_command(text: str, *options: str) -> Any:  # noqa: ANN401 (JSON)
    command = (sys.executable, "-m", "repro", "audit", "-", "--json", *options)
    done = subprocess.run(command, input=text, capture_output=True, text=True, check=False)
    return json.loads(done.stdout)


def said(rows: list[dict[str, Any]]) -> list[str]:
    """Return rows in the words of the page."""
    return [
        f"{row['grade']} {', '.join(filter(None, (row['row'], row['column'])))}: "
        f"{row['explanation']}" + (f"; holds if {row['condition']}" if row["condition"] else "")
        for row in rows
    ]


def test_a_planted_table_gives_the_rows_that_the_command_gives(page: Visit) -> None:
    (table,) = by_command(PLANTED)
    audited(page, PLANTED)
    assert len(table["rows"]) >= 3
    assert page.page.locator("#answer ol > li").all_text_contents() == said(table["rows"])
    assert [guess.split("\n")[0].strip() for guess in guesses(page)] == table["read"]["guesses"]


def guesses(visit: Visit) -> list[str]:
    """Return the guesses that are shown, without the words of their menus."""
    lists = visit.page.locator("#answer ul").first.locator("li")
    return [str(each.evaluate("item => item.firstChild.data")) for each in lists.all()]


def test_flags_stand_beside_their_cells_and_markup_stays_text(page: Visit) -> None:
    audited(page, PLANTED)
    flagged = page.page.locator("#answer td.impossible").all_text_contents()
    assert any(text.startswith("-1.00E+00 [") for text in flagged)
    assert page.page.get_by_role("cell", name="<script>alert(1)</script>").count() == 1
    assert not page.complaints


def test_a_guess_is_changed_by_its_menu(page: Visit) -> None:
    (table,) = by_command(PLANTED, "--runs", "2")
    audited(page, PLANTED)
    menu = page.page.get_by_label("instead of: n = 30")
    menu.fill("2")
    menu.press("Tab")
    page.page.wait_for_selector("#audit:enabled", timeout=180_000)
    assert page.page.locator("#answer ol > li").all_text_contents() == said(table["rows"])


def test_nothing_but_its_own_server_is_asked_and_nothing_is_wider_than_a_phone(
    page: Visit, manual: str
) -> None:
    audited(page, PLANTED)
    assert page.requests
    assert all(url.startswith((f"{manual}/", f"blob:{manual}/")) for url in page.requests)
    assert page.page.evaluate("document.documentElement.scrollWidth") <= 360


def test_what_is_no_table_is_said_in_a_line(page: Visit) -> None:
    audited(page, "only words, and no number")
    state = page.page.locator("#state").text_content()
    assert state == "no table with numbers in it was found"
