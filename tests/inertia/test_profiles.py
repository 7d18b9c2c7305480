"""Profiles by their sizes, against integrals over their width at every height, and their refusals."""

from math import pi, sqrt
from typing import Any

import pytest
from harness import answer, run
from mpmath import mp, quad

# Width of the material at a height, for profiles whose fillets are symmetric, in mm.
H, W, WEB, FLANGE, R = 200.0, 100.0, 5.6, 8.5, 12.0
SIZES = ("--height", "200 mm", "--width", "100 mm", "--web", "5.6 mm", "--flange", "8.5 mm", "--fillet", "12 mm")
WITHIN = 1e-12


def opening(y: Any) -> Any:
    """How much of the width one fillet fills at a distance from its flange."""
    return R - mp.sqrt(R * R - (R - y) ** 2) if y < R else mp.mpf(0)


def section(profile: str, *sizes: str) -> dict[str, Any]:
    return answer("inertia", "section", "--profile", profile, *sizes)["results"]


def value(results: dict[str, Any], address: str) -> float:
    node: Any = results
    for key in address.split("."):
        node = node[key]
    return float(node["value"])


def test_an_i_beam_with_fillets() -> None:
    half = H / 2 - FLANGE
    places = [0, half - R, half]

    def width(y: Any) -> Any:
        return WEB + 2 * opening(half - y)

    area = 2 * (quad(width, places) + W * FLANGE)
    ix = 2 * (quad(lambda y: width(y) * y * y, places) + W * ((H / 2) ** 3 - half**3) / 3)
    iy = 2 * (quad(lambda y: width(y) ** 3, places) + W**3 * FLANGE) / 12
    results = section("i-beam", *SIZES)
    for address, expected in (("area", area), ("centroidal.ix", ix), ("centroidal.iy", iy)):
        assert value(results, address) == pytest.approx(float(expected), rel=WITHIN)
    assert value(results, "moduli.x_top") == pytest.approx(float(ix / (H / 2)), rel=WITHIN)
    assert value(results, "perimeter") == pytest.approx(2 * H + 4 * W - 2 * WEB - 8 * R + 2 * pi * R, rel=WITHIN)


def test_a_channel_and_a_tee_lie_where_their_material_is() -> None:
    half = H / 2 - FLANGE
    places = [0, half - R, half]

    def width(y: Any) -> Any:
        return WEB + opening(half - y)

    area = 2 * (quad(width, places) + W * FLANGE)
    first = 2 * (quad(lambda y: width(y) ** 2 / 2, places) + W**2 / 2 * FLANGE)
    results = section("channel", *SIZES)
    assert value(results, "area") == pytest.approx(float(area), rel=WITHIN)
    assert value(results, "x") == pytest.approx(float(first / area) - W / 2, rel=WITHIN)
    assert value(results, "y") == 0.0
    tee = section("tee", "--height", "100 mm", "--width", "100 mm", "--web", "10 mm", "--flange", "10 mm")
    assert value(tee, "y") == pytest.approx((1000 * 45 - 900 * 5) / 1900, rel=WITHIN)


def test_an_angle_of_equal_legs_has_axes_at_half_a_right_angle() -> None:
    results = section("angle", "--height", "100 mm", "--width", "100 mm", "--thickness", "10 mm", "--fillet", "12 mm")
    assert value(results, "area") == pytest.approx(1900 + 144 * (1 - pi / 4), rel=WITHIN)
    assert value(results, "principal.angle") == pytest.approx(45, rel=WITHIN)
    # about the axis of symmetry, along u = (x + y)/√2: the legs are seen under 45 degrees
    plain = section("angle", "--height", "100 mm", "--width", "100 mm", "--thickness", "10 mm")
    assert value(plain, "principal.i1") == pytest.approx(
        value(plain, "centroidal.ix") - value(plain, "centroidal.ixy"), rel=WITHIN
    )
    assert value(plain, "gyration.r2") == pytest.approx(sqrt(value(plain, "principal.i2") / 1900), rel=WITHIN)


@pytest.mark.parametrize(
    ("profile", "pieces"),
    [
        (
            "box|--height|60 mm|--width|40 mm|--thickness|5 mm",
            "--piece|width=40 mm, height=60 mm|--hole|width=30 mm, height=50 mm",
        ),
        ("tube|--diameter|60 mm|--thickness|5 mm", "--piece|diameter=60 mm|--hole|diameter=50 mm"),
        ("flat|--height|60 mm|--width|5 mm|--x|3 mm", "--piece|width=5 mm, height=60 mm, x=3 mm"),
        ("round|--diameter|60 mm|--y|-3 mm", "--piece|diameter=60 mm, y=-3 mm"),
    ],
)
def test_closed_profiles_are_pieces_and_holes(profile: str, pieces: str) -> None:
    assert section(*profile.split("|")) == answer("inertia", "section", *pieces.split("|"))["results"]


@pytest.mark.parametrize(
    ("call", "message"),
    [
        ("tee|--height|60 mm|--width|40 mm|--web|5 mm", "a tee needs its flange"),
        ("tube|--diameter|60 mm|--thickness|5 mm|--width|2 mm", "a tube takes no width"),
        ("tube|--diameter|60 mm|--thickness|30 mm", "the wall fills the tube"),
        ("box|--height|60 mm|--width|40 mm|--thickness|20 mm", "the walls fill the profile"),
        ("angle|--height|60 mm|--width|40 mm|--thickness|5 mm|--fillet|36 mm", "there is room for 35 mm"),
        ("tee|--height|40 mm|--width|120 mm|--web|10 mm|--flange|10 mm|--fillet|31 mm", "there is room for 30 mm"),
        ("box|--height|60 mm|--width|40 mm|--thickness|5 mm|--fillet|1 mm", "a box takes no fillet"),
    ],
)
def test_refusals(call: str, message: str) -> None:
    outcome = run("inertia", "section", "--profile", *call.split("|"))
    assert outcome.status == 3
    assert message in outcome.err


def test_bars_are_built_up() -> None:
    plates = "profile=flat, width=10 mm, height=100 mm", "profile=flat, width=80 mm, height=10 mm, y=55 mm"
    results = answer("inertia", "section", *(word for plate in plates for word in ("--bar", plate)))["results"]
    assert value(results, "area") == 1800
    assert value(results, "y") == pytest.approx(800 * 55 / 1800, rel=WITHIN)


def test_the_mass_per_length() -> None:
    results = section("round", "--diameter", "50 mm", "--density", "7.85 g/cm^3")
    assert value(results, "linear_density") == pytest.approx(7850 * pi * 0.05**2 / 4, rel=WITHIN)
    assert "linear_density" not in section("round", "--diameter", "50 mm")
