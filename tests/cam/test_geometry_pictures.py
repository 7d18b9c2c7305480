"""Pictures of a cam as data, and the drawing that turns it."""

import math
from xml.etree import ElementTree

import numpy as np
import pytest
from geometry_cases import CYCLE, NOTHING, SWING
from harness import run

from dynamics_cli.cam.geometry import followers
from dynamics_cli.cam.geometry.animation import animation
from dynamics_cli.cam.geometry.pictures import profile_picture
from dynamics_cli.cam.geometry.profile import profile
from dynamics_cli.pictures import Curve, Mark

SVG = "{http://www.w3.org/2000/svg}"
ALL = [
    (CYCLE, followers.Roller(0.025, 0.006, 0.003), "inner"),
    (CYCLE, followers.Roller(0.03, 0.006), "outer"),
    (CYCLE, followers.FlatFace(0.05), "inner"),
    (CYCLE, followers.KnifeEdge(0.03), "inner"),
    (CYCLE, followers.ConjugateRoller(0.03, 0.008, 0.09), "inner"),
    (SWING, followers.OscillatingRoller(0.03, 0.008, 0.08, 0.1), "inner"),
    (SWING, followers.OscillatingFlat(0.03, 0.1, 0.004), "inner"),
    (SWING, followers.ConjugateOscillatingRoller(0.03, 0.008, 0.08, 0.1, 1.1), "inner"),
]


def drawn(program, follower, flank="inner", **given):
    given = {"program": program, "follower": follower, "flank": followers.Flank(flank), **given}
    return profile_picture(profile(NOTHING, **given), NOTHING, **given)


def named(panel, label: str) -> Curve:
    return next(item for item in panel.items if isinstance(item, Curve) and item.label == label)


@pytest.mark.parametrize(("program", "follower", "flank"), ALL)
def test_every_follower_is_drawn_where_it_touches_the_cam(program, follower, flank) -> None:
    shape, pressure, bend = drawn(program, follower, flank, start_angle=0.4).panels
    assert shape.equal
    cam = named(shape, "cam" if flank == "inner" else "outer flank")
    assert (cam.x[0], cam.y[0]) == (cam.x[-1], cam.y[-1])
    name = "roller" if hasattr(follower, "roller_radius") else "knife-edge"
    touching = named(shape, "face" if "Flat" in type(follower).__name__ else name)
    contact = next(item for item in shape.items if isinstance(item, Mark) and (item.x or item.y))
    points = np.array(touching.x) + 1j * np.array(touching.y)
    along = (complex(contact.x, contact.y) - points[:-1]) / np.diff(points)
    near = np.abs(np.diff(points)) * np.where((along.real >= 0) & (along.real <= 1), np.abs(along.imag), 9.0)
    # a circle is drawn as a polygon of 90 sides
    assert min(near.min(), np.abs(points - complex(contact.x, contact.y)).min()) < 7e-4 * getattr(
        follower, "roller_radius", 1e-9
    )
    for panel in (pressure, bend):
        assert panel.x.ends == (0.0, 2.0 * math.pi)
        assert panel.items[0].x[0] == 0.0
        assert panel.items[0].x[-1] == pytest.approx(2.0 * math.pi)


def test_arm_and_pivot_are_drawn() -> None:
    for follower in (followers.OscillatingRoller(0.03, 0.008, 0.08, 0.1), followers.OscillatingFlat(0.03, 0.1, 0.004)):
        shape = drawn(SWING, follower, start_angle=0.3).panels[0]
        pivot = next(item for item in shape.items if isinstance(item, Mark) and item.label == "pivot")
        assert complex(pivot.x, pivot.y) == pytest.approx(0.1 * complex(math.cos(0.3), math.sin(0.3)))
        curves = [item for item in shape.items if isinstance(item, Curve)]
        assert any((arm.x[0], arm.y[0]) == (pivot.x, pivot.y) for arm in curves)


@pytest.mark.parametrize(("rotation", "sense"), [("ccw", 1.0), ("cw", -1.0)])
def test_the_arrow_turns_as_the_cam_does(rotation: str, sense: float) -> None:
    shape = drawn(CYCLE, followers.FlatFace(0.05), rotation=followers.Rotation(rotation)).panels[0]
    arrow = [item for item in shape.items if isinstance(item, Curve)][-1]
    assert sense * (arrow.x[0] * arrow.y[1] - arrow.x[1] * arrow.y[0]) > 0.0


def test_the_panels_reach_the_extremes_of_the_document() -> None:
    follower = followers.Roller(0.025, 0.006)
    made = profile(NOTHING, program=CYCLE, follower=follower, points=8)
    shape, pressure, _ = profile_picture(made, NOTHING, program=CYCLE, follower=follower, points=8).panels
    # a short table does not make the picture a polygon
    assert len(shape.items[0].x) == 721
    assert max(pressure.items[0].y) == pytest.approx(made.largest_pressure_angle, rel=1e-4)
    assert sum(isinstance(item, Mark) for item in pressure.items) == 2


@pytest.mark.parametrize("rotation", ["ccw", "cw"])
@pytest.mark.parametrize("follower", [followers.FlatFace(0.05), followers.OscillatingFlat(0.03, 0.1)])
def test_a_face_without_a_pressure_angle_shows_where_it_is_touched(follower, rotation) -> None:
    program = SWING if hasattr(follower, "pivot_distance") else CYCLE
    sense = followers.Rotation(rotation)
    cam = profile(NOTHING, program=program, follower=follower, rotation=sense)
    panel = drawn(program, follower, rotation=sense).panels[1]
    assert min(panel.items[0].y) == pytest.approx(cam.face_low, rel=1e-4)
    assert max(panel.items[0].y) == pytest.approx(cam.face_high, rel=1e-4)
    marks = [item for item in panel.items if isinstance(item, Mark)]
    assert [mark.y for mark in marks] == [cam.face_high, cam.face_low]
    values = np.interp([mark.x for mark in marks], panel.items[0].x, panel.items[0].y)
    assert values == pytest.approx([cam.face_high, cam.face_low], rel=1e-4)


def points_of(path: str) -> np.ndarray:
    numbers = np.array([float(word) for word in path.split() if word not in "MLZ"])
    return numbers[0::2] - 1j * numbers[1::2]


@pytest.mark.parametrize("rotation", ["ccw", "cw"])
@pytest.mark.parametrize(("program", "follower", "flank"), ALL)
def test_cam_and_follower_touch_all_through_the_turn(program, follower, flank, rotation) -> None:
    given = {"program": program, "follower": follower, "flank": followers.Flank(flank),
             "rotation": followers.Rotation(rotation), "start_angle": 0.3}  # fmt: skip
    made = profile(NOTHING, **given)
    page = animation(made, NOTHING, **given)
    assert page == animation(made, NOTHING, **given)
    root = ElementTree.fromstring(page)
    assert "script" not in page
    cam, moving = root.findall(f"{SVG}g")
    turn, shift = (group.find(f"{SVG}animateTransform") for group in (cam, moving))
    first, last = float(turn.get("from")), float(turn.get("to"))
    # y points down in SVG: anticlockwise is a falling angle
    assert last - first == (-360.0 if rotation == "ccw" else 360.0)
    # without animation the first position is shown
    assert cam.get("transform") == f"rotate({turn.get('from')})"
    values = shift.get("values").split(";")
    assert values[0] == values[-1]
    assert len(values) == 361
    outline = points_of(cam.find(f"{SVG}path").get("d").split("Z")[-2])
    shape = points_of(moving.find(f"{SVG}path").get("d"))
    for k in range(0, 360, 15):
        angle = first + (last - first) * k / 360.0
        wall = outline * np.exp(-1j * math.radians(angle))
        numbers = [float(word) for word in values[k].replace(",", " ").split()]
        if shift.get("type") == "rotate":
            pivot = complex(numbers[1], -numbers[2])
            placed = pivot + (shape - pivot) * np.exp(-1j * math.radians(numbers[0]))
        else:
            placed = shape + complex(numbers[0], -numbers[1])
        if hasattr(follower, "roller_radius"):
            centre = 0.5 * (placed[0] + placed[45])
            assert np.abs(wall - centre).min() == pytest.approx(1e3 * follower.roller_radius, abs=0.03)
        elif len(placed) == 2:
            along = (wall - placed[0]) / (placed[1] - placed[0])
            within = (along.real > 0.0) & (along.real < 1.0)
            assert np.abs(along.imag[within]).min() * abs(placed[1] - placed[0]) < 0.03
        else:
            assert np.abs(wall - placed[0]).min() < 0.3


def test_the_drawing_is_of_true_size_and_holds_everything() -> None:
    follower = followers.OscillatingRoller(0.03, 0.008, 0.08, 0.1)
    root = ElementTree.fromstring(
        animation(profile(NOTHING, program=SWING, follower=follower), NOTHING, SWING, follower)
    )
    left, top, width, height = (float(word) for word in root.get("viewBox").split())
    assert root.get("width") == f"{width:.4f}mm"
    assert (left, top) == (-0.5 * width, -0.5 * height)
    assert 0.5 * width > 100.0


def test_the_command_writes_the_still_picture_and_the_turning_cam(tmp_path) -> None:
    words = ["cam", "profile", "--program", SWING, "--follower", "oscillating-flat", "--base-radius", "30 mm",
             "--pivot-distance", "100 mm", "--points", "12"]  # fmt: skip
    turning = tmp_path / "turn.svg"
    done = run(*words, "--drawing", str(turning), "--json")
    assert done.status == 0
    assert ElementTree.parse(turning).getroot().tag == f"{SVG}svg"
    assert run(*words, "--drawing", str(tmp_path / "turn.html")).status == 2
    assert run(*words, "--drawing", str(tmp_path / "turn.dxf")).status == 2
