"""Motions over time, against integrations of 40 digits and conserved quantities.

Skew double pendulum: Taylor series in mpmath, energy kept to 3e-41; four-bar: absolute angles reduced to the crank,
integrated in mpmath.
"""

from pathlib import Path
from typing import Any

import pytest
from harness import answer, run

PLAIN = ("--gravity", "9.81 m/s^2")
FOUR_BAR = str(Path(__file__).resolve().parents[2] / "examples" / "swing_crane" / "four_bar.toml")
# Ten times what two tolerances differ by.
CLOSE = 1e-9
DEGREES = 180.0 / 3.141592653589793


def states(document: dict[str, Any]) -> dict[str, tuple[float, float]]:
    assert all(check["passed"] for check in document["checks"]), document["checks"]
    rows = document["results"]["states"]
    return {row["name"]: (row["coordinate"]["value"], row["speed"]["value"]) for row in rows}


def test_the_skew_double_pendulum(scene: Any) -> None:
    path = scene(
        {"name": "b", "parent": "a", "axis": "1, 0, 0", "position": "0, 0, -1 m", "mass": "1 kg", "rod": "0, 0, -1 m",
         "angle": "0.5 rad"},
        {"name": "a", "axis": "0, 1, 0", "mass": "1 kg", "rod": "0, 0, -1 m", "angle": "1 rad"},
    )  # fmt: skip
    found = states(answer("multibody", "simulate", path, "--duration", "1 s", *PLAIN))
    expected = {
        "a": (-0.8357689571924373744128379, -1.361115068252790200761537),
        "b": (-0.1291418093475890647544184, 1.541973572935451934592746),
    }
    for name, (angle, speed) in expected.items():
        assert found[name][0] == pytest.approx(angle * DEGREES, abs=DEGREES * CLOSE)
        assert found[name][1] == pytest.approx(speed, abs=10 * CLOSE)


def test_the_four_bar_over_half_a_second() -> None:
    document = answer("multibody", "simulate", FOUR_BAR, "--duration", "0.5 s", *PLAIN)
    found = states(document)
    expected = {
        "crank": (1.515181329175765754861, 4.648089300542386564304),
        "coupler": (-2.509993415763796858026, -6.338005937283874944233),
        "rocker": (-0.7725455969746507517779, -4.432269133252935505183),
    }
    for name, (angle, speed) in expected.items():
        assert found[name][0] == pytest.approx(angle * DEGREES, abs=DEGREES * CLOSE)
        assert found[name][1] == pytest.approx(speed, abs=10 * CLOSE)
    assert document["results"]["gap"]["value"] < 1e-9


def test_a_free_body_keeps_energy_and_turns_over(scene: Any) -> None:
    """Spin about the middle axis is unstable: the body turns over, and comes back."""
    box = {"name": "box", "joint": "free", "mass": "2 kg", "moments": "1, 2, 3 kg*m^2", "speed": "0.1, 3, 0 rad/s",
           "velocity": "1, 0, 0 m/s"}  # fmt: skip
    document = answer("multibody", "simulate", scene(box), "--duration", "6 s", "--up", "none", "--steps", "60")
    rows = document["results"]["motion"]
    assert rows[-1]["centre"]["value"] == pytest.approx((6.0, 0.0, 0.0), abs=CLOSE)
    assert document["results"]["kinetic_energy"]["value"] == pytest.approx(0.5 * (0.01 + 18.0 + 2.0), rel=CLOSE)
    # angular momentum along the ground's y stays, where the body's own spin changes its sign
    from_body = [row["angular_velocity"]["value"][1] for row in rows]
    assert min(from_body) > 2.0


def test_work_of_motors_and_dampers_balances(scene: Any) -> None:
    arm = {"name": "arm", "axis": "0, 1, 0", "mass": "3 kg", "rod": "1, 0, 0 m", "torque": "20 N*m",
           "torsion_damping": "1.5 N*m*s/rad", "torsion_stiffness": "4 N*m/rad"}  # fmt: skip
    document = answer("multibody", "simulate", scene(arm), "--duration", "3 s")
    assert all(check["passed"] for check in document["checks"])
    assert abs(document["results"]["energy_error"]["value"]) < 1e-6


def test_what_cannot_be_simulated_is_refused(scene: Any) -> None:
    arm = {"name": "arm", "axis": "0, 1, 0", "mass": "3 kg", "rod": "1, 0, 0 m"}
    assert run("multibody", "simulate", scene(arm), "--duration", "0 s").status == 3
    assert "tolerance" in run("multibody", "simulate", scene(arm), "--duration", "1 s", "--tolerance", "1e-20").err
    outcome = run("multibody", "simulate", scene({**arm, "rod": "0, 1, 0 m"}), "--duration", "1 s")
    assert outcome.status == 3
    assert "joint of arm" in outcome.err
