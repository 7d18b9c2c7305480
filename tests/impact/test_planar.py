"""Planar impacts: what does not depend on how a scene is written, both sides of every branch, refusals."""

import math
import random
from typing import Any

import pytest
from harness import answer, run

from dynamics_cli.impact.conventions import Axes, ByMass, BySpeed, ByVelocity, Energetic, Fixed, Restituted
from dynamics_cli.impact.particles.springs import Hertz, Spring
from dynamics_cli.impact.planar.bodies import ByInertia, Lever, OnBody, Placed, RigidBody, RigidTarget
from dynamics_cli.impact.planar.impact import planar
from dynamics_cli.impact.planar.laws import LAWS, Law
from dynamics_cli.impact.planar.results import PlanarImpact

HALF = 0.5 * math.pi


def draw(seed: int) -> dict[str, Any]:
    """Two bodies that approach."""
    r = random.Random(seed)
    while True:
        scene = {
            "m": (r.uniform(1.0, 5.0), r.uniform(1.0, 5.0)),
            "j": (r.uniform(0.2, 5.0), r.uniform(0.2, 5.0)),
            "r": ((r.uniform(0.0, 1.5), r.uniform(-1.0, 1.0)), (r.uniform(-1.5, 0.0), r.uniform(-1.0, 1.0))),
            "v": ((r.uniform(0.0, 9.0), r.uniform(-5.0, 5.0)), (r.uniform(-9.0, 0.0), r.uniform(-5.0, 5.0))),
            "w": (r.uniform(-3.0, 3.0), r.uniform(-3.0, 3.0)),
            "normal": r.uniform(-0.7, 0.7),
            "mu": r.uniform(0.0, 1.0),
            "e": r.uniform(0.0, 1.0),
        }
        try:
            hit(scene)
        except Exception:
            continue
        return scene


def hit(s: dict[str, Any], law: str = "stronge", turn: float = 0.0, scale: float = 1.0, swap: bool = False,
        **more: Any) -> PlanarImpact:  # fmt: skip
    """The scene, turned, scaled in length, or its bodies exchanged."""
    c, d = math.cos(turn), math.sin(turn)
    sides = []
    for index in (1, 0) if swap else (0, 1):
        (x, y), (a, b) = s["r"][index], s["v"][index]
        lever = Lever((scale * (c * x - d * y), scale * (d * x + c * y)))
        motion = ByVelocity((scale * (c * a - d * b), scale * (d * a + c * b)))
        sides.append((ByMass(s["m"][index]), ByInertia(scale * scale * s["j"][index]), lever, motion, s["w"][index]))
    normal = s["normal"] + turn + (math.pi if swap else 0.0)
    return planar(
        first=RigidBody(*sides[0]),
        second=RigidTarget(*sides[1]),
        normal=normal,
        friction=s["mu"],
        contact=Restituted(s["e"]),
        law=Law(law),
        **more,
    )


SCENES = [draw(seed) for seed in range(40)]


def laws_of(scene: dict[str, Any]) -> list[str]:
    """The laws that have an answer."""
    found = hit(scene, "all")
    return [law for law in LAWS if getattr(found, law.replace("-", "_")) is not None]


@pytest.mark.parametrize("index", range(len(SCENES)))
class TestInvariants:
    def test_turning_the_axes_changes_nothing_but_directions(self, index: int) -> None:
        for law in laws_of(SCENES[index]):
            one, two = hit(SCENES[index], law), hit(SCENES[index], law, turn=1.234)
            assert two.normal_impulse == pytest.approx(one.normal_impulse, rel=1e-12)
            assert two.tangential_impulse == pytest.approx(one.tangential_impulse, rel=1e-9, abs=1e-12)
            assert two.first.delta_v.magnitude == pytest.approx(one.first.delta_v.magnitude, rel=1e-12)
            assert two.energy_lost == pytest.approx(one.energy_lost, rel=1e-10)

    def test_exchanging_the_bodies_exchanges_the_answers(self, index: int) -> None:
        for law in laws_of(SCENES[index]):
            one, two = hit(SCENES[index], law), hit(SCENES[index], law, swap=True)
            assert two.first.velocity == pytest.approx(one.second.velocity, rel=1e-11, abs=1e-12)
            assert two.second.spin == pytest.approx(one.first.spin, rel=1e-10, abs=1e-11)
            assert two.tangential_impulse == pytest.approx(one.tangential_impulse, rel=1e-9, abs=1e-12)

    def test_lengths_scale(self, index: int) -> None:
        one, two = hit(SCENES[index]), hit(SCENES[index], scale=8.0)
        assert two.normal_impulse == pytest.approx(8.0 * one.normal_impulse, rel=1e-13)
        assert two.energy_lost == pytest.approx(64.0 * one.energy_lost, rel=1e-13)

    def test_energy_by_its_definition(self, index: int) -> None:
        scene = SCENES[index]
        for law in laws_of(scene):
            found = hit(scene, law)
            before = after = 0.0
            for k, body in enumerate((found.first, found.second)):
                m, j, v, w = scene["m"][k], scene["j"][k], scene["v"][k], scene["w"][k]
                before += 0.5 * m * (v[0] ** 2 + v[1] ** 2) + 0.5 * j * w * w
                after += 0.5 * m * (body.velocity[0] ** 2 + body.velocity[1] ** 2) + 0.5 * j * body.spin**2
            assert before - after == pytest.approx(found.energy_lost, abs=1e-12 * before)
            assert found.energy_lost >= -1e-12 * before

    def test_friction_and_push(self, index: int) -> None:
        for law in laws_of(SCENES[index]):
            found = hit(SCENES[index], law)
            assert found.normal_impulse > 0.0
            limit = SCENES[index]["mu"] * found.normal_impulse
            assert abs(found.tangential_impulse) <= limit * (1.0 + 1e-14) + 1e-15

    def test_laws_agree_on_straight_paths(self, index: int) -> None:
        found = hit(SCENES[index], "all")
        if found.slip_history == "slip":
            assert found.newton.normal_impulse == pytest.approx(found.stronge.normal_impulse, rel=1e-14)
            assert found.poisson.normal_impulse == pytest.approx(found.stronge.normal_impulse, rel=1e-14)


def ball(velocity: tuple[float, float], spin: float = 0.0) -> RigidBody:
    """A ball of mass 1 and radius 1."""
    return RigidBody(ByMass(1.0), ByInertia(0.4), Lever((0.0, -1.0)), ByVelocity(velocity), spin)


FLOOR = RigidTarget(Fixed(True))


def bounce(body: RigidBody, friction: float, restitution: float, **more: Any) -> PlanarImpact:
    return planar(first=body, second=FLOOR, normal=-HALF, friction=friction, contact=Restituted(restitution), **more)


def strike(velocity: tuple[float, float], friction: float, **more: Any) -> PlanarImpact:
    """A leaning body against a wall: k_t = 2 and k_x = −1, so that friction of one half just holds."""
    body = RigidBody(ByMass(1.0), ByInertia(1.0), Lever((1.0, 1.0)), ByVelocity(velocity))
    return planar(first=body, second=FLOOR, normal=0.0, friction=friction, contact=Restituted(0.6), **more)


def test_a_ball_that_grips_rolls_off() -> None:
    # k_t = 1/m + r²/J = 3.5: the slip of 1 needs 1/3.5 N·s of friction
    found = bounce(ball((1.0, -2.0)), 0.5, 0.5)
    assert found.slip_history == "slip, stick"
    assert found.first.velocity[0] == pytest.approx(5.0 / 7.0, rel=1e-15)
    assert found.sliding_after == 0.0
    assert found.slip_impulse == pytest.approx(2.0 / 3.5, rel=1e-15)


def test_a_ball_that_slides() -> None:
    found = bounce(ball((9.0, -2.0)), 0.1, 0.5)
    assert found.slip_history == "slip"
    assert found.first.velocity == pytest.approx((9.0 - 0.3, 1.0), rel=1e-15)
    assert found.critical.share == pytest.approx(0.3 / (9.0 / 3.5), rel=1e-14)


def test_history_without_friction_and_without_slip() -> None:
    assert bounce(ball((9.0, -2.0)), 0.0, 0.5).slip_history == "slip without friction"
    assert strike((1.0, 0.0), 0.4).slip_history == "slip from rest"
    assert strike((1.0, 0.0), 0.5).slip_history == "stick"


@pytest.mark.parametrize("law", ["stronge", "newton", "poisson"])
def test_reversed_slip_begins_where_friction_cannot_hold(law: str) -> None:
    # k_t = 2, |k_x| = 1: friction below one half lets the contact slip back
    for friction, words in ((math.nextafter(0.5, 0.0), "slip, reversed slip"), (0.5, "slip, stick")):
        found = strike((2.0, -0.25), friction, law=Law(law))
        assert found.slip_history == words
        assert abs(found.sliding_after) <= 1e-15


def test_newton_may_gain_energy_and_is_then_refused() -> None:
    rod = RigidBody(ByMass(1.0), ByInertia(1.0 / 12.0), Lever((0.25, -0.433)), ByVelocity((-0.5, -1.0)))
    outcome = bounce(rod, 0.6, 1.0, law=Law("all"))
    assert outcome.newton is None
    assert outcome.stronge is not None
    assert "newton" in [one.result for one in outcome.advice if one.code == "law-inadmissible"]
    with pytest.raises(Exception, match="gains"):
        bounce(rod, 0.6, 1.0, law=Law("newton"))


def test_moment_restitution_brings_spins_together() -> None:
    scene = {**SCENES[3], "mu": 0.4, "e": 0.2}
    found = hit(scene, "brach", moment_restitution=0.0)
    assert found.first.spin == pytest.approx(found.second.spin, rel=1e-11)
    free = hit(scene, "brach", moment_restitution=1.0)
    assert free.moment_impulse is None
    near = hit(scene, "brach", moment_restitution=1.0 - 1e-9)
    assert near.normal_impulse == pytest.approx(free.normal_impulse, rel=1e-6)
    assert all(check.passed for check in found.checks)


def test_the_contact_may_be_given_in_three_ways() -> None:
    scene = SCENES[5]
    base = hit(scene)
    (x, y), (a, b) = scene["r"]
    nose = 0.7
    c, d = math.cos(nose), math.sin(nose)
    first = RigidBody(ByMass(scene["m"][0]), ByInertia(scene["j"][0]), OnBody((c * x + d * y, c * y - d * x)),
                      ByVelocity(scene["v"][0]), scene["w"][0], nose)  # fmt: skip
    second = RigidTarget(ByMass(scene["m"][1]), ByInertia(scene["j"][1]), Placed((4.0 - a, 2.0 - b)),
                         ByVelocity(scene["v"][1]), scene["w"][1])  # fmt: skip
    found = planar(first=first, second=second, normal=scene["normal"], friction=scene["mu"],
                   contact=Restituted(scene["e"]), contact_point=(4.0, 2.0))  # fmt: skip
    assert found.normal_impulse == pytest.approx(base.normal_impulse, rel=1e-13)
    assert found.first.delta_v.vector == pytest.approx(base.first.delta_v.vector, rel=1e-12)


def test_sae_axes_are_the_mirror_image() -> None:
    one = RigidBody(ByMass(2.0), ByInertia(1.5), Lever((1.0, 0.3)), BySpeed(5.0, 0.2), 0.5)
    two = RigidTarget(ByMass(3.0), ByInertia(2.5), Lever((-1.0, 0.4)), BySpeed(2.0, 2.0), -0.3)
    base = planar(first=one, second=two, normal=0.1, friction=0.4, contact=Restituted(0.3))
    turned = planar(first=one, second=two, normal=0.1, friction=0.4, contact=Restituted(0.3), axes=Axes("sae"))
    assert turned.first.velocity == base.first.velocity
    assert turned.first.delta_v.pdof == -base.first.delta_v.pdof


def test_energetic_contacts_say_so() -> None:
    found = planar(first=ball((0.0, -2.0)), second=FLOOR, normal=-HALF, friction=0.0, contact=Energetic(1.5))
    assert found.separation_speed == pytest.approx(3.0)
    assert found.energy_lost < 0.0
    assert [one.code for one in found.advice] == ["energetic-contact"]


class TestStiffness:
    @pytest.mark.parametrize("law", ["brach", "kudlich-slibar"])
    def test_laws_without_a_path_have_no_duration(self, law: str) -> None:
        document = answer(*CALL, "--law", law, "--contact-stiffness", "10 N/mm")
        assert document["results"]["duration"] is None
        assert document["results"]["peak_force"] is None
        assert {one["code"] for one in document["warnings"]} == {"no-path"}

    def test_a_spring_gives_half_a_period(self) -> None:
        found = bounce(ball((0.0, -2.0)), 0.0, 1.0, force=Spring(400.0))
        assert found.duration == pytest.approx(math.pi / 20.0, rel=1e-14)
        assert found.peak_force == pytest.approx(2.0 * 20.0, rel=1e-14)

    def test_hertz_gives_its_classical_duration(self) -> None:
        stiffness = 4.0 / 3.0 * 1e6 * math.sqrt(0.25)
        deflection = (2.5 * 0.5 * 4.0 / stiffness) ** 0.4
        found = bounce(ball((0.0, -2.0)), 0.0, 1.0, force=Hertz(0.25, 1e6))
        # 2 ∫ dx/√(1 − x^(5/2)) = 2.943275…
        assert found.duration == pytest.approx(2.9432751843247047 * deflection / 2.0, rel=1e-13)
        assert found.peak_force == pytest.approx(stiffness * deflection**1.5, rel=1e-13)

    @pytest.mark.parametrize("force", [Spring(5e4), Hertz(0.02, 2e9)])
    @pytest.mark.parametrize("index", range(0, 40, 3))
    def test_the_force_history_gives_the_impulse(self, force: Spring | Hertz, index: int) -> None:
        """March F(δ) in time with many steps: its impulse and duration are those reported."""
        scene = {**SCENES[index], "e": 0.3 + 0.6 * SCENES[index]["e"]}
        found = hit(scene, force=force)
        impulse, duration = marched(scene, force, found)
        assert impulse == pytest.approx(found.normal_impulse, rel=2e-5)
        assert duration == pytest.approx(found.duration, rel=2e-4)


def marched(scene: dict[str, Any], force: Spring | Hertz, found: PlanarImpact) -> tuple[float, float]:
    """Impulse and duration by explicit steps of the normal deflection."""
    from dynamics_cli.impact.planar.bodies import contact_velocity, mobility, solid
    from dynamics_cli.numerics.vectors import planar_dot as dot

    axes = Axes("mathematical")
    one = solid(RigidBody(ByMass(scene["m"][0]), ByInertia(scene["j"][0]), Lever(scene["r"][0]),
                          ByVelocity(scene["v"][0]), scene["w"][0]), None, axes, 9.8, "")  # fmt: skip
    two = solid(RigidTarget(ByMass(scene["m"][1]), ByInertia(scene["j"][1]), Lever(scene["r"][1]),
                            ByVelocity(scene["v"][1]), scene["w"][1]), None, axes, 9.8, "")  # fmt: skip
    inward = -math.cos(scene["normal"]), -math.sin(scene["normal"])
    k, _ = mobility(one, two, inward)
    u = contact_velocity(one, two)
    ut, un = dot(u, (-inward[1], inward[0])), dot(u, inward)
    power = 1.5 if isinstance(force, Hertz) else 1.0
    stiffness = (
        4.0 / 3.0 * force.contact_modulus * force.contact_radius**0.5 if power == 1.5 else force.contact_stiffness
    )
    step = found.duration / 200_000
    deflection = impulse = time = work = 0.0
    unloading = 0.0
    top = 0.0
    while True:
        if un < 0.0 and not top:
            push = stiffness * (deflection - 0.5 * step * un) ** power
        else:
            if not top:
                # from here the force falls by the same power of a smaller deflection, giving back e² of the work
                top = (power + 1.0) * scene["e"] ** 2 * work / (stiffness * deflection**power)
                peak = stiffness * deflection**power
                unloading = top
            unloading -= step * un
            if unloading <= 0.0:
                return impulse, time
            push = peak * (unloading / top) ** power
        c = -scene["mu"] * math.copysign(1.0, ut)
        if abs(ut) <= 2.0 * step * push * (abs(k.coupling) + scene["mu"] * k.tangential):
            hold = -k.coupling / k.tangential
            c = hold if abs(hold) <= scene["mu"] else -scene["mu"] * math.copysign(1.0, k.coupling)
            ut = 0.0
        deflection -= step * un
        work -= push * step * un
        un += (k.normal + k.coupling * c) * push * step
        ut += (k.coupling + k.tangential * c) * push * step
        impulse += push * step
        time += step


CALL = (
    "impact", "planar", "--first-mass", "1 kg", "--first-inertia", "0.4 kg*m^2", "--first-lever", "0, -1 m",
    "--first-velocity", "1, -2 m/s", "--second-fixed", "--normal", "-90 deg", "--friction", "0.3",
    "--restitution", "0.5",
)  # fmt: skip


def without(*names: str) -> list[str]:
    words = list(CALL)
    for name in names:
        place = words.index(name)
        del words[place : place + (1 if name == "--second-fixed" else 2)]
    return words


class TestRefusals:
    @pytest.mark.parametrize(
        ("change", "status", "code"),
        [
            (("--first-velocity", "1, 2 m/s"), 3, "no-impact"),
            (("--first-velocity", "1, 0 m/s"), 3, "no-impact"),
            (("--first-inertia", "0 kg*m^2"), 3, "no-inertia"),
            (("--first-mass", "0 kg"), 3, "no-mass"),
            (("--first-mass", "-1 kg"), 2, None),
            (("--friction", "-0.1"), 2, None),
            (("--restitution", "1.5"), 2, None),
            (("--restitution", "-0.3"), 2, None),
            (("--normal", "90 m"), 2, None),
            (("--first-velocity", "1, inf m/s"), 2, None),
            (("--first-velocity", "1e300, -1e300 m/s"), 3, "range"),
        ],
    )
    def test_bad_values(self, change: tuple[str, str], status: int, code: str | None) -> None:
        words = without(change[0])
        outcome = run(*words, *change, "--json")
        assert outcome.status == status, outcome.err
        if code:
            assert outcome.error["code"] == code

    def test_missing_normal(self) -> None:
        outcome = run(*without("--normal"), "--json")
        assert outcome.status == 2
        assert outcome.error["parameter"] == "normal"

    def test_no_inertia_of_a_struck_body(self) -> None:
        outcome = run(*without("--second-fixed"), "--second-mass", "1 kg", "--json")
        assert outcome.status == 2
        assert outcome.error["code"] == "no-inertia"

    def test_a_centre_needs_the_contact_point(self) -> None:
        outcome = run(*without("--first-lever"), "--first-centre", "0, 1 m", "--json")
        assert outcome.status == 2
        assert outcome.error["code"] == "no-contact-point"
        answer(*without("--first-lever"), "--first-centre", "0, 1 m", "--contact-point", "0, 0 m")

    def test_contradicting_closing_speed(self) -> None:
        assert run(*CALL, "--closing-speed", "3 m/s", "--json").error["code"] == "contradiction"
        answer(*CALL, "--closing-speed", "2 m/s")

    def test_far_contact_and_wrong_side_are_told(self) -> None:
        document = answer(*without("--first-lever"), "--first-lever", "9, -1 m")
        assert [one["code"] for one in document["warnings"]] == ["far-contact"]
        document = answer(*without("--first-lever"), "--first-lever", "0, 1 m")
        assert [one["code"] for one in document["warnings"]] == ["contact-behind"]

    def test_moment_restitution_has_a_range(self) -> None:
        assert (
            run(*CALL, "--law", "brach", "--moment-restitution", "1.5", "--json").error["code"] == "moment-restitution"
        )

    def test_moment_restitution_goes_with_brach(self) -> None:
        document = answer(*CALL, "--moment-restitution", "0.5")
        assert [one["code"] for one in document["warnings"]] == ["moment-ignored"]
