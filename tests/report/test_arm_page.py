import json
import re
from collections.abc import Sequence
from typing import Any

import numpy as np

from repro.report.arm_page import arm_drawing, arm_page
from repro.report.drawings.arm_motion import Moving
from repro.robotics.skeleton import Skeleton

TIMES = np.linspace(0.0, 2.0, 21)


def slid(way: float) -> Skeleton:
    """Return a column on which a joint slides up, as no D-H table of turning joints has it."""
    corners = np.array([[0.0, 0.0, 0.0], [0.0, 0.0, 0.2 + way], [0.4, 0.0, 0.2 + way]])
    return Skeleton(corners=corners, joints=corners[1:2], axes=np.array([[0.0, 0.0, 1.0]]))


def made(notes: Sequence[str] = ()) -> str:
    moving = Moving(
        name="lift",
        durations=(2.0,),
        times=TIMES,
        postures=tuple(map(slid, 0.1 * TIMES)),
        angles=0.1 * TIMES[:, None],
        shares=np.full((len(TIMES), 1, 1), 0.5),
    )
    stops = (slid(0.0), slid(0.2))
    drawn = arm_drawing("A lift", [moving], stops, joints=[("lift", "mm")], notes=notes)
    return arm_page("A lift <b>", [drawn], says=["It is < 1 m <i>high</i>"])


def scene(page: str) -> dict[str, Any]:
    found = re.search(r'<script type="application/json" class="arm-scene">(.*?)</script>', page)
    assert found
    read: dict[str, Any] = json.loads(found[1])
    return read


def test_a_page_shows_any_chain_with_the_units_of_its_joints() -> None:
    shown = scene(made())

    assert shown["names"] == ["lift [mm]"]
    assert shown["joints"] == [1]
    (motion,) = shown["motions"]
    assert motion["angles"][-1] == [2000]  # tenths of a millimetre
    assert motion["corners"][-1] == [0, 0, 0, 0, 0, 400, 400, 0, 400]
    assert shown["limits"] == ["velocity of joint lift"]


def test_a_page_has_its_still_its_notes_and_no_markup_of_a_title() -> None:
    page = made(notes=["5 < 6 mm are left"])

    assert "<h1>A lift &lt;b&gt;</h1>" in page
    assert "5 &lt; 6 mm are left" in page
    assert "<p>It is &lt; 1 m &lt;i&gt;high&lt;/i&gt;</p>" in page
    assert page.count("<svg") == 1
