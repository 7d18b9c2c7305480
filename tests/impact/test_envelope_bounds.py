"""Bounds of envelopes: every point of small grids followed event by event in 50 digits."""

import random
from typing import Any

import numpy as np
import pytest
from mpmath import mp, mpf
from references.impact_events import brach, follow, kudlich_slibar

from dynamics_cli.impact.conventions import ByMass, ByVelocity, Fixed
from dynamics_cli.impact.planar.bodies import ByInertia, Lever, RigidBody, RigidTarget
from dynamics_cli.impact.planar.envelope import envelope
from dynamics_cli.impact.planar.envelope_records import Envelope
from dynamics_cli.impact.planar.laws import LAWS, Law

UNIT_ROUNDOFF = 2.0**-53
Pair = tuple[float, float]


def region(seed: str) -> dict[str, Any]:
    """Two bodies or a wall, whose closing speed may cancel to its last digits."""
    r = random.Random(seed)

    def body(kind: Any) -> Any:
        mass = 10.0 ** r.uniform(-2.0, 4.0)
        lever = Lever((r.uniform(-2.0, 2.0), r.uniform(-2.0, 2.0)))
        motion = ByVelocity((r.uniform(-20.0, 20.0), r.uniform(-20.0, 20.0)))
        return kind(ByMass(mass), ByInertia(mass * 10.0 ** r.uniform(-2.0, 1.0)), lever, motion, r.uniform(-3.0, 3.0))

    first = body(RigidBody)
    wall = r.random() < 0.5
    second = RigidTarget(Fixed(True), motion=ByVelocity((0.0, 0.0))) if wall else body(RigidTarget)
    u = np.subtract(*(moved(one) for one in (first, second)))
    # along the sliding but for a little: what closes is a small part of the speed
    across = np.arctan2(u[1], u[0]) + np.pi / 2
    angle = float(across - 10.0 ** r.uniform(-9.0, 0.3) * (1.0 if r.random() < 0.5 else 1e-3))
    return {"first": first, "second": second, "normal": angle}


def moved(body: Any) -> Pair:
    """Velocity of its point at the contact."""
    x, y = (0.0, 0.0) if isinstance(body.bulk, Fixed) else body.arm.lever
    return body.motion.velocity[0] - body.spin * y, body.motion.velocity[1] + body.spin * x


class Contact:
    """The contact in 50 digits, by unit impulses."""

    def __init__(self, given: dict[str, Any]) -> None:
        angle = mpf(given["normal"])
        n = -mp.cos(angle), -mp.sin(angle)
        t = -n[1], n[0]
        self.axes = t, n
        self.bodies = [given["first"], given["second"]]
        one, two = (self.velocity(body) for body in self.bodies)
        u = one[0] - two[0], one[1] - two[1]
        self.slip, self.approach = (u[0] * axis[0] + u[1] * axis[1] for axis in self.axes)
        self.k = [[sum(self.answer(body, a, b) for body in self.bodies) for b in self.axes] for a in self.axes]
        self.turns = [None if isinstance(b.bulk, Fixed) else [self.turn(b, a) for a in self.axes] for b in self.bodies]

    def velocity(self, body: Any) -> Any:
        v = [mpf(part) for part in body.motion.velocity]
        if isinstance(body.bulk, Fixed):
            return v
        x, y = map(mpf, body.arm.lever)
        return v[0] - mpf(body.spin) * y, v[1] + mpf(body.spin) * x

    def turn(self, body: Any, axis: Any) -> Any:
        """Change of spin from a unit impulse along an axis."""
        x, y = map(mpf, body.arm.lever)
        return (x * axis[1] - y * axis[0]) / mpf(body.turning.inertia)

    def answer(self, body: Any, along: Any, seen: Any) -> Any:
        """Change of velocity at the contact along one axis from a unit impulse along the other."""
        if isinstance(body.bulk, Fixed):
            return mpf(0)
        x, y = map(mpf, body.arm.lever)
        w = self.turn(body, along)
        m = mpf(body.bulk.mass)
        return (along[0] / m - w * y) * seen[0] + (along[1] / m + w * x) * seen[1]

    def point(self, mu: float, e: float, law: str) -> dict[str, Any] | None:
        """All that has extremes, at one point; nothing where the law gains energy or does not push."""
        k = self.k[0][0], self.k[0][1], self.k[1][1]
        given = (*k, self.slip, self.approach, mu, e)
        if law in ("brach", "kudlich-slibar"):
            pt, pn = (brach if law == "brach" else kudlich_slibar)(*given)
        else:
            end = follow(*given, law)
            pt, pn = end["tangential"], end["normal"]
        if pn <= 0:
            return None
        after = self.slip + k[0] * pt + k[1] * pn, self.approach + k[1] * pt + k[2] * pn
        lost = -(pt * (self.slip + after[0]) + pn * (self.approach + after[1])) / 2
        if lost < -mpf("1e-12") * (abs(pn * self.approach) + abs(pt * self.slip)) and law != "stronge":
            return None
        size = mp.sqrt(pn * pn + pt * pt)
        found = {"energy": lost}
        for name, body, turn, way in zip(("first", "second"), self.bodies, self.turns, (1, -1), strict=True):
            if turn is not None:
                found[f"{name}_delta_v"] = size / mpf(body.bulk.mass)
                found[f"{name}_spin_change"] = way * (turn[0] * pt + turn[1] * pn)
        return found


def judge(found: Envelope, exact: list[dict[str, Any]], *, tight: bool = True) -> int:
    """Every bound holds, and if tight is no more than a hundred times the error or half a last bit of the largest."""
    assert found.numerics is not None
    judged = 0
    for bound in found.numerics.bounds:
        name, _, end = bound.result.replace("_energy_lost", ".energy").partition(".")
        name, end = (name, end) if end != "energy" else ("energy", name)
        every = [point[name] for point in exact]
        true = min(every) if end == "least" else max(every)
        record = getattr(found, name, None)
        value = getattr(found, f"{end}_energy_lost") if record is None else getattr(record, end)
        width = bound.bound * (abs(value) if bound.relative else 1.0)
        error = abs(mpf(value) - true)
        size = max(map(abs, every))
        assert error <= width + size * mpf("1e-40"), (bound, value, true)
        assert not tight or width <= 100.0 * max(error, UNIT_ROUNDOFF * size), (bound, value, true)
        judged += 1
    return judged


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("seed", range(6))
def test_extremes_of_a_grid_hold_their_bounds(law: str, seed: int) -> None:
    given = region(f"envelope {seed}")
    found = envelope(**given, law=Law(law), restitution_points=7, friction_points=9, greatest_friction=1.3)
    with mp.workdps(50):
        contact = Contact(given)
        places = [(float(mu), float(e)) for mu in np.linspace(0.0, 1.3, 9) for e in np.linspace(0.0, 1.0, 7)]
        exact = [point for place in places if (point := contact.point(*place, law)) is not None]
        assert judge(found, exact) >= 6


def test_a_plateau_of_thousands_of_points_is_bounded_too() -> None:
    # where friction holds the contact all the way, ΔV does not depend on it: doubles cannot tell these points apart
    ball = RigidBody(ByMass(3.0), ByInertia(0.1), Lever((0.3, -0.4)), ByVelocity((0.0, -2.0)))
    given = {"first": ball, "second": RigidTarget(Fixed(True)), "normal": -1.5707963267948966}
    found = envelope(**given, restitution_points=3, friction_points=4000, least_friction=5.0, greatest_friction=9.0)
    with mp.workdps(50):
        contact = Contact(given)
        assert judge(found, [contact.point(5.0, e, "stronge") for e in (0.0, 0.5, 1.0)]) == 6


@pytest.mark.parametrize("law", LAWS)
def test_a_lever_longer_than_all_sense_is_bounded(law: str) -> None:
    # det K is 1e-45 of the products that it is the difference of: doubles say nothing of the energy, and it is told
    first = RigidBody(
        ByMass(1471.3152549403676), ByInertia(2508.5022233840414), Lever((1.65e23, -0.4)), ByVelocity((2.5e23, 0.0))
    )
    second = RigidTarget(
        ByMass(1.5e23), ByInertia(2.5e23), Lever((0.0, 0.27643400391615536)), motion=ByVelocity((0.0, 3.0))
    )
    given: dict[str, Any] = {"first": first, "second": second, "normal": 0.1}
    found = envelope(
        **given, law=Law(law), restitution_points=3, friction_points=2, least_friction=0.48524490050764146,
        least_restitution=0.1829375989272593, greatest_friction=1.3856614607109112, map_points=2,
    )  # fmt: skip
    e, mu = np.linspace(0.1829375989272593, 1.0, 3).tolist(), (0.48524490050764146, 1.3856614607109112)
    with mp.workdps(160):
        exact = [Contact(given).point(m, r, law) for m in mu for r in e]
        assert None not in exact
        assert found.refused == 0
        assert judge(found, exact, tight=False) >= 6
