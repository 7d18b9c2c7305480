"""Stated bounds of a single gear contain the true errors: random gears, and found ones, against 50 digits."""

import random
from typing import Any

import pytest
from harness import answer, run
from mpmath import mp, mpf

from dynamics_cli.gear.single.rack import FULL_DEPTH

RACKS = {"a": ("1", "1.25"), "d": ("1", "1.4"), "stub": ("0.8", "1"), "agma-fine": ("1", "1.2")}


def cases() -> list[tuple[int, float, float | None, float | None, str]]:
    rng = random.Random(1511)
    made: list[tuple[int, float, float | None, float | None, str]] = [
        (20, 1.0, 0.4475314769152722, 0.091, "a"),
        (5, 1.0, 0.3490658503988659, None, "a"),
        (7, 5.194153905733795, None, 0.380743675622535, "d"),
    ]
    for _ in range(40):
        angle = rng.choice([None, rng.uniform(0.25, 0.5)])
        shift = rng.choice([None, rng.uniform(0.0, 0.5)])
        made.append((rng.randint(9, 120), rng.uniform(0.3, 9.0), angle, shift, rng.choice(list(RACKS))))
    return made


def exact(z: int, m: float, angle: float | None, shift: float | None, profile: str, near: float) -> dict[str, Any]:
    module, alpha, x = mpf(m), mpf(FULL_DEPTH if angle is None else angle), mpf(shift or 0.0)
    add, ded = (mpf(float(value)) for value in RACKS[profile])
    pitch = z * module
    base, tip = pitch * mp.cos(alpha), pitch + 2 * module * (add + x)

    def inv(diameter: Any) -> Any:
        roll = mp.sqrt((diameter / base) ** 2 - 1)
        return roll - mp.atan(roll)

    def half(own: Any) -> Any:
        return (mp.pi / 2 + 2 * own * mp.tan(alpha)) / z + mp.tan(alpha) - alpha

    return {
        "base_diameter": base,
        "tip_diameter": tip,
        "root_diameter": pitch - 2 * module * (ded - x),
        "v_diameter": pitch + 2 * module * x,
        "addendum": module * (add + x),
        "dedendum": module * (ded - x),
        "tooth_depth": module * (add + ded),
        "normal_thickness": module * (mp.pi / 2 + 2 * x * mp.tan(alpha)),
        "tip_thickness": tip * (half(x) - inv(tip)),
        "tip_pressure_angle": mp.acos(base / tip),
        "base_thickness": base * half(x),
        "pointed_shift": mp.findroot(lambda own: half(own) - inv(pitch + 2 * module * (add + own)), mpf(near)),
    }


@pytest.mark.parametrize(("z", "m", "angle", "shift", "profile"), cases())
def test_bounds_contain_the_errors(z: int, m: float, angle: float | None, shift: float | None, profile: str) -> None:
    words = ["gear", "spur", "--teeth", str(z), "--module", f"{m!r} m", "--profile", profile, "--units", "base"]
    words += [] if angle is None else ["--pressure-angle", f"{angle!r} rad"]
    words += [] if shift is None else ["--profile-shift", repr(shift)]
    if run(*words).status == 3:
        pytest.skip("no such gear")
    document = answer(*words)
    results, bounds = document["results"], document["numerics"]["error_bound"]
    with mp.workdps(50):
        for name, true in exact(z, m, angle, shift, profile, results["pointed_shift"]["value"]).items():
            bound = mpf(bounds[name].get("absolute", 0.0)) + mpf(bounds[name].get("relative", 0.0)) * abs(true)
            # stated bounds have two digits
            assert abs(mpf(results[name]["value"]) - true) <= bound, name
