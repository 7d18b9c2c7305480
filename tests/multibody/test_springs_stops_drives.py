"""Springs between points, stops of joints and prescribed motions, against closed forms and other routes."""

import json
import math
from pathlib import Path
from typing import Any

import pytest
from harness import answer, run

ROUNDING = 1e-12
# Ten times the tolerance of the integration.
CLOSE = 1e-9
DEGREE = math.pi / 180.0
FOUR_BAR = Path(__file__).resolve().parents[2] / "examples" / "swing_crane" / "four_bar.toml"
DOOR = {"name": "door", "axis": "0, 0, 1", "mass": "20 kg", "rod": "0.8, 0, 0 m", "angle": "30 deg"}
CLOSER = {"first": "door", "first_at": "0.4, 0, 0 m", "second_at": "0, -0.3, 0 m", "stiffness": "500 N/m"}
SLED = {"name": "sled", "joint": "prismatic", "axis": "1, 0, 0", "mass": "1 kg", "velocity": "1 m/s"}


@pytest.fixture
def scene(tmp_path: Path) -> Any:
    def written(*bodies: dict[str, Any], **more: Any) -> str:
        path = tmp_path / "scene.json"
        path.write_text(json.dumps({"bodies": bodies, **more}))
        return str(path)

    return written


def test_a_spring_and_a_damper_turn_a_door(scene: Any) -> None:
    angle, speed, arm, post, free, stiffness, damping = 30 * DEGREE, -1.5, 0.4, 0.3, 0.3, 500.0, 40.0
    length = math.sqrt(arm**2 + post**2 + 2 * arm * post * math.sin(angle))
    lever = arm * post * math.cos(angle) / length
    torque = -(stiffness * (length - free) + damping * lever * speed) * lever
    spring = CLOSER | {"free_length": "0.3 m", "damping": "40 N*s/m"}
    path = scene(DOOR | {"speed": "-1.5 rad/s"}, springs=[spring])
    document = answer("multibody", "accelerations", path)
    assert all(check["passed"] for check in document["checks"])
    row = document["results"]["accelerations"][0]
    assert row["acceleration"]["value"] == pytest.approx(torque / (20.0 * 0.64 / 3.0), rel=ROUNDING)
    energy = 0.5 * stiffness * (length - free) ** 2
    assert document["results"]["potential_energy"]["value"] == pytest.approx(energy, rel=ROUNDING)
    assert answer("multibody", "simulate", path, "--duration", "1 s")["results"]["energy_error"]["value"] < 1e-6


def test_a_spring_is_free_as_the_scene_stands(scene: Any) -> None:
    row = answer("multibody", "accelerations", scene(DOOR, springs=[CLOSER]))["results"]["accelerations"][0]
    assert row["acceleration"]["value"] == 0.0


def test_modes_have_dampers_between_points(scene: Any) -> None:
    """A sled on a spring with a damper along its way: m·s² + c·s + k = 0; the frequency is that without damping."""
    spring = {"first": "sled", "second_at": "2, 0, 0 m", "stiffness": "400 N/m", "damping": "8 N*s/m"}
    mode = answer("multibody", "modes", scene(SLED, springs=[spring]), "--up", "none")["results"]["modes"][0]
    assert mode["frequency"]["value"] == pytest.approx(20.0 / (2 * math.pi), rel=1e-8)
    assert mode["damping_ratio"]["value"] == pytest.approx(8.0 / (2 * 20.0), rel=1e-8)


def test_a_sled_meets_its_stop_and_comes_back(scene: Any) -> None:
    """Half a period of √(m/k) at the stop; where the stop has no stiffness the sled goes on, and that is said."""
    stopped = SLED | {"upper_slide": "0.5 m", "stop_stiffness": "100 N/m"}
    state = answer("multibody", "simulate", scene(stopped), "--duration", "1 s")["results"]["states"][0]
    assert state["coordinate"]["value"] == pytest.approx(0.1 * math.pi, abs=CLOSE)
    assert state["speed"]["value"] == pytest.approx(-1.0, abs=CLOSE)
    document = answer("multibody", "simulate", scene(SLED | {"upper_slide": "0.5 m"}), "--duration", "1 s")
    assert document["results"]["states"][0]["coordinate"]["value"] == pytest.approx(1.0)
    assert [warning["code"] for warning in document["warnings"]] == ["stop"]
    assert "stop_stiffness" in document["warnings"][0]["remedy"]


def test_a_state_beyond_a_stop_is_said(scene: Any) -> None:
    document = answer("multibody", "accelerations", scene(DOOR | {"upper_angle": "20 deg"}))
    assert "10 deg beyond its stop" in document["warnings"][0]["message"]


def test_a_rod_at_constant_speed_needs_its_weight_held(scene: Any) -> None:
    arm = {"name": "arm", "axis": "0, 1, 0", "mass": "3 kg", "rod": "1, 0, 0 m"}
    path = scene(arm, drives=[{"body": "arm", "speed": "1 rad/s"}])
    document = answer("multibody", "simulate", path, "--duration", "2 s", "--gravity", "10 m/s^2")
    row = document["results"]["drives"][0]
    assert (row["largest"]["value"], row["time"]["value"]) == (pytest.approx(-15.0), 0.0)
    assert row["end"]["value"] == pytest.approx(-15.0 * math.cos(2.0), abs=1e-8)


def test_the_torque_of_a_driven_crank_moves_it_so(scene: Any) -> None:
    """The effort at the end, given as a motor's, makes the acceleration that the law has there."""
    import tomllib

    content = tomllib.loads(FOUR_BAR.read_text())
    law = {"body": "crank", "angle_law": "20*sin(3*t) deg"}
    path = scene(*content["bodies"], loops=content["loops"], drives=[law])
    results = answer("multibody", "simulate", path, "--duration", "1 s")["results"]
    amplitude = 20.0 * DEGREE
    state = {"angle": f"{amplitude * math.sin(3.0)!r} rad", "speed": f"{3 * amplitude * math.cos(3.0)!r} rad/s",
             "torque": f"{results['drives'][0]['end']['value']!r} N*m"}  # fmt: skip
    bodies = [body | state if body["name"] == "crank" else body for body in content["bodies"]]
    rows = answer("multibody", "accelerations", scene(*bodies, loops=content["loops"]))["results"]["accelerations"]
    expected = -9.0 * amplitude * math.sin(3.0)
    assert rows[0]["acceleration"]["value"] == pytest.approx(expected, abs=1e-7)


def test_what_cannot_be_driven_or_sprung_is_refused(scene: Any) -> None:
    ball = {"name": "ball", "joint": "ball", "mass": "1 kg", "moments": "1, 1, 1 kg*m^2"}
    for content, word in ((scene(ball, drives=[{"body": "ball", "speed": "1 rad/s"}]), "cannot be driven"),):
        outcome = run("multibody", "simulate", content, "--duration", "1 s")
        assert (outcome.status, word in outcome.err) == (3, True)
    outcome = run(
        "multibody", "simulate", scene(SLED, drives=[{"body": "sled", "speed": "1 rad/s"}]), "--duration", "1 s"
    )
    assert "velocity or slide_law" in outcome.err
    outcome = run("multibody", "efforts", scene(DOOR, springs=[CLOSER | {"second": "door"}]))
    assert "joins door to itself" in outcome.err
    outcome = run("multibody", "efforts", scene(DOOR | {"lower_angle": "3 deg", "upper_angle": "2 deg"}))
    assert "not above its lower" in outcome.err
