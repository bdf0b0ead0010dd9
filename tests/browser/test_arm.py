"""The view of the robot in a real browser: it draws, and obeys mouse, finger and keyboard."""

import io
import re
from collections.abc import Callable, Iterator
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from matplotlib.image import imread
from numpy.typing import NDArray

from repro.commands.written_pages import write_pages
from repro.runs.plan import plan
from repro.runs.store.store import Store
from tests.browser.conftest import of_extra
from tests.small_arms import SHOWING_AN_ARM

SOFTWARE_WEBGL = ("--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader")
NO_WEBGL = ("--disable-gpu", "--disable-3d-apis")
SHADES = 50  # of lit links and smooth edges at least; a blank canvas has one
END = 10.0  # s: the longer of the two motions of the arm

Open = Callable[..., Any]


@pytest.fixture(scope="module")
def address(tmp_path_factory: pytest.TempPathFactory) -> str:
    """Return the address of a page that shows an arm."""
    folder = tmp_path_factory.mktemp("arm")
    with Store(folder / "store") as store:
        write_pages(
            store, [SHOWING_AN_ARM], plan([SHOWING_AN_ARM], 1), folder, [SHOWING_AN_ARM.key]
        )
    return (folder / "doe2021.arm.html").as_uri()


@pytest.fixture(scope="module")
def chromium(launch: Callable[..., Any]) -> Iterator[Callable[..., Any]]:
    """Return what starts a browser with WebGL, or without."""
    started: dict[tuple[str, ...], Any] = {}

    def start(*options: str) -> Any:  # noqa: ANN401 (playwright is no dependency of mypy's)
        if options not in started:
            started[options] = launch(*options)
        return started[options]

    yield start
    for browser in started.values():
        browser.close()


@pytest.fixture
def view(chromium: Callable[..., Any], address: str) -> Iterator[Open]:
    """Return what opens the page, waits for the view, and watches that nothing goes wrong."""
    contexts, wrong = [], []

    def open_page(*options: str, live: bool = True, **settings: object) -> Any:  # noqa: ANN401
        context = chromium(*(options or SOFTWARE_WEBGL)).new_context(**settings)
        contexts.append(context)
        page = context.new_page()
        page.on("pageerror", lambda error: wrong.append(str(error)))
        page.on("console", lambda m: wrong.append(m.text) if m.type == "error" else None)
        page.on("request", lambda r: None if r.url == address else wrong.append(r.url))
        page.goto(address)
        page.locator("figure:has(.arm)").scroll_into_view_if_needed()
        if live:
            page.locator(".arm-canvas").wait_for(state="visible")
            page.locator(".arm-canvas").scroll_into_view_if_needed()
        return page

    yield open_page
    for context in contexts:
        context.close()
    assert wrong == []


def picture(page: Any) -> NDArray[np.float64]:  # noqa: ANN401
    """Return the pixels of the view, (height, width, 4), once all has been drawn."""
    page.evaluate("new Promise(r => requestAnimationFrame(() => requestAnimationFrame(r)))")
    return np.asarray(imread(io.BytesIO(page.locator(".arm-stage").screenshot())))


def seconds(page: Any) -> float:  # noqa: ANN401
    """Return the time that the view shows."""
    return float(page.locator(".arm-now").inner_text().split(" s")[0])


def expect(locator: Any) -> Any:  # noqa: ANN401
    """Return what waits, for a few seconds, until something holds of a part of the page."""
    return of_extra("playwright.sync_api").expect(locator)


def wait_until_it_moves(page: Any) -> None:  # noqa: ANN401
    """Return once the clock shows a second, when the arm has left its start; fail after some."""
    expect(page.locator(".arm-now")).to_have_text(re.compile(r"^[1-9]\."))


def differ(before: NDArray[np.float64], after: NDArray[np.float64]) -> bool:
    """Whether more than a thousandth of the pixels changed."""
    return bool((np.abs(before - after).max(axis=-1) > 0.1).mean() > 1e-3)


def test_the_canvas_is_really_drawn_on(view: Open) -> None:
    pixels = picture(view())
    assert len(np.unique(pixels.reshape(-1, pixels.shape[-1]), axis=0)) > SHADES


def test_nothing_moves_before_it_is_told_to(view: Open) -> None:
    page = view()
    before = picture(page)
    page.wait_for_timeout(500)
    assert seconds(page) == 0.0
    assert not differ(before, picture(page))


def test_a_click_on_play_moves_the_arm_and_another_stops_it(view: Open) -> None:
    page = view()
    before = picture(page)
    play = page.get_by_role("button", name="Play")
    play.click()
    wait_until_it_moves(page)
    page.get_by_role("button", name="Pause").click()
    stopped = seconds(page)
    assert 0.0 < stopped < END
    assert differ(before, picture(page))
    page.wait_for_timeout(300)
    assert seconds(page) == stopped


def test_the_space_bar_plays_too(view: Open) -> None:
    page = view()
    page.locator(".arm-play").focus()
    page.keyboard.press("Space")
    wait_until_it_moves(page)
    page.keyboard.press("Space")
    assert 0.0 < seconds(page) < END
    assert page.locator(".arm-play").inner_text() == "Play"


def test_a_motion_ends_at_its_end_and_plays_again_from_the_start(view: Open) -> None:
    page = view()
    page.locator(".arm-time").focus()
    page.keyboard.press("End")
    page.keyboard.press("ArrowLeft")
    page.locator(".arm-play").click()
    expect(page.locator(".arm-play")).to_have_text("Play")
    assert seconds(page) == END
    page.locator(".arm-play").click()
    expect(page.locator(".arm-now")).not_to_have_text("10.00 s of 10.00 s")
    assert seconds(page) < END / 2


def test_a_click_on_the_scale_scrubs(view: Open) -> None:
    page = view()
    before = picture(page)
    box = page.locator(".arm-time").bounding_box()
    page.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    assert seconds(page) == pytest.approx(END / 2, abs=0.3)
    assert differ(before, picture(page))


def test_keys_scrub_by_a_hundredth_a_tenth_and_to_the_ends(view: Open) -> None:
    page = view()
    page.locator(".arm-time").focus()
    shown = []
    for key in ("ArrowRight", "PageUp", "ArrowLeft", "End", "Home"):
        page.keyboard.press(key)
        shown.append(seconds(page))
    assert shown == pytest.approx([0.1, 1.1, 1.0, END, 0.0])


def test_the_time_and_both_motions_are_told_in_words(view: Open) -> None:
    page = view()
    page.locator(".arm-time").focus()
    for _ in range(7):
        page.keyboard.press("PageUp")
    told = page.locator(".arm-where").inner_text().splitlines()
    assert told == [
        "as </script><b>printed</b>: segment 2 of 2; nearest limit: velocity of joint 2, 49 %",
        "certified optimum: arrived at 5.89 s",
    ]
    spoken = page.locator(".arm-time").get_attribute("aria-valuetext")
    assert spoken == f"7.00 s. {'. '.join(told)}"


@pytest.mark.parametrize("key", ["ArrowLeft", "ArrowUp", "+", "-"])
def test_a_key_on_the_picture_moves_the_eye_and_home_brings_it_back(view: Open, key: str) -> None:
    page = view()
    page.locator(".arm-canvas").focus()
    before = picture(page)
    for _ in range(3):
        page.keyboard.press(key)
    assert differ(before, picture(page))
    page.keyboard.press("Home")
    assert not differ(before, picture(page))
    assert seconds(page) == 0.0


def test_dragging_turns_the_view(view: Open) -> None:
    page = view()
    before = picture(page)
    box = page.locator(".arm-canvas").bounding_box()
    page.mouse.move(box["x"] + 100, box["y"] + 100)
    page.mouse.down()
    page.mouse.move(box["x"] + 200, box["y"] + 130, steps=5)
    page.mouse.up()
    turned = picture(page)
    assert differ(before, turned)
    page.mouse.move(box["x"] + 300, box["y"] + 200, steps=5)  # the button is up
    assert not differ(turned, picture(page))


def test_a_finger_turns_the_view(view: Open) -> None:
    page = view(has_touch=True)
    before = picture(page)
    box = page.locator(".arm-canvas").bounding_box()
    session = page.context.new_cdp_session(page)
    for kind, across in (("touchStart", 80), ("touchMove", 110), ("touchMove", 180)):
        point = {"x": box["x"] + across, "y": box["y"] + 100}
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": [point]})
    session.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
    assert differ(before, picture(page))


def test_buttons_look_along_the_axes(view: Open) -> None:
    page = view()
    seen = []
    for name in ("first view", "along x", "along y", "from above", "first view"):
        page.get_by_role("button", name=name).click()
        seen.append(picture(page))
    assert all(differ(*pair) for pair in pairwise(seen))
    assert not differ(seen[0], seen[-1])


def test_the_motion_pauses_when_it_is_scrolled_out_of_sight(view: Open) -> None:
    page = view(viewport={"width": 800, "height": 450})
    page.locator(".arm-play").click()
    page.evaluate("scrollTo({top: document.body.scrollHeight, behavior: 'instant'})")
    expect(page.locator(".arm-play")).to_have_text("Play")
    stopped = seconds(page)
    page.wait_for_timeout(300)
    assert seconds(page) == stopped < END


def test_reduced_motion_starts_nothing_and_still_obeys(view: Open) -> None:
    page = view(reduced_motion="reduce")
    page.wait_for_timeout(400)
    assert seconds(page) == 0.0
    page.locator(".arm-time").focus()
    page.keyboard.press("PageUp")
    assert seconds(page) == 1.0


def test_dark_and_light_are_drawn_in_colours_of_their_own(view: Open) -> None:
    light, dark = (picture(view(color_scheme=scheme)) for scheme in ("light", "dark"))
    assert np.median(light) > 0.8
    assert np.median(dark) < 0.2


def test_the_live_view_takes_the_place_of_the_still_but_in_print(view: Open) -> None:
    page = view()
    still = page.locator("figure:has(.arm) > svg")
    assert not still.is_visible()
    page.emulate_media(media="print")
    assert still.is_visible()
    assert not page.locator(".arm-canvas").is_visible()


def test_without_webgl_the_still_stays(view: Open) -> None:
    page = view(*NO_WEBGL, live=False)
    page.wait_for_timeout(500)
    assert page.locator("figure:has(.arm) > svg").is_visible()
    assert not page.locator(".arm-canvas").is_visible()


def test_without_script_the_still_stays(view: Open) -> None:
    page = view(live=False, java_script_enabled=False)
    assert page.locator("figure:has(.arm) > svg").is_visible()
    assert not page.locator(".arm-play").is_visible()


@pytest.mark.parametrize("width", [360, 1280])
def test_the_view_fits_the_page(view: Open, width: int) -> None:
    page = view(viewport={"width": width, "height": 800})
    for part in (".arm-stage", ".arm-controls", ".arm-legend"):
        box = page.locator(part).bounding_box()
        assert box["x"] >= 0
        assert box["x"] + box["width"] <= width


def test_joint_angles_move_with_the_clock_and_the_nearest_limit_is_underlined(view: Open) -> None:
    page = view()
    cells = page.locator(".arm-joints td")
    assert cells.all_inner_texts() == ["0.0"] * 4
    page.locator(".arm-time").focus()
    page.keyboard.press("End")
    assert cells.all_inner_texts() == ["90.0"] * 4
    page.keyboard.press("Home")
    page.keyboard.press("PageUp")
    assert page.locator(".arm-binds").count() == 2
