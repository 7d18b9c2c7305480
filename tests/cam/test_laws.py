"""Rise laws: ends, monotony, symmetry, derivatives, peak factors, continuity, and what is refused."""

from math import pi

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dynamics_cli.cam.laws.components import u_minus_sine
from dynamics_cli.cam.laws.names import LawName
from dynamics_cli.cam.laws.normalised import law_named, scca
from dynamics_cli.cam.laws.peaks import continuity, extremes, peak
from dynamics_cli.cam.laws.polynomials import polynomial, spline
from dynamics_cli.cam.laws.rise import rise
from dynamics_cli.cam.laws.selection import Condition, SplinePoint
from dynamics_cli.cam.laws.table import laws
from dynamics_cli.errors import InadmissibleError

NAMED = [name for name in LawName.names if name not in ("scca", "polynomial", "spline")]
SHARES = [
    (0.25, 0.5, 0.25),
    (0.0, 1.0, 0.0),
    (0.0, 0.0, 1.0),
    (0.5, 0.5, 0.0),
    (0.1, 0.2, 0.7),
    (1e-9, 1.0 - 2e-9, 1e-9),
]
ALL = [law_named(name) for name in NAMED] + [scca(*shares) for shares in SHARES]
IDS = [*NAMED, *map(str, SHARES)]
PUBLISHED = {
    "parabolic": ("2", "4", "inf"),
    "cubic": ("1.5", "6", "inf"),
    "harmonic": ("1.5708", "4.9348", "inf"),
    "double-harmonic": ("2.0405", "9.8696", "inf"),
    "cycloidal": ("2", "6.2832", "39.478"),
    "modified-trapezoid": ("2", "4.8881", "61.426"),
    "modified-sine": ("1.7596", "5.5280", "69.466"),
    "trapezoid": ("2", "5.3333", "42.667"),
    "3-4-5": ("1.875", "5.7735", "60"),
    "4-5-6-7": ("2.1875", "7.5132", "52.5"),
    "5-6-7-8-9": ("2.4609", "9.3720", "78.75"),
    "gutman-1-3": ("2", "5.1302", "59.22"),
    "freudenstein-1-3": ("2", "5.3856", "50.76"),
    "freudenstein-1-3-5": ("2", "5.0603", "59.62"),
    "modified-constant-velocity": ("1.2753", "8.0127", "201.38"),
    "half-harmonic-start": ("1.5708", "2.4674", "inf"),
}


@pytest.mark.parametrize("law", ALL, ids=IDS)
class TestEveryLaw:
    def test_ends_are_met_to_the_bit(self, law) -> None:
        assert law.at(0.0)[0] == 0.0
        assert law.at(1.0)[0] == 1.0
        assert 0.1 * law.at(1.0)[0] == 0.1

    def test_it_never_turns_back_or_overshoots(self, law) -> None:
        # steps of 2⁻⁵⁰ about the joints: a rise over less is smaller than the spacing of doubles near one
        near = np.concatenate(
            [np.linspace(0.0, 1.0, 20001), *(edge + np.arange(-40, 41) * 2.0**-50 for edge in law.edges)]
        )
        values = law.at(np.sort(near), 0)[0]
        assert (np.diff(values) >= 0.0).all()
        assert values[0] == 0.0
        assert values[-1] == 1.0

    def test_each_derivative_is_that_of_the_one_below(self, law) -> None:
        step = 1e-5
        for x in np.linspace(0.011, 0.987, 37).tolist():
            if any(abs(x - edge) < 2 * step for edge in law.breaks):
                continue
            low, high, here = law.at(x - step, 4), law.at(x + step, 4), law.at(x, 4)
            for order in range(4):
                slope = (high[order] - low[order]) / (2 * step)
                scale = max(abs(value) for _, value in extremes(law, min(order + 1, 3))) + abs(here[order + 1]) + 1.0
                assert abs(slope - here[order + 1]) < 1e-4 * scale, (x, order)

    def test_arrays_and_floats_give_the_same(self, law) -> None:
        x = np.linspace(0.0, 1.0, 257)
        for side in (-1, 1):
            many = law.at(x, 3, side)
            for place, *values in zip(x.tolist(), *many, strict=True):
                single = law.at(place, 3, side)
                for order, value in enumerate(values):
                    scale = max(abs(top) for _, top in extremes(law, order)) or 1.0
                    assert abs(single[order] - value) <= 1e-15 * scale

    def test_peaks_are_none_below_a_grid(self, law) -> None:
        x = np.linspace(0.0, 1.0, 40001)
        for order in (1, 2, 3):
            top = max(abs(value) for _, value in extremes(law, order))
            grid = max(abs(law.at(x, order, side)[order]).max() for side in (-1, 1))
            assert grid <= top * (1.0 + 1e-15)
            assert grid >= top * (1.0 - 1e-4)


@pytest.mark.parametrize("name", PUBLISHED)
def test_peak_factors_are_the_published_ones(name: str) -> None:
    law = law_named(name)
    for order, printed in enumerate(PUBLISHED[name], 1):
        found = peak(law, order)[0]
        decimals = len(printed.partition(".")[2])
        assert found == float(printed) or abs(found - float(printed)) <= 0.5 * 10.0**-decimals


def test_the_modified_trapezoid_constant() -> None:
    assert peak(law_named("mt"), 2)[0] == pytest.approx(8.0 * pi / (pi + 2.0), rel=4e-16)


@pytest.mark.parametrize(
    ("shares", "name"),
    [
        ((0.25, 0.5, 0.25), "mt"),
        ((0.25, 0.0, 0.75), "ms"),
        ((0.5, 0.0, 0.5), "cycloidal"),
        ((0.0, 1.0, 0.0), "parabolic"),
    ],
)
def test_scca_contains_its_family(shares, name: str) -> None:
    x = np.linspace(0.0, 1.0, 101)
    for own, other, scale in zip(scca(*shares).at(x), law_named(name).at(x), (1.0, 2.0, 7.0, 70.0), strict=True):
        assert abs(own - other).max() <= 2e-15 * scale


@settings(max_examples=150, deadline=None)
@given(st.floats(0.0, 1.0), st.floats(0.0, 1.0), st.floats(0.0, 0.98))
def test_any_scca_is_a_rise_with_the_closed_form_peak(b: float, c: float, constant: float) -> None:
    b, c = round(b, 9), round(c * (1.0 - round(b, 9)), 9)
    d = round(1.0 - b - c, 9)
    law = scca(b, c, d, constant)
    assert law.at(1.0)[0] == 1.0
    assert abs(law.at(0.5)[0] - 0.5) < 1e-15
    assert abs(law.at(0.5, 0, -1)[0] - 0.5) < 1e-15
    if constant == 0.0:
        peak_a = 4 * pi**2 / ((pi**2 - 8) * (b**2 - d**2) - 2 * pi * (pi - 2) * b + pi**2)
        assert max(abs(v) for _, v in extremes(law, 2)) == pytest.approx(peak_a, rel=1e-13)


def test_continuity_is_told() -> None:
    told = {name: continuity(law_named(name)) for name in NAMED}
    assert told["linear"] == (0, 0.0)
    assert told["parabolic"] == (1, 0.0)
    assert told["double-harmonic"] == (1, 1.0)
    assert told["3-4-5"][0] == 2
    assert told["4-5-6-7"][0] == 3
    assert told["5-6-7-8-9"] == (4, None)
    assert told["half-cycloid-start"] == (2, 0.0)


def test_names_of_the_standard_are_aliases() -> None:
    assert LawName("Geneigte Sinuslinie") == LawName("Bestehorn") == "cycloidal"
    assert LawName("modifiziertes_Beschleunigungstrapez") == "modified-trapezoid"
    assert set(LawName.aliases.values()) <= set(LawName.names)


@pytest.mark.parametrize("u", [1e-90, 1e-8, 0.3, 0.9999999999999999, 1.0, 1.0000000000000002, 3.0])
def test_u_minus_sine_on_both_sides_of_its_switch(u: float) -> None:
    from mpmath import mp, mpf, sin

    mp.dps = 300
    exact = mpf(u) - sin(mpf(u))
    assert abs(u_minus_sine(u) / exact - 1) < 8e-16
    assert u_minus_sine(np.array([u, 2.0]))[0] == u_minus_sine(u)


def test_a_polynomial_meets_its_conditions() -> None:
    conditions = [
        (0.0, 0, 0.0),
        (0.0, 1, 0.5),
        (0.3, 0, 0.4),
        (0.5, 2, -1.0),
        (1.0, 0, 1.0),
        (1.0, 1, 0.0),
        (1.0, 3, 2.0),
    ]
    law = polynomial(conditions)
    for x, order, value in conditions:
        assert law.at(x)[order] == pytest.approx(value, abs=2e-14)
    found = laws(
        law=LawName("polynomial"),
        conditions=(Condition(0.0, 0.0, 0.0, 0.0), Condition(1.0, 1.0, 0.0, 0.0)),
    ).laws[0]
    assert found.velocity == 1.875
    assert found.jerk == 60.0


def test_a_spline_goes_through_its_points_with_continuous_acceleration() -> None:
    points = [(0.0, 0.0), (0.1, 0.02), (0.45, 0.6), (0.7, 0.8), (1.0, 1.0)]
    law = spline(points, 0.0, 0.3)
    for x, f in points:
        assert law.at(x)[0] == pytest.approx(f, abs=2e-16)
    for x, _ in points[1:-1]:
        for before, after in zip(law.at(x, 2, -1), law.at(x, 2), strict=True):
            assert before == pytest.approx(after, abs=2e-13)
    assert law.at(0.0)[1] == 0.0
    assert law.at(1.0)[1] == 0.3


@settings(max_examples=60, deadline=None)
@given(st.sampled_from(NAMED), st.floats(1e-4, 0.1), st.floats(0.01, 6.0), st.floats(0.0, 1.0))
def test_a_mirrored_return_is_the_rise_run_backwards(name: str, lift: float, span: float, share: float) -> None:
    at = share * span
    up = rise(law=LawName(name), lift=lift, span=span, at=(span - at,)).points[0]
    down = rise(law=LawName(name), lift=lift, span=span, at=(at,), mirrored=True).points[0]
    assert down.lift == pytest.approx(up.lift, rel=1e-9, abs=1e-15 * lift)
    assert down.velocity == pytest.approx(-up.velocity, rel=1e-9, abs=1e-13 * lift / span)


def test_values_in_time_scale_with_the_speed() -> None:
    slow, fast = (
        rise(law=LawName("3-4-5"), lift=0.01, span=1.0, at=(0.3,), shaft_speed=w).points[0] for w in (1.0, 8.0)
    )
    assert fast.speed == 8.0 * slow.speed
    assert fast.acceleration_in_time == 64.0 * slow.acceleration_in_time
    assert fast.jerk_in_time == 512.0 * slow.jerk_in_time
    assert fast.time == slow.time / 8.0


@pytest.mark.parametrize(
    ("given_", "code"),
    [
        ({"lift": 0.0}, "lift"),
        ({"span": 0.0}, "span"),
        ({"at": (1.5,)}, "angle"),
        ({"count": 1}, "count"),
        ({"law": LawName("scca")}, "shares"),
        ({"law": LawName("scca"), "shares": (0.5, 0.4, 0.2)}, "shares"),
        ({"law": LawName("scca"), "shares": (-0.5, 1.0, 0.5)}, "shares"),
        ({"shares": (0.5, 0.4, 0.1)}, "shares"),
        ({"constant": 0.5}, "constant"),
        ({"law": LawName("mcv"), "constant": 1.0}, "constant"),
        ({"law": LawName("polynomial")}, "conditions"),
        (
            {"law": LawName("polynomial"), "conditions": (Condition(0.0, None, 0.0), Condition(1.0, None, 0.0))},
            "conditions",
        ),
        ({"law": LawName("polynomial"), "conditions": (Condition(0.0, 0.0), Condition(0.0, 0.0))}, "conditions"),
        ({"conditions": (Condition(0.0, 0.0),)}, "law"),
        ({"law": LawName("spline"), "points": (SplinePoint(0.5, 0.5), SplinePoint(0.4, 0.5))}, "points"),
        ({"start_velocity": 1.0}, "law"),
    ],
)
def test_what_has_no_answer_is_refused(given_, code: str) -> None:
    with pytest.raises(InadmissibleError) as refused:
        rise(**{"law": LawName("cycloidal"), "lift": 0.01, "span": 1.0, **given_})
    assert refused.value.code == code


@pytest.mark.parametrize("speed", [31.4, -31.4, 0.0])
def test_peaks_in_time_are_those_by_angle_times_powers_of_the_shaft_speed(speed: float) -> None:
    made = rise(law=LawName("cycloidal"), lift=0.01, span=0.5 * pi, shaft_speed=speed)
    rate = abs(speed)
    assert made.peak_speed == pytest.approx(0.04 / pi * rate, rel=1e-14)
    assert made.peak_acceleration_in_time == pytest.approx(0.08 / pi * rate**2, rel=1e-14)
    assert made.peak_jerk_in_time == pytest.approx(0.32 / pi * rate**3, rel=1e-14)
    assert rise(law=LawName("cycloidal"), lift=0.01, span=0.5 * pi).peak_speed is None
