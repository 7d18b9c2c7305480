"""Pictures of particle impacts as data: every number finite, arrows that add up, profiles that close."""

import math
import shlex
from collections.abc import Iterator
from pathlib import Path

import pytest
from harness import run

from dynamics_cli.core.answering.task import Task
from dynamics_cli.impact.commands.particles import TASKS
from dynamics_cli.impact.conventions import Axes, ByMass, Restituted
from dynamics_cli.impact.particles import pictures
from dynamics_cli.impact.particles.drop import drop
from dynamics_cli.impact.reconstruction.crush import Damaged, MeanCrush, Stations, crush
from dynamics_cli.impact.reconstruction.crush_stiffness import Coefficients
from dynamics_cli.impact.reconstruction.momentum import CrushEnergies, Vehicle, momentum, momentum_and_energy
from dynamics_cli.impact.scene_pictures import LENGTH, WIDTH, apart
from dynamics_cli.pictures import Arrow, Band, Curve, Label, Mark, Picture, Ruler, Spreads

PICTURED = [task for task in TASKS if task.plot]


def numbers(picture: Picture) -> Iterator[float]:
    for panel in picture.panels:
        for item in panel.items:
            if isinstance(item, Curve):
                assert len(item.x) == len(item.y) > 1
                yield from item.x
                yield from item.y
            elif isinstance(item, Arrow):
                yield from (item.x, item.y, item.dx, item.dy)
            elif isinstance(item, Mark | Label | Ruler):
                yield from (item.x, item.y)
            else:
                assert isinstance(item, Band)
                yield from (item.low, item.high)


def test_the_tasks_with_a_scene_have_a_picture() -> None:
    assert list(TASKS) == PICTURED


def arrows(picture: Picture, panel: int) -> list[tuple[float, float]]:
    return [(item.dx, item.dy) for item in picture.panels[panel].items if isinstance(item, Arrow)]


def test_speeds_are_drawn_over_three_degrees_of_their_worst_heading() -> None:
    first = Vehicle(ByMass(1500.0), None, 0.2, 8.0, 0.9)
    second = Vehicle(ByMass(1200.0), None, 1.7, 9.0, 0.8)
    made = momentum(first=first, second=second)
    panel = pictures.momentum(made, first=first, second=second, gravity=9.80665).panels[-1]
    curves = [item for item in panel.items if isinstance(item, Curve)]
    for curve, body in zip(curves, (made.first, made.second), strict=True):
        assert (curve.x[0], curve.x[-1]) == pytest.approx((-math.radians(3.0), math.radians(3.0)))
        assert curve.y[len(curve.y) // 2] == pytest.approx(body.approach_speed, rel=1e-12)
        degrees = abs(curve.y[-1] - curve.y[0]) / 6.0
        assert body.determined is not None
        assert degrees == pytest.approx(body.determined.per_degree, rel=0.02)
    # vehicles that met on one line are decided by energy
    one = Vehicle(ByMass(1000.0), None, 0.0, 5.0, 0.0)
    line = momentum_and_energy(first=one, second=one, damage=CrushEnergies(20000.0, 5000.0))
    picture = pictures.momentum(line, first=one, second=one, gravity=9.80665, damage=CrushEnergies(20000.0, 5000.0))
    assert len(picture.panels) == 2


@pytest.mark.parametrize("axes", Axes.names)
def test_arrows_of_momentum_add_up(axes: str) -> None:
    first = Vehicle(ByMass(1500.0), None, 0.2, 8.0, 0.9)
    second = Vehicle(ByMass(1200.0), None, 1.7, 9.0, 0.8)
    made = momentum(first=first, second=second, axes=Axes(axes))
    picture = pictures.momentum(made, first=first, second=second, gravity=9.80665)
    assert all(math.isfinite(number) for number in numbers(picture))
    *parts, total = arrows(picture, 1)
    for two in (parts[:2], parts[2:]):
        assert [sum(part) for part in zip(*two, strict=True)] == pytest.approx(total, rel=1e-12)
    # one scale for all velocities of the scene: before and after of the first, then of the second
    speeds = [speed for one in (made.first, made.second) for speed in (one.approach_speed, one.exit_speed)]
    lengths = [math.hypot(*arrow) for arrow in arrows(picture, 0)[:4]]
    scale = lengths[0] / speeds[0]
    assert lengths == pytest.approx([scale * speed for speed in speeds], rel=1e-12)


def test_fans_hold_the_uncertain_headings() -> None:
    """The fan before spans the interval about the vehicle's centre; that of a certain heading is not drawn."""
    one = Vehicle(ByMass(1500.0), None, 0.0, 8.0, 0.7)
    two = Vehicle(ByMass(1200.0), None, math.pi / 2.0, 9.0, 0.65)
    found = momentum(first=one, second=two)
    spread = Spreads(0.95, {"first.approach_heading": (-0.1, 0.1)}, {}, {}, {}, {})
    picture = pictures.momentum(found, first=one, second=two, gravity=9.8, spreads=spread)
    fans = [item for item in picture.panels[0].items if isinstance(item, Curve) and item.style == "fill"]
    assert len(fans) == 1
    centre = fans[0].x[0], fans[0].y[0]
    ways = [math.atan2(centre[1] - y, centre[0] - x) for x, y in zip(fans[0].x[1:-1], fans[0].y[1:-1], strict=True)]
    assert (min(ways), max(ways)) == (pytest.approx(-0.1), pytest.approx(0.1))


@pytest.mark.parametrize("turn", [0.0, 0.2, 1.0, 1.5707963267948966, 2.5, 3.141592653589793])
def test_outlines_at_an_impact_do_not_overlap(turn: float) -> None:
    ways = (1.0, 0.0), (math.cos(turn), math.sin(turn))
    first, second = apart(*ways)
    assert math.dist(first, second) >= WIDTH * (1.0 - 1e-12)
    assert math.dist(first, second) <= 1.5 * LENGTH


def test_bounces_end_on_the_floor_and_reach_their_heights() -> None:
    picture = pictures.drop(drop(evidence=Restituted(0.8), height=1.0, bounces=3))
    curve = next(item for item in picture.panels[0].items if isinstance(item, Curve))
    assert min(curve.y) == 0.0
    assert curve.y[-1] == 0.0
    assert max(curve.y[61:122]) == pytest.approx(0.64, rel=1e-3)


def test_crush_profiles_close() -> None:
    stiff = Coefficients(6e4, 5e5)
    for profile in (Stations((0.1, 0.4, 0.2), 1.4), MeanCrush(0.3, 1.2)):
        car = Damaged(ByMass(1500.0), stiff, profile)
        picture = pictures.crush(crush(first=car), first=car)
        outline = picture.panels[0].items[0]
        assert isinstance(outline, Curve)
        assert (outline.x[0], outline.y[0]) == (outline.x[-1], outline.y[-1]) == (0.0, 0.0)
        assert max(outline.x) == profile.width


@pytest.mark.parametrize("task", PICTURED, ids=lambda task: task.name)
def test_every_example_draws(task: Task, tmp_path: Path) -> None:
    for number, example in enumerate(task.examples):
        file = tmp_path / f"{number}.svg"
        outcome = run(*shlex.split(example)[1:], "--plot", str(file))
        assert outcome.status == 0, outcome.err
        assert file.stat().st_size > 2000


def test_damage_given_by_its_energy_is_a_bar(tmp_path: Path) -> None:
    file = tmp_path / "energy.svg"
    outcome = run("impact", "crush", "--first-mass", "1500 kg", "--first-energy", "62 kJ", "--plot", str(file))
    assert outcome.status == 0, outcome.err
    assert "energy of deformation" in file.read_text()
