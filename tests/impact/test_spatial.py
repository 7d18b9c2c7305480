"""Impacts in space: references in many digits, a tight integration, the planar limit, invariants, refusals."""

import math
import random
from typing import Any

import numpy as np
import pytest
from harness import answer, run
from mpmath import mp, mpf
from references import impact_keller
from references.comparison import cases
from references.generate_impact_spatial_references import answered, box, impacts, reported, scenes

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.impact.conventions import ByMass, Fixed, Restituted
from dynamics_cli.impact.planar import path
from dynamics_cli.impact.spatial.hodograph import travel
from dynamics_cli.impact.spatial.impact import (
    BodyInSpace,
    LeverInSpace,
    SpatialLaw,
    TargetInSpace,
    spatial,
)
from dynamics_cli.impact.spatial.results import SpatialImpact
from dynamics_cli.impact.spatial.straight_slip import Slip, settled, stick_ratio, way_out

FILE = "impact_spatial.json"
LAWS = ("stronge", "newton", "poisson")
EVERY = cases(FILE, "keller")
WHOLE = cases(FILE, "spatial")


# Of the impulse, as often as K enlarges them.
ROUNDED = 5e-16


def kernel(case: dict[str, Any]) -> Any:
    inputs = case["inputs"]
    k = tuple(tuple(float(x) for x in row) for row in inputs["mobility"])
    u = tuple(float(x) for x in inputs["velocity"])
    return travel(k, u, float(inputs["friction"]), float(inputs["restitution"]), inputs["law"]["word"])


@pytest.mark.parametrize("case", EVERY, ids=[case["name"] for case in EVERY])
def test_impulses_in_doubles_are_right_to_a_few_roundings(case: dict[str, Any]) -> None:
    mp.dps = 40
    found = kernel(case)
    exact = [mpf(case["results"][f"impulse[{i}]"]) for i in range(3)]
    size = mp.sqrt(sum(x * x for x in exact))
    k, u = case["inputs"]["mobility"], case["inputs"]["velocity"]
    stretch = max(1.0, max(float(k[i][i]) for i in range(3)) * float(size) / -float(u[2]))
    limit = ROUNDED * stretch * size
    assert max(abs(mpf(a) - b) for a, b in zip(found.impulse, exact, strict=True)) <= limit
    assert abs(mpf(found.compression) - mpf(case["results"]["compression"])) <= limit


def test_the_references_are_hard_enough() -> None:
    hard = [case for case in EVERY if case["kind"] == "hard"]
    assert len(hard) >= 20
    assert {kernel(case).history for case in EVERY} >= {
        "slip",
        "slip, stick",
        "slip, slip anew",
        "stick",
        "slip from rest",
    }


def test_a_reference_made_again_is_the_same() -> None:
    for scene in scenes()[3:11]:
        assert answered(scene) == next(case for case in EVERY if case["name"] == scene[0])
    for impact in impacts()[:2] + impacts()[15:16]:
        assert reported(impact) == next(case for case in WHOLE if case["name"] == impact[0])


def test_references_do_not_depend_on_order_and_bits() -> None:
    scene = scenes()[0][3:]
    usual, again = (
        impact_keller.reference(*scene),
        impact_keller.reference(*scene, impact_keller.Effort(230, 80, 165, 185)),
    )
    size = max(map(abs, usual.impulse))
    for one, other in zip((*usual.impulse, usual.heat), (*again.impulse, again.heat), strict=True):
        assert abs(mpf(str(one - other))) <= mpf("1e-42") * mpf(str(size))


def matrix(r: Any, floor: float = 0.05) -> tuple[tuple[float, ...], ...]:
    rows = r.normal(size=(3, 3))
    full = rows @ rows.T + floor * np.eye(3)
    return tuple(tuple(float(full[min(i, j)][max(i, j)]) for j in range(3)) for i in range(3))


@pytest.mark.parametrize("law", LAWS)
def test_velocities_and_energy_follow_from_the_impulse(law: str) -> None:
    r = np.random.default_rng(5)
    histories = set()
    for _ in range(120):
        k, mu, e = matrix(r), float(r.uniform(0.0, 1.5)), float(r.uniform(0.0, 1.0))
        u = float(r.normal(0.0, 2.0)), float(r.normal(0.0, 2.0)), -float(r.uniform(0.1, 3.0))
        end = travel(k, u, mu, e, law)
        histories.add(end.history)
        p, full = np.array(end.impulse), np.array(k)
        size = np.abs(u).max() + np.abs(full @ p).max()
        assert np.abs(np.array(u) + full @ p - end.velocity).max() <= 1e-13 * size
        work = p @ u + 0.5 * p @ full @ p
        assert abs(work - (end.work_back - end.work - end.heat)) <= 1e-12 * (end.work + end.heat)
        assert math.hypot(p[0], p[1]) <= mu * p[2] * (1.0 + 1e-13)
    assert histories >= {"slip", "slip, stick"}


def test_a_tight_integration_by_impulse_agrees() -> None:
    from scipy.integrate import solve_ivp

    r = np.random.default_rng(3)
    compared = 0
    for _ in range(25):
        k, mu, e = matrix(r, 0.1), float(r.uniform(0.0, 0.6)), float(r.uniform(0.0, 1.0))
        u = float(r.normal(0.0, 3.0)), float(r.normal(0.0, 3.0)), -float(r.uniform(0.1, 1.0))
        end = travel(k, u, mu, e, "stronge")
        if end.history != "slip":
            continue
        full = np.array(k)

        def rates(_: float, y: Any, mu: float = mu, full: Any = full) -> Any:
            size = math.hypot(y[0], y[1])
            c = np.array([-mu * y[0] / size, -mu * y[1] / size, 1.0])
            return [*(full @ c), y[2], c[0], c[1]]

        found = solve_ivp(rates, [0.0, end.impulse[2]], [*u, 0.0, 0.0, 0.0], method="DOP853", rtol=1e-13, atol=1e-15)
        y = found.y[:, -1]
        size = np.linalg.norm(end.impulse)
        assert abs(y[4] - end.impulse[0]) + abs(y[5] - end.impulse[1]) <= 1e-11 * size
        assert np.abs(y[:3] - end.velocity).max() <= 1e-11 * (np.abs(u).max() + size * np.abs(full).max())
        # the law's end is where it says: the work given back is e² of that done
        assert y[3] == pytest.approx(-(1.0 - e * e) * end.work, rel=1e-9, abs=1e-11 * end.work)
        compared += 1
    assert compared >= 15


@pytest.mark.parametrize("law", LAWS)
def test_in_a_plane_it_is_the_closed_form(law: str) -> None:
    r = random.Random(2)
    for _ in range(100):
        kt, kn = r.uniform(1.0, 4.0), r.uniform(1.0, 4.0)
        kx = r.uniform(-0.9, 0.9) * math.sqrt(kt * kn)
        mu, e = r.uniform(0.0, 1.2), r.uniform(0.0, 1.0)
        ut, un = r.uniform(-3.0, 3.0), -r.uniform(0.1, 2.0)
        flat = path.travel(path.Mobility(kt, kx, kn, path.determinant(kt, kx, kn)), ut, un, mu, e, law)
        end = travel(((kt, 0.0, kx), (0.0, 2.0, 0.0), (kx, 0.0, kn)), (ut, 0.0, un), mu, e, law)
        size = math.hypot(flat.normal, flat.tangential)
        assert end.impulse[2] == pytest.approx(flat.normal, abs=1e-14 * size)
        assert end.impulse[0] == pytest.approx(flat.tangential, abs=1e-14 * size)
        assert end.impulse[1] == 0.0
        assert end.heat == pytest.approx(flat.friction_work, abs=1e-13 * (flat.friction_work + flat.compression_work))


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("thin", [1e2, 1e4, 1e8, 1e12])
def test_a_contact_that_gives_way_far_more_along_one_tangent(thin: float, law: str) -> None:
    r = np.random.default_rng(7)
    histories = set()
    for _ in range(40):
        k = np.array(matrix(r, 0.2)) + np.diag([thin * float(r.uniform(1.0, 2.0)), 0.0, 0.0])
        u = float(r.normal(0.0, 2.0)), float(r.normal(0.0, 2.0)), -float(r.uniform(0.1, 3.0))
        mu, e = float(r.uniform(0.1, 1.5)), float(r.uniform(0.0, 1.0))
        end = travel(tuple(map(tuple, k.tolist())), u, mu, e, law)
        histories.add(end.history)
        # slip along the yielding tangent is gone at once, so that few steps tell how it turns away from it
        assert end.steps <= 200
        p = np.array(end.impulse)
        assert np.abs(np.array(u) + k @ p - end.velocity).max() <= 1e-12 * (np.abs(u).max() + np.abs(k * p).max())
        work = p @ u + 0.5 * p @ k @ p
        assert abs(work - (end.work_back - end.work - end.heat)) <= 1e-11 * (end.work + end.heat)
    assert len(histories) >= 2


def test_slip_that_keeps_its_direction_is_followed_in_closed_form() -> None:
    k = ((2.0, 0.0, -1.0), (0.0, 3.0, 0.0), (-1.0, 0.0, 2.0))
    for x in (0.5, -0.5):
        slip = Slip([x, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0])
        assert settled(k, 0.4, slip) == (math.copysign(1.0, x), 0.0)
    slip = Slip([0.5, 1e-20, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0])
    assert settled(k, 0.4, slip) is None  # turning aside, it goes on turning
    turned = Slip([-0.5, 1e-9, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0])
    assert settled(k, 0.4, turned) is None


@pytest.mark.parametrize("law", LAWS)
def test_certificates_hold_for_slender_bodies_on_long_levers(law: str) -> None:
    r = random.Random(f"slender {law}")

    def three(reach: float) -> tuple[float, ...]:
        return tuple(r.uniform(-reach, reach) for _ in range(3))

    def body() -> BodyInSpace:
        mass = 10.0 ** r.uniform(-6.0, 6.0)
        sides = [10.0 ** r.uniform(-4.0, 1.0) for _ in range(3)]
        tensor = box(mass, *sides, *three(3.0))
        return BodyInSpace(
            ByMass(mass), tensor, LeverInSpace(three(10.0 ** r.uniform(-2.0, 1.5))), three(30.0), three(50.0)
        )

    answered = 0
    for _ in range(50):
        one, two = body(), body()
        target = TargetInSpace(two.bulk, two.inertia, two.arm, two.velocity, two.spin)
        try:
            found = spatial(first=one, second=target, normal=three(1.0), friction=r.uniform(0.0, 1.5),
                            contact=Restituted(r.uniform(0.0, 1.0)), law=SpatialLaw(law))  # fmt: skip
        except InadmissibleError as error:
            if error.code not in ("no-impact", "energy-gained", "singular"):
                raise
            continue
        answered += 1
        assert all(check.passed for check in found.checks), [check for check in found.checks if not check.passed]
    assert answered >= 15


def test_a_contact_that_gives_way_in_one_direction_alone_is_refused() -> None:
    k = ((1.0, 0.0, -2.0), (0.0, 1.0, 0.0), (-2.0, 0.0, 4.0))
    with pytest.raises(InadmissibleError, match="one direction only"):
        travel(k, (0.0, 0.0, -1.0), 3.0, 0.5, "stronge")


def test_the_way_out_keeps_its_direction_and_grows() -> None:
    r = np.random.default_rng(8)
    found = 0
    while found < 50:
        k = matrix(r)
        held = math.hypot(*stick_ratio(k))
        mu = held * float(r.uniform(0.0, 1.0))
        if mu == 0.0:
            continue
        x, y = way_out(k, mu)
        rate = [k[i][2] - mu * (k[i][0] * x + k[i][1] * y) for i in (0, 1)]
        assert abs(rate[0] * y - rate[1] * x) <= 1e-12 * (abs(k[0][2]) + abs(k[1][2]) + mu * k[0][0])
        assert rate[0] * x + rate[1] * y > 0.0
        found += 1


BLOCK = ((0.02, 0.0, 0.0), (0.0, 0.03, 0.004), (0.0, 0.004, 0.04))


def thrown(law: str = "stronge", friction: float = 0.4, restitution: float = 0.6, **change: Any) -> SpatialImpact:
    body = {
        "bulk": ByMass(2.0), "inertia": BLOCK, "arm": LeverInSpace((0.1, 0.05, -0.2)), "velocity": (3.0, 1.0, -4.0),
        "spin": (0.0, 5.0, 2.0),
    }  # fmt: skip
    return spatial(
        first=BodyInSpace(**{**body, **change}),
        second=TargetInSpace(Fixed(True)),
        normal=(0.0, 0.0, -1.0),
        friction=friction,
        contact=Restituted(restitution),
        law=SpatialLaw(law),
    )


def rotation(seed: int) -> Any:
    q, _ = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))
    return q * np.sign(np.linalg.det(q))


def test_turning_the_axes_turns_the_answer() -> None:
    base = thrown()
    for seed in range(5):
        q = rotation(seed)
        inertia = q @ np.array(BLOCK) @ q.T
        symmetric = tuple(tuple(float(inertia[min(i, j)][max(i, j)]) for j in range(3)) for i in range(3))

        def turn(v: tuple[float, ...], q: Any = q) -> tuple[float, ...]:
            return tuple(float(x) for x in q @ np.array(v))

        found = spatial(
            first=BodyInSpace(ByMass(2.0), symmetric, LeverInSpace(turn((0.1, 0.05, -0.2))), turn((3.0, 1.0, -4.0)),
                              turn((0.0, 5.0, 2.0))),
            second=TargetInSpace(Fixed(True)),
            normal=turn((0.0, 0.0, -3.0)),
            friction=0.4,
            contact=Restituted(0.6),
        )  # fmt: skip
        assert found.normal_impulse == pytest.approx(base.normal_impulse, rel=1e-12)
        assert found.first.velocity == pytest.approx(turn(base.first.velocity), rel=1e-11)
        assert found.first.spin == pytest.approx(turn(base.first.spin), rel=1e-11)
        assert found.energy_lost == pytest.approx(base.energy_lost, rel=1e-11)


@pytest.mark.parametrize("law", LAWS)
def test_the_certificate_holds(law: str) -> None:
    found = thrown(law)
    assert len(found.checks) >= 8
    assert all(check.passed for check in found.checks)
    smooth = thrown(law, friction=0.0)
    assert smooth.slip_history == "slip without friction"
    assert smooth.tangential_impulse == 0.0
    assert smooth.energy_lost_tangential == 0.0


def test_exchanging_the_bodies() -> None:
    one = BodyInSpace(ByMass(2.0), BLOCK, LeverInSpace((0.1, 0.05, -0.2)), (3.0, 1.0, -4.0), (0.0, 5.0, 2.0))
    two = BodyInSpace(
        ByMass(3.0), ((0.05, 0.0, 0.0), (0.0, 0.05, 0.0), (0.0, 0.0, 0.05)), LeverInSpace((0.0, 0.1, 0.2))
    )

    def target(body: BodyInSpace) -> TargetInSpace:
        return TargetInSpace(body.bulk, body.inertia, body.arm, body.velocity, body.spin)

    a = spatial(first=one, second=target(two), normal=(0.0, 0.0, -1.0), friction=0.3, contact=Restituted(0.5))
    b = spatial(first=two, second=target(one), normal=(0.0, 0.0, 1.0), friction=0.3, contact=Restituted(0.5))
    assert b.second.velocity == pytest.approx(a.first.velocity, rel=1e-12)
    assert b.first.spin == pytest.approx(a.second.spin, rel=1e-11)


CALL = (
    "impact", "spatial", "--first-mass", "2 kg", "--first-inertia", "[[0.02, 0, 0], [0, 0.03, 0], [0, 0, 0.04]] kg*m^2",
    "--first-lever", "0.1, 0.05, -0.2 m", "--first-velocity", "3, 1, -4 m/s", "--second-fixed", "--normal", "0, 0, -1",
    "--friction", "0.4", "--restitution", "0.6",
)  # fmt: skip


class TestRefusals:
    @pytest.mark.parametrize(
        ("option", "value", "status", "code"),
        [
            ("--first-velocity", "3, 1, 4 m/s", 3, "no-impact"),
            ("--normal", "0, 0, 0", 3, "no-normal"),
            ("--first-inertia", "[[0, 0, 0], [0, 0, 0], [0, 0, 0]] kg*m^2", 3, "no-inertia"),
            ("--first-inertia", "[[1, 0, 0], [0, 1, 0], [0, 0, 3]] kg*m^2", 3, "no-body"),
            ("--first-mass", "0 kg", 3, "no-mass"),
            ("--friction", "-1", 2, None),
            ("--restitution", "2", 2, None),
            ("--first-lever", "1, 2 m", 2, None),
        ],
    )
    def test_bad_values(self, option: str, value: str, status: int, code: str | None) -> None:
        words = list(CALL)
        words[words.index(option) + 1] = value
        outcome = run(*words, "--json")
        assert outcome.status == status, outcome.err
        if code:
            assert outcome.error["code"] == code

    def test_bounds_are_stated(self) -> None:
        document = answer(*CALL)
        bounds, results = document["numerics"]["error_bound"], document["results"]
        assert bounds.keys() >= results.keys() - {"first", "second", "law", "slip_history"}
        assert 1e-16 <= bounds["impulse_magnitude"]["relative"] <= 4e-16
        assert bounds["first.spin"]["unit"] == results["first"]["spin"]["unit"]

    def test_slip_that_a_rounded_normal_lets_into_the_closing_speed_is_told_from_it(self) -> None:
        words = list(CALL)
        words[words.index("--normal") + 1] = "1e-3, 0, -1"
        words[words.index("--first-velocity") + 1] = "300, 1, 0.299999999 m/s"
        document = answer(*words)
        with mp.workdps(60):
            x, z = mpf(1e-3), mpf(-1)
            exact = (300 * x + mpf(0.299999999) * z) / mp.sqrt(x * x + z * z)
        found = document["results"]["closing_speed"]
        assert found["unit"] == "m/s"
        assert abs(mpf(found["value"]) - exact) <= 4e-16 * exact
        assert document["numerics"]["error_bound"]["closing_speed"]["relative"] <= 4e-16

    @pytest.mark.parametrize(
        ("mass", "lever", "velocity", "friction"),
        [
            ("1e-30 kg", "1, 2, 0 m", "1, 1, 2 m/s", "100"),
            ("1 kg", "1, 2, 3 m", "1, 1, 2 m/s", "1e200"),
            ("1 kg", "1, 0, 0 m", "1, 1, 2 m/s", "1e-300"),
            ("1 kg", "1, 2, 3 m", "1, 1e-9, 0 m/s", "1e-300"),
            ("1e30 kg", "1, 2, 3 m", "1e-9, 1, 2 m/s", "0.3"),
            ("1 kg", "1e9, 2, 3 m", "1, 1, 2 m/s", "0.3"),
        ],
    )
    def test_sizes_far_from_one(self, mass: str, lever: str, velocity: str, friction: str) -> None:
        size = float(mass.split()[0])
        inertia = f"[[{size}, 0, 0], [0, {1.2 * size}, 0], [0, 0, {1.1 * size}]] kg*m^2"
        document = answer(
            "impact", "spatial", "--first-mass", mass, "--first-inertia", inertia,
            "--first-lever", lever, "--first-velocity", velocity, "--second-fixed", "--normal", "1, 0, 0",
            "--friction", friction, "--restitution", "0.4",
        )  # fmt: skip
        assert document["results"]["normal_impulse"]["value"] > 0.0
