"""Both vehicles in the form of the fit, and the answer from a fit."""

from dynamics_cli.errors import require, worded
from dynamics_cli.impact.conventions import (
    AXES,
    PDOF_ZERO,
    Axes,
    PdofZero,
    conventions,
    delta_v,
    direction_of,
    heading_of,
    velocity_of,
)
from dynamics_cli.impact.conventions import BySpeed as Course
from dynamics_cli.impact.inverse.fit import SETTLED, Fit, Side
from dynamics_cli.impact.inverse.judgement import (
    Contact,
    agreement,
    by_heading,
    chance,
    least_certain,
    share_verdict,
    unreliable,
)
from dynamics_cli.impact.inverse.records import (
    UNKNOWN_CONTACT,
    Approach,
    Departing,
    ExitSpeed,
    ExitVelocity,
    InverseResult,
    KnownContact,
    Residual,
    RestAfter,
    TurningAfter,
)
from dynamics_cli.impact.planar.bodies import Solid, struck
from dynamics_cli.quantities import STANDARD_GRAVITY, RoadSpeed
from dynamics_cli.records import Advice, Check, Numerics

Pair = tuple[float, float]


def ended(vehicle: Departing) -> bool:
    """Whether its motion after is given by where it came to rest."""
    return isinstance(vehicle.motion, RestAfter | TurningAfter)


def turns(vehicle: Departing) -> bool:
    """Whether its change of spin and the data for it are given; from rest positions the spin after follows."""
    needed = [vehicle.turning, vehicle.arm]
    if not ended(vehicle):
        needed += [vehicle.exit_spin, vehicle.approach_spin]  # type: ignore[list-item]
    return all(quantity is not None for quantity in needed)


class Scene:
    """Both vehicles in the form of the fit, and the answer from a fit."""

    def __init__(
        self,
        first: Departing,
        second: Departing,
        contact_point: Pair | None = None,
        normal: float | None = None,
        contact: KnownContact = UNKNOWN_CONTACT,
        axes: Axes = AXES,
        pdof_zero: PdofZero = PDOF_ZERO,
        gravity: float = STANDARD_GRAVITY,
        *,
        spins: bool = True,
        headings: bool = True,
    ) -> None:
        self.vehicles = vehicles = first, second
        self.names = first.name or "the first", second.name or "the second"
        self.contact, self.axes, self.zero = contact, axes, pdof_zero
        self.solids = [
            _solid(vehicle, contact_point, axes, gravity, name)
            for vehicle, name in zip(vehicles, ("the first vehicle", "the second vehicle"), strict=True)
        ]
        self.momentum = not spins
        used = [spins and turns(vehicle) for vehicle in vehicles]
        self.weighted = all(
            (vehicle.rest_sigma if ended(vehicle) else vehicle.velocity_sigma) is not None
            and (vehicle.spin_sigma is not None or not turning or ended(vehicle))
            for vehicle, turning in zip(vehicles, used, strict=True)
        )
        self.sides = self._side(0, used[0], headings), self._side(1, used[1], headings)
        self.inward = None
        if normal is not None:
            x, y = direction_of(normal, axes)
            self.inward = -x, -y

    def _side(self, index: int, turning: bool, headed: bool) -> Side:
        vehicle, body = self.vehicles[index], self.solids[index]
        name = self.names[index].removeprefix("the ")
        for sigma, word in (
            (vehicle.velocity_sigma, "exit velocity"), (vehicle.spin_sigma, "exit spin"), (vehicle.rest_sigma, "rest")
        ):  # fmt: skip
            require(
                sigma is None or sigma > 0.0,
                "the standard deviation of the {word} of {name} is not above zero",
                word=word,
                name=self.names[index],
                code="no-sigma",
                hint="every measurement has one: give a small number",
            )
        require(vehicle.heading_sigma >= 0.0, "a standard deviation is below zero", code="no-sigma")
        way = turn = None
        if headed and vehicle.approach_heading is not None:
            x, y = way = direction_of(vehicle.approach_heading, self.axes)
            turn = (y, -x) if self.axes == "compass" else (-y, x)
        spins = None
        if turning:
            spins = float(body.inertia), body.lever, vehicle.approach_spin or 0.0, vehicle.exit_spin or 0.0  # type: ignore[arg-type]
        sigmas = 1.0, 1.0, 0.0
        if self.weighted:
            sigmas = vehicle.velocity_sigma or 1.0, vehicle.spin_sigma or 1.0, vehicle.heading_sigma
        mass = float(body.mass)  # type: ignore[arg-type]
        return Side(name, 1.0 - 2.0 * index, mass, body.velocity, way, turn, spins, *sigmas)

    def answer(self, fit: Fit, verdict: str | None, sine: float | None, method: str) -> InverseResult:
        """The complete answer."""
        self._require_forward(fit)
        residuals = sorted(fit.residuals, key=lambda a: -abs(a[1])) if self.weighted else []
        probability = chance(fit.chi_squared, fit.freedom) if self.weighted else None
        advice = agreement(probability, residuals)
        contact = Contact(fit, self.sides, self.inward)
        approaches = [self._approach(index, fit, verdict) for index in (0, 1)]
        verdicts = [(self.names[i], a.verdict, a.approach_speed, a.speed_sigma) for i, a in enumerate(approaches)]
        p = float(fit.state[4]), float(fit.state[5])
        tolerance = 100.0 * SETTLED
        gradient = fit.gradient / (1.0 + fit.chi_squared**0.5)
        doubt = least_certain(fit, self.names) if self.weighted else None
        return InverseResult(
            first=approaches[0],
            second=approaches[1],
            correlation=self._correlation(fit, approaches),
            least_certain=doubt and doubt[0],
            least_certain_sigma=None if doubt is None else doubt[1],
            impulse=p,
            impulse_size=(p[0] * p[0] + p[1] * p[1]) ** 0.5,
            chi_squared=fit.chi_squared if self.weighted else None,
            degrees_of_freedom=fit.freedom,
            probability=probability,
            lever_sine=sine,
            restitution=contact.restitution,
            restitution_sigma=contact.restitution_sigma if self.weighted else None,
            impulse_ratio=contact.ratio,
            impulse_ratio_sigma=contact.ratio_sigma if self.weighted else None,
            energy_lost=contact.energy_lost,
            residuals=tuple(Residual(name, value) for name, value in residuals),
            conventions=conventions(self.axes, self.zero),
            numerics=Numerics(method),
            checks=(Check("the fit has settled", gradient <= tolerance, gradient, tolerance),),
            advice=contact.advice() + advice + unreliable(tuple(verdicts)) + self._unused(),
        )

    def _require_forward(self, fit: Fit) -> None:
        for index, side in enumerate(self.sides):
            if side.way is None:
                continue
            along = float(fit.state[2 * index] * side.way[0] + fit.state[2 * index + 1] * side.way[1])
            require(
                along >= 0.0,
                "no approach gives these exits: {name} would have driven backwards at {speed:3}",
                name=self.names[index],
                speed=(-along, RoadSpeed),
                code="backwards",
                hint="check its approach heading, and that headings are directions of travel",
            )

    def _approach(self, index: int, fit: Fit, verdict: str | None) -> Approach:
        vehicle, body, side = self.vehicles[index], self.solids[index], self.sides[index]
        velocity = float(fit.state[2 * index]), float(fit.state[2 * index + 1])
        speed = fit.speed(index)
        along = self._way(index, fit)
        p = float(fit.state[4]), float(fit.state[5])
        push = side.sense / side.mass
        heading = heading_of(*along, self.axes)
        if side.way is not None and not side.bends:
            heading = vehicle.approach_heading  # type: ignore[assignment]
        sigma = heading_sigma = None
        if self.weighted:
            sigma = fit.sigma(self._row(index, along))
            turned = (
                0.0 if side.way is not None and not side.bends else fit.sigma(self._row(index, (-along[1], along[0])))
            )
            heading_sigma = turned / speed if speed > 0.0 else None
        spin = None
        if side.spins is not None:
            inertia, lever, before, _ = side.spins
            spin = before + side.sense * (lever[0] * p[1] - lever[1] * p[0]) / inertia
        headed = by_heading(fit, self.sides, index) if self.momentum else None
        nose = along if vehicle.nose is None else direction_of(vehicle.nose, self.axes)
        push_on_it = side.sense * p[0], side.sense * p[1]
        change = delta_v(push_on_it, float(body.mass), nose, axes=self.axes, pdof_zero=self.zero, travel=along)  # type: ignore[arg-type]
        return Approach(
            approach_speed=speed,
            approach_heading=heading,
            speed_sigma=sigma,
            heading_sigma=heading_sigma,
            verdict=share_verdict(speed, sigma) or (headed[0] if headed else verdict),
            heading_tolerance=headed[1] if headed else None,
            worst_heading=headed[2] if headed else None,
            per_degree=headed[3] if headed else None,
            exit_velocity=(velocity[0] + push * p[0], velocity[1] + push * p[1]),
            exit_spin=spin,
            delta_v=change,
        )

    def _way(self, index: int, fit: Fit) -> Pair:
        """Direction of an approach: of its velocity; of a vehicle at rest, its heading."""
        speed = fit.speed(index)
        if speed == 0.0:
            return self.sides[index].way or direction_of(0.0, self.axes)
        return float(fit.state[2 * index]) / speed, float(fit.state[2 * index + 1]) / speed

    def _row(self, index: int, way: Pair) -> "list[float]":
        return [*([0.0, 0.0] * index), *way, *([0.0, 0.0] * (2 - index))]

    def _correlation(self, fit: Fit, approaches: "list[Approach]") -> float | None:
        sigmas = [approach.speed_sigma for approach in approaches]
        if None in sigmas or 0.0 in sigmas:
            return None
        rows = [self._row(index, self._way(index, fit)) for index in (0, 1)]
        sum_deviation = fit.sigma([a + b for a, b in zip(*rows, strict=True)])
        return (sum_deviation * sum_deviation - sigmas[0] ** 2 - sigmas[1] ** 2) / (2.0 * sigmas[0] * sigmas[1])  # type: ignore[operator]

    def _unused(self) -> "tuple[Advice, ...]":
        notes = []
        for vehicle, side, name in zip(self.vehicles, self.sides, self.names, strict=True):
            if vehicle.exit_spin is not None and side.spins is None:
                text = worded("the exit spin of {name} is not used", name=name)
                remedy = "give its approach spin, inertia and lever, and standard deviations"
                notes.append(Advice(code="spin-unused", message=text, severity="note", remedy=remedy))
        return tuple(notes)


def _solid(vehicle: Departing, contact_point: Pair | None, axes: Axes, gravity: float, name: str) -> Solid:
    motion = vehicle.motion
    velocity = 0.0, 0.0
    if isinstance(motion, ExitVelocity):
        velocity = motion.exit_velocity
    elif isinstance(motion, ExitSpeed):
        velocity = velocity_of(Course(motion.exit_speed, motion.exit_heading), axes)
    return struck(vehicle, velocity, vehicle.exit_spin or 0.0, vehicle.nose, contact_point, axes, gravity, name)
