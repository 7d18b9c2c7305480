"""Words of pictures keep apart; planes show their common line, and space one view."""

import math

import pytest

from dynamics_cli.pictures import Arrow, Curve, Mark
from dynamics_cli.pictures.vectors import Step, head_to_tail, labelled, seen, square, view_of
from dynamics_cli.vec import pictures
from dynamics_cli.vec.frame import frame
from dynamics_cli.vec.lines import Item, lines


def test_words_of_arrows_that_coincide_stand_on_both_sides() -> None:
    steps = [Step((0.0, 0.0), (3.0, 4.0), "part", 0), Step((0.0, 0.0), (3.0, 4.0), "whole", 6)]
    first, second = (item for item in labelled(steps) if isinstance(item, Mark))
    assert first.aside[0] * second.aside[0] < 0.0


def test_arrows_follow_each_other() -> None:
    total = Step((0.0, 0.0), (4.0, 6.0), "sum", 6)
    steps = head_to_tail([(1.0, 2.0), (3.0, 4.0)], ["a", "b"], total)
    assert [step.tail for step in steps] == [(0.0, 0.0), (1.0, 2.0), (0.0, 0.0)]
    assert steps[1].tip == total.tip


def test_an_arrow_without_length_is_not_drawn() -> None:
    items = labelled([Step((0.0, 0.0), (1.0, 0.0), "a", 0), Step((1.0, 0.0), (0.0, 0.0), "nothing", 1)])
    assert len([item for item in items if isinstance(item, Arrow)]) == 1


def test_space_is_seen_in_right_angles() -> None:
    x, y, z = seen((1.0, 0.0, 0.0)), seen((0.0, 1.0, 0.0)), seen((0.0, 0.0, 1.0))
    # an orthographic view: the rows of the projection are unit vectors at right angles
    rows = list(zip(x, y, z, strict=True))
    assert [math.hypot(*row) for row in rows] == pytest.approx([1.0, 1.0])
    assert sum(a * b for a, b in zip(*rows, strict=True)) == pytest.approx(0.0)
    assert view_of([(1.0, 2.0, 0.0)])((1.0, 2.0, 0.0)) == (1.0, 2.0)


def test_a_square_lies_in_its_plane() -> None:
    patch = square((0.0, 0.0, 0.0), (0.0, 0.0, 1.0), 1.0, 0)
    assert len(patch.x) == 5
    assert (patch.x[0], patch.y[0]) == (patch.x[-1], patch.y[-1])


def test_planes_show_their_common_line() -> None:
    first = Item((0.0, 0.0, 2.0), normal=(1.0, 1.0, -1.0))
    second = Item((0.0, 0.0, 0.0), normal=(0.0, 0.0, 1.0))
    drawn = pictures.lines(lines(first=first, second=second), first=first, second=second)
    items = [item for panel in drawn.panels for item in panel.items]
    assert [item for item in items if isinstance(item, Curve) and item.style == "thick"]
    assert "black" not in drawn.subtitle


def test_directions_given_by_points_are_dashed() -> None:
    points = ((0.0, 0.0, 0.0), (2.0, 1.0, 0.0), (0.0, 3.0, 1.0))
    drawn = pictures.frame(frame(*points), *points)
    dashed = [item for item in drawn.panels[0].items if isinstance(item, Curve) and item.style == "dashed"]
    assert len(dashed) == 2
