"""A scene with an uncertain mass: results are spread, errors of the calculation are not, but may be limited."""

from pathlib import Path

import numpy as np
import pytest

from dynamics_cli.motion.bodies.records import Driver, Link, Load, Scene, Slide, Spring, Torsion
from dynamics_cli.motion.scenes.scene import scene
from dynamics_cli.motion.scenes.side_by_side import ENOUGH, scenes
from dynamics_cli.numerics.linkages.records import Pin
from dynamics_cli.records import Formula
from dynamics_cli.sampling import Drawing
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


def _linked(k: int) -> Scene:
    """A driven arm with a bob on it, a block on a slide, springs, dampers and a load; numbers that depend on k."""
    pins = Pin("O", (0.0, 0.0)), Pin("W", (0.0, 0.9)), Pin("E", (0.9, 0.9))
    arm = Link("arm", (pins[0], Pin("A", (0.5, 0.0))), mass=1.0 + 0.05 * k, rod=True, angle=0.3)
    bob = Link("bob", (Pin("A", (0.0, 0.0)), Pin("B", (0.3 + 0.01 * k, 0.0))), mass=1.0, rod=True, angle=-0.7)
    block = Link("block", (Pin("S", (0.0, 0.0)),), mass=2.0, moment=0.01, position=(0.4, 0.9))
    return Scene(
        (Link("ground", pins), arm, bob, block),
        slides=(Slide("S", "ground", "W", "E", "block"),),
        springs=(Spring("B", "S", 100.0 + k, 0.7, 20.0),),
        torsions=(Torsion("bob", "arm", 3.0, damping=0.1),),
        drivers=(Driver("arm", speed=0.2 + 0.1 * k, angular_acceleration=1.0),),
        loads=(Load(link="bob", torque=Formula("2 - 0.1*speed", 1.0, "N*m")),),
    )


def test_scenes_side_by_side_move_as_alone() -> None:
    cases = [{"scene": _linked(k), "duration": 0.5 + 0.02 * k, "follow": "B"} for k in range(12)]
    with Drawing() as drawn:
        together = scenes(cases)
        alone = [scene(cases[k]["scene"], duration=cases[k]["duration"], follow="B") for k in (0, 11)]
    assert drawn.each > 0.0
    for one, other in zip((together[0], together[11]), alone, strict=True):
        for name in ("x", "y", "largest_force", "driver_work", "load_work", "damper_loss"):
            assert getattr(one, name) == pytest.approx(getattr(other, name), rel=1e-5), name


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


def test_a_driven_slider_crank_side_by_side_moves_as_alone() -> None:
    """Conditions that share no coordinate; a piston without a moment, which its slide keeps from turning."""

    def engine(k: int) -> Scene:
        ground = Link("ground", (Pin("O", (0.0, 0.0)), Pin("X", (0.5, 0.0))))
        crank = Link("crank", (Pin("O", (0.0, 0.0)), Pin("A", (0.06, 0.0))), mass=2.0, moment=0.004, angle=0.5)
        rod = Link("rod", (Pin("A", (0.0, 0.0)), Pin("B", (0.22, 0.0))), mass=0.8, rod=True, angle=-0.1)
        piston = Link("piston", (Pin("B", (0.0, 0.0)),), mass=0.6 + 0.02 * k)
        return Scene(
            (ground, crank, rod, piston),
            slides=(Slide("B", "ground", "O", "X", "piston"),),
            drivers=(Driver("crank", speed=157.0),),
            loads=(Load(point="B", force_x=Formula("-50*vx", 1.0, "N")),),
        )

    cases = [{"scene": engine(k), "duration": 0.02, "follow": "B"} for k in range(12)]
    with Drawing():
        together = scenes(cases)
        alone = [scene(cases[k]["scene"], duration=0.02, follow="B") for k in (0, 11)]
    for one, other in zip((together[0], together[11]), alone, strict=True):
        for name in ("x", "largest_force", "driver_work", "load_work"):
            assert getattr(one, name) == pytest.approx(getattr(other, name), rel=1e-6), name


def test_later_samples_are_rougher_only_as_far_as_is_stated() -> None:
    cases = [{"scene": _linked(k), "duration": 0.5, "follow": "B"} for k in range(12)]
    with Drawing() as drawn:
        first, later = scenes(cases), scenes(cases)
    assert 0.0 < drawn.missed < ENOUGH
    for name in ("x", "y", "largest_force", "damper_loss"):
        fine, rough = (np.array([getattr(made, name) for made in part]) for part in (first, later))
        assert np.abs(fine - rough).max() <= 2.0 * drawn.missed * fine.std()
