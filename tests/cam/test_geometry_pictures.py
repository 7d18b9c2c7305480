"""Pictures of a cam as data, and the page that turns it."""

import math
import re
from xml.etree import ElementTree

import pytest
from geometry_cases import CYCLE, NOTHING, SWING

from dynamics_cli.cam import followers
from dynamics_cli.cam.geometry_pictures import animation, profile_picture
from dynamics_cli.cam.profile import profile


def test_the_picture_shows_cam_pressure_angle_and_curvature() -> None:
    follower = followers.Roller(0.025, 0.006)
    made = profile(NOTHING, program=CYCLE, follower=follower, points=72)
    picture = profile_picture(made, NOTHING, program=CYCLE, follower=follower)
    shape, pressure, bend = picture.panels
    assert shape.equal
    cam = shape.items[0]
    assert (cam.x[0], cam.y[0]) == (cam.x[-1], cam.y[-1])
    assert max(math.hypot(x, y) for x, y in zip(cam.x, cam.y, strict=True)) == pytest.approx(0.035, rel=1e-12)
    roller = next(item for item in shape.items if getattr(item, "label", "") == "roller")
    assert {round(math.hypot(x, y - 0.031), 12) for x, y in zip(roller.x, roller.y, strict=True)} == {0.006}
    assert max(pressure.items[0].y) <= made.largest_pressure_angle
    assert pressure.items[0].x[-1] == pytest.approx(2 * math.pi)
    assert len(bend.items[0].y) == 361


@pytest.mark.parametrize(
    ("program", "follower"),
    [
        (CYCLE, followers.Roller(0.025, 0.006, 0.003)),
        (CYCLE, followers.FlatFace(0.05)),
        (CYCLE, followers.KnifeEdge(0.03)),
        (SWING, followers.OscillatingRoller(0.03, 0.008, 0.08, 0.1)),
    ],
)
@pytest.mark.parametrize("rotation", ["ccw", "cw"])
def test_the_page_turns_the_cam_once(program: str, follower, rotation: str) -> None:
    made = profile(NOTHING, program=program, follower=follower, points=36, rotation=followers.Rotation(rotation))
    page = animation(made)
    svg = ElementTree.fromstring(page[page.index("<svg") : page.index("</svg>") + 6])
    turn = next(node for node in svg.iter() if node.get("type") == "rotate")
    # y points down in SVG: anticlockwise is a falling angle
    assert float(turn.get("to")) - float(turn.get("from")) == (-360.0 if rotation == "ccw" else 360.0)
    move = next(node for node in svg.iter() if node.get("type") == "translate").get("values")
    assert len(move.split(";")) == 37
    assert all(re.fullmatch(r"-?[\d.]+ -?[\d.]+", pair) for pair in move.split(";"))
    assert "nan" not in page


def test_a_short_table_does_not_make_the_picture_a_polygon() -> None:
    follower = followers.Roller(0.025, 0.006)
    made = profile(NOTHING, program=CYCLE, follower=follower, points=8)
    shape, pressure, _ = profile_picture(made, NOTHING, program=CYCLE, follower=follower, points=8).panels
    assert len(shape.items[0].x) == 361
    assert max(pressure.items[0].y) == pytest.approx(made.largest_pressure_angle, rel=1e-3)


def test_a_flat_face_is_drawn_along_the_cam() -> None:
    follower = followers.FlatFace(0.045)
    made = profile(NOTHING, program=CYCLE, follower=follower, start_angle=0.5)
    shape, pressure, _ = profile_picture(made, NOTHING, program=CYCLE, follower=follower, start_angle=0.5).panels
    face = next(item for item in shape.items if getattr(item, "label", "") == "face")
    (x0, x1), (y0, y1) = face.x, face.y
    assert math.hypot(x1 - x0, y1 - y0) == pytest.approx(made.face_width, rel=1e-12)
    # its distance from the axis is the base radius: it touches the cam at the first angle
    assert abs(x0 * y1 - x1 * y0) / made.face_width == pytest.approx(0.045, rel=1e-12)
    assert [item.label for item in pressure.items if hasattr(item, "label")].count("least") == 0


def test_the_face_of_an_arm_leans_with_the_arm() -> None:
    made = profile(NOTHING, program=SWING, follower=followers.OscillatingFlat(0.045, 0.1), points=360)
    page = animation(made)
    svg = ElementTree.fromstring(page[page.index("<svg") : page.index("</svg>") + 6])
    face = next(node for node in svg.iter() if node.tag.endswith("path"))
    angles = [float(value) for value in next(iter(face)).get("values").split(";")]
    assert len(angles) == 361
    assert angles[0] == angles[-1]
    # the arm swings 15 degrees, and its face with it; the page takes chords for tangents
    assert max(angles) - min(angles) == pytest.approx(15.0, abs=0.05)
