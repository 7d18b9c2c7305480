"""Approach speeds from rest positions: impact and slides driven forward, least squares to where the vehicles ended."""

from dynamics_cli.errors import require, worded
from dynamics_cli.impact.conventions import Axes, direction_of
from dynamics_cli.impact.inverse.fit import SETTLED, Fit, Side, stepped
from dynamics_cli.impact.inverse.records import Departing, InverseResult, KnownContact, RestAfter, TurningAfter
from dynamics_cli.impact.slide.motion import run
from dynamics_cli.impact.slide.task import car_of, heading_angle, shares_of
from dynamics_cli.impact.slide.wheels import State
from dynamics_cli.numerics.elementary import cos, hypot, sin, sqrt
from dynamics_cli.quantities import Angle, Ratio
from dynamics_cli.records import Advice

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    Pair = tuple[float, float]

MOST_STEPS = 60
# Differences for derivatives, of unknowns that are speeds of metres a second and ratios of order one.
SMOOTH_STEP, ROUGH_STEP = 1e-6, 1e-3
FINE = 1e-8
# Twenty degrees: beyond this turn the tyre forces of a straight slide no longer apply.
FAR = 0.3490658503988659
STARTS = (1.0, 0.6, 1.6)


class Contact:
    """Known data of the contact: normal from the second to the first, restitution and ratio of impulses."""

    def __init__(self, inward: "Pair", restitution: "Pair", ratio: "Pair") -> None:
        self.inward = inward
        self.across = -inward[1], inward[0]
        # each with its standard deviation
        self.restitution, self.ratio = restitution, ratio


class Ended:
    """Where one vehicle came to rest, and the slide that brings it there from a motion after the impact."""

    def __init__(self, given: Departing, side: Side, axes: Axes, gravity: float) -> None:
        self.given, self.side, self.axes, self.gravity = given, side, axes, gravity
        end = given.motion
        assert isinstance(end, RestAfter | TurningAfter)
        self.motion: Any = end
        self.sigma = given.rest_sigma or 1.0
        self.drag = (end.slide_friction if isinstance(end, TurningAfter) else end.drag), given.drag_sigma
        require(
            self.drag[0] > 0.0,
            "the drag of the slide of {name} is not above zero", name=side.name, code="no-drag",
        )  # fmt: skip
        self.nose = 0.0
        if isinstance(end, TurningAfter):
            require(
                side.spins is not None and given.nose is not None,
                "of {name}, which turned on its wheels, inertia, lever or the nose at the impact is missing",
                name=side.name, code="not-enough", hint="give them, or a mean drag for a straight slide",
            )  # fmt: skip
            assert given.nose is not None
            self.nose = heading_angle(given.nose, axes)
            self.rest_nose = heading_angle(end.rest_nose, axes)

    def car(self, friction: float) -> "Any":
        """The car on its wheels, with this friction."""
        motion = self.motion
        assert self.side.spins is not None
        gyration = sqrt(self.side.spins[0] / self.side.mass)
        return car_of(
            motion.front_axle, motion.rear_axle, motion.track, gyration, friction,
            shares_of(motion.__dict__), 0.1, 0.0, self.gravity, (), self.axes,
        )  # fmt: skip

    def gaps(self, velocity: "Pair", spin: float, drag: float) -> "list[tuple[str, float]]":
        """Where it slides to less where it was found, in standard deviations."""
        name = f"{self.side.name} rest position along "
        speed = hypot(*velocity)
        if isinstance(self.motion, RestAfter):
            reach = speed / (2.0 * drag * self.gravity)
            place = reach * velocity[0], reach * velocity[1]
            more = []
        else:
            end = run(self.car(drag), State(0.0, 0.0, self.nose, *velocity, spin), FINE).end
            place = end.x, end.y
            more = [(f"{self.side.name} nose at rest", (end.nose - self.rest_nose) / self.given.rest_nose_sigma)]
        return [
            (name + letter, (place[axis] - self.motion.rest[axis]) / self.sigma) for axis, letter in enumerate("xy")
        ] + more

    def turned(self, velocity: "Pair", spin: float) -> float:
        """How far a straight slide would turn meanwhile: the spin falls as the speed does."""
        speed = hypot(*velocity)
        return 0.0 if speed == 0.0 else abs(spin) * hypot(*self.motion.rest) / speed


class Problem:
    """Unknowns: both speeds, uncertain headings, then data of contact and drags with a deviation."""

    def __init__(self, sides: "tuple[Side, Side]", ends: "tuple[Ended, Ended]", contact: Contact) -> None:
        self.sides, self.ends, self.contact = sides, ends, contact
        self.known: list[tuple[str, float, float]] = []
        self.bends = [side.bends for side in sides]
        for side in sides:
            if side.bends:
                self.known.append((f"{side.name} approach heading", 0.0, side.heading_sigma))
        for name, (value, sigma) in (
            ("restitution", contact.restitution), ("ratio of impulses", contact.ratio),
            (f"{sides[0].name} drag", ends[0].drag), (f"{sides[1].name} drag", ends[1].drag),
        ):  # fmt: skip
            if sigma > 0.0:
                self.known.append((name, value, sigma))
        self.smooth = all(isinstance(end.motion, RestAfter) for end in ends)

    def state(self, unknowns: "list[float]") -> "tuple[list[float], list[tuple[Pair, float]], list[float]]":
        """V₁, V₂ and p; the exits; drags."""
        more = iter(unknowns[2:])
        before: list[Pair] = []
        for side, speed, bends in zip(self.sides, unknowns[:2], self.bends, strict=True):
            assert side.way is not None
            assert side.turn is not None
            off = next(more) if bends else 0.0
            c, s = cos(off), sin(off)
            before.append((speed * (c * side.way[0] + s * side.turn[0]), speed * (c * side.way[1] + s * side.turn[1])))
        bounce, ratio, *drags = (
            next(more) if sigma > 0.0 else value
            for value, sigma in (self.contact.restitution, self.contact.ratio, *(end.drag for end in self.ends))
        )
        push = self._impulse(before, bounce, ratio)
        exits = []
        for side, velocity in zip(self.sides, before, strict=True):
            signed_mobility = side.sense / side.mass
            spin = 0.0
            if side.spins is not None:
                inertia, lever, spun, _ = side.spins
                spin = spun + side.sense * (lever[0] * push[1] - lever[1] * push[0]) / inertia
            exits.append(((velocity[0] + signed_mobility * push[0], velocity[1] + signed_mobility * push[1]), spin))
        return [*before[0], *before[1], *push], exits, drags

    def _impulse(self, before: "list[Pair]", bounce: float, ratio: float) -> "Pair":
        """The impulse on the first that ends the closing with this restitution and ratio."""
        inward, across = self.contact.inward, self.contact.across
        direction = inward[0] + ratio * across[0], inward[1] + ratio * across[1]
        closing = [before[0][axis] - before[1][axis] for axis in (0, 1)]
        gain = [0.0, 0.0]
        for side in self.sides:
            gain[0] += direction[0] / side.mass
            gain[1] += direction[1] / side.mass
            if side.spins is None:
                continue
            inertia, (x, y), spin, _ = side.spins
            turned = (x * direction[1] - y * direction[0]) / inertia
            gain[0] -= turned * y
            gain[1] += turned * x
            closing[0] -= side.sense * spin * y
            closing[1] += side.sense * spin * x
        along = closing[0] * inward[0] + closing[1] * inward[1]
        size = -(1.0 + bounce) * along / (gain[0] * inward[0] + gain[1] * inward[1])
        return size * direction[0], size * direction[1]

    def residuals(self, unknowns: "list[float]") -> "list[tuple[str, float]]":
        """Every measurement against the forward run, in standard deviations."""
        _, exits, drags = self.state(unknowns)
        listed: list[tuple[str, float]] = []
        for end, (velocity, spin), drag in zip(self.ends, exits, drags, strict=True):
            listed += end.gaps(velocity, spin, drag)
        for (name, value, sigma), fitted in zip(self.known, unknowns[2:], strict=True):
            listed.append((name, (fitted - value) / sigma))
        return listed

    def starts(self) -> "list[list[float]]":
        """Start values of the speeds: from the momentum of straight slides to the rest positions."""
        exits = []
        for end in self.ends:
            motion = end.motion
            braking = 1.0 if isinstance(motion, RestAfter) else max(motion.braking, 0.5)
            distance = hypot(*motion.rest)
            speed = sqrt(2.0 * braking * end.drag[0] * end.gravity * distance)
            exits.append((speed * motion.rest[0] / (distance or 1.0), speed * motion.rest[1] / (distance or 1.0)))
        (a, b), (first_side, second_side) = (self.sides[0].way, self.sides[1].way), self.sides
        assert a is not None
        assert b is not None
        total = [first_side.mass * exits[0][axis] + second_side.mass * exits[1][axis] for axis in (0, 1)]
        sine = a[0] * b[1] - a[1] * b[0]
        sine = sine if abs(sine) > 0.1 else 0.1
        v1 = abs(total[0] * b[1] - total[1] * b[0]) / abs(sine) / first_side.mass
        v2 = abs(a[0] * total[1] - a[1] * total[0]) / abs(sine) / second_side.mass
        parameters = [value for _, value, _ in self.known]
        return [[pace * v1, pace * v2, *parameters] for pace in STARTS]


def solve_rest(problem: Problem) -> Fit:
    """Gauss–Newton with halved steps from momentum, derivatives by differences."""
    import numpy as np

    best: tuple[float, Any, float, Any] | None = None
    unsettled: list[tuple[float, list[tuple[str, float]]]] = []
    for start in problem.starts():
        tried = _settled(problem, start, unsettled)
        if tried is not None and (best is None or tried[0] < best[0]):
            best = tried
        if best is not None and problem.smooth:
            break
    if best is None:
        name, off = max(min(unsettled)[1], key=lambda one: abs(one[1]))
        require(
            False,
            "no approach leads to these rest positions: at best the {name} is off by {off:2} standard deviations",
            name=name, off=(abs(off), Ratio), code="undetermined",
            hint="check the signs of that rest position, the approach headings and the drags",
        )  # fmt: skip
    assert best is not None
    _, unknowns, moved, (count, inverse) = best
    residuals = problem.residuals(unknowns)
    require(
        len(residuals) >= len(unknowns), "there are more unknowns than measurements", code="undetermined",
        hint="leave the standard deviation of restitution, ratio or drags out, or measure more",
    )  # fmt: skip
    jacobian = _differences(lambda numbers: problem.state(numbers)[0], unknowns, problem.smooth)
    half = jacobian @ inverse
    fit = Fit(np.array(problem.state(unknowns)[0]), half @ half.T, residuals, len(unknowns))
    fit.steps, fit.gradient = count, moved
    return fit


def _settled(
    problem: Problem, unknowns: "list[float]", unsettled: "list[tuple[float, list[tuple[str, float]]]]"
) -> "tuple[float, list[float], float, Any] | None":
    """Where the fit settles; otherwise none, with its last residuals among `unsettled`."""
    import numpy as np

    def values(numbers: "list[float]") -> "list[float]":
        return [value for _, value in problem.residuals(numbers)]

    now = np.array(values(unknowns))
    for count in range(1, MOST_STEPS + 1):
        matrix = _differences(values, unknowns, problem.smooth)
        step, inverse, moved = stepped(matrix, now)
        size = float(now @ now)
        limit = (SETTLED if problem.smooth else 1e-5) * (1.0 + size**0.5)
        if moved <= limit:
            return size, unknowns, min(moved, SETTLED * (1.0 + size**0.5)), (count, inverse)
        scale = min(1.0, 0.5 * max(hypot(*unknowns[:2]), 1.0) / max(float(np.linalg.norm(step[:2])), 1e-300))
        for _ in range(12):
            tried = [numbers - scale * float(part) for numbers, part in zip(unknowns, step, strict=True)]
            residuals_there = np.array(values(tried))
            if float(residuals_there @ residuals_there) < size:
                break
            scale *= 0.5
        else:
            # within the accuracy of the differences
            return size, unknowns, SETTLED, (count, inverse)
        unknowns, now = tried, residuals_there
    unsettled.append((float(now @ now), problem.residuals(unknowns)))
    return None


def _differences(function: "Callable[[list[float]], list[float]]", at: "list[float]", smooth: bool) -> "Any":
    """Derivatives by central differences."""
    import numpy as np

    step = SMOOTH_STEP if smooth else ROUGH_STEP
    columns = []
    for index, value in enumerate(at):
        width = step * max(abs(value), 1.0 if index < 2 else 0.1)
        ends = [function([*at[:index], value + sign * width, *at[index + 1 :]]) for sign in (1.0, -1.0)]
        columns.append([(a - b) / (2.0 * width) for a, b in zip(*ends, strict=True)])
    return np.array(columns).T


def contact_of(normal: float | None, axes: Axes, known: KnownContact) -> Contact:
    """Data of the contact for the rest positions; refuses missing ones."""
    restitution, ratio = known.restitution, known.impulse_ratio
    listed = (("normal", normal), ("restitution", restitution), ("ratio of impulses", ratio))
    missing = [word for word, value in listed if value is None]
    require(
        not missing,
        "rest positions need the impact driven forward, and of its contact {missing} is not given",
        missing=" and ".join(missing), code="not-enough",
        hint="give --normal, --contact-restitution and --contact-impulse-ratio, with standard deviations",
    )  # fmt: skip
    assert normal is not None
    assert restitution is not None
    assert ratio is not None
    require(
        known.restitution_sigma >= 0.0 and known.ratio_sigma >= 0.0,
        "a standard deviation is below zero", code="no-sigma",
    )  # fmt: skip
    x, y = direction_of(normal, axes)
    return Contact((-x, -y), (restitution, known.restitution_sigma), (ratio, known.ratio_sigma))


def with_turning(result: InverseResult, problem: Problem, names: "tuple[str, str]") -> InverseResult:
    """The result with a caution for each straight slide in which the vehicle would have turned far."""
    notes: list[Advice] = []
    for index, (end, vehicle) in enumerate(zip(problem.ends, (result.first, result.second), strict=True)):
        if not isinstance(end.motion, RestAfter) or vehicle.exit_spin is None:
            continue
        turned = end.turned(vehicle.exit_velocity, vehicle.exit_spin)
        if turned > FAR:
            text = worded(
                "{name} turned about {angle:2} in its slide: a straight one with a mean drag is rough",
                name=names[index], angle=(turned, Angle),
            )  # fmt: skip
            remedy = "give its nose at rest and its wheels (rest nose, slide friction, axles, track, braking)"
            notes.append(Advice("turned-far", text, remedy=remedy))
    return InverseResult(**{**result.__dict__, "advice": (*result.advice, *notes)})
