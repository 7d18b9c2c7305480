"""A scene with an uncertain mass: results are spread, errors of the calculation are not, but may be limited."""

from pathlib import Path

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
