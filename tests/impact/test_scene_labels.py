"""Scenes: words cover neither one another nor lines where there is room, and everything stands within the picture."""

import math
from itertools import combinations

import pytest

from dynamics_cli.impact.scene_labels import Words, bounds, placed
from dynamics_cli.impact.scene_pictures import collision
from dynamics_cli.pictures import Curve, Label, Panel

NAMES = ("Ford", "Opel Corsa")


def scene(turn: float, after: tuple[float, float]) -> Panel:
    ways = (1.0, 0.0), (math.cos(turn), math.sin(turn))
    before = [(15.0, 0.0), (10.0 * ways[1][0], 10.0 * ways[1][1])]
    gone = [(8.0 * math.cos(angle), 8.0 * math.sin(angle)) for angle in after]
    return collision(NAMES, ways, before, gone, (0.0, 1.0))


def clash(one: Label, other: Label, metres: float) -> bool:
    a, b = bounds([one], metres), bounds([other], metres)
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


@pytest.mark.parametrize("turn", [0.0, 0.4, 1.5708, 2.6, 3.1416])
@pytest.mark.parametrize("after", [(0.5, 0.6), (0.0, 0.1), (2.0, -2.0)])
def test_words_cover_no_other_words_and_stay_in_the_picture(turn: float, after: tuple[float, float]) -> None:
    panel = scene(turn, after)
    assert panel.x.ends is not None
    assert panel.y.ends is not None
    metres = (panel.x.ends[1] - panel.x.ends[0]) / 3.4
    labels = [item for item in panel.items if isinstance(item, Label)]
    assert {label.text.partition("\n")[0] for label in labels} >= {
        f"{name} {word}" for name in NAMES for word in ("before", "after")
    }
    assert not any(clash(*pair, 0.9 * metres) for pair in combinations(labels, 2))
    left, low, right, high = bounds(panel.items, 0.95 * metres)
    assert panel.x.ends[0] <= left
    assert right <= panel.x.ends[1]
    assert panel.y.ends[0] <= low
    assert high <= panel.y.ends[1]


def test_words_leave_a_line_and_take_the_side_they_ask_for() -> None:
    line = Curve([-10.0, 10.0], [0.0, 0.0])
    (label,) = placed([line], [Words((0.0, 0.0), (0.0, 1.0), "word", 0)], 1.0)
    assert label.y > 0.07
    (below,) = placed([line], [Words((0.0, 0.0), (0.0, -1.0), "word", 0)], 1.0)
    assert below.y == pytest.approx(-label.y)


def test_words_without_room_beside_their_point_have_a_line_to_it() -> None:
    grid = [Curve([-1.0, 1.0], [0.05 * nth, 0.05 * nth]) for nth in range(-9, 10)]
    made = placed(grid, [Words((0.0, 0.0), (0.0, 1.0), "word", 0)], 1.0)
    assert [type(item) for item in made] == [Curve, Label]
    assert (made[0].x[0], made[0].y[0]) == (0.0, 0.0)
