"""The committed pages in a real browser, driven by its command line."""

import os
import re
import subprocess
from pathlib import Path

import pytest

BROWSER = os.environ.get("REPRO_BROWSER", "")
REPORTS = Path(__file__).parent.parent / "reports"
PAGES = sorted(path.name for path in REPORTS.glob("*.html"))
QUIET = (
    *("--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run"),
    *("--disable-background-networking", "--disable-component-update", "--disable-sync"),
)
pytestmark = [
    pytest.mark.browser,
    pytest.mark.skipif(not BROWSER, reason="REPRO_BROWSER names no Chromium"),
]


def browse(tmp_path: Path, page: str, *options: str) -> subprocess.CompletedProcess[str]:
    profile = f"--user-data-dir={tmp_path / 'profile'}"
    command = [BROWSER, *QUIET, profile, *options, (REPORTS / page).as_uri()]
    return subprocess.run(command, capture_output=True, text=True, check=True, timeout=120)


def test_there_are_pages_to_look_at() -> None:
    assert {"index.html", "liang2026.html"} <= set(PAGES)


@pytest.mark.parametrize("page", PAGES)
def test_a_page_opens_without_an_error_and_its_script_has_run(tmp_path: Path, page: str) -> None:
    done = browse(tmp_path, page, "--enable-logging=stderr", "--dump-dom")
    assert 'class="sort"' in done.stdout
    assert "CONSOLE" not in done.stderr


@pytest.mark.parametrize("page", PAGES)
@pytest.mark.parametrize("width", [1280, 500])
def test_a_page_draws_a_picture_that_is_not_blank(tmp_path: Path, page: str, width: int) -> None:
    picture = tmp_path / "page.png"
    browse(tmp_path, page, f"--screenshot={picture}", f"--window-size={width},1400")
    assert picture.stat().st_size > 20_000


@pytest.mark.parametrize("page", PAGES)
def test_a_page_prints_to_pdf(tmp_path: Path, page: str) -> None:
    paper = tmp_path / "page.pdf"
    browse(tmp_path, page, f"--print-to-pdf={paper}")
    content = paper.read_bytes()
    assert content.startswith(b"%PDF")
    assert len(re.findall(rb"/Type\s*/Page\b", content)) >= 1
