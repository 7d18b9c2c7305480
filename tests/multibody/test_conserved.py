"""Properties of random trees and loops: momentum and energy kept, one motion by several methods."""

import random

import numpy as np
import pytest

from dynamics_cli.multibody.bodies.energy import kinetic, momentum
from dynamics_cli.multibody.bodies.loops import Loops
from dynamics_cli.multibody.bodies.records import Axes, Body, Joint, Load, Loop, Scene, Spring, Upward
from dynamics_cli.multibody.bodies.system import System, loads_of
from dynamics_cli.multibody.motions.guided import Guided
from dynamics_cli.multibody.motions.planar import Planar, normal_of
from dynamics_cli.multibody.motions.simulate import runs_of
from dynamics_cli.numerics.orientation.rotations import AxisAngle, matrix_of
from dynamics_cli.numerics.trees.articulated import forward
from dynamics_cli.numerics.trees.matrix import mass_matrix
from dynamics_cli.numerics.trees.newton_euler import inverse, sweep
from dynamics_cli.numerics.vectors import times

NONE = Upward("none")
# Energy and momentum of a motion at a tolerance of 1e-11.
KEPT = 1e-9
ROUNDING = 1e-11


def vector(source: random.Random, size: float = 1.0) -> tuple[float, float, float]:
    return tuple(size * source.uniform(-1.0, 1.0) for _ in range(3))  # type: ignore[return-value]


def free_tree(source: random.Random, count: int) -> Scene:
    """A free body that carries others on joints of every kind, all moving."""
    bodies = []
    for k in range(count):
        joint = "free" if k == 0 else source.choice(("revolute", "prismatic", "ball", "universal", "cylindrical"))
        turns = {"free": 3, "ball": 3, "universal": 2, "prismatic": 0}.get(joint, 1)
        slides = {"free": 3, "prismatic": 1, "cylindrical": 1}.get(joint, 0)
        bodies.append(
            Body(
                f"b{k}", "ground" if k == 0 else f"b{source.randrange(k)}", Joint(joint),
                axis=vector(source), second_axis=vector(source) if joint == "universal" else None,
                position=vector(source),
                mass=source.uniform(0.5, 3.0), centroid=vector(source, 0.3),
                moments=tuple(source.uniform(0.5, 0.9) for _ in range(3)),
                speed=vector(source)[:turns], velocity=vector(source)[:slides],
            )
        )  # fmt: skip
    return Scene(tuple(bodies))


@pytest.mark.parametrize("seed", range(3))
def test_a_free_tree_keeps_momentum_and_energy(seed: int) -> None:
    run, _, _ = runs_of(free_tree(random.Random(seed), 4), 1.0, 2, 1e-10, NONE, 9.81)
    totals = []
    for state in run.states:
        run.put(state)
        motions = sweep(run.system.tree, run.system.frames, run.system.speeds)
        totals.append([*sum(momentum(run.system, motions), ()), kinetic(run.system, motions)])
    size = max(map(abs, totals[0]))
    assert max(abs(a - b) for total in totals for a, b in zip(total, totals[0], strict=True)) < KEPT * size


@pytest.mark.parametrize("heavy", [1.0, 1e3, 1e6, 1e12])
def test_a_light_chain_carries_a_heavy_load(heavy: float) -> None:
    """Articulated bodies and the mass matrix agree as well as its condition lets them; efforts give back the motion."""
    source = random.Random(7)
    bodies = [
        Body(
            f"b{k}", f"b{k - 1}" if k else "ground", axis=vector(source), position=vector(source), mass=1.0,
            centroid=vector(source, 0.5), moments=(0.1, 0.1, 0.1), angle=(source.uniform(-1, 1),),
            speed=(source.uniform(-1, 1),), torque=(source.uniform(-1, 1),),
        )
        for k in range(6)
    ]  # fmt: skip
    bodies.append(Body("load", "b5", Joint("fixed"), position=vector(source), mass=heavy, moments=(heavy,) * 3))
    system = System(Scene(tuple(bodies)))
    tree, frames, speeds = system.tree, system.frames, system.speeds
    rates = forward(tree, frames, speeds, system.efforts, ground=system.base)
    matrix = np.array(mass_matrix(tree, frames))
    bias, _ = inverse(tree, frames, speeds, ground=system.base)
    scale = 1.0 / np.sqrt(np.diag(matrix))
    condition = float(np.linalg.cond(matrix * np.outer(scale, scale)))
    by_matrix = np.linalg.solve(matrix, np.array(system.efforts) - bias)
    assert np.abs(by_matrix - rates).max() <= 1e-14 * condition * np.abs(rates).max()
    back, _ = inverse(tree, frames, speeds, rates, ground=system.base)
    sizes = np.abs(matrix) @ np.abs(rates) + np.abs(bias)
    assert np.abs((np.array(back) - system.efforts) / sizes).max() < ROUNDING


def four_bar(axis: tuple[float, float, float] = (0.0, 1.0, 0.0), **more: object) -> Scene:
    bodies = (
        Body("crank", axis=axis, mass=1.0, rod=(0.3, 0.0, 0.4), speed=(2.0,), torque=(1.0,), **more),  # type: ignore[arg-type]
        Body("coupler", parent="crank", axis=(0.0, -1.0, 0.0), position=(0.3, 0.0, 0.4), mass=2.0, rod=(0.9, 0.0, 0.3),
             torsion_stiffness=3.0, torsion_damping=0.2),
        Body("rocker", axis=axis, position=(1.0, 0.0, 0.0), mass=1.5, rod=(0.2, 0.0, 0.7), rotor_inertia=0.1),
    )  # fmt: skip
    return Scene(bodies, loops=(Loop("coupler", "rocker", (0.9, 0.0, 0.3), (0.2, 0.0, 0.7), axis),))


def slider_crank() -> Scene:
    """Turned out of the planes of the axes."""
    turn = AxisAngle((1.0, 2.0, 3.0), 0.7)
    bodies = (
        Body("crank", turn=turn, mass=1.0, rod=(0.2, 0.1, 0.0), speed=(-3.0,)),
        Body("rod", parent="crank", position=(0.2, 0.1, 0.0), mass=2.0, rod=(0.6, -0.1, 0.0)),
        Body(
            "piston",
            joint=Joint("prismatic"),
            turn=turn,
            axis=(1.0, 0.0, 0.0),
            position=times(matrix_of(turn), (0.8, 0.0, 0.0)),
            mass=0.7,
        ),
    )
    return Scene(bodies, loops=(Loop("rod", "piston", (0.6, -0.1, 0.0), axis=(0.0, 0.0, 1.0)),))


def pushed(scene: Scene) -> Scene:
    """The same with loads in all directions, and a spring that leaves the plane."""
    name = scene.loops[0].first
    push = Load(name, (3.0, -2.0, 5.0), (0.5, 1.0, -0.7), (0.1, 0.2, 0.3))
    spring = Spring(name, first_at=(0.5, 0.0, 0.1), second_at=(0.5, 0.3, -1.0), stiffness=40.0, damping=2.0)
    loads = (push, Load(push.body, push.force, push.moment, push.at, Axes("body")))
    return Scene(scene.bodies, loads, scene.loops, springs=(spring, Spring("crank", first_at=(0.1, 0.0, 0.2),
                 stiffness=5.0, free_length=0.0)))  # fmt: skip


SCENES = {"four-bar": four_bar(), "slider-crank": slider_crank()}
SCENES |= {f"{name}, pushed": pushed(scene) for name, scene in SCENES.items()}


@pytest.mark.parametrize("name", SCENES)
def test_loops_move_alike_in_the_plane_and_in_space(name: str) -> None:
    """By complex numbers in the plane, by elimination in space, and by singular values with all forces."""
    system = System(SCENES[name])
    loops = Loops(system)
    loops.close()
    loops.settle()
    normal = normal_of(loops)
    assert normal is not None
    planar, guided = Planar(loops, normal), Guided(system, loops, None)
    for way in (0.0, 0.4):
        system.at([x + way * (k == 0) for k, x in enumerate(system.coordinates)], system.speeds)
        loops.restore()
        system.loads = loads_of(system)
        driven = [a + b for a, b in zip(system.efforts, system.spring_efforts(), strict=True)]
        expected = loops.accelerations(driven)[0].tolist()
        assert guided.accelerations(driven, 0.0) == pytest.approx(expected, rel=ROUNDING)
        rates = planar.accelerations(system.coordinates, system.speeds, driven)
        assert rates == pytest.approx(expected, rel=ROUNDING)


@pytest.mark.parametrize("plane", [True, False])
def test_a_pushed_loop_keeps_its_energy(monkeypatch: pytest.MonkeyPatch, plane: bool) -> None:
    if not plane:
        monkeypatch.setattr("dynamics_cli.multibody.motions.planar.normal_of", lambda _: None)
    runs_of.cache_clear()
    run, _, _ = runs_of(SCENES["four-bar, pushed"], 0.5, 2, 1e-10, Upward("z"), 9.81)
    assert (run.plane is not None) is plane
    assert run.energy_error() < KEPT
