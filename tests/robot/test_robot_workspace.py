"""Workspaces of arms: areas by another way of counting, published reaches, points, limits, pictures."""

import shlex
from itertools import pairwise
from math import asin, atan2, cos, hypot, pi, radians, sin
from pathlib import Path
from random import Random

import pytest
from harness import run
from scipy.integrate import quad

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.robot.arms.records import STANDARD, Arm, Joint
from dynamics_cli.robot.pose import pose
from dynamics_cli.robot.workspace.border import border, loops
from dynamics_cli.robot.workspace.planar import PlanarArm
from dynamics_cli.robot.workspace.task import workspace


def two_link_area(l1: float, l2: float, first: float, second: tuple[float, float]) -> float:
    """The union of both elbow arcs over the distance from the first axis, for limits of the elbow within a half turn.

    At an elbow of ±t the hand is at one distance, in directions that are a range of the first joint wide and 2δ apart.
    """

    def width(t: float) -> float:
        fits = (second[0] <= t <= second[1], second[0] <= -t <= second[1])
        apart = 2.0 * atan2(l2 * sin(t), l1 + l2 * cos(t))
        joined = first + min(apart, first) if first < pi else min(first + min(apart, first), 2.0 * pi)
        return first * (fits[0] ^ fits[1]) + joined * (fits[0] and fits[1])

    breaks = sorted({abs(second[0]), abs(second[1]), 0.0, pi})
    middle = [asin(1.0)] if first < pi else []
    area = 0.0
    marks = sorted({*breaks, *middle})
    for low, high in pairwise(marks):
        area += quad(lambda t: l1 * l2 * sin(t) * width(t), low, high, epsabs=1e-13, epsrel=1e-13, limit=400)[0]
    return area


def area_of(arm: PlanarArm) -> float:
    return sum(side.area for side in border(arm.arcs(), arm.reaches, arm.size))


def test_both_elbows_count_once() -> None:
    """The reference is a quadrature in 40 digits; a determinant integrated over the joints counts 0.2827."""
    arm = Arm(lengths=(0.4, 0.3), lower=(0.0, radians(-60.0)), upper=(radians(90.0), radians(90.0)))
    answer = workspace(arm)
    assert answer.area == pytest.approx(0.223383007304994001685088, abs=2e-16)
    assert answer.both_elbows is not None
    assert answer.area + answer.both_elbows == pytest.approx(0.12 * pi / 2.0 * 1.5, rel=1e-14)
    assert answer.holes == 0
    assert answer.nearest == pytest.approx(0.5)


@pytest.mark.parametrize("seed", range(60))
def test_areas_of_two_links(seed: int) -> None:
    draw = Random(seed)
    l1, l2 = draw.uniform(0.5, 0.8), draw.uniform(0.1, 0.45)
    low, first = draw.uniform(-3.0, 3.0), draw.uniform(0.3, 2.8)
    second = draw.uniform(-2.9, 0.5), draw.uniform(0.6, 2.9)
    arm = PlanarArm((l1, l2), ((low, low + first), second))
    assert area_of(arm) == pytest.approx(two_link_area(l1, l2, first, second), rel=1e-9)


@pytest.mark.parametrize("seed", range(25))
def test_areas_of_three_links_by_filling_cells(seed: int) -> None:
    np = pytest.importorskip("numpy")
    draw = Random(seed)
    links = tuple(draw.uniform(0.2, 0.6) for _ in range(3))
    spans = []
    for _ in range(3):
        low = draw.uniform(-2.8, 1.0)
        spans.append((low, low + draw.uniform(0.5, 2.5)))
    arm = PlanarArm(links, tuple(spans))
    sides = border(arm.arcs(), arm.reaches, arm.size)
    assert all(abs(line[-1].ends[1] - line[0].ends[0]) < 1e-6 * arm.size for line in loops(sides, arm.size))
    grid = np.meshgrid(*[np.linspace(*span, 150) for span in spans], indexing="ij")
    place, turned = 0.0, 0.0
    for link, angle in zip(links, grid, strict=True):
        turned = turned + angle
        place = place + link * np.exp(1j * turned)
    cell = 0.012 * arm.size
    cells = {*zip((place.real.ravel() // cell).tolist(), (place.imag.ravel() // cell).tolist(), strict=True)}
    filled = len(cells) * cell * cell
    length = sum(side.arc.radius * (side.arc.end - side.arc.start) for side in sides)
    # cells that the border crosses are counted whole
    area = sum(side.area for side in sides)
    assert area - 0.15 * length * cell <= filled <= area + 1.0 * length * cell


def test_no_limits() -> None:
    ring = workspace(Arm(lengths=(0.5, 0.4)))
    assert ring.area == pytest.approx(pi * (0.81 - 0.01))
    assert (ring.holes, ring.hole_area) == (1, pytest.approx(pi * 0.01))
    assert (ring.reach, ring.nearest) == (pytest.approx(0.9), pytest.approx(0.1))
    disc = workspace(Arm(lengths=(0.5, 0.4, 0.2)))
    assert (disc.area, disc.holes, disc.nearest) == (pytest.approx(pi * 1.21), 0, 0.0)


def six_axis(limits: bool = True) -> Arm:
    """A small industrial arm: shoulder 25 mm before the first axis, links of 455 and hypot(35, 420) mm."""
    right = pi / 2.0
    rows = (
        (0.025, -right, 0.4, 0.0, -170, 170), (0.455, 0.0, 0.0, 0.0, -190, 45), (0.035, -right, 0.0, -right, -120, 156),
        (0.0, right, 0.42, 0.0, -185, 185), (0.0, -right, 0.0, 0.0, -120, 120), (0.0, 0.0, 0.08, 0.0, -350, 350),
    )  # fmt: skip
    return Arm(
        convention=STANDARD,
        joints=tuple(
            Joint(a=a, alpha=alpha, d=d, theta=theta, lower=radians(low) if limits else None,
                  upper=radians(high) if limits else None)
            for a, alpha, d, theta, low, high in rows
        ),
    )  # fmt: skip


def test_the_reach_of_a_six_axis_arm() -> None:
    """Stretched level: shoulder offset, upper arm and forearm in line."""
    answer = workspace(six_axis())
    assert answer.reach == pytest.approx(0.025 + 0.455 + hypot(0.035, 0.42), rel=1e-14)
    assert answer.highest == pytest.approx(0.4 + 0.455 + hypot(0.035, 0.42), rel=1e-14)
    assert answer.tip == "wrist centre"
    assert answer.first_turn == pytest.approx(radians(340.0))


def test_postures_at_a_point_lead_there() -> None:
    answer = workspace(six_axis(), position=(0.4, 0.2, 0.7))
    assert answer.reached == "yes"
    assert answer.postures is not None
    assert len(answer.postures) == 3
    arm = six_axis()
    wrist = Arm(convention=STANDARD, joints=(*arm.joints[:5], Joint()))
    for posture in answer.postures:
        at = pose(wrist, angles=(*posture.angles, 0.0, 0.0, 0.0)).position
        assert at == pytest.approx((0.4, 0.2, 0.7), abs=1e-14)


def test_a_scara_arm_has_a_volume() -> None:
    results = run("robot", "workspace", "examples/scara.toml", "--json").document["results"]
    assert results["volume"]["value"] == pytest.approx(0.18 * results["area"]["value"])
    assert (results["lowest"]["value"], results["highest"]["value"]) == (pytest.approx(220), pytest.approx(400))


@pytest.mark.parametrize(
    ("point", "verdict"),
    [
        ("0, 650 mm", "yes"),
        ("300, 300 mm", "no, a joint's limit stops it"),
        ("700, 600 mm", "no, out of reach"),
    ],
)
def test_points(point: str, verdict: str) -> None:
    arm = '--lengths "400, 300 mm" --lower "0, -60 deg" --upper "90, 90 deg"'
    results = run(*shlex.split(f'robot workspace {arm} --position "{point}"'), "--json").document["results"]
    assert results["reached"] == verdict
    assert ("postures" in results) == (verdict == "yes")


def test_a_quill_that_does_not_go_so_low() -> None:
    typed = shlex.split('robot workspace examples/scara.toml --position "300, 350, 100 mm"')
    assert run(*typed, "--json").document["results"]["reached"] == "no, a joint's limit stops it"


@pytest.mark.parametrize(
    ("call", "code"),
    [
        ('--lengths "400, 300 mm" --position "100, 600, 20 mm"', "out-of-reach"),
        ('--lengths "400, 300 mm" --lower "0 deg"', "limit"),
        ('--robot puma-560 --upper "0, 10 deg"', "limit"),
        ('--lengths "400, 300 mm" --lower "30, 0 deg" --upper "30, 90 deg"', "no-area"),
        ('--lengths "400, 300, 200, 100 mm"', "no-closed-form"),
    ],
)
def test_refusals(call: str, code: str) -> None:
    out = run("robot", "workspace", *shlex.split(call), "--json")
    assert out.status in (2, 3)
    assert out.error["code"] == code


def test_axes_that_are_not_square() -> None:
    rows = (Joint(alpha=0.5), Joint(a=0.4), Joint(a=0.3))
    with pytest.raises(InadmissibleError, match="right angles"):
        workspace(Arm(convention=STANDARD, joints=rows))


@pytest.mark.parametrize(
    "call",
    [
        '--lengths "400, 300 mm" --lower "0, -60 deg" --upper "90, 90 deg" --position "300, 300 mm"',
        '--robot puma-560 --position "450, 100, 900 mm"',
        'examples/scara.toml --position "300, 350, 320 mm"',
        '--lengths "500, 400, 200 mm" --position "300, 350 mm"',
    ],
)
def test_pictures(call: str, tmp_path: Path) -> None:
    target = tmp_path / "picture.svg"
    outcome = run("robot", "workspace", *shlex.split(call), "--plot", str(target))
    assert outcome.status == 0, outcome.err
    assert b"nan" not in target.read_bytes()
