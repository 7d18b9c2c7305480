"""`motion scene` and `motion equilibrium`: closed forms and other formulations, invariants, refusals."""

import contextlib
import json
import math
import os
import re
import sys
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from harness import run
from hypothesis import given, settings
from hypothesis import strategies as st

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.motion.bodies.records import Driver, Link, Load, Scene, Slide, Spring, Torsion, Weld
from dynamics_cli.motion.scenes.equilibrium import equilibrium
from dynamics_cli.motion.scenes.scene import scene as motion
from dynamics_cli.numerics.linkages.records import Near, Pin, Side, Way
from dynamics_cli.records import Formula

HERE = Path(__file__).parent
KNOWN: dict[str, Any] = json.loads((HERE / "scenes.json").read_text(encoding="utf-8"))
CHAINS: dict[str, Any] = json.loads((HERE / "chains.json").read_text(encoding="utf-8"))


def point(name: str, x: float = 0.0, y: float = 0.0) -> Pin:
    return Pin(name, (x, y))


def rod(name: str, first: str, second: str, length: float, mass: float, **rest: Any) -> Link:
    return Link(name, (point(first), point(second, length)), mass=mass, rod=True, **rest)


def ground(*points: Pin) -> Link:
    return Link("ground", points)


def chain(angles: tuple[float, ...], length: float, **rest: Any) -> Scene:
    names = "OABCDEF"
    links = [
        rod(f"rod {k}", names[k], names[k + 1], length, 1.0, angle=angle - math.pi / 2)
        for k, angle in enumerate(angles)
    ]
    return Scene((ground(point("O")), *links), **rest)


A, B, C = math.hypot(0.3, 0.4), math.hypot(0.9, 0.3), math.hypot(0.2, 0.7)
BASE = ground(point("A"), point("D", 1.0))


def four_bar(**rest: Any) -> Scene:
    links = (
        BASE, rod("crank", "A", "B", A, 1.0, angle=math.atan2(0.4, 0.3)), rod("coupler", "B", "C", B, 2.0),
        rod("rocker", "D", "C", C, 1.5),
    )  # fmt: skip
    return Scene(links, **rest)


def slider_crank(**rest: Any) -> Scene:
    links = (
        ground(point("O"), point("E", 0.3)),
        Link("crank", (point("O"), point("A", 0.04)), mass=2.0, moment=0.01, angle=math.radians(30.0)),
        rod("rod", "A", "B", 0.15, 0.5), Link("piston", (point("B"),), mass=0.4),
    )  # fmt: skip
    return Scene(links, slides=(Slide("B", "ground", "O", "E", "piston"),), **rest)


def tailgate() -> Scene:
    gate = Link("gate", (point("H"), point("G", 0.3, -0.04)), mass=25.0, centroid=(0.48, -0.03), moment=2.6,
                angle=math.radians(-60.0))  # fmt: skip
    return Scene((ground(point("H"), point("S", 0.05, -0.45)), gate), springs=(Spring("S", "G", 500.0, 1.6, 1200.0),))


def states(made: Any) -> list[float]:
    return [*(link.angle for link in made.links), *(link.speed for link in made.links)]


@pytest.mark.parametrize(
    ("name", "made", "duration", "gravity"),
    [
        ("three rods, 2 s", chain(tuple(map(math.radians, (30.0, -20.0, 45.0))), 0.5), 2.0, 9.80665),
        ("unit rods, 1 s", chain((math.pi / 2,) * 2, 1.0), 1.0, 1.0),
        ("unit rods, 5 s", chain((math.pi / 2,) * 2, 1.0), 5.0, 1.0),
    ],
)
def test_chains(name: str, made: Scene, duration: float, gravity: float) -> None:
    """The double and triple pendulum of `motion chain`, whose references come from a third formulation."""
    found = motion(made, duration=duration, gravity=gravity)
    wanted = [float(x) for x in CHAINS["motions"][name]]
    n = len(wanted) // 2
    shifted = [x + (math.pi / 2 if k < n else 0.0) for k, x in enumerate(states(found))]
    assert shifted == pytest.approx(wanted, abs=1e-9)
    off = max(abs(a - b) for a, b in zip(shifted[:n], wanted, strict=False))
    # differences are of lengths: an angle times the length of a rod
    assert off * 0.5 <= 2.0 * found.difference + 1e-13
    assert all(check.passed for check in found.checks)


def test_four_bar_let_go() -> None:
    found = motion(four_bar(), duration=0.5, gravity=9.81)
    assert states(found) == pytest.approx([float(x) for x in KNOWN["four-bar, 0.5 s"]], abs=1e-9)
    assert found.reactions is not None
    assert found.start_moved == 0.0


def test_four_bar_at_rest() -> None:
    """Reactions of the reference page, by constraint forces, orthogonal complement and sums of reactions."""
    made = four_bar()
    rows = {(row.joint, row.on): row for row in motion(made, duration=0.1, at=0.0, gravity=9.81).reactions or ()}
    assert (rows["A", "crank"].force_x, rows["A", "crank"].force_y) == pytest.approx(
        (9.417123454032775901, 15.76997417571679834724588), rel=1e-12
    )
    assert rows["D", "rocker"].force_y == pytest.approx(20.87682151930539657723555, rel=1e-12)
    assert rows["C", "rocker"].force_x == pytest.approx(-1.92631382785672408498283, rel=1e-12)
    (first, *_) = motion(made, duration=0.1, follow="crank", steps=1, gravity=9.81).motion or ()
    assert first.angular_acceleration == pytest.approx(-12.17657109355370054998744, rel=1e-12)


def test_slider_crank_at_constant_speed() -> None:
    driven = slider_crank(drivers=(Driver("crank", speed=100.0),))
    made = motion(driven, duration=0.02, at=0.013)
    rows = {row.joint: row for row in made.reactions or ()}
    wanted = {name: float(x) for name, x in KNOWN["slider-crank, 0.013 s"].items()}
    assert rows["driver of crank"].moment == pytest.approx(wanted["torque"], rel=1e-10)
    assert rows["slide of B"].force_y == pytest.approx(wanted["side"], abs=1e-10 * wanted["A"])
    assert rows["A"].force == pytest.approx(wanted["A"], rel=1e-10)
    assert rows["B"].force == pytest.approx(wanted["B"], rel=1e-10)
    assert made.verdict.startswith("holds to the end")


def test_a_tube_that_turns() -> None:
    """r = r₀·cosh Ωt + (g/2Ω²)(sin Ωt − sinh Ωt): a point slides along a driven line."""
    links = (
        ground(point("O")), Link("tube", (point("O"), point("E", 1.0)), mass=1.0, moment=1.0, angle=0.0),
        Link("ball", (point("P"),), mass=0.2, position=(0.1, 0.0), velocity=(0.0, 0.8)),
    )  # fmt: skip
    made = Scene(links, slides=(Slide("P", "tube", "O", "E", "ball"),), drivers=(Driver("tube", angle=0.0, speed=8.0),))
    found = {one.name: one for one in motion(made, duration=0.3).points or ()}
    assert math.hypot(*found["P"].position) == pytest.approx(float(KNOWN["tube, 0.3 s"]), rel=1e-9)


def test_oscillator() -> None:
    mass = Link("mass", (point("P"),), mass=2.0, position=(1.1, 0.0), velocity=(-0.2, 0.0), angle=0.0)
    base = ground(point("W"), point("E", 2.0))
    made = Scene((base, mass), slides=(Slide("P", "ground", "W", "E", "mass"),),
                 springs=(Spring("W", "P", 50.0, 1.0, 4.0),), horizontal=True)  # fmt: skip
    (link,) = motion(made, duration=0.7).links or ()
    assert link.centre[0] - 1.0 == pytest.approx(float(KNOWN["oscillator, 0.7 s"]), abs=1e-10)
    still = equilibrium(made)
    assert still.stability == "stable"
    (mode,) = still.modes or ()
    assert (mode.frequency, mode.damping_ratio) == pytest.approx((5.0 / (2.0 * math.pi), 0.2), rel=1e-9)


def test_a_torque_that_falls_with_the_speed() -> None:
    wheel = Link("wheel", (point("O"),), mass=1.0, moment=0.01)
    made = Scene((ground(point("O")), wheel), loads=(Load(link="wheel", torque=Formula("5 - 0.05*speed", 1.0, "N*m")),))
    found = motion(made, duration=0.4)
    wanted = float(KNOWN["torque 5 - 0.05 w on 0.01, 0.4 s"])
    assert (found.links or ())[0].speed == pytest.approx(wanted, rel=1e-9)
    assert found.load_work == pytest.approx(0.5 * 0.01 * wanted**2, rel=1e-9)


def test_tailgate() -> None:
    found = equilibrium(tailgate())
    roots = [float(x) for x in KNOWN["tailgate"]["roots"]]
    places = sorted(found.places, key=lambda place: place.angles[0])
    assert [place.angles[0] for place in places] == pytest.approx(roots, abs=1e-10)
    stable = [place for place in places if place.stability == "stable"]
    assert [place.angles[0] for place in stable] == pytest.approx([float(x) for x in KNOWN["tailgate"]["stable"]])
    opened = equilibrium(tailgate(), place=stable[-1].number)
    assert (opened.springs or ())[0].pull == pytest.approx(float(KNOWN["tailgate"]["pull"]), rel=1e-10)
    square, damping = (float(KNOWN["tailgate"][name]) for name in ("square", "damping"))
    # s² + 2δs + ω²: the sum and the product of the decays
    decays = [1.0 / (mode.time_constant or math.inf) for mode in opened.modes or ()]
    assert sum(decays) == pytest.approx(damping, rel=1e-8)
    assert math.prod(decays) == pytest.approx(square, rel=1e-8)


def test_cart_with_a_hanging_rod() -> None:
    cart = Link("cart", (point("P"),), mass=2.0, angle=0.0, position=(1.0, 0.0))
    base = ground(point("W"), point("E", 2.0))
    made = Scene((base, cart, rod("rod", "P", "Q", 0.8, 1.0, angle=-1.2)),
                 slides=(Slide("P", "ground", "W", "E", "cart"),), springs=(Spring("W", "P", 50.0, 1.0),))  # fmt: skip
    found = equilibrium(made)
    hanging = next(place for place in found.places if place.stability == "stable")
    modes = equilibrium(made, place=hanging.number).modes or ()
    wanted = [float(x) / (2.0 * math.pi) for x in KNOWN["cart"]]
    assert [mode.frequency for mode in modes] == pytest.approx(wanted, rel=1e-9)
    assert {place.stability for place in found.places} == {"stable", "unstable"}


def test_a_driven_four_bar_balances_its_power() -> None:
    made = motion(four_bar(drivers=(Driver("crank", speed=-3.0, angular_acceleration=-1.0),)), duration=0.6)
    assert made.driver_work is not None
    assert abs(made.driver_work) > 1.0
    assert made.energy_error < 1e-9


@settings(max_examples=6, deadline=None)
@given(st.floats(-2.0, 2.0), st.floats(-2.0, 2.0), st.floats(0.2, 5.0))
def test_galilei(x: float, y: float, scale: float) -> None:
    """Two masses on a spring: in a frame that moves, and in other units of length and mass, they do the same."""

    def made(size: float, mass: float, vx: float, vy: float) -> Any:
        one = Link("one", (point("P", 0.1 * size),), mass=mass, moment=0.02 * mass * size**2, position=(0.0, 0.0),
                   velocity=(size * vx, size * vy), speed=1.0)  # fmt: skip
        two = Link("two", (point("Q", -0.2 * size),), mass=2.0 * mass, moment=0.05 * mass * size**2,
                   position=(size, 0.0), velocity=(size * vx, size * (0.5 + vy)))  # fmt: skip
        scene = Scene((one, two), springs=(Spring("P", "Q", 30.0 * mass, 0.5 * size),), horizontal=True)
        return motion(scene, duration=1.0)

    rest, moved = made(1.0, 1.0, 0.0, 0.0), made(scale, 3.0, x, y)
    for one, other in zip(rest.links, moved.links, strict=True):
        assert other.angle == pytest.approx(one.angle, abs=1e-8)
        assert other.centre[0] / scale - x == pytest.approx(one.centre[0], abs=1e-8)
        assert other.centre[1] / scale - y == pytest.approx(one.centre[1], abs=1e-8)


@settings(max_examples=5, deadline=None)
@given(st.floats(-2.5, 2.5), st.floats(-3.0, 3.0))
def test_time_goes_back(angle: float, speed: float) -> None:
    first = chain((angle, 0.4), 0.6)
    links = (first.links[0], *(_with(link, speed=speed) for link in first.links[1:]))
    there = motion(Scene(links), duration=0.8)
    back = [_with(link, angle=one.angle, speed=-(one.speed or 0.0))
            for link, one in zip(links[1:], there.links or (), strict=True)]  # fmt: skip
    again = motion(Scene((links[0], *back)), duration=0.8)
    for one, start in zip(again.links or (), links[1:], strict=True):
        assert one.angle == pytest.approx(start.angle, abs=1e-7)
        assert one.speed == pytest.approx(-speed, abs=1e-6)


def _with(link: Link, **new: Any) -> Link:
    return Link(**({name: getattr(link, name) for name in Link.fields} | new))  # type: ignore[attr-defined]


def test_a_weld_is_one_body() -> None:
    """Two welded rods swing as one body of both."""
    half = rod("far", "A", "B", 0.5, 1.0)
    far = Link("far", (point("B", 0.5),), mass=1.0, centroid=(0.25, 0.0), moment=1.0 / 48.0)
    both = Scene(
        (ground(point("O")), rod("near", "O", "A", 0.5, 1.0, angle=0.0), far), welds=(Weld("far", "near", (0.5, 0.0)),)
    )
    whole = Scene((ground(point("O")), rod("near", "O", "B", 1.0, 2.0, angle=0.0)))
    one, other = motion(both, duration=1.0), motion(whole, duration=1.0)
    assert (one.links or ())[0].angle == pytest.approx((other.links or ())[0].angle, abs=1e-9)
    assert half.mass == far.mass


def test_torsion_spring_and_speed_law() -> None:
    """A disk on a torsion spring turns as cos √(k/I)·t; a given rate adds up to its integral."""
    disk = Link("disk", (point("O"),), mass=1.0, moment=0.5, angle=0.3)
    free = motion(
        Scene((ground(point("O")), disk), torsions=(Torsion("disk", stiffness=8.0, free_angle=0.0),)), duration=1.0
    )
    assert (free.links or ())[0].angle == pytest.approx(0.3 * math.cos(4.0), abs=1e-9)
    law = Driver("disk", speed_law=Formula("6*t^2", 1.0, "rad/s"))
    driven = motion(Scene((ground(point("O")), disk), drivers=(law,)), duration=1.5)
    assert (driven.links or ())[0].angle == pytest.approx(0.3 + 2.0 * 1.5**3, rel=1e-9)
    assert driven.driver_work == pytest.approx(0.25 * 13.5**2, rel=1e-9)


def test_stiff_scenes_take_radau() -> None:
    mass = Link("mass", (point("P"),), mass=1.0, position=(1.0, 0.0), angle=0.0, velocity=(1.0, 0.0))
    made = Scene((ground(point("W"), point("E", 2.0)), mass), slides=(Slide("P", "ground", "W", "E", "mass"),),
                 springs=(Spring("W", "P", 100.0, 0.5, 1e5),), horizontal=True)  # fmt: skip
    found = motion(made, duration=20.0)
    assert found.numerics.method.startswith("Radau")
    # it creeps at k/c
    slow = 100.0 / 1e5
    assert (found.links or ())[0].centre[0] == pytest.approx(0.5 + (0.5 + 1e-5) * math.exp(-slow * 20.0), abs=2e-6)


def test_past_the_horizon_there_is_no_state() -> None:
    found = motion(chain((math.radians(120.0),) * 3, 0.5), duration=30.0)
    assert found.links is None
    assert found.verdict == "ends at the horizon"
    assert found.horizon is not None
    assert 4.0 < found.horizon < 20.0
    assert {advice.code for advice in found.advice} == {"past-horizon"}


def parallelogram(angle: float, *, third: bool = False) -> Scene:
    base = ground(point("A"), point("D", 1.0), point("F", 0.5))
    coupler = Link("coupler", (point("B"), point("C", 1.0), point("E", 0.5)), mass=1.0, moment=0.1, angle=0.0)
    links = [
        base,
        rod("crank", "A", "B", 0.5, 1.0, angle=angle),
        coupler,
        rod("rocker", "D", "C", 0.5, 1.0, angle=angle),
    ]
    if third:
        links.append(rod("third", "F", "E", 0.5, 1.0, angle=angle))
    return Scene(tuple(links))


def test_joints_that_repeat_others_are_named() -> None:
    found = motion(parallelogram(-1.0, third=True), duration=0.3)
    assert "over-constrained" in {advice.code for advice in found.advice}
    assert all(row.force is None for row in found.reactions or ())
    assert found.energy_error < 1e-9


def test_a_change_point_on_the_way_is_said() -> None:
    found = motion(parallelogram(1.0), duration=1.0)
    assert {"change-point", "singular"} & {advice.code for advice in found.advice}
    assert found.largest_force is None


def test_a_start_that_does_not_close_is_moved() -> None:
    links = four_bar().links
    bent = Scene((*links[:3], _with(links[3], angle=1.2)))
    found = motion(bent, duration=0.1, at=0.0)
    assert found.start_moved > 1e-3
    assert "assembled" in {advice.code for advice in found.advice}


HEAD = """
[[links]]
name = "ground"
points = [{name = "A", at = "0, 0 m"}, {name = "D", at = "1, 0 m"}]
"""
CRANK = """
[[links]]
name = "crank"
mass = "1 kg"
rod = true
angle = "20 deg"
points = [{name = "A", at = "0, 0 m"}, {name = "B", at = "0.5, 0 m"}]
"""
LOOP = """
[[links]]
name = "coupler"
mass = "1 kg"
rod = true
points = [{name = "B", at = "0, 0 m"}, {name = "C", at = "LENGTH, 0 m"}]
[[links]]
name = "rocker"
mass = "1 kg"
rod = true
points = [{name = "D", at = "0, 0 m"}, {name = "C", at = "0.3, 0 m"}]
"""
REFUSED = {
    "no such point": (HEAD + CRANK + '[[springs]]\nfrom = "A"\nto = "Z"\n', "unknown-point"),
    "no such link": (HEAD + CRANK + '[[loads]]\nlink = "arm"\ntorque = "1 N*m"\n', "unknown-link"),
    "twice": (HEAD + CRANK + CRANK, "same-name"),
    "nothing moves": (HEAD, "no-links"),
    "massless": (HEAD + CRANK.replace('mass = "1 kg"\nrod = true', 'mass = "0 kg"'), "massless"),
    "a point without moment": (
        HEAD + '[[links]]\nname = "wheel"\nmass = "1 kg"\nspeed = "1 rad/s"\npoints = [{name = "A", at = "0, 0 m"}]\n',
        "massless",
    ),
    "does not close": (HEAD + CRANK + LOOP.replace("LENGTH", "0.1"), "cannot-be-closed"),
    "held": (HEAD + CRANK.replace('"B", at = "0.5, 0 m"', '"D", at = "1, 0 m"'), "rigid"),
    "two drivers": (
        HEAD + CRANK + '[[drivers]]\nlink = "crank"\nspeed = "1 rad/s"\n' * 2, "over-driven",
    ),
    "at rest": (HEAD + CRANK.replace("20 deg", "-90 deg"), "at-rest"),
    "load of nothing": (HEAD + CRANK + '[[loads]]\nlink = "crank"\n', "load"),
    "slide without a line": (
        HEAD + CRANK + '[[slides]]\npoint = "B"\nlink = "ground"\nstart = "A"\nend = "A"\n', "no-length",
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", REFUSED)
def test_refusals(name: str, tmp_path: Path) -> None:
    text, code = REFUSED[name]
    (tmp_path / "scene.toml").write_text(text)
    out = run("motion", "scene", str(tmp_path / "scene.toml"), "--duration", "1 s", "--json")
    assert out.status in (2, 3), out.out
    assert out.error["code"] == code


def test_too_long_and_past_the_end(tmp_path: Path) -> None:
    (tmp_path / "scene.toml").write_text(HEAD + CRANK)
    assert (
        run("motion", "scene", str(tmp_path / "scene.toml"), "--duration", "9 h", "--json").error["code"] == "too-long"
    )
    late = run("motion", "scene", str(tmp_path / "scene.toml"), "--duration", "1 s", "--at", "2 s", "--json")
    assert late.error["code"] == "time"
    lost = run("motion", "scene", str(tmp_path / "scene.toml"), "--duration", "1 s", "--follow", "arm", "--json")
    assert lost.error["code"] == "name"


def test_nothing_balances_a_torque() -> None:
    wheel = Link("wheel", (point("O"),), mass=1.0, moment=0.01)
    made = Scene((ground(point("O")), wheel), loads=(Load(link="wheel", torque=Formula("5", 1.0, "N*m")),))
    with pytest.raises(Exception, match=r"nothing balances 5 N.m on wheel"):
        equilibrium(made)


def test_tables_drive_and_load(tmp_path: Path) -> None:
    """A rate that rises in straight lines, and a force that comes and goes; files lie beside the scene."""
    (tmp_path / "rate.csv").write_text("t[s],speed[rpm]\n0,0\n1,60\n2,60\n")
    text = HEAD + CRANK + '[[drivers]]\nlink = "crank"\ntable = "rate.csv"\n'
    (tmp_path / "scene.toml").write_text(text)
    out = run("motion", "scene", str(tmp_path / "scene.toml"), "--duration", "2 s", "--json")
    assert out.status == 0, out.err
    angle = out.document["results"]["links"][0]["angle"]["value"]
    assert angle == pytest.approx(20.0 + 180.0 + 360.0, abs=1e-6)
    (tmp_path / "push.csv").write_text("t[s],force_x[N]\n0,0\n1,2\n2,0\n")
    body = '[[links]]\nname = "block"\nmass = "2 kg"\npoints = [{name = "P", at = "0, 0 m"}]\nmoment = "1 kg*m^2"\n'
    (tmp_path / "push.toml").write_text("horizontal = true\n" + body + '[[loads]]\npoint = "P"\ntable = "push.csv"\n')
    out = run("motion", "scene", str(tmp_path / "push.toml"), "--duration", "2 s", "--json")
    assert out.document["results"]["links"][0]["velocity"]["value"][0] == pytest.approx(1.0, abs=1e-9)


def test_masses_come_from_documents_of_inertia(tmp_path: Path) -> None:
    block = ("inertia", "shape", "block", "--mass", "25 kg", "--width", "900 mm", "--depth", "60 mm")
    assert run(*block, "--height", "40 mm", "--about", "centroid", "--output", str(tmp_path / "b.json")).status == 0
    scene = """
        [[links]]
        name = "ground"
        points = [{name = "H", at = "0, 0 mm"}]
        [[links]]
        name = "gate"
        mass = "@b.json:mass"
        moment = "@b.json:MOMENT"
        angle = "10 deg"
        centroid = ["@b.json:centroid[0]", "-450 mm"]
        points = [{name = "H", at = "0, 0 mm"}]
    """
    typed = scene.replace("@b.json:mass", "25 kg").replace("@b.json:centroid[0]", "0 mm")

    def answered(text: str) -> Any:
        (tmp_path / "gate.toml").write_text(text, encoding="utf-8")
        return run("motion", "scene", str(tmp_path / "gate.toml"), "--duration", "1 s", "--only", "links")

    wanted = answered(typed.replace("@b.json:MOMENT", "1.695 kg*m^2"))
    assert wanted.status == 0, wanted.err
    for moment in ("moments.zz", "tensor[2][2]"):
        assert answered(scene.replace("MOMENT", moment)).out == wanted.out
    refused = answered(scene.replace("MOMENT", "tensor[2][3]"))
    assert refused.status == 2
    assert "'b.json' has no result 'tensor[2][3]'" in refused.err


SIX_BAR = (Path(__file__).parents[2] / "examples/six_bar.toml").read_text(encoding="utf-8")


@pytest.mark.parametrize("driven", [True, False])
@pytest.mark.parametrize(("b", "q"), [("left", "left"), ("left", "right"), ("right", "left"), ("right", "right")])
def test_a_linkage_file_with_masses_starts_in_the_assembly_of_its_sides(
    tmp_path: Path, b: str, q: str, driven: bool
) -> None:
    text = SIX_BAR.replace('pin = "B"\nside = "left"', f'pin = "B"\nside = "{b}"')
    text = text.replace('pin = "Q"\nside = "left"', f'pin = "Q"\nside = "{q}"')
    linkage, scene = tmp_path / "linkage.toml", tmp_path / "scene.toml"
    linkage.write_text(text, encoding="utf-8")
    crank = 'name = "crank"\nmass = "1 kg"\nrod = true' + ("" if driven else '\nangle = "40 deg"\nspeed = "10 rad/s"')
    text = text.replace('name = "crank"', crank, 1)
    if not driven:
        text = text[: text.index("[[drivers]]")] + text[text.index("# Which of") :]
    scene.write_text(text, encoding="utf-8")
    wanted = json.loads(run("linkage", "solve", str(linkage), "--json").out)["results"]["pins"]
    made = run("motion", "scene", str(scene), "--duration", "0.02 s", "--at", "0 s", "--json")
    assert made.status == 0, made.err
    for pin, point_there in zip(wanted, json.loads(made.out)["results"]["points"], strict=True):
        for part in ("position", "velocity"):
            assert point_there[part]["value"] == pytest.approx(pin[part]["value"], abs=1e-9), pin["name"]


def test_near_says_on_which_side_a_pin_begins() -> None:
    sides = []
    for y in (0.6, -0.6):
        made = motion(four_bar(near=(Near("C", (0.6, y)),), drivers=()), duration=0.01, at=0.0, gravity=9.81)
        assert not [one for one in made.advice if one.code == "which-assembly"]
        sides.append(next(one.position[1] for one in made.points or () if one.name == "C") > 0.0)
    assert sides == [True, False]


def test_sides_that_fit_no_assembly_are_refused_with_the_list() -> None:
    with pytest.raises(InadmissibleError, match="no assembly has those sides"):
        motion(four_bar(sides=(Side("C", Way("ahead")),)), duration=0.1)
    with pytest.raises(InadmissibleError, match="near names the point 'X'"):
        motion(four_bar(near=(Near("X", (0.6, 0.0)),)), duration=0.1)


def in_a_terminal(*call: str) -> str:
    """What a call writes when standard error is a terminal."""
    import pty

    child, terminal = pty.fork()
    if child == 0:
        os.environ |= {"TERM": "xterm", "COLUMNS": "80"}
        os.execv(sys.executable, [sys.executable, "-m", "dynamics_cli", *call])
    seen = b""
    with contextlib.suppress(OSError):
        while part := os.read(terminal, 65536):
            seen += part
    os.close(terminal)
    assert os.waitpid(child, 0)[1] == 0, seen[-500:]
    return seen.decode()


def test_a_long_run_shows_how_far_it_is_in_a_terminal_only(tmp_path: Path) -> None:
    links = ['[[links]]\nname = "ground"\npoints = [{name = "A", at = "0, 0 m"}]']
    for first, second in pairwise("ABCDE"):
        points = f'{{name = "{first}", at = "0, 0 m"}}, {{name = "{second}", at = "0.3, 0 m"}}'
        rest = 'mass = "1 kg"\nrod = true\nangle = "-60 deg"'
        links.append(f'[[links]]\nname = "{first}{second}"\n{rest}\npoints = [{points}]')
    (tmp_path / "rods.toml").write_text("\n".join(links), encoding="utf-8")
    call = ("motion", "scene", str(tmp_path / "rods.toml"), "--duration", "14 s")
    shown = in_a_terminal(*call)
    assert "seconds of motion" in shown
    # the bar is gone and the cursor back before the answer
    assert shown.index("\x1b[?25h") < shown.index("answer  ")
    piped = run(*call)
    assert piped.err == ""
    assert piped.out.startswith("answer ")


def test_the_animated_drawing_runs_in_real_time_and_stands_at_its_end(tmp_path: Path) -> None:
    file = tmp_path / "gate.svg"
    call = ("motion", "scene", "examples/tailgate/tailgate.toml", "--duration", "4 s", "--drawing", str(file), "-q")
    assert run(*call).status == 0
    text = file.read_text(encoding="utf-8")
    assert 'dur="5s"' in text
    poses = re.findall(r'attributeName="d" values="([^"]*)"', text)[0].split(";")
    # 25 frames a second, a second at the end, and the start again
    assert len(poses) == 4 * 25 + 1 + 25 + 1
    assert poses[-1] == poses[0] != poses[100] == poses[125]
    # a link of three points is a closed, shaded outline; a spring is not
    assert [text.count('fill-opacity="0.15"'), text.count('fill-opacity="0"')] == [1, 1]


def test_errors_of_the_calculation_are_not_spread_over_inputs() -> None:
    """They are rounding: a search for their distribution would take minutes and say nothing."""
    scene = {
        "links": [
            {"name": "ground", "points": [{"name": "O", "at": "0, 0 m"}]},
            {
                "name": "rod", "mass": "2 ± 0.1 kg", "rod": True, "angle": "30 deg",
                "points": [{"name": "O", "at": "0, 0 m"}, {"name": "A", "at": "0.5, 0 m"}],
            },
        ],
        "duration": "0.2 s",
    }  # fmt: skip
    ran = run("motion", "scene", "--input", "-", "--json", stdin=json.dumps(scene))
    results = json.loads(ran.out)["results"]
    assert "interval" in results["largest_force"]
    assert "interval" not in results["energy_error"]


def test_the_scene_of_a_motion_is_also_one_of_equilibrium(tmp_path: Path) -> None:
    file = tmp_path / "arm.toml"
    file.write_text(run("motion", "scene", "--template").out, encoding="utf-8")
    assert 'duration = "2 s"' in file.read_text(encoding="utf-8")
    assert run("motion", "equilibrium", str(file), "--json").document["results"]["count"]["value"] >= 1
