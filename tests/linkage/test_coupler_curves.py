"""Coupler curves: length, extremes, cusps, cognates, drawings within their proved deviation."""

from cmath import exp, phase, rect
from math import pi, radians
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from harness import answer, run
from mpmath import mpf
from references.linkage_exact import curve_length

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.linkage.fourbar.circuit import FULL, Circuit, CouplerPath
from dynamics_cli.linkage.fourbar.closure import frame
from dynamics_cli.linkage.fourbar.coupler import Form, coupler
from dynamics_cli.linkage.fourbar.four_bar import four_bar
from dynamics_cli.linkage.fourbar.pictures import moving_four_bar

LENGTHS = (0.04, 0.12, 0.08, 0.1)
POINT = (0.06, 0.04)
# One of every kind of motion: turning, between outer limits, inner limits, both, and through change points.
MOTIONS = (
    (LENGTHS, 1.0), (LENGTHS, -1.0), ((3.0, 2.0, 2.5, 4.0), 1.0), ((4.0, 3.0, 2.0, 5.0), 1.0),
    ((2.0, 3.0, 1.1, 2.2), 1.0), ((3.0, 1.5, 3.0, 3.2), -1.0), ((2.0, 5.0, 4.0, 3.0), 1.0),
    ((1.0, 3.0, 1.0, 3.0), -1.0), ((3.0, 2.0, 3.0, 4.0), 1.0), ((2.0, 3.0, 3.0, 2.0), 1.0),
    ((3.0, 2.0, 2.0, 3.0), 1.0), ((2.0, 2.0, 2.0, 2.0), 1.0), ((2.0, 2.0, 3.0, 3.0), -1.0),
)  # fmt: skip


def curve(lengths: tuple[float, ...] = LENGTHS, point: tuple[float, float] = POINT, **more: object) -> object:
    a, b, c, d = lengths
    return coupler(crank=a, coupler=b, rocker=c, ground=d, point=point, **more)  # type: ignore[arg-type]


def test_length_against_forty_digits() -> None:
    made = curve()
    exact = curve_length(*(mpf(x) for x in LENGTHS), mpf(POINT[0]) + 1j * mpf(POINT[1]), 240)
    assert made.length == pytest.approx(0.24703160182511789857, rel=1e-14)  # type: ignore[attr-defined]
    assert abs(made.length - exact) <= made.numerics.bounds[0].bound + 1e-15 * exact  # type: ignore[attr-defined]


@pytest.mark.parametrize(("lengths", "side"), MOTIONS)
def test_every_motion_is_closed_smooth_and_keeps_its_links(lengths: tuple[float, ...], side: float) -> None:
    a, b, c, d = lengths
    circuit = Circuit(frame(*lengths), side)
    u = np.linspace(0.0, FULL, 97)
    (ax, ay), (bx, by) = circuit.place(u, 0j), circuit.place(u, complex(b))
    for x, y, length in ((ax.parts[0], ay.parts[0], a), (bx.parts[0] - ax.parts[0], by.parts[0] - ay.parts[0], b),
                         (bx.parts[0] - d, by.parts[0], c)):  # fmt: skip
        assert np.abs(np.hypot(x, y) - length).max() <= 1e-13 * d
    assert abs(bx.parts[0][0] - bx.parts[0][-1]) <= 1e-13 * d
    step = 1e-6
    ahead, behind = circuit.place(u + step, complex(b)), circuit.place(u - step, complex(b))
    for jet, one, other in ((bx, ahead[0], behind[0]), (by, ahead[1], behind[1])):
        assert np.abs((one.parts[0] - other.parts[0]) / (2.0 * step) - jet.parts[1]).max() <= 1e-7 * d
        assert np.abs((one.parts[1] - other.parts[1]) / (2.0 * step) - jet.derivative(2)).max() <= 1e-5 * d


@pytest.mark.parametrize("form", ["arcs", "cubics", "lines"])
def test_the_drawing_is_within_its_deviation(form: str) -> None:
    made = curve(form=Form(form), tolerance=2e-5)
    path = CouplerPath(Circuit(frame(*LENGTHS), 1.0), complex(*POINT))
    x, y = path.at(np.linspace(0.0, FULL, 4001))[:2]
    start = x + 1j * y
    step = np.diff(start)
    worst = 0.0
    for piece in made.shape.outlines[0].pieces:  # type: ignore[attr-defined]
        for point in getattr(piece, "points", ()) or (piece.start, middle(piece)):
            way = complex(*point) - start[:-1]
            share = np.clip((way * step.conj()).real / np.abs(step) ** 2, 0.0, 1.0)
            worst = max(worst, float(np.abs(way - share * step).min()))
    assert made.deviation <= 2e-5  # type: ignore[attr-defined]
    # the samples' own chords are off by less than this
    assert worst <= made.deviation + 5e-8  # type: ignore[attr-defined]


def middle(piece: Any) -> tuple[float, float]:
    """The point of an arc or a cubic half way."""
    (ax, ay), (bx, by) = piece.start, piece.end
    if hasattr(piece, "bulge"):
        return 0.5 * (ax + bx + piece.bulge * (by - ay)), 0.5 * (ay + by - piece.bulge * (bx - ax))
    (px, py), (qx, qy) = piece.control1, piece.control2
    return (ax + 3.0 * (px + qx) + bx) / 8.0, (ay + 3.0 * (py + qy) + by) / 8.0


def test_cognates_trace_one_curve() -> None:
    """The left cognate's crank turns as the coupler does: the program's own four-bar must find the same point."""
    for theta in (0.3, 1.9, 4.0):
        a, b, c, d = LENGTHS
        first = four_bar(crank=a, coupler=b, rocker=c, ground=d, crank_angle=theta, point=POINT)
        assert first.position is not None
        assert first.coupler_angle is not None
        target = complex(*first.position)
        share = complex(*POINT) / b
        left, right = curve().cognates  # type: ignore[attr-defined]
        for one, pivot, angle in (
            (left, 0j, first.coupler_angle + phase(share)),
            (right, complex(d), first.coupler_angle + pi + phase(1.0 - share)),
        ):
            third = complex(*one.third_pivot) - pivot
            found = []
            for branch in ("open", "crossed"):
                made = four_bar(crank=one.crank, coupler=one.coupler, rocker=one.rocker, ground=one.ground,
                                crank_angle=angle - phase(third), branch=branch, point=one.point)  # type: ignore[arg-type]  # fmt: skip
                assert made.position is not None
                found.append(pivot + complex(*made.position) * exp(1j * phase(third)))
            assert min(abs(place - target) for place in found) <= 1e-14


def test_cognates_of_a_point_in_the_middle() -> None:
    point = rect(0.5 * 120.0, radians(35.0))
    left, right = curve((40.0, 120.0, 80.0, 100.0), (point.real, point.imag), tolerance=0.1).cognates  # type: ignore[attr-defined]
    assert (left.crank, left.coupler, left.rocker, left.ground) == pytest.approx((60.0, 20.0, 40.0, 50.0))
    assert left.third_pivot == pytest.approx((40.957602214449589484, 28.678821817552304805))
    wanted = (78.766811299166594, 52.511207532777729, 26.255603766388865, 65.639009415972162)
    assert (right.crank, right.coupler, right.rocker, right.ground) == pytest.approx(wanted)


def test_a_point_on_the_moving_centrode_has_a_cusp() -> None:
    a, b, c, d = LENGTHS
    made = four_bar(crank=a, coupler=b, rocker=c, ground=d, crank_angle=1.0)
    assert made.coupler_ratio is not None
    assert made.coupler_angle is not None
    assert made.crank_pin is not None
    # the instant centre of the coupler, A − a/ω₃, in the coupler's own axes
    place = -complex(*made.crank_pin) / made.coupler_ratio * exp(-1j * made.coupler_angle)
    found = curve(point=(place.real, place.imag))
    assert [round(one.crank_angle, 6) for one in found.cusps] == [1.0]  # type: ignore[attr-defined]
    pieces = found.shape.outlines[0].pieces  # type: ignore[attr-defined]
    # straight away from the cusp and up to it, arcs between
    assert hasattr(pieces[0], "points")
    assert hasattr(pieces[-1], "points")
    assert len([piece for piece in pieces if hasattr(piece, "bulge")]) > 10
    assert found.deviation <= 1e-5  # type: ignore[attr-defined]
    assert curve(point=(place.real + 1e-3, place.imag)).cusps is None  # type: ignore[attr-defined]


def test_hoeken() -> None:
    made = curve((1.0, 2.5, 2.5, 2.0), (5.0, 0.0), tolerance=1e-3)
    path = Circuit(frame(1.0, 2.5, 2.5, 2.0), 1.0)
    _, y = path.place(np.linspace(0.5 * pi, 1.5 * pi, 20001), 5.0 + 0j)
    assert y.parts[0].min() == pytest.approx(4.0, abs=1e-9)
    assert y.parts[0].max() == pytest.approx(4.009753733086360005765, abs=1e-9)
    assert made.top >= float(y.parts[0].max())  # type: ignore[attr-defined]
    # the peak over the straight part
    peak = four_bar(crank=1.0, coupler=2.5, rocker=2.5, ground=2.0, crank_angle=radians(128.68218745348944),
                    speed=1.0, point=(5.0, 0.0))  # fmt: skip
    assert peak.position is not None
    assert peak.velocity is not None
    assert peak.position[1] == pytest.approx(4.009753733086360005765, rel=1e-15)
    assert peak.velocity[1] == pytest.approx(0.0, abs=1e-14)


def test_crossings_lie_on_the_curve_twice() -> None:
    made = curve((1.0, 2.5, 2.5, 2.0), (1.25, -2.5), tolerance=1e-3)
    for one in made.crossings or ():  # type: ignore[attr-defined]
        for angle in (one.crank_angle, one.second_crank_angle):
            at = four_bar(crank=1.0, coupler=2.5, rocker=2.5, ground=2.0, crank_angle=angle, point=(1.25, -2.5))
            assert at.position == pytest.approx((one.x, one.y), abs=1e-9)


def test_a_line_has_no_curve() -> None:
    with pytest.raises(InadmissibleError, match="cannot move"):
        curve((1.0, 1.0, 1.0, 3.0))


def test_files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    links = (
        "--crank",
        "40 mm",
        "--coupler",
        "120 mm",
        "--rocker",
        "80 mm",
        "--ground",
        "100 mm",
        "--point",
        "60, 40 mm",
    )
    for name in ("curve.svg", "curve.csv"):
        done = run("linkage", "coupler", *links, "--drawing", name)
        assert done.status == 0
        assert "within" in done.out
        assert (tmp_path / name).stat().st_size > 500
    moving = moving_four_bar(None, 0.04, 0.12, 0.08, 0.1, point=POINT)
    assert moving.count("<animate ") == 9
    assert "<script" not in moving


def test_an_uncertain_curve_is_not_drawn_for_every_sample() -> None:
    links = ("--coupler", "120 mm", "--rocker", "80 mm", "--ground", "100 mm", "--point", "60, 40 mm")
    made = answer("linkage", "coupler", "--crank", "40 ± 0.1 mm", *links)["results"]
    wide = [curve((a, 0.12, 0.08, 0.1), tolerance=1e-3).length for a in (0.0401, 0.0399)]  # type: ignore[attr-defined]
    assert made["length"]["std"] == pytest.approx(0.5e3 * (wide[0] - wide[1]), rel=1e-2)
    assert 0.0 < made["deviation"]["value"] <= 0.01


def test_the_straight_part_of_hoekens_linkage_is_as_wide_as_it_says() -> None:
    links = {"crank": 0.01, "coupler": 0.025, "rocker": 0.025, "ground": 0.02}
    result = coupler(**links, point=(0.05, 0.0), straight_within=5e-5, points=4).straight
    assert result
    part = result[0]
    # the pose by the law of cosines
    turn = np.linspace(part.crank_angle, part.last_crank_angle, 5001)
    a = 0.01 * np.exp(1j * turn)
    gap = 0.02 - a
    along = (abs(gap) ** 2 + 0.025**2 - 0.025**2) / (2.0 * abs(gap))
    p = a + 2.0 * gap / abs(gap) * (along + 1j * np.sqrt(0.025**2 - along**2))
    assert 0.5 * np.ptp(p.imag) == pytest.approx(part.deviation, rel=1e-3)
    assert abs(p[-1] - p[0]) == pytest.approx(part.length, rel=1e-9)
    assert abs(p[0] - complex(*part.start)) <= 1.001 * part.deviation
    assert part.deviation <= 5e-5
    # half a degree more at either end is not within it
    wider = coupler(**links, point=(0.05, 0.0), straight_within=1.1 * part.deviation, points=4).straight
    assert wider
    assert wider[0].length > part.length
    assert coupler(**links, point=(0.05, 0.0), straight_within=1e-12, points=4).straight == ()
    # the whole curve is within 5 mm: its two ends that are farthest apart
    whole = coupler(**links, point=(0.05, 0.0), straight_within=5e-3, points=4).straight
    assert whole
    places = coupler(**links, point=(0.05, 0.0), points=720).points.arrays
    chords = np.array(places["x"]) + 1j * np.array(places["y"])
    assert whole[0].length == pytest.approx(np.abs(chords[:, None] - chords[None, :]).max(), rel=1e-4)
