"""Planar impact mechanics solutions of two NHTSA offset-oblique tests, and a small-overlap test.

N. A. Rose, S. J. Fenton, G. Beauchamp, SAE 2006-01-0908: tests 4363 and 4438, impulse ratio at 100 % of the critical
one; printed ΔV to 0.1 mph, spins to 1 deg/s. M. Carpenter, B. Welcher, SAE 2019-01-0422: worksheet of IIHS CF11002,
e = 0, no sliding. Axes are SAE, headings and angles on the vehicle clockwise; the normal is turned to point from
vehicle 1 to vehicle 2.
"""

from typing import Any

import pytest
from harness import answer

ROSE = {
    "4363": {
        "first": ("3451.1 lbf", "2152 slug*ft^2", "2.6 ft @ 23.8 deg", "35.1 mph", "180 deg"),
        "second": ("4695.4 lbf", "2805 slug*ft^2", "5.7 ft @ 10.6 deg", "35 mph", "32 deg"),
        "normal": "235 deg",
        "restitution": "0.126",
        "critical": -0.51,
        "delta_v": (39.5, 29.1),
        "spin": (31.0, 182.0),
    },
    "4438": {
        "first": ("3305.7 lbf", "2066 slug*ft^2", "2.8 ft @ 35.3 deg", "34.7 mph", "180 deg"),
        "second": ("4725.3 lbf", "2889 slug*ft^2", "5 ft @ 13.2 deg", "35 mph", "30 deg"),
        "normal": "230.7 deg",
        "restitution": "0.095",
        "critical": -0.44,
        "delta_v": (39.7, 27.8),
        "spin": (68.0, 166.0),
    },
}
NAMES = "weight", "inertia", "contact-on-body", "speed", "heading"


def vehicle(side: str, values: tuple[str, ...]) -> list[str]:
    words = [word for name, value in zip(NAMES, values, strict=True) for word in (f"--{side}-{name}", value)]
    return [*words, f"--{side}-nose", values[-1]]


def solved(test: str) -> dict[str, Any]:
    case = ROSE[test]
    words = vehicle("first", case["first"]) + vehicle("second", case["second"])
    words += ["--normal", case["normal"], "--restitution", case["restitution"], "--friction", "10"]
    return answer("impact", "planar", *words, "--law", "brach", "--axes", "sae", "--units", "us", "--gravity",
                  "32.174 ft/s^2")["results"]  # fmt: skip


@pytest.mark.parametrize("test", ROSE)
def test_delta_v_as_printed(test: str) -> None:
    results = solved(test)
    for side, printed in zip(("first", "second"), ROSE[test]["delta_v"], strict=True):
        found = results[side]["delta_v"]["magnitude"]
        assert found["unit"] == "mph"
        assert abs(found["value"] - printed) <= 0.05


@pytest.mark.parametrize("test", ROSE)
def test_critical_impulse_ratio_as_printed(test: str) -> None:
    found = solved(test)["critical"]["impulse_ratio"]["value"]
    assert abs(found - ROSE[test]["critical"]) <= 0.005


@pytest.mark.parametrize("test", ROSE)
def test_spins_as_printed(test: str) -> None:
    # levers printed to 0.1 ft and angles to 0.1 deg move the spins by this much, twice the printed digit
    for side, printed in zip(("first", "second"), ROSE[test]["spin"], strict=True):
        assert abs(abs(solved(test)[side]["spin_change"]["value"]) - printed) <= 1.0


CARPENTER = [
    "--first-weight", "3574.2 lbf", "--first-inertia", "2336.3 slug*ft^2", "--first-contact-on-body",
    "3.62092, -2.00708 ft", "--first-speed", "39.9545 mph", "--first-heading", "0 deg", "--second-weight", "1e7 lbf",
    "--second-inertia", "173611111.11 slug*ft^2", "--second-contact-on-body", "4.16667, -4.16667 ft",
    "--second-velocity", "0, 0 m/s", "--second-nose", "180 deg", "--normal", "344.6 deg", "--friction", "0.82",
    "--restitution", "0", "--law", "kudlich-slibar", "--axes", "sae", "--units", "us", "--gravity", "32.2 ft/s^2",
]  # fmt: skip


def test_carpenter_and_welcher_small_overlap() -> None:
    results = answer("impact", "planar", *CARPENTER)["results"]
    x, y = results["first"]["delta_v"]["vector"]["value"]
    assert x == pytest.approx(-35.72753, rel=2e-6)
    assert y == pytest.approx(7.59976, rel=2e-6)
    assert results["first"]["spin_change"]["value"] == pytest.approx(-176.4298, rel=1e-6)
    # the speed, printed to 6 digits, moves the energy by twice its own half digit
    assert results["energy_lost"]["value"] == pytest.approx(170421.5392, rel=2.0 * 0.00005 / 39.9545)
    assert results["energy_lost"]["unit"] == "ft·lbf"
    assert results["impulse_ratio"]["value"] == pytest.approx(0.05926, rel=1e-4)


def test_stronge_newton_and_poisson_agree_without_restitution() -> None:
    words = ["all" if word == "kudlich-slibar" else word for word in CARPENTER]
    results = answer("impact", "planar", *words)["results"]
    lost = [results[law]["energy_lost"]["value"] for law in ("stronge", "newton", "poisson")]
    assert lost[0] == pytest.approx(lost[1], rel=1e-13) == pytest.approx(lost[2], rel=1e-13)
