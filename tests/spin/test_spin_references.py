"""Spinning bodies against published reference numbers and against integrated motions."""

import math
from typing import Any

import pytest

from dynamics_cli.errors import DynamicsError
from dynamics_cli.spin.disk import Wheel, disk
from dynamics_cli.spin.free import free
from dynamics_cli.spin.gyro import gyro
from dynamics_cli.spin.rod import rod
from dynamics_cli.spin.shaft import shaft
from dynamics_cli.spin.top import top

TOP = {"mass": 0.5, "distance": 0.06, "axial": 0.0006, "transverse": 0.0025}


def near(value: Any, text: str, tolerance: float = 4e-15) -> None:
    assert value == pytest.approx(float(text), rel=tolerance, abs=0.0)


def test_gyro() -> None:
    made = gyro(axial=0.03, transverse=0.02, spin=100 * math.pi, precession=2.0, angle=math.pi / 3)
    near(made.torque, "16.34151478618364943")
    assert made.simple_share == pytest.approx(1.0, rel=2e-3)
    assert gyro(axial=0.03, transverse=0.02, spin=-300.0, precession=2.0).sense.endswith(
        "away from the precession axis"
    )


@pytest.mark.parametrize(
    ("moments", "rates", "period"),
    [
        ((1.0, 2.0, 3.0), (0.2, 1.0, 0.5), "10.17824796582004425046"),
        ((1.0, 2.0, 3.0), (1e-6, 1.0, 0.0), "105.3211939463924371459"),
        ((1.0, 1.000001, 2.0), (1e-3, 1e-8, 10.0), "0.628319159036804310630"),
        ((3.0, 1.0, 2.0), (0.5, -0.2, 1.0), "10.17824796582004425046"),
    ],
)
def test_periods(moments: Any, rates: Any, period: str) -> None:
    near(free(moments=moments, angular_velocity=rates).period, period)


@pytest.mark.parametrize("rates", [(0.2, 1.0, 0.5), (1.5, 0.4, 0.3)])
def test_a_free_body_returns_and_stays_within_its_extremes(rates: tuple[float, float, float]) -> None:
    """Euler's equations by Runge–Kutta over one period."""
    moments = (1.0, 2.0, 3.0)
    made = free(moments=moments, angular_velocity=rates)
    assert made.period is not None
    steps, state, sizes = 2000, rates, [[abs(w)] for w in rates]
    h = made.period / steps

    def slope(w: tuple[float, ...]) -> tuple[float, ...]:
        return (-w[1] * w[2], w[2] * w[0], -w[0] * w[1] / 3.0)

    def moved(w: tuple[float, ...], k: tuple[float, ...], by: float) -> tuple[float, ...]:
        return tuple(a + by * b for a, b in zip(w, k, strict=True))

    for _ in range(steps):
        k1 = slope(state)
        k2 = slope(moved(state, k1, h / 2))
        k3 = slope(moved(state, k2, h / 2))
        k4 = slope(moved(state, k3, h))
        state = tuple(  # type: ignore[assignment]
            w + h / 6 * (a + 2 * b + 2 * c + d) for w, a, b, c, d in zip(state, k1, k2, k3, k4, strict=True)
        )
        for size, w in zip(sizes, state, strict=True):
            size.append(abs(w))
    assert state == pytest.approx(rates, abs=1e-9)
    assert tuple(map(max, sizes)) == pytest.approx(made.greatest, abs=1e-5)
    assert tuple(map(min, sizes)) == pytest.approx(made.least, abs=4e-3)


def test_symmetric_bodies() -> None:
    made = free(moments=(1.0, 1.0, 1.5), angular_velocity=(0.0, 0.1, 1.0))
    assert made.period == pytest.approx(2 * math.pi / 0.5, rel=1e-15)
    assert made.least_precession == pytest.approx(math.hypot(0.1, 1.5), rel=1e-15)
    assert free(moments=(1.0, 1.0, 1.0), angular_velocity=(0.0, 0.1, 1.0)).period is None
    assert "across" in free(moments=(1.0, 1.0, 1.5), angular_velocity=(0.3, 0.1, 0.0)).motion


def test_separatrix_is_decided_on_the_decimals() -> None:
    """9·4·0.1² = 4·1·0.3² in decimals, though not in doubles."""
    on = free(moments=(4.0, 5.0, 9.0), angular_velocity=(0.3, 1.0, 0.1))
    assert on.period is None
    assert on.motion.startswith("separatrix")
    above = free(moments=(4.0, 5.0, 9.0), angular_velocity=(0.3, 1.0, 0.1000000000001))
    below = free(moments=(4.0, 5.0, 9.0), angular_velocity=(0.3, 1.0, 0.0999999999999))
    assert above.period is not None
    assert below.period is not None
    assert above.motion.startswith("goes round about z")
    assert below.motion.startswith("goes round about x")


def test_middle_axis() -> None:
    made = free(moments=(1.0, 2.0, 3.0), angular_velocity=(0.0, 1.0, 0.0))
    assert made.period is None
    assert made.growth == pytest.approx(math.sqrt(1 / 3), rel=1e-15)


def test_top() -> None:
    made = top(**TOP, spin=200.0, tilt=math.pi / 6)
    near(made.slow, "2.570914194402071009")
    near(made.fast, "52.85471164780200238")
    near(made.sleeping_spin, "90.40026732998820802")
    assert top(**TOP, spin=90.5).upright == "sleeps"
    assert top(**TOP, spin=90.3).upright != "sleeps"
    level = top(**TOP, spin=200.0, tilt=math.pi / 2)
    assert level.fast is None
    assert top(**TOP, spin=-200.0, tilt=1.0).slow == pytest.approx(-top(**TOP, spin=200.0, tilt=1.0).slow)


def test_both_sides_of_the_least_spin() -> None:
    least = top(**TOP, spin=200.0, tilt=0.5).least_spin
    touched = top(**TOP, spin=least * (1 + 1e-12), tilt=0.5)
    assert touched.slow == pytest.approx(touched.fast, rel=1e-5)
    with pytest.raises(DynamicsError, match="steady precession"):
        top(**TOP, spin=least * (1 - 1e-9), tilt=0.5)


def test_disk() -> None:
    made = disk(radius=0.3, lean=math.radians(20.0), turn=1.5)
    near(made.rolling_limit, "3.300951041408795")
    near(made.pivoting_limit, "5.113811364008913")
    near(made.spin, "5.202389331378439686")
    near(made.path_radius, "1.040477866275688")
    hoop = disk(radius=0.3, wheel=Wheel("hoop"))
    near(hoop.rolling_limit**2, repr(9.80665 / 1.2))
    near(hoop.pivoting_limit**2, repr(9.80665 / 0.45))


def test_both_sides_of_the_rolling_limit() -> None:
    limit = disk(radius=0.3).rolling_limit
    assert disk(radius=0.3, roll=limit * (1 - 1e-9)).growth is not None
    assert disk(radius=0.3, roll=limit * (1 + 1e-9)).upright == "stable"


def test_rod() -> None:
    made = rod(length=0.8, speed=7.0, mass=2.0)
    near(math.degrees(made.angle), "67.95995884676926105")
    near(made.frequency * 2 * math.pi, "6.488452840596781089")
    assert rod(length=0.8, speed=made.critical * (1 - 1e-9)).angle == 0.0
    assert rod(length=0.8, speed=made.critical * (1 + 1e-9)).angle > 0.0


def test_shaft() -> None:
    given: Any = {"mass": 10.0, "speed": 100 * math.pi, "span": 0.4, "position": 0.1}
    skewed: Any = {"skew": math.radians(2.0), "axial": 0.2, "transverse": 0.1}
    made = shaft(**given, **skewed)
    near(made.couple, "344.2344001347466793")
    assert made.left_load == pytest.approx(made.couple / 0.4)
    assert made.left_load == pytest.approx(made.right_load)
    offset = shaft(**given, eccentricity=5e-5)
    both = shaft(**given, **skewed, eccentricity=5e-5)
    assert both.left_load == pytest.approx(made.left_load + offset.left_load)
    assert offset.left_load + offset.right_load == pytest.approx(offset.force)


def test_a_racket_thrown_about_its_middle_axis_tumbles() -> None:
    spun = free(moments=(1.0, 2.0, 3.0), angular_velocity=(0.01, 1.0, 0.01))
    assert [note.code for note in spun.advice] == ["tumbles"]
    assert not free(moments=(1.0, 2.0, 3.0), angular_velocity=(0.2, 1.0, 0.5)).advice
