"""Linkages from scenes: assemblies, motion, certificate, centres, mobility, and scenes that are refused."""

from itertools import combinations
from math import atan2, cos, degrees, hypot, radians, sin
from typing import Any

import pytest
from harness import answer, run
from mpmath import findroot, mp, mpf

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.linkage.bodies.body import TwoPoints, body
from dynamics_cli.linkage.fourbar.four_bar import four_bar
from dynamics_cli.linkage.scenes.centres import centres
from dynamics_cli.linkage.scenes.mobility import mobility
from dynamics_cli.linkage.scenes.pictures import motion, moving_scene, scene_picture
from dynamics_cli.linkage.scenes.solve import Solution, solve
from dynamics_cli.linkage.sliders.double_slider import oldham, scotch_yoke
from dynamics_cli.numerics.linkages.records import Driver, Link, Near, Pin, Scene, Side, Slide, Way

SIX = "examples/six_bar.toml"


def link(name: str, **points: tuple[float, float]) -> Link:
    return Link(name, tuple(Pin(pin, at) for pin, at in points.items()))


LINKS = (
    link("ground", O2=(0.0, 0.0), O4=(0.1, 0.0), O6=(0.18, -0.02)),
    link("crank", O2=(0.0, 0.0), A=(0.04, 0.0)),
    link("coupler", A=(0.0, 0.0), B=(0.12, 0.0), P=(0.06, 0.04)),
    link("rocker", O4=(0.0, 0.0), B=(0.08, 0.0)),
    link("five", P=(0.0, 0.0), Q=(0.13, 0.0)),
    link("six", O6=(0.0, 0.0), Q=(0.09, 0.0)),
)
LEFT = (Side("B", Way("left")), Side("Q", Way("left")))


def six_bar(**driver: Any) -> Scene:
    own: dict[str, Any] = {"link": "crank", "angle": radians(40.0), "speed": 1.0} | driver
    return Scene(LINKS, (Driver(**own),), (), LEFT)


def pins(made: Solution) -> dict[str, Any]:
    return {pin.name: pin for pin in made.pins}


def links(made: Solution) -> dict[str, Any]:
    return {one.name: one for one in made.links}


def test_a_six_bar_against_more_digits() -> None:
    made = solve(six_bar())
    found = pins(made)
    assert found["P"].position == pytest.approx((0.07303984320093256612552, 0.08404163419940446960643), abs=1e-16)
    assert found["Q"].position == pytest.approx((0.201954866490798350234, 0.06728106230661505722907), abs=1e-16)
    six = links(made)["six"]
    assert degrees(six.angle) == pytest.approx(75.88062537690188583313, rel=1e-14)
    assert six.speed == pytest.approx(0.212699348117265, rel=1e-12)
    assert six.acceleration == pytest.approx(0.677924813782, rel=1e-11)
    rocker = four_bar(crank=0.04, coupler=0.12, rocker=0.08, ground=0.1, crank_angle=radians(40.0), speed=1.0)
    assert links(made)["rocker"].acceleration == pytest.approx(rocker.rocker_acceleration, rel=1e-12)


def test_the_certificate_holds() -> None:
    made = solve(six_bar())
    mp.dps = 40
    values = [findroot(_closure, [mpf(one) for pin in ("B", "P", "Q") for one in pins(made)[pin].position])]
    exact = [float(x) for x in values[0]]
    found = [one for pin in ("B", "P", "Q") for one in pins(made)[pin].position]
    off = sum((one - other) ** 2 for one, other in zip(exact, found, strict=True)) ** 0.5
    assert (made.kantorovich or 1.0) < 1e-6
    assert off <= (made.pin_error or 0.0) <= 1e-12
    assert 0.0 < (made.nearest_other or 0.0) < 0.12


def _closure(bx: Any, by: Any, px: Any, py: Any, qx: Any, qy: Any) -> list[Any]:
    angle = mpf(radians(40.0))
    ax, ay = mpf(0.04) * mp.cos(angle), mpf(0.04) * mp.sin(angle)
    share = (mpf(0.06) / mpf(0.12), mpf(0.04) / mpf(0.12))
    return [
        (bx - ax) ** 2 + (by - ay) ** 2 - mpf(0.12) ** 2,
        (bx - mpf(0.1)) ** 2 + by**2 - mpf(0.08) ** 2,
        px - ax - share[0] * (bx - ax) + share[1] * (by - ay),
        py - ay - share[1] * (bx - ax) - share[0] * (by - ay),
        (qx - px) ** 2 + (qy - py) ** 2 - mpf(0.13) ** 2,
        (qx - mpf(0.18)) ** 2 + (qy + mpf(0.02)) ** 2 - mpf(0.09) ** 2,
    ]


def test_all_assemblies_of_dyads_and_of_a_triad() -> None:
    made = solve(Scene(LINKS, six_bar().drivers), assemblies=True)
    assert made.assemblies == 4
    triad = Scene(LINKS, (Driver("six", angle=radians(80.0)),), near=(Near("A", (0.04, 0.001)),))
    done = solve(triad, assemblies=True)
    rows = [row for row in done.every_assembly or () if row.pin == "A"]
    found = sorted(degrees(atan2(row.position[1], row.position[0])) % 360.0 for row in rows)
    wanted = [1.2926973343870897818, 48.360861795906456992, 54.370436095725611545, 308.19640021039030333]
    assert found == pytest.approx(wanted, rel=1e-12)
    near = pins(solve(triad))["A"].position
    assert degrees(atan2(near[1], near[0])) == pytest.approx(wanted[0], rel=1e-12)


def test_an_open_choice_is_refused_with_the_list() -> None:
    with pytest.raises(InadmissibleError, match=r"4 assemblies .* B left, Q left; B left, Q right"):
        solve(Scene(LINKS, six_bar().drivers))


SLIDER = (link("ground", O=(0.0, 0.0), S=(0.0, 0.02), T=(0.1, 0.02)), link("crank", O=(0.0, 0.0), A=(0.05, 0.0)),
          link("rod", A=(0.0, 0.0), B=(0.15, 0.0)))  # fmt: skip
RAIL = (Slide("B", "ground", "S", "T"),)


def test_a_slider_driven_by_the_crank_and_a_crank_driven_by_the_slider() -> None:
    crank = Scene(SLIDER, (Driver("crank", angle=radians(60.0), speed=100.0),), RAIL, (Side("B", Way("ahead")),))
    made = solve(crank)
    assert pins(made)["B"].velocity[0] == pytest.approx(-4.72325377341707114, rel=1e-12)
    assert pins(made)["B"].acceleration[0] == pytest.approx(-225.130116956498698, rel=1e-12)
    assert links(made)["rod"].acceleration == pytest.approx(2877.46399181974955, rel=1e-12)
    push = Driver(point="B", position=pins(made)["B"].position[0], velocity=-4.72325377341707114,
                  acceleration=-225.130116956498698)  # fmt: skip
    back = solve(Scene(SLIDER, (push,), RAIL, (Side("A", Way("left")),)))
    assert links(back)["crank"].speed == pytest.approx(100.0, rel=1e-12)
    assert links(back)["crank"].acceleration == pytest.approx(0.0, abs=1e-8)
    assert mobility(crank).freedom == mobility(crank).counted == 1
    far = centres(crank).centres
    assert [one.position is None for one in far] == [False] * 3


def test_a_slotted_lever() -> None:
    scene = Scene(
        (link("ground", O2=(0.0, 0.0), O4=(0.12, 0.0)), link("crank", O2=(0.0, 0.0), A=(0.05, 0.0)),
         link("lever", O4=(0.0, 0.0), E=(0.25, 0.0))),
        (Driver("crank", angle=radians(75.0), speed=10.0),), (Slide("A", "lever", "O4", "E"),),
        (Side("lever", Way("ahead")),),
    )  # fmt: skip
    lever = links(solve(scene))["lever"]
    assert degrees(lever.angle) == pytest.approx(155.718995016940526)
    assert (lever.speed, lever.acceleration) == pytest.approx((0.686583991083247245, 36.2452208310856967))


YOKE = (
    link("ground", O=(0.0, 0.0), S=(0.1, 0.0)),
    link("crank", O=(0.0, 0.0), A=(0.04, 0.0)),
    link("yoke", Y=(0.0, 0.0), Z=(0.06, 0.0), T=(0.05 * sin(0.2), 0.05 * cos(0.2))),
)
YOKE_SLIDES = (Slide("Y", "ground", "O", "S"), Slide("Z", "ground", "O", "S"), Slide("A", "yoke", "Y", "T"))


@pytest.mark.parametrize("degree", [0.0, 30.0, 90.0, 135.0, 180.0, 250.0])
def test_a_scotch_yoke_as_a_scene_agrees_with_its_closed_form(degree: float) -> None:
    angle, speed, rise = radians(degree), 31.4, 12.0
    exact = scotch_yoke(crank=0.04, crank_angle=angle, slot_angle=0.2, speed=speed, angular_acceleration=rise)
    driver = Driver("crank", angle=angle, speed=speed, angular_acceleration=rise)
    here = float(exact.position)
    upright = (Near("Z", (here + 0.06, 0.0)), Near("T", (here + 0.01, 0.05)))
    scene = Scene(YOKE, (driver,), YOKE_SLIDES, near=upright)
    pin = pins(solve(scene))["Y"]
    assert pin.position == pytest.approx((here, 0.0), abs=1e-15)
    assert pin.velocity == pytest.approx((exact.velocity, 0.0), abs=1e-12)
    assert pin.acceleration == pytest.approx((exact.acceleration, 0.0), abs=1e-10)
    assert mobility(scene).freedom == mobility(scene).counted == 1


@pytest.mark.parametrize("degree", [0.0, 30.0, 90.0, 135.0, 180.0, 250.0])
def test_an_oldham_coupling_as_a_scene_agrees_with_its_closed_form(degree: float) -> None:
    angle, speed, offset = radians(degree), 157.0, 0.003
    exact = oldham(offset=offset, speed=speed, shaft_angle=angle)
    along, across = (cos(angle), sin(angle)), (-sin(angle), cos(angle))
    x, y = exact.centre
    shafts = (
        link("ground", O=(0.0, 0.0), Q=(offset, 0.0)),
        link("first", O=(0.0, 0.0), U=(0.02, 0.0)),
        link("second", Q=(0.0, 0.0), V=(0.02, 0.0)),
        link("disc", C=(0.0, 0.0), D=(0.01, 0.0), E=(0.0, 0.01)),
    )
    slots = (("C", "first", "O", "U"), ("D", "first", "O", "U"), ("C", "second", "Q", "V"), ("E", "second", "Q", "V"))
    near = (
        Near("E", (x + 0.01 * across[0], y + 0.01 * across[1])),
        Near("V", (offset + 0.02 * across[0], 0.02 * across[1])),
    )
    scene = Scene(
        shafts, (Driver("first", angle=angle, speed=speed),), tuple(Slide(*slot) for slot in slots), near=near
    )
    solved = solve(scene)
    centre = pins(solved)["C"]
    assert centre.position == pytest.approx(exact.centre, abs=1e-15)
    # the disc slides along the first slot at the speed that the closed form gives
    slip = centre.velocity[0] * along[0] + centre.velocity[1] * along[1]
    assert slip == pytest.approx(exact.first_slip, abs=1e-12)
    assert hypot(*centre.velocity) == pytest.approx(exact.centre_speed)
    assert hypot(*centre.acceleration) == pytest.approx(exact.centre_acceleration)
    for name in ("second", "disc"):
        assert links(solved)[name].speed == pytest.approx(exact.disc_speed)
        assert links(solved)[name].acceleration == pytest.approx(0.0, abs=1e-8)
    assert mobility(scene).freedom == mobility(scene).counted == 1


def test_sides_do_not_select_what_newton_found() -> None:
    driver = Driver("crank", angle=0.5)
    with pytest.raises(InadmissibleError, match="2 assemblies are possible"):
        solve(Scene(YOKE, (driver,), YOKE_SLIDES))
    with pytest.raises(InadmissibleError, match="'yoke' selects none of these assemblies"):
        solve(Scene(YOKE, (driver,), YOKE_SLIDES, (Side("yoke", Way("ahead")),)))
    answers = {solve(Scene(YOKE, (driver,), YOKE_SLIDES, near=(Near("T", (0.0, y)),))).assembly for y in (-1.0, 1.0)}
    assert answers == {"solution 1 of 2", "solution 2 of 2"}


def test_relative_drivers_and_velocities_against_differences() -> None:
    chain = (
        link("ground", O=(0.0, 0.0)),
        link("one", O=(0.0, 0.0), A=(0.3, 0.0)),
        link("two", A=(0.0, 0.0), E=(0.2, 0.0)),
    )

    def at(time: float) -> Solution:
        upper = Driver("one", angle=0.5 + 2.0 * time + 1.5 * time**2, speed=2.0 + 3.0 * time, angular_acceleration=3.0)
        lower = Driver("two", "one", 0.8 - time - 2.0 * time**2, -1.0 - 4.0 * time, -4.0)
        return solve(Scene(chain, (upper, lower)))

    made, ahead, behind = at(0.0), at(1e-5), at(-1e-5)
    for i in (0, 1):
        velocity = (pins(ahead)["E"].position[i] - pins(behind)["E"].position[i]) / 2e-5
        change = (pins(ahead)["E"].velocity[i] - pins(behind)["E"].velocity[i]) / 2e-5
        assert pins(made)["E"].velocity[i] == pytest.approx(velocity, abs=1e-7)
        assert pins(made)["E"].acceleration[i] == pytest.approx(change, abs=1e-6)
    assert links(made)["two"].speed == pytest.approx(1.0)


PARALLEL = (
    link("ground", a=(0.0, 0.0), b=(1.0, 0.0), c=(2.0, 0.0)), link("one", a=(0.0, 0.0), d=(0.5, 0.0)),
    link("two", b=(0.0, 0.0), e=(0.5, 0.0)), link("three", c=(0.0, 0.0), f=(0.5, 0.0)),
    link("bar", d=(0.0, 0.0), e=(1.0, 0.0), f=(2.0, 0.0)),
)  # fmt: skip


def test_an_over_constrained_linkage_that_moves_is_known_as_one() -> None:
    scene = Scene(PARALLEL, (Driver("one", angle=1.0, speed=2.0),))
    made = mobility(scene)
    assert (made.freedom, made.counted, made.repeated) == (1, 0, 1)
    assert "three" in str(made.named)
    assert [one.speed for one in solve(scene).links] == pytest.approx([2.0, 2.0, 2.0, 0.0], abs=1e-12)
    bent = (*PARALLEL[:3], link("three", c=(0.0, 0.0), f=(0.51, 0.0)), PARALLEL[4])
    with pytest.raises(InadmissibleError, match=r"miss by .* more conditions than it can keep"):
        solve(Scene(bent, scene.drivers))
    flat = solve(Scene(PARALLEL, (Driver("one", angle=0.0, speed=2.0),)))
    assert [one.code for one in flat.advice] == ["singular"]
    assert flat.links[1].speed is None


def test_centres_give_the_speeds_and_lie_on_lines() -> None:
    made = centres(six_bar())
    assert made.count == 15
    places = {(row.first, row.second): complex(*row.position) for row in made.centres if row.position}
    for one, two, three in combinations([link.name for link in six_bar().links], 3):
        a, b, c = places[one, two], places[two, three], places[one, three]
        # Kennedy: the centres of three links lie on a line
        assert abs(((b - a).conjugate() * (c - a)).imag) <= 1e-12 * max(abs(b - a), abs(c - a)) ** 2
    known = {(one.first, one.second): one for one in made.centres}
    assert known["ground", "coupler"].position == pytest.approx((0.216533637130032315, 0.1816932950532851))
    x = (known["crank", "rocker"].position or (0.0, 0.0))[0]
    assert x == pytest.approx(-0.0388733446579118351)
    # ω₄/ω₂ from the centre on the line of the pivots
    assert known["crank", "rocker"].ratio == pytest.approx(x / (x - 0.1))


def test_body_agrees_with_the_solved_coupler() -> None:
    made = solve(six_bar(speed=10.0, angular_acceleration=5.0))
    found = pins(made)
    one, two = found["A"], found["B"]
    coupler = body(
        point=one.position, velocity=one.velocity, acceleration=one.acceleration,
        rest=TwoPoints(two.position, two.velocity, two.acceleration),
    )  # fmt: skip
    assert coupler.angular_velocity == pytest.approx(-1.6483657661390795785)
    assert coupler.angular_acceleration == pytest.approx(46.945695808693474690)
    assert coupler.zero_acceleration == pytest.approx((0.0780518240103239481, -0.0450415973354378932))


@pytest.mark.parametrize(
    ("scene", "words"),
    [
        (Scene(LINKS[1:], six_bar().drivers), "ground"),
        (Scene((*LINKS, LINKS[1]), six_bar().drivers), "two links are called"),
        (Scene((*LINKS[:1], link("crank", O2=(0.0, 0.0), A=(0.0, 0.0))), six_bar().drivers), "length above zero"),
        (Scene(LINKS, ()), "1 more drivers"),
        (Scene(LINKS, (Driver("crank"), Driver("six"))), "miss by"),
        (Scene(LINKS, (Driver("wheel"),)), "driver of 'wheel'"),
        (Scene(SLIDER, (Driver("crank"),), (Slide("C", "ground", "S", "T"),)), "slide of 'C'"),
        (Scene(LINKS, six_bar().drivers, (), (Side("B", Way("ahead")),)), "there is: B left"),
        (Scene(LINKS, six_bar().drivers, (), (Side("X", Way("left")),)), "'X'"),
    ],
)
def test_scenes_that_do_not_fit_are_refused(scene: Scene, words: str) -> None:
    with pytest.raises(InadmissibleError, match=words):
        solve(scene)


def test_a_driver_out_of_reach_names_the_gap() -> None:
    with pytest.raises(InadmissibleError, match=r"Q on five and six miss by 0\.16"):
        solve(Scene((*LINKS[:4], link("five", P=(0.0, 0.0), Q=(0.4, 0.0)), LINKS[5]), six_bar().drivers))


def test_the_example_from_its_file_and_over_a_turn() -> None:
    made = answer("linkage", "solve", SIX, "--follow", "six", "--steps", "4")["results"]
    assert len(made["motion"]) == 5
    assert made["assembly"] == "B left, Q left"
    assert run("linkage", "centres", SIX).status == run("linkage", "mobility", SIX).status == 0


def test_pictures_follow_the_linkage() -> None:
    made = solve(six_bar())
    at = {pin.name: complex(*pin.position) for pin in made.pins}
    poses = motion(six_bar(), at, 90)
    assert len(poses) == 90
    assert all(abs(abs(pose["A"]) - 0.04) < 1e-12 for pose in poses)
    # the crank comes round a quarter of a turn after as many frames
    assert abs(poses[45]["A"] + 0.04 * complex(cos(radians(40.0)), sin(radians(40.0)))) < 1e-12
    assert len(scene_picture(made, six_bar()).panels) == 1
    assert moving_scene(made, six_bar()).count("<animate ") >= 5
    swinging = Scene(LINKS, (Driver("rocker", angle=1.2),), (), (Side("A", Way("left")), LEFT[1]))
    there = motion(swinging, {pin.name: complex(*pin.position) for pin in solve(swinging).pins}, 90)
    assert 4 < len(there) < 180


def four_bar_scene(a: float, b: float, c: float, d: float, angle: float, **driver: Any) -> Scene:
    members = (link("ground", O2=(0.0, 0.0), O4=(d, 0.0)), link("crank", O2=(0.0, 0.0), A=(a, 0.0)),
               link("coupler", A=(0.0, 0.0), B=(b, 0.0)), link("rocker", O4=(0.0, 0.0), B=(c, 0.0)))  # fmt: skip
    own: dict[str, Any] = {"link": "crank", "angle": angle, "speed": 1.0} | driver
    return Scene(members, (Driver(**own),), (), (Side("B", Way("left")),))


def rows_of(made: Solution) -> list[tuple[float, float]]:
    return [(degrees(row.driver_angle), degrees(row.angle)) for row in made.motion or ()]  # type: ignore[arg-type]


def test_a_parallelogram_is_followed_through_its_change_point() -> None:
    made = solve(four_bar_scene(1.0, 3.0, 1.0, 3.0, 0.5), follow="rocker", steps=12)
    # by the side of B alone it would turn into the antiparallelogram at 180 deg
    assert all(driver == pytest.approx(angle, abs=1e-9) for driver, angle in rows_of(made))
    assert [one.code for one in made.advice] == ["change-point"]
    assert "over a change point" in str(made.followed_by)


@pytest.mark.parametrize("excess", [1e-3, 1e-6, 1e-9])
def test_beside_a_change_point_the_motion_turns_into_the_other(excess: float) -> None:
    made = solve(four_bar_scene(1.0, 3.0, 1.0 + excess, 3.0, 0.5), follow="rocker", steps=12)
    assert not made.advice
    for driver, angle in rows_of(made):
        exact = four_bar(crank=1.0, coupler=3.0, rocker=1.0 + excess, ground=3.0, crank_angle=radians(driver))
        assert cos(radians(angle)) == pytest.approx(cos(exact.rocker_angle or 0.0), abs=1e-9)


def test_a_driver_is_followed_to_its_limits() -> None:
    made = solve(four_bar_scene(3.0, 2.0, 2.5, 4.0, 0.1), follow="rocker", steps=24)
    limits = degrees(made.driver_from or 0.0), degrees(made.driver_to or 0.0)
    assert limits == pytest.approx((-78.584842257269508863, 78.584842257269508863), abs=1e-6)
    assert [one.code for one in made.advice] == ["limit"]
    assert len(rows_of(made)) == 10
    part = solve(four_bar_scene(3.0, 2.0, 2.5, 4.0, 0.1), follow="rocker", steps=4, turn=-radians(40.0))
    assert len(rows_of(part)) == 5
    assert not part.advice


def test_a_pushed_slider_is_followed_along_its_slide() -> None:
    push = Driver(point="B", position=0.15, velocity=-4.0)
    scene = Scene(SLIDER, (push,), RAIL, (Side("A", Way("left")),))
    made = solve(scene, follow="crank", steps=6, travel=0.06)
    # stretched out: √((0.05 + 0.15)² − 0.02²)
    assert [one.code for one in made.advice] == ["limit"]
    assert [row.driver_position for row in made.motion or ()] == pytest.approx([0.15, 0.16, 0.17, 0.18, 0.19])
    with pytest.raises(InadmissibleError, match="say how far"):
        solve(scene, follow="crank")
    with pytest.raises(InadmissibleError, match="no travel"):
        solve(six_bar(), follow="six", travel=0.1)
    with pytest.raises(InadmissibleError, match="no link or pin"):
        solve(six_bar(), follow="seven")


def test_repeated_conditions_and_relative_drivers_are_followed() -> None:
    made = solve(Scene(PARALLEL, (Driver("one", angle=1.0, speed=2.0),)), follow="two", steps=12)
    assert all(driver == pytest.approx(angle, abs=1e-9) for driver, angle in rows_of(made))
    elbow = (
        link("ground", O=(0.0, 0.0)),
        link("one", O=(0.0, 0.0), A=(0.3, 0.0)),
        link("two", A=(0.0, 0.0), E=(0.2, 0.0)),
    )
    drivers = (Driver("two", "one", 0.8, 1.0), Driver("one", angle=0.5))
    made = solve(Scene(elbow, drivers), follow="two", steps=8)
    assert [angle - driver for driver, angle in rows_of(made)] == pytest.approx([degrees(0.5)] * 9, abs=1e-9)


def test_peaucellier_draws_a_straight_line() -> None:
    made = answer("linkage", "solve", "examples/peaucellier.toml", "--follow", "Q", "--steps", "24")["results"]
    # OP·OQ = 100² − 50², and the crank's circle goes through O: x = 7500/(2·40)
    assert len(made["motion"]) >= 10
    assert [row["position"]["value"][0] for row in made["motion"]] == pytest.approx([93.75] * len(made["motion"]))
