"""What the generators calculate with, proved by other ways: Taylor arithmetic, envelopes, extremes, systems."""

import json
import subprocess
import sys
from contextlib import nullcontext
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "references"))

import numpy as np
from cam_envelope import Carried, extreme, tops
from cam_geometry_cases import CASES as CAMS
from cam_programs import laws
from digits import BITS, DOUBLES, MANY, gmpy2, solved
from generate_cam_geometry_references import SWINGING, pairs, turned
from mpmath import diff as difference
from mpmath import mp, mpc, mpf
from taylor import circle, diff, expanded, of_numbers, sqrt

from dynamics_cli.accuracy.cases import DATA

REFERENCES = Path(__file__).resolve().parents[1] / "references"


@pytest.fixture(autouse=True)
def many_digits() -> Any:
    """The precision of the generators, whatever other tests have set."""
    wide = gmpy2.context(gmpy2.get_context(), precision=BITS) if gmpy2 else nullcontext()
    with wide, mp.workprec(BITS):
        yield


def plain(value: Any) -> Any:
    return mpf(str(value))


class TestTaylor:
    @pytest.mark.parametrize("order", [1, 2, 3, 4])
    def test_derivatives_are_those_by_differences(self, order: int) -> None:
        def ours(t: Any) -> Any:
            c, s = circle(MANY, t * t)
            return sqrt(MANY, 2 + s) / (1 + c * c) - (3 - t) ** 3 / t

        def theirs(t: Any) -> Any:
            return mp.sqrt(2 + mp.sin(t * t)) / (1 + mp.cos(t * t) ** 2) - (3 - t) ** 3 / t

        for x in ("0.3", "1.7", "-2.25"):
            found, expected = plain(diff(ours, MANY.number(x), order)), difference(theirs, mpf(x), order)
            assert abs(found - expected) < mpf(10) ** -60 * abs(expected)

    def test_derivatives_of_derivatives(self) -> None:
        def cube(t: Any) -> Any:
            return t * t * t

        t = MANY.number(2)
        assert diff(lambda u: diff(cube, u), t) == 12
        assert diff(lambda u: diff(cube, u) * u, t, 2) == 36
        assert expanded(lambda u: diff(cube, u) * u, t, 2) == [24, 36, 36]

    def test_by_something_else_than_the_variable_is_refused(self) -> None:
        with pytest.raises(TypeError):
            diff(lambda t: diff(lambda u: u * u, 2 * t), MANY.number(1))

    def test_arrays_go_through(self) -> None:
        x = np.linspace(0.1, 3.0, 7)
        assert np.allclose(diff(lambda t: circle(DOUBLES, t)[1] / t, x), np.cos(x) / x - np.sin(x) / x**2, rtol=1e-13)

    def test_functions_of_numbers_alone(self) -> None:
        made = of_numbers(lambda t: mp.exp(2 * t))
        assert abs(diff(made, mpf("0.5"), 2) - 4 * mp.e) < mpf(10) ** -60


class TestEnvelope:
    """Points of a cam by mpmath's differences of the followers' places, written down again."""

    @pytest.mark.parametrize("case", CAMS, ids=[case[0] for case in CAMS])
    def test_a_circle_or_a_line_is_touched(self, case: Any) -> None:
        _, _, segments, follower, turn, side = case
        exact, _ = turned(segments, swing=follower["record"] in SWINGING)
        carried = Carried(follower, turn, side)
        for start, end, lift, _ in exact[:3]:
            theta = start + (end - start) * 3 / 7
            point, normal = carried.point(lift, theta)
            z, n = mpc(plain(point.real), plain(point.imag)), mpc(plain(normal.real), plain(normal.imag))

            def away(t: Any, lift: Any = lift, z: Any = z, n: Any = n) -> Any:
                u = MANY.number(str(t))
                back = carried.back(u)
                back = mpc(plain(back.real), plain(back.imag))
                if carried.flat:
                    face, level = carried.face(lift(u))
                    own = mpc(plain(face.real), plain(face.imag)) * back
                    return (z * mp.conj(own)).real - plain(level)
                c = carried.centre(lift(u))
                return abs(z - mpc(plain(c.real), plain(c.imag)) * back) ** 2 - plain(carried.roller) ** 2

            size = 1 + abs(z) ** 2
            assert abs(away(plain(theta))) < mpf(10) ** -70 * size
            # a program that rises within 1e-6 rad has slopes of as many digits less
            assert abs(difference(away, plain(theta), h=mpf(10) ** -30)) < mpf(10) ** -18 * size
            assert abs(abs(n) - 1) < mpf(10) ** -70

    def test_every_law_goes_from_zero_to_one_without_a_step(self) -> None:
        for name, law in laws(MANY).items():
            places = [0, *(branch[1] for branch in law)]
            assert law[0][0] == 0, name
            for (_, end, f), (start, _, g) in pairwise(law):
                assert abs(end - start) < 1e-80, name
                for order in (0, 1):
                    one, other = (expanded(part, end, 1)[order] for part in (f, g))
                    assert abs(one - other) < 1e-75, (name, order)
            assert abs(law[0][2](MANY.number(0))) < 1e-80
            assert abs(law[-1][2](places[-1]) - 1) < 1e-80

    def test_curvature_by_three_points(self) -> None:
        """Of a knife-edge's path: the circle through three of its points, a millionth of a millionth apart."""
        segments = next(case[2] for case in CAMS if case[0] == "knife-edge offset")
        exact, _ = turned(segments)
        carried = Carried({"record": "KnifeEdge", "base_radius": "0.04", "offset": "0.01"}, 1, 1)
        lift = exact[0][2]
        theta, step = MANY.number("0.8"), MANY.number("1e-25")
        places = [carried.point(lift, theta + k * step)[0] for k in (-1, 0, 1)]
        a, b, c = (mpc(plain(p.real), plain(p.imag)) for p in places)
        area = abs((b - a).real * (c - a).imag - (b - a).imag * (c - a).real) / 2
        expected = abs(b - a) * abs(c - b) * abs(c - a) / (4 * area)
        assert abs(plain(carried.radius(lift, theta)) - expected) < mpf(10) ** -20 * abs(expected)


class TestExtremes:
    @pytest.mark.parametrize(
        "name", ["second cam on a slide", "roller, clockwise", "flat rocker with offset face, clockwise"]
    )
    def test_no_place_of_a_grid_lies_beyond(self, name: str) -> None:
        _, _, segments, follower, turn, side = next(case for case in CAMS if case[0] == name)
        exact, rough = turned(segments, swing=follower["record"] in SWINGING)
        carried, coarse = (Carried(follower, turn, side, field) for field in (MANY, DOUBLES))
        greatest = extreme(carried.pressure, pairs(exact, rough), 1, coarse.pressure)
        least = extreme(carried.pressure, pairs(exact, rough), -1, coarse.pressure)
        for start, end, lift, _ in rough:
            values = np.asarray(coarse.pressure(lift, start + (end - start) * np.linspace(0.0, 1.0, 3001)[1:-1]))
            assert values.max() <= float(greatest) + 1e-13
            assert values.min() >= float(least) - 1e-13

    def test_a_top_below_the_resolution_of_doubles_is_seen(self) -> None:
        """1 + 1e-20·(x − x²): in doubles the values are all one, their slopes are not."""
        whole = [((MANY.number(0), MANY.number(1), lambda t: t), (0.0, 1.0, lambda t: t))]
        tiny = MANY.number("1e-20")

        def bump(field_tiny: Any) -> Any:
            return lambda lift, t: 1 + field_tiny * (lift(t) - lift(t) * lift(t))

        found = extreme(bump(tiny), whole, 1, bump(1e-20))
        assert abs(found - 1 - tiny / 4) < 1e-60

    def test_slopes_that_fall_through_zero(self) -> None:
        slopes = np.array([1.0, 0.5, -0.5, 1.0, 0.0, -1.0])
        assert tops(slopes, np.ones(6, dtype=bool)) == [1, 3]
        assert tops(slopes, np.array([1, 0, 1, 1, 1, 1], dtype=bool)) == [3]


class TestSystems:
    def test_a_circle_and_a_line(self) -> None:
        x, y = solved(lambda x, y: [x * x + y * y - 25, 3 * x - 4 * y], (3, 2))
        assert abs(x - 4) < 1e-80
        assert abs(y - 3) < 1e-80

    def test_what_has_no_root_is_told(self) -> None:
        with pytest.raises(ArithmeticError):
            solved(lambda x: [x * x + 1], (0.3,))


def test_mpmath_alone_gives_the_same_digits(tmp_path: Path) -> None:
    """Where gmpy2 is not installed the generators take mpmath's numbers: slower, and the same file."""
    made = tmp_path / "cam_design.json"
    generator = REFERENCES / "generate_cam_design_references.py"
    code = (
        f"import sys, runpy; sys.modules['gmpy2'] = None; sys.argv = ['', {str(made)!r}];"
        f"runpy.run_path({str(generator)!r}, run_name='__main__')"
    )
    subprocess.run([sys.executable, "-c", code], check=True)
    assert json.loads(made.read_text()) == json.loads((DATA / "cam_design.json").read_text())
