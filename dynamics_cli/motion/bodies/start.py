"""The start of a scene: its pose, put together with what is given left alone; its rates; joints that depend."""

import math
from itertools import product

import numpy as np

from dynamics_cli.errors import require, worded
from dynamics_cli.motion.bodies.assembly import places_of
from dynamics_cli.motion.bodies.system import System
from dynamics_cli.numerics.linkages.records import GROUND
from dynamics_cli.quantities import Size
from dynamics_cli.records import Advice

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.motion.bodies.records import Scene

CLOSED, MOVED = 1e-13, 1e-9
STEPS, LARGEST = 80, 0.5
# Smaller singular values of the conditions than this share of the largest are zero.
RANK = 1e-9
# How far a pose is moved to see whether dependent conditions stay so.
WIGGLE = 1e-3
PART = 1e-6
SIDES = (0.0, 0.5 * math.pi, -0.5 * math.pi, math.pi)
MOST_TRIES = 256


class Start:
    """The system of a scene at its start, and what is to be said of that."""

    def __init__(self, scene: "Scene", gravity: float, *, static: bool = False) -> None:
        self.static = static
        self.system = system = System(scene, gravity, static=static)
        self.advice: list[Advice] = []
        self.repeated: tuple[str, ...] = ()
        self.moved = 0.0
        self.ambiguous: tuple[str, ...] = ()
        self.near = places_of(scene, system.size) if scene.sides or scene.near else {}
        self.loose = self._loose()
        guess, self.firm = self._guess({})
        system.connect(guess)
        system.arrange()
        self.q = self._closed(guess)
        self._independent()
        if not static:
            self._require_masses()
        self.state = self._rates()

    def _loose(self) -> "list[int]":
        """Links whose angle nothing says."""
        scene = self.system.scene
        said = {driver.link for driver in scene.drivers} | {slide.slider for slide in scene.slides}
        return [
            k for k, link in enumerate(self.system.moving)
            if link.angle is None and link.position is None and link.name not in said
        ]  # fmt: skip

    def _guess(self, tried: "dict[int, float]") -> "tuple[list[float], list[bool]]":
        """Coordinates, and which of them the scene gives."""
        system = self.system
        driven = {driver.link: driver for driver in system.scene.drivers if not driver.point}
        sliders = {slide.slider for slide in system.scene.slides}
        placed = {name: complex(*system.spots[k][1:]) for (link, name), k in system.where.items() if link == GROUND}
        q, firm = [0.0] * (3 * system.n), [False] * (3 * system.n)
        waiting = list(range(system.n))
        angles = {GROUND: 0.0}
        while waiting:
            k = max(waiting, key=lambda k: self._readiness(k, placed))
            waiting.remove(k)
            link, body = system.moving[k], system.bodies[k]
            angle, driver = link.angle, driven.get(link.name)
            if angle is None and driver is not None:
                first = driver.angle_law
                value = driver.angle if first is None else _first(first)
                angle = None if value is None else value + angles.get(driver.against, 0.0)
            if angle is not None or link.position is not None or link.name in sliders:
                firm[3 * k + 2] = True
            there = [name for name in body.points if name in placed]
            ends = there if len(there) > 1 else there + [name for name in body.points if name in self.near]
            if angle is None and len(ends) > 1 and k not in tried:
                seen = {**self.near, **placed}
                one, two = ends[0], ends[-1]
                angle = float(np.angle((seen[two] - seen[one]) / ((body.points[two] - body.points[one]) or 1.0)))
            angle = tried.get(k, 0.0) if angle is None else angle
            turn = complex(math.cos(angle), math.sin(angle))
            if link.position is not None:
                centre = complex(*link.position) / system.size + turn * body.centre
                firm[3 * k] = firm[3 * k + 1] = True
            elif ends:
                centre = (placed if there else self.near)[ends[0]] - turn * body.points[ends[0]]
            else:
                centre = turn * body.centre
            q[3 * k : 3 * k + 3] = centre.real, centre.imag, angle
            angles[link.name] = angle
            for name, at in body.points.items():
                placed.setdefault(name, centre + turn * at)
        return q, firm

    def _readiness(self, k: int, placed: "dict[str, complex]") -> "tuple[bool, int, int]":
        link, body = self.system.moving[k], self.system.bodies[k]
        there = sum(name in placed for name in body.points)
        return link.position is not None, there if k in self.loose else 3 * there, -k

    def _closed(self, guess: "list[float]") -> "Any":
        """The pose that meets all conditions: what is not given moves first, then all of it, as little as it must."""
        system = self.system
        free = np.array([not given for given in self.firm])
        q = self._newton(np.array(guess), free)
        if q is None and self.loose:
            tries = list(product(SIDES, repeat=min(len(self.loose), 4)))[1:MOST_TRIES]
            for angles in tries:
                q = self._newton(np.array(self._guess(dict(zip(self.loose, angles, strict=False)))[0]), free)
                if q is not None:
                    break
        if q is not None:
            # a link with two points that others hold, and no angle given, fits on either side
            self.ambiguous = tuple(system.bodies[k].name for k in self.loose if self._held_twice(k))
            return q
        q = self._newton(np.array(guess), np.ones_like(free))
        if q is None:
            self._refuse_gap(np.array(guess))
        assert q is not None
        arms = np.array([x for body in system.bodies for x in (1.0, 1.0, max(body.reach, 1e-3))])
        self.moved = float(np.abs((q - guess)[~free] * arms[~free]).max(initial=0.0)) * system.size
        if self.moved > MOVED * system.size:
            words = worded("the start as given does not close: it was moved by up to {gap}", gap=(self.moved, Size))
            self.advice.append(Advice("assembled", words, remedy="see the start with --at '0 s'"))
        return q

    def _held_twice(self, k: int) -> bool:
        name = self.system.bodies[k].name
        if set(self.system.bodies[k].points) & set(self.near):
            return False
        others = [joint for joint in self.system.joints if name in (joint.link, joint.by) and joint.kind != "driver"]
        return len(others) > 1

    def _newton(self, q: "Any", free: "Any") -> "Any | None":
        for _ in range(STEPS):
            f = self._frame(q)
            missed = self.system.gaps(0.0, f)
            if np.abs(missed).max(initial=0.0) <= CLOSED:
                return q
            if not free.any():
                return None
            jacobian = self.system.jacobian(0.0, f)[:, free]
            step = -np.linalg.lstsq(jacobian, missed, rcond=1e-10)[0]
            q = q.copy()
            q[free] += step * min(1.0, LARGEST / max(np.abs(step).max(initial=0.0), 1e-300))
        return q if np.abs(self.system.gaps(0.0, self._frame(q))).max(initial=0.0) <= 1e2 * CLOSED else None

    def _frame(self, q: "Any") -> "Any":
        return self.system.frame_of([*q, *[0.0] * (3 * self.system.n + len(self.system.phases) + 3)])

    def _refuse_gap(self, q: "Any") -> None:
        """Least squares by damped steps; then the joint that misses most takes the whole gap."""
        system, weights = self.system, np.ones(self.system.rows)
        for _ in range(2):
            for _ in range(4 * STEPS):
                f = self._frame(q)
                jacobian, missed = system.jacobian(0.0, f) * weights[:, None], system.gaps(0.0, f) * weights
                normal = jacobian.T @ jacobian + 1e-3 * np.eye(len(q))
                q = q - np.linalg.solve(normal, jacobian.T @ missed)
            missed = system.gaps(0.0, self._frame(q))
            sizes = [math.hypot(*missed[joint.rows()]) for joint in system.joints]
            joint = system.joints[int(np.argmax(sizes))]
            weights[:] = 30.0
            weights[joint.rows()] = 1.0
        gap = max(sizes)
        hint = "change a length by about that much, or the angles of the start"
        require(False, "the scene cannot be put together: {joint} misses by {gap}", joint=_named(joint),
                gap=(float(gap) * system.size, Size), code="cannot-be-closed", hint=hint)  # fmt: skip

    def _independent(self) -> None:
        """Leave out conditions that repeat others everywhere; refuse those that do so at this pose alone."""
        system = self.system
        jacobian = system.jacobian(0.0, self._frame(self.q))
        driven = {part.row for part in system.driven}
        passive = [row for row in range(system.rows) if row not in driven]
        kept, null = _basis(jacobian[passive])
        if len(kept) < len(passive):
            involved = [passive[k] for k in np.flatnonzero(np.abs(null).max(axis=1) > PART)]
            names = self._names(involved)
            require(self._repeat(passive, kept), "at the start the conditions of {names} depend on each other: a "
                    "change point, from which the scene can go on in several ways", names=", ".join(names),
                    code="singular", hint="begin a little beside it")  # fmt: skip
            self.repeated = tuple(names)
            system.left = set(involved)
            words = f"the scene is over-constrained: {', '.join(names)} repeat what others hold"
            self.advice.append(Advice("over-constrained", words, remedy="their forces are not determined"))
        rows = sorted([passive[k] for k in kept] + list(driven))
        count, _ = _basis(jacobian[rows])
        require(len(count) == len(rows), "the driver of {names} moves what the joints or another driver hold",
                names=" or ".join(self._names(sorted(driven))), code="over-driven",
                hint="leave a driver out")  # fmt: skip
        system.arrange(rows)
        self.freedom = system.end - len(rows)
        moving = any(part.motion.of_rate or any(part.motion.law(t)[1] for t in (0.0, 0.37, 1.0)) or part.motion.knots
                     for part in system.driven)  # fmt: skip
        require(self.freedom > 0 or moving or self.static, "nothing can move: the joints hold every link", code="rigid",
                hint="leave a joint out: {names}", names=", ".join(system.joints[k].name for k in range(
                    min(4, len(system.joints)))))  # fmt: skip

    def _repeat(self, passive: "list[int]", kept: "list[int]") -> bool:
        """Whether the conditions left out hold beside this pose too."""
        system = self.system
        rows = [passive[k] for k in kept]
        jacobian = system.jacobian(0.0, self._frame(self.q))[rows]
        free = np.linalg.svd(jacobian)[2][len(rows) :]
        for way in free:
            q = self.q + WIGGLE * way
            for _ in range(12):
                f = self._frame(q)
                q = q - np.linalg.lstsq(system.jacobian(0.0, f)[rows], system.gaps(0.0, f)[rows], rcond=1e-12)[0]
            if np.abs(system.gaps(0.0, self._frame(q))[passive]).max() > 1e-10:
                return False
        return True

    def _names(self, rows: "list[int]") -> "list[str]":
        return list(dict.fromkeys(_named(joint) for joint in self.system.joints if set(joint.rows()) & set(rows)))

    def _require_masses(self) -> None:
        """Refuse motions in which nothing with a mass takes part."""
        system = self.system
        free = np.linalg.svd(system.jacobian(0.0, self._frame(self.q)))[2][system.m :]
        if not len(free):
            return
        values, vectors = np.linalg.eigh((free * system.masses) @ free.T)
        lightest = np.abs(vectors[:, 0] @ free)
        body = system.bodies[int(lightest.argmax()) // 3]
        turning = int(lightest.argmax()) % 3 == 2
        require(values[0] > 1e-14 * values[-1] and values[-1] > 0.0, "{name} can {move} without moving any mass",
                name=body.name, move="turn" if turning else "move", code="massless",
                hint="give it a moment of inertia" if turning else "give it a mass")  # fmt: skip

    def _rates(self) -> "Any":
        """The state at the start: rates given are kept where joints allow it, the rest follow as from a blow."""
        system, end = self.system, self.system.end
        state = np.concatenate((self.q, np.zeros(end + len(system.phases) + 3)))
        firm = np.zeros(end, dtype=bool)
        f = system.frame_of(state)
        for k, (link, body) in enumerate(zip(system.moving, system.bodies, strict=True)):
            if link.speed is not None:
                state[end + 3 * k + 2], firm[3 * k + 2] = link.speed, True
            if link.velocity is not None:
                arm = complex(f.c[k], f.s[k]) * body.centre
                speed = complex(*link.velocity) / system.size + 1j * (link.speed or 0.0) * arm
                state[end + 3 * k : end + 3 * k + 2], firm[3 * k : 3 * k + 2] = (speed.real, speed.imag), True
        given = state[end : 2 * end].copy()
        slipped = system.drives(0.0) - system.jacobian(0.0, f) @ given
        if not np.abs(slipped).max(initial=0.0):
            return state
        scale = max(np.abs(given).max(initial=0.0), np.abs(system.drives(0.0)).max(initial=0.0))
        for free in (~firm, np.ones(end, dtype=bool)):
            change = self._blow(f, free, slipped)
            if np.abs(system.jacobian(0.0, f) @ (given + change) - system.drives(0.0)).max() <= 1e-9 * scale:
                break
        state[end : 2 * end] += change
        changed = np.abs(change[firm]).max(initial=0.0)
        if changed > 1e-9 * scale:
            name = system.bodies[int(np.abs(np.where(firm, change, 0.0)).argmax()) // 3].name
            words = f"the joints do not allow the rates given: those of {name} and others were changed"
            self.advice.append(Advice("rates", words, remedy="see the start with --at '0 s'"))
        return system.projected(0.0, state, CLOSED)

    def _blow(self, f: "Any", free: "Any", slipped: "Any") -> "Any":
        """The change of the free rates that joints and drivers demand, with the least kinetic energy."""
        system, end = self.system, self.system.end
        a, _ = system.matrix(0.0, f)
        chosen = np.concatenate((np.flatnonzero(free), np.arange(end, end + system.m)))
        right = np.concatenate((np.zeros(int(free.sum())), slipped))
        out = np.zeros(end)
        out[free] = np.linalg.lstsq(a[np.ix_(chosen, chosen)], right, rcond=1e-13)[0][: int(free.sum())]
        return out


def _first(formula: "Any") -> float:
    from dynamics_cli.numerics.expressions.laws import law_of

    return float(law_of(formula, (), ("t",))(t=0.0))


def _basis(rows: "Any") -> "tuple[list[int], Any]":
    """Independent rows, and for all rows the combinations that vanish."""
    if not rows.size:
        return [], np.zeros((len(rows), 0))
    from scipy.linalg import qr

    u, values, _ = np.linalg.svd(rows)
    rank = int((values > RANK * values[0]).sum())
    order = qr(rows.T, mode="r", pivoting=True)[1]
    return sorted(int(k) for k in order[:rank]), u[:, rank:]


def _named(joint: "Any") -> str:
    return f"pin {joint.name}" if joint.kind == "pin" else joint.name
