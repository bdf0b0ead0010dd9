import gzip
import hashlib
import json
import re
from base64 import b64decode
from pathlib import Path

import pytest

from repro.commands.written_pages import write_pages
from repro.report.drawings.arm_viewer import packed_viewer, viewer
from repro.runs.plan import plan
from repro.runs.store.store import Store
from tests.doe2021 import PAPER
from tests.small_arms import SHOWING_AN_ARM

FOLDER = Path(__file__).parents[3] / "repro" / "report" / "arm"
LARGEST = 700_000  # bytes


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> str:
    folder = tmp_path_factory.mktemp("arm")
    with Store(folder / "store") as store:
        tasks = plan([SHOWING_AN_ARM], 1)
        write_pages(store, [SHOWING_AN_ARM], tasks, folder, [SHOWING_AN_ARM.key])
    return (folder / "doe2021.arm.html").read_text(encoding="utf-8")


def test_the_bundle_was_built_from_the_files_beside_it() -> None:
    digest = hashlib.sha256()
    sources = sorted(path.relative_to(FOLDER).as_posix() for path in FOLDER.glob("source/*.js"))
    for name in ("build.js", "package.json", "package-lock.json", *sources):
        digest.update(name.encode() + b"\0" + (FOLDER / name).read_bytes() + b"\0")
    found = re.search(r"SHA-256 (\w{64})", viewer())
    assert found
    assert found[1] == digest.hexdigest(), "build it anew: nox -s bundle"


def test_the_bundle_carries_licence_and_version_of_what_it_contains() -> None:
    lock = json.loads((FOLDER / "package-lock.json").read_text(encoding="utf-8"))
    head = viewer()[:2000]
    assert f"three.js {lock['packages']['node_modules/three']['version']} " in head
    assert "The MIT License" in head
    assert "Copyright" in head
    assert "three.js authors" in head


def test_the_bundle_is_light_and_ends_no_script_element() -> None:
    assert len(viewer().encode()) < LARGEST
    assert "</script" not in viewer().lower()
    assert "<!--" not in viewer()


def test_the_packed_script_is_the_script() -> None:
    assert gzip.decompress(b64decode(packed_viewer())).decode() == viewer()
    assert len(packed_viewer()) < len(viewer()) / 2


def test_the_lock_names_no_registry() -> None:
    lock = json.loads((FOLDER / "package-lock.json").read_text(encoding="utf-8"))
    assert not [name for name, package in lock["packages"].items() if "resolved" in package]


def test_a_page_with_an_arm_carries_scene_and_script_once(page: str) -> None:
    assert page.count('class="arm-scene"') == 1
    assert page.count("Contains three.js") == page.count(packed_viewer()) == 1


def test_text_in_a_scene_can_neither_end_it_nor_become_markup(page: str) -> None:
    (scene,) = re.findall(r'<script type="application/json"[^>]*>(.*?)</script>', page, re.DOTALL)
    assert json.loads(scene)["motions"][0]["name"] == "as </script><b>printed</b>"
    assert "<b>printed" not in page
    assert "<b>drawn" not in page


def test_a_page_without_an_arm_carries_no_viewer(tmp_path: Path) -> None:
    with Store(tmp_path / "store") as store:
        write_pages(store, [PAPER], plan([PAPER], 1), tmp_path, [PAPER.key])
    assert not (tmp_path / "doe2021.arm.html").exists()
    for page in tmp_path.glob("*.html"):
        assert "three.js" not in page.read_text(encoding="utf-8")
