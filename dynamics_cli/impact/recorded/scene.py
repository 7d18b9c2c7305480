"""Both vehicles of a recorded crash: the exchanged impulse, and its effect at the contact."""

from dynamics_cli.errors import require
from dynamics_cli.impact.conventions import AXES, PDOF_ZERO, Axes, PdofZero, direction_of
from dynamics_cli.impact.planar.bodies import Solid, struck
from dynamics_cli.impact.recorded.records import Partner, Recorder
from dynamics_cli.numerics.elementary import absolute, hypot
from dynamics_cli.numerics.vectors import planar_cross as cross
from dynamics_cli.numerics.vectors import planar_dot as dot
from dynamics_cli.quantities import STANDARD_GRAVITY

Pair = tuple[float, float]


def spun(spin: float, lever: Pair) -> Pair:
    """Velocity of a point by a spin."""
    return 0.0 - spin * lever[1], spin * lever[0]


def plus(a: Pair, b: Pair, times: float = 1.0) -> Pair:
    """The sum a + times·b."""
    return a[0] + times * b[0], a[1] + times * b[1]


class Crash:
    """Masses, levers and the recorded ΔV at the mass centre in the axes of the scene; `impulse` acts on the first."""

    def __init__(
        self,
        first: Recorder,
        second: Partner,
        least_restitution: float | None = None,
        greatest_restitution: float | None = None,
        normal: float | None = None,
        contact_point: Pair | None = None,
        tolerance: float = 0.1,
        final_change: float | None = None,
        axes: Axes = AXES,
        pdof_zero: PdofZero = PDOF_ZERO,
        gravity: float = STANDARD_GRAVITY,
    ) -> None:
        self.given, self.other, self.axes, self.zero = first, second, axes, pdof_zero
        self.restitutions, self.normal = (least_restitution, greatest_restitution), normal
        self.tolerance, self.final_change = tolerance, final_change
        nose = direction_of(first.nose, axes)
        require(
            first.spin_change is not None or (first.module[0] == 0.0) & (first.module[1] == 0.0),
            "the recorder is away from the mass centre: its ΔV includes a part due to rotation",
            code="no-spin-change",
            hint="give the recorded spin change, or leave the place of the module out",
        )
        self.change = _turned((first.delta_v_longitudinal, first.delta_v_lateral), nose)
        if first.spin_change is not None:
            self.change = plus(self.change, spun(first.spin_change, _turned(first.module, nose)), -1.0)
        heading = first.nose if first.approach_heading is None else first.approach_heading
        self.travel = direction_of(heading, axes)
        facing = second.approach_heading if second.nose is None else second.nose
        self.one = _solid(first, first.nose, first.approach_spin, contact_point, axes, gravity, "the first vehicle")
        self.two = _solid(second, facing, second.approach_spin, contact_point, axes, gravity, "the second vehicle")
        mass, other = float_like(self.one.mass), float_like(self.two.mass)
        self.impulse = mass * self.change[0], mass * self.change[1]
        self.size = hypot(*self.impulse)
        require(self.size > 0.0, "the recorded change of velocity is zero: no impact", code="no-impact")
        self.second_change = 0.0 - self.impulse[0] / other, 0.0 - self.impulse[1] / other
        self.before: Pair | None = None
        if first.approach_speed is not None:
            self.before = first.approach_speed * self.travel[0], first.approach_speed * self.travel[1]

    def gained(self) -> Pair:
        """Change of the relative velocity of the contact points: K·p."""
        total: Pair = (0.0, 0.0)
        for body in (self.one, self.two):
            total = plus(total, self.impulse, 1.0 / float_like(body.mass))
            if body.inertia is not None:
                total = plus(total, spun(cross(body.lever, self.impulse) / body.inertia, body.lever))
        return total

    def spin_change(self, body: Solid, sense: float) -> float | None:
        """Change of spin by the impulse."""
        return None if body.inertia is None else sense * cross(body.lever, self.impulse) / body.inertia

    def contact(self, body: Solid, velocity: Pair) -> Pair:
        """Velocity of the contact point of a body before."""
        return plus(velocity, spun(body.spin, body.lever))


def float_like(number: float | None) -> float:
    """A number that is known not to be None."""
    assert number is not None
    return number


def _turned(on_body: Pair, nose: Pair) -> Pair:
    return on_body[0] * nose[0] - on_body[1] * nose[1], on_body[0] * nose[1] + on_body[1] * nose[0]


def _solid(
    vehicle: Recorder | Partner,
    nose: float | None,
    spin: float,
    contact_point: Pair | None,
    axes: Axes,
    gravity: float,
    name: str,
) -> Solid:
    require(
        (vehicle.turning is None) == (vehicle.arm is None),
        "{name}: only one of inertia and lever is given; its rotation needs both",
        name=name,
        code="half-turning",
        hint="give both, or neither to neglect its rotation",
    )
    return struck(vehicle, (0.0, 0.0), spin, nose, contact_point, axes, gravity, name)


def slopes(
    crash: Crash, inward: Pair, travel: Pair, before: Pair, restitution: float, speed: float
) -> "tuple[float, float]":
    """Sizes of the derivatives of the second's speed by its heading and by the normal: v₂ = (W·n)/(d₂·n)."""
    relative = plus(
        plus(crash.contact(crash.one, before), crash.contact(crash.two, (0.0, 0.0)), -1.0),
        crash.gained(), 1.0 / (1.0 + restitution),
    )  # fmt: skip
    facing = dot(travel, inward)
    turned = 0.0 - inward[1], inward[0]
    by_heading = absolute(speed * cross(travel, inward) / facing)
    by_normal = absolute((dot(relative, turned) - speed * dot(travel, turned)) / facing)
    return by_heading, by_normal
