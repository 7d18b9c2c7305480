"""Rest and small motions: closed forms, and a four-bar by its potential over the crank's angle alone."""

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from harness import answer, run
from scipy.optimize import minimize_scalar

FOUR_BAR = str(Path(__file__).resolve().parents[2] / "examples" / "swing_crane" / "four_bar.toml")
PIN = "0, 1, 0"
# Five-point differences over 2e-3, of a fourth order.
CLOSE = 1e-10


def rods(angle: str = "1 rad") -> list[dict[str, Any]]:
    rod = {"axis": PIN, "mass": "1 kg", "rod": "0, 0, -1 m"}
    return [{"name": "a", **rod, "angle": angle}, {"name": "b", "parent": "a", "position": "0, 0, -1 m", **rod}]


def passed(document: dict[str, Any]) -> dict[str, Any]:
    assert all(check["passed"] for check in document["checks"]), document["checks"]
    return document["results"]  # type: ignore[no-any-return]


def test_two_hanging_rods(scene: Any) -> None:
    """ω²·l/g = 3·(1 ∓ 2/√7)."""
    results = passed(answer("multibody", "modes", scene(*rods()), "--gravity", "1 m/s^2"))
    squares = [(2.0 * math.pi * row["frequency"]["value"]) ** 2 for row in results["modes"]]
    assert squares == pytest.approx([3.0 * (1.0 - 2.0 / 7.0**0.5), 3.0 * (1.0 + 2.0 / 7.0**0.5)], rel=CLOSE)


def test_standing_rods_are_unstable_and_stay(scene: Any) -> None:
    results = passed(answer("multibody", "equilibrium", scene(*rods("180 deg"))))
    assert results["stability"] == "unstable"
    assert results["joints"][0]["coordinate"]["value"] == pytest.approx(180.0)
    hanging = passed(answer("multibody", "equilibrium", scene(*rods())))
    assert hanging["stability"] == "stable"
    assert [abs(row["coordinate"]["value"]) < 1e-6 for row in hanging["joints"]] == [True, True]


def test_a_damped_arm_on_a_spring(scene: Any) -> None:
    """I = 1, k = 16, c = 2: ω = 4, ζ = 1/4, the free angle at 0.3 rad, without weight."""
    arm = {"name": "arm", "axis": PIN, "mass": "3 kg", "rod": "1, 0, 0 m", "torsion_stiffness": "16 N*m/rad",
           "torsion_damping": "2 N*m*s/rad", "free_angle": "0.3 rad"}  # fmt: skip
    results = passed(answer("multibody", "modes", scene(arm), "--up", "none"))
    (mode,) = results["modes"]
    assert mode["frequency"]["value"] == pytest.approx(4.0 / (2.0 * math.pi), rel=CLOSE)
    assert mode["damping_ratio"]["value"] == pytest.approx(0.25, rel=CLOSE)
    assert results["joints"][0]["coordinate"]["value"] == pytest.approx(math.degrees(0.3), rel=CLOSE)


def _four_bar(crank: float) -> tuple[np.ndarray, np.ndarray]:
    """Pins B and C of the four-bar whose crank has turned by an angle about +y, from x to −z."""
    cosine, sine = math.cos(crank), math.sin(crank)
    b = np.array([0.3 * cosine + 0.4 * sine, 0.4 * cosine - 0.3 * sine])
    d = np.array([1.0, 0.0])
    coupler, rocker = math.sqrt(0.9), math.sqrt(0.53)
    way = d - b
    far = float(np.linalg.norm(way))
    along = (far**2 + coupler**2 - rocker**2) / (2.0 * far)
    side = math.sqrt(coupler**2 - along**2)
    # C on the side of the line B-D that the assembly starts on
    return b, b + (way * along + side * np.array([-way[1], way[0]])) / far


def _height(crank: float) -> float:
    """Potential over g: 1, 2 and 1.5 kg at the middles of the rods."""
    b, c = _four_bar(crank)
    return float(0.5 * b[1] + 1.0 * (b[1] + c[1]) + 0.75 * c[1])


def _inertia(crank: float, step: float = 1e-4) -> float:
    """Twice the kinetic energy at a crank speed of 1: of a rod m·(u² + u·v + v²)/3 by the velocities of its ends."""
    (b1, c1), (b0, c0) = _four_bar(crank + step), _four_bar(crank - step)
    b, c = (b1 - b0) / (2.0 * step), (c1 - c0) / (2.0 * step)
    return float(b @ b / 3.0 + 2.0 * (b @ b + b @ c + c @ c) / 3.0 + 1.5 * (c @ c) / 3.0)


def test_the_four_bar_hangs_where_its_height_is_least() -> None:
    _, c = _four_bar(0.0)
    assert c == pytest.approx((1.2, 0.7))
    results = passed(answer("multibody", "equilibrium", FOUR_BAR))
    least = minimize_scalar(_height, bounds=(2.0, 3.5), method="bounded", options={"xatol": 1e-9}).x
    crank = results["joints"][0]["coordinate"]["value"]
    assert crank == pytest.approx(math.degrees(least), abs=1e-4)
    step = 1e-3
    bend = (_height(least + step) - 2.0 * _height(least) + _height(least - step)) / step**2
    frequency = math.sqrt(9.80665 * bend / _inertia(least)) / (2.0 * math.pi)
    assert results["frequencies"]["value"][0] == pytest.approx(frequency, rel=1e-4)
    assert results["stability"] == "stable"


def test_where_nothing_balances_is_refused(scene: Any) -> None:
    arm = {"name": "block", "joint": "slide", "axis": "0, 0, 1", "mass": "3 kg"}
    outcome = run("multibody", "equilibrium", scene(arm))
    assert outcome.status == 3
    assert "drives block on" in outcome.err
