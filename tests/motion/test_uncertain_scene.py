"""A scene with an uncertain mass: results are spread, errors of the calculation are not, but may be limited."""

from pathlib import Path

import pytest

from tests.harness import answer

SCENE = """duration = "0.2 s"
[[links]]
name = "ground"
points = [{ name = "O", at = "0, 0 mm" }]
[[links]]
name = "arm"
mass = "2 ± 0.1 kg"
rod = true
angle = "20 deg"
points = [{ name = "O", at = "0, 0 mm" }, { name = "A", at = "500, 0 mm" }]
"""


def test_a_limit_on_an_error_of_the_calculation_is_compared(tmp_path: Path) -> None:
    scene = tmp_path / "scene.toml"
    scene.write_text(SCENE)
    document = answer("motion", "scene", str(scene), "--limit", "energy_error=1e-9 %")
    (limit,) = document["limits"]
    assert limit["beyond"] is False
    assert "probability" not in limit


def test_a_link_that_nothing_joins_is_pointed_out(tmp_path: Path) -> None:
    scene = tmp_path / "scene.toml"
    scene.write_text(SCENE.replace('"O", at = "0, 0 mm" }, {', '"o", at = "0, 0 mm" }, {'))
    warnings = {warning["code"]: warning["message"] for warning in answer("motion", "scene", str(scene))["warnings"]}
    assert "nothing joins arm" in warnings["not-joined"]


def test_the_point_followed_is_spread_with_few_calls(tmp_path: Path) -> None:
    """A rod on a pin moves the same at every mass; a torque makes the difference."""
    scene = tmp_path / "scene.toml"
    scene.write_text(SCENE)
    same = answer("motion", "scene", str(scene), "--follow", "arm", "--duration", "1 s")
    assert "interval" not in same["results"]["angle"]
    assert "interval" in same["results"]["largest_force"]
    scene.write_text(SCENE + '[[loads]]\nlink = "arm"\ntorque = "1 N*m"\n')
    found = answer("motion", "scene", str(scene), "--follow", "arm", "--duration", "1 s")
    ends = []
    for mass in ("1.804003601545997 kg", "2.195996398454003 kg"):
        scene.write_text(SCENE.replace("2 ± 0.1 kg", mass) + '[[loads]]\nlink = "arm"\ntorque = "1 N*m"\n')
        alone = answer("motion", "scene", str(scene), "--follow", "arm", "--duration", "1 s")
        ends.append(alone["results"]["angle"]["value"])
    assert found["results"]["angle"]["interval"] == pytest.approx(sorted(ends), rel=1e-3)
    assert found["numerics"]["uncertainty"]["evaluations"] < 200
