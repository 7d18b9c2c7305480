"""Lanes keep what functions have made of them, and that stays true."""

import math

import numpy as np

from dynamics_cli.numerics.elementary import cos
from dynamics_cli.numerics.lanes import Lanes, parts


def lanes(*numbers: float) -> Lanes:
    return np.array(numbers).view(Lanes)


def test_a_function_is_mapped_once_and_what_it_made_cannot_be_changed() -> None:
    angle = lanes(0.1, 0.2, 3.0)
    first, second = cos(angle), cos(angle)
    assert first is second
    assert first.tolist() == [math.cos(x) for x in (0.1, 0.2, 3.0)]
    assert not first.flags.writeable
    assert not angle.flags.writeable


def test_operators_in_place_make_new_numbers() -> None:
    angle = lanes(0.1, 0.2)
    before, cosine = angle, cos(angle)
    angle += 1.0
    angle -= 0.5
    angle *= 2.0
    angle /= 4.0
    assert before.tolist() == [0.1, 0.2]
    assert angle.tolist() == [(x + 1.0 - 0.5) * 2.0 / 4.0 for x in (0.1, 0.2)]
    assert cos(angle).tolist() == list(map(math.cos, angle.tolist()))
    assert cos(before) is cosine


def test_what_is_derived_knows_nothing_of_its_origin() -> None:
    angle = lanes(0.1, 0.2, 0.3)
    cos(angle)
    assert cos(angle[1:]).tolist() == [math.cos(0.2), math.cos(0.3)]
    assert cos(-angle).tolist() == [math.cos(x) for x in (0.1, 0.2, 0.3)]
    assert cos(angle.copy()).tolist() == cos(angle).tolist()


def test_only_the_rows_asked_for_are_called() -> None:
    rows = np.arange(30)[np.arange(30) != 4]
    found = parts(lambda inputs: abs(inputs["x"]) if inputs["x"] < 0.0 else inputs["x"], {"x": np.arange(-15.0, 15.0)},
                  rows, lambda error: True)  # fmt: skip
    answers = {row: value for part in found for row, value in zip(part.rows, part.outcome, strict=True)}
    assert answers == {row: abs(row - 15.0) for row in rows}
