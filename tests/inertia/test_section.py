"""Sections: exact references, invariants, and everything a contour can do wrong."""

import math
import random
from fractions import Fraction
from itertools import pairwise

import pytest
from harness import answer, run
from mpmath import mp, mpf

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.inertia.section.contours import Hole, Piece
from dynamics_cli.inertia.section.pictures import section_picture
from dynamics_cli.inertia.section.task import Drawn, section
from dynamics_cli.pictures import Arrow, Curve, Mark

U = 2.0**-53
ELL = (0.0, 0.0, 60.0, 0.0, 60.0, 8.0, 8.0, 8.0, 8.0, 40.0, 0.0, 40.0)


def by_triangles(corners: list[tuple[float, float]]) -> dict[str, mpf]:
    """Area moments by triangles from the first corner, each from its vertices and centroid: another formula."""
    points = [(Fraction(x), Fraction(y)) for x, y in corners]
    a = sx = sy = ix = iy = ixy = Fraction(0)
    p = points[0]
    for q, r in pairwise(points[1:]):
        area = ((q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1])) / 2
        gx, gy = (p[0] + q[0] + r[0]) / 3, (p[1] + q[1] + r[1]) / 3
        a, sx, sy = a + area, sx + area * gx, sy + area * gy
        iy += area * (sum(v[0] ** 2 for v in (p, q, r)) + 9 * gx * gx) / 12
        ix += area * (sum(v[1] ** 2 for v in (p, q, r)) + 9 * gy * gy) / 12
        ixy += area * (sum(v[0] * v[1] for v in (p, q, r)) + 9 * gx * gy) / 12
    if a < 0:
        a, sx, sy, ix, iy, ixy = -a, -sx, -sy, -ix, -iy, -ixy
    ix, iy, ixy = ix - sy * sy / a, iy - sx * sx / a, ixy - sx * sy / a
    with mp.workdps(50):
        real = {
            name: mpf(value.numerator) / value.denominator
            for name, value in (("a", a), ("x", sx / a), ("y", sy / a), ("ix", ix), ("iy", iy), ("ixy", ixy))
        }
        radius = mp.sqrt(((real["ix"] - real["iy"]) / 2) ** 2 + real["ixy"] ** 2)
        real["i1"], real["i2"] = (real["ix"] + real["iy"]) / 2 + radius, (real["ix"] + real["iy"]) / 2 - radius
    return real


def star(seed: int, stretch: float, offset: float) -> list[tuple[float, float]]:
    """A star-shaped polygon, stretched, turned and moved: it never crosses itself."""
    generator = random.Random(seed)
    count = generator.randrange(3, 12)
    turn = generator.uniform(0.0, 6.28)
    corners = []
    for k in range(count):
        r = generator.uniform(0.5, 1.0)
        angle = 2.0 * math.pi * (k + generator.uniform(0.0, 0.4)) / count
        x, y = r * math.cos(angle), r * math.sin(angle) / stretch
        corners.append(
            (x * math.cos(turn) - y * math.sin(turn) + offset, x * math.sin(turn) + y * math.cos(turn) - 0.7 * offset)
        )
    return corners


@pytest.mark.parametrize(
    ("stretch", "offset"), [(1.0, 0.0), (1.0, 1e3), (1.0, 1e6), (1e3, 0.0), (1e3, 1e3), (1e3, 1e6), (1e7, 0.0)]
)
def test_every_moment_is_rounded_once(stretch: float, offset: float) -> None:
    for seed in range(12):
        corners = star(seed, stretch, offset)
        made = section(polygon=tuple(x for corner in corners for x in corner))
        true = by_triangles(corners)
        found = {
            "a": made.area,
            "x": made.x,
            "y": made.y,
            "ix": made.centroidal.ix,
            "iy": made.centroidal.iy,
            "ixy": made.centroidal.ixy,
            "i1": made.principal.i1,
        }
        for name, value in found.items():
            assert abs(value - true[name]) <= 1.0000001 * U * abs(true[name]), (name, seed)
        with mp.workdps(60):
            small = (true["ix"] * true["iy"] - true["ixy"] ** 2) / true["i1"]
        assert abs(made.principal.i2 - small) <= 1.0000001 * U * small


def test_a_thin_turned_strip_keeps_its_least_moment() -> None:
    c, s = math.cos(0.3), math.sin(0.3)
    a, t = 1.0, 1e-6
    corners = [(x * c - y * s, x * s + y * c) for x, y in ((-a, -t), (a, -t), (a, t), (-a, t))]
    made = section(polygon=tuple(x for corner in corners for x in corner))
    true = by_triangles(corners)
    assert made.principal.i2 == pytest.approx(float(true["i2"]), rel=1e-15)
    # the strip lies along 0.3 rad, so its greatest moment is about the axis across it
    assert made.principal.angle == pytest.approx(0.3 - math.pi / 2, rel=1e-9)


def test_circles_and_rectangles_by_their_formulas() -> None:
    tube = section(pieces=(Piece(diameter=0.06),), holes=(Hole(diameter=0.05),))
    with mp.workdps(40):
        true = mp.pi / 64 * (mpf(0.06) ** 4 - mpf(0.05) ** 4)
    assert abs(tube.centroidal.ix - true) <= U * true
    assert tube.advice == ()
    assert tube.principal.angle == 0.0
    assert tube.principal.degeneracy.startswith("every axis")
    box = section(pieces=(Piece(width=3.0, height=4.0, x=10.0, y=-2.0),))
    assert (box.centroidal.ix, box.centroidal.iy, box.centroidal.ixy) == (16.0, 9.0, 0.0)
    assert (box.moduli.x_top, box.moduli.x_bottom, box.moduli.y_right) == (8.0, 8.0, 6.0)
    assert box.about_origin.ix == 16.0 + 12.0 * 4.0
    assert box.gyration.rx == math.sqrt(16.0 / 12.0)
    assert box.perimeter == 14.0
    assert [advice.code for advice in box.advice] == ["not-torsion"]


def test_either_way_round_and_any_first_corner_give_the_same() -> None:
    made = section(polygon=ELL)
    pairs = list(zip(ELL[0::2], ELL[1::2], strict=True))
    for shift in range(6):
        turned = pairs[shift:] + pairs[:shift]
        for order in (turned, turned[::-1], [*turned, turned[0]]):
            assert section(polygon=tuple(x for pair in order for x in pair)) == made


def test_a_hole_is_a_piece_taken_away() -> None:
    plate = (0.0, 0.0, 100.0, 0.0, 100.0, 50.0, 0.0, 50.0)
    whole, hole = section(polygon=plate), section(pieces=(Piece(diameter=20.0, x=30.0, y=20.0),))
    made = section(polygon=plate, holes=(Hole(diameter=20.0, x=30.0, y=20.0),))
    assert made.area == pytest.approx(whole.area - hole.area, rel=4e-16)
    for name in ("ix", "iy", "ixy", "polar"):
        rest = getattr(whole.about_origin, name) - getattr(hole.about_origin, name)
        assert getattr(made.about_origin, name) == pytest.approx(rest, rel=1e-15)


def test_moduli_of_an_angle_section() -> None:
    made = section(polygon=ELL)
    assert made.moduli.x_top == pytest.approx(made.centroidal.ix / (40.0 - made.y), rel=4e-16)
    assert made.moduli.y_left == pytest.approx(made.centroidal.iy / made.x, rel=4e-16)
    c, s = math.cos(made.principal.angle), math.sin(made.principal.angle)
    pairs = list(zip(ELL[0::2], ELL[1::2], strict=True))
    far = max(abs(-s * (x - made.x) + c * (y - made.y)) for x, y in pairs)
    assert made.moduli.first_least == pytest.approx(made.principal.i1 / far, rel=1e-14)


def test_a_tube_within_a_tube_is_sound() -> None:
    made = section(pieces=(Piece(diameter=20.0), Piece(diameter=5.0)), holes=(Hole(diameter=18.0), Hole(diameter=1.0)))
    assert made.area == pytest.approx(math.pi / 4.0 * (400.0 - 324.0 + 25.0 - 1.0), rel=4e-16)


def test_pieces_may_touch() -> None:
    two = section(pieces=(Piece(width=2.0, height=2.0), Piece(width=2.0, height=2.0, x=2.0)))
    assert two.centroidal == section(pieces=(Piece(width=4.0, height=2.0, x=1.0),)).centroidal


SQUARE = (0.0, 0.0, 10.0, 0.0, 10.0, 10.0, 0.0, 10.0)


@pytest.mark.parametrize(
    ("code", "inputs"),
    [
        ("missing", {}),
        ("missing", {"holes": (Hole(diameter=1.0),)}),
        ("polygon", {"polygon": (0.0, 0.0, 1.0, 1.0)}),
        ("polygon", {"polygon": (0.0, 0.0, 1.0, 1.0, 2.0)}),
        ("polygon", {"polygon": (0.0, 0.0, 1.0, 1.0, 2.0, 2.0)}),
        ("polygon", {"polygon": (0.0, 0.0, 4.0, 4.0, 4.0, 0.0, 0.0, 3.0)}),
        ("polygon", {"polygon": SQUARE, "holes": (Hole(diameter=3.0, x=10.0, y=5.0),)}),
        ("polygon", {"polygon": SQUARE, "holes": (Hole(width=10.0, height=1.0, x=10.0, y=5.0),)}),
        ("polygon", {"polygon": SQUARE, "pieces": (Piece(width=10.0, height=10.0, x=10.0, y=5.0),)}),
        ("polygon", {"pieces": (Piece(diameter=2.0), Piece(diameter=2.0, x=1.0))}),
        ("polygon", {"pieces": (Piece(diameter=2.0), Piece(width=9.0, height=0.5))}),
        ("hole-outside", {"polygon": SQUARE, "holes": (Hole(diameter=3.0, x=20.0),)}),
        ("hole-outside", {"polygon": SQUARE, "holes": (Hole(diameter=30.0, x=5.0, y=5.0),)}),
        ("hole-outside", {"pieces": (Piece(diameter=9.0),), "holes": (Hole(diameter=3.0), Hole(diameter=1.0))}),
        ("pieces-overlap", {"polygon": SQUARE, "pieces": (Piece(width=5.0, height=5.0, x=5.0, y=5.0),)}),
        ("pieces-overlap", {"polygon": SQUARE, "pieces": (Piece(polygon=SQUARE),)}),
        ("hole-outside", {"polygon": SQUARE, "holes": (Hole(polygon=SQUARE),)}),
        ("missing", {"pieces": (Piece(),)}),
        ("missing", {"pieces": (Piece(width=1.0),)}),
        ("exclusive", {"pieces": (Piece(width=1.0, height=1.0, diameter=1.0),)}),
        ("size", {"pieces": (Piece(diameter=0.0),)}),
        ("size", {"pieces": (Piece(width=1.0, height=0.0),)}),
        ("range", {"pieces": (Piece(diameter=1e-300),)}),
    ],
)  # fmt: skip
def test_refusals(code: str, inputs: dict[str, object]) -> None:
    with pytest.raises(InadmissibleError) as caught:
        section(**inputs)  # type: ignore[arg-type]
    assert caught.value.code == code


def test_what_is_too_large_for_a_double_is_refused() -> None:
    assert run("inertia", "section", "--piece", "diameter=1e300 m").status == 3


def test_the_command_answers_in_units() -> None:
    document = answer("inertia", "section", "--polygon", "0, 0, 3, 0, 3, 4, 0, 4 in", "--units", "us")
    assert document["results"]["centroidal"]["ix"] == {"value": pytest.approx(16.0, rel=1e-15), "unit": "in⁴"}
    assert document["warnings"][0]["code"] == "not-torsion"


def test_the_picture_shows_contours_axes_and_mohrs_circle() -> None:
    holes = (Hole(diameter=4.0, x=4.0, y=30.0),)
    made = section(polygon=ELL, holes=holes)
    shape, mohr = section_picture(made, Drawn(polygon=ELL, holes=holes)).panels
    curves = [item for item in shape.items if isinstance(item, Curve)]
    assert [curve.style for curve in curves] == ["solid", "dashed"]
    assert (curves[0].x[0], curves[0].y[0]) == (curves[0].x[-1], curves[0].y[-1])
    assert max(curves[1].x) == pytest.approx(6.0)
    first, second = (item for item in shape.items if isinstance(item, Arrow))
    assert first.dx * second.dx + first.dy * second.dy == pytest.approx(0.0, abs=1e-9)
    marks = {item.label: item for item in mohr.items if isinstance(item, Mark)}
    circle = mohr.items[0]
    assert isinstance(circle, Curve)
    assert max(circle.x) == pytest.approx(marks["I₁"].x)
    middle = 0.5 * (marks["x"].x + marks["y"].x)
    reach = math.hypot(marks["x"].x - middle, marks["x"].y)
    assert reach == pytest.approx(marks["I₁"].x - middle, rel=1e-14)


@pytest.mark.parametrize("units", ["si", "us", "base"])
def test_bounds_hold_in_the_units_shown(units: str) -> None:
    """Showing a number in another unit rounds it again, which the bound of the number shown has to cover."""
    ratio = {"si": mpf(1000), "us": mpf(1) / mpf("0.0254"), "base": mpf(1)}[units]
    with mp.workdps(40):
        for size in range(11, 60):
            found = answer("inertia", "section", "--piece", f"diameter={size} mm", "--units", units)
            diameter = mpf(size) / 1000
            for name, true in (
                ("area", mp.pi * diameter**2 / 4 * ratio**2),
                ("perimeter", mp.pi * diameter * ratio),
            ):
                bound = found["numerics"]["error_bound"][name]["relative"]
                assert abs(mpf(found["results"][name]["value"]) / true - 1) <= bound


class TestReading:
    """What was typed is a decimal; the doubles it is read into are not."""

    @staticmethod
    def exact(corners: list[tuple[Fraction, Fraction]]) -> dict[str, Fraction]:
        """Area and central moments of a polygon in rationals."""
        a = x = y = xx = yy = Fraction(0)
        for (x0, y0), (x1, y1) in zip(corners, corners[1:] + corners[:1], strict=True):
            c = x0 * y1 - x1 * y0
            a, x, y = a + c / 2, x + c * (x0 + x1) / 6, y + c * (y0 + y1) / 6
            xx, yy = xx + c * (x0 * x0 + x0 * x1 + x1 * x1) / 12, yy + c * (y0 * y0 + y0 * y1 + y1 * y1) / 12
        ix, iy = yy - y * y / a, xx - x * x / a
        return {"area": a, "centroidal.ix": ix, "centroidal.iy": iy, "centroidal.polar": ix + iy}

    @pytest.mark.parametrize(("x", "y"), [(0, 0), (1, 2), (450, 560), (4500000, 5600000), (-33333.3, 77777.7)])
    @pytest.mark.parametrize("unit", ["mm", "in", "ft"])
    def test_an_angle_anywhere_is_what_its_decimals_say(self, x: float, y: float, unit: str) -> None:
        outline = [(0, 0), (90, 0), (90, 9), (9, 9), (9, 60), (0, 60)]
        typed = [(Fraction(str(x)) + dx, Fraction(str(y)) + dy) for dx, dy in outline]
        text = ", ".join(str(float(part)) for corner in typed for part in corner)
        document = answer("inertia", "section", "--polygon", f"{text} {unit}", "--units", "base")
        metres = {"mm": Fraction(1, 1000), "in": Fraction(254, 10000), "ft": Fraction(3048, 10000)}[unit]
        true = self.exact([(px * metres, py * metres) for px, py in typed])
        stated = document["numerics"]
        for name, value in true.items():
            shown = document["results"]
            for part in name.split("."):
                shown = shown[part]
            error = abs(Fraction(shown["value"]) / value - 1)
            assert error <= stated["error_bound"][name]["relative"] <= 5e-16, name
        assert "input_rounding" not in stated
        assert "as typed" in stated["method"]
        assert [warning["code"] for warning in document["warnings"]] == ["not-torsion"]

    def test_pieces_and_holes_of_decimals_far_away(self) -> None:
        document = answer(
            "inertia", "section", "--piece", "width=0.3 mm, height=0.1 mm, x=7000000.1 mm, y=-0.7 mm",
            "--hole", "diameter=0.1 mm, x=7000000.2 mm, y=-0.7 mm", "--units", "base",
        )  # fmt: skip
        with mp.workdps(40):
            circle = mp.pi * mpf("0.0001") ** 2 / 4
            area = mpf("3e-8") - circle
            x = (mpf("7000.0001") * mpf("3e-8") - mpf("7000.0002") * circle) / area
            shown = document["results"]
            assert abs(shown["area"]["value"] / area - 1) <= document["numerics"]["error_bound"]["area"]["relative"]
            assert abs(shown["x"]["value"] / x - 1) <= document["numerics"]["error_bound"]["x"]["relative"]

    def test_json_and_scene_keep_the_decimals(self) -> None:
        scene = '{"polygon": {"value": [4500000.1, 0, 4500000.2, 0, 4500000.2, 0.1], "unit": "mm"}}'
        document = answer("inertia", "section", "--input", "-", "--units", "base", stdin=scene)
        assert document["results"]["area"]["value"] == pytest.approx(5e-9, rel=3e-16)


def test_corners_may_be_written_in_pairs() -> None:
    flat = answer("inertia", "section", "--polygon", "0, 0, 60, 0, 60, 8, 0, 8 mm")
    assert answer("inertia", "section", "--polygon", "0, 0; 60, 0; 60, 8; 0, 8 mm")["results"] == flat["results"]
