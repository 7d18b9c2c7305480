"""Rigid bodies in the plane: as given by the user, and in the form that the contact needs."""

from dynamics_cli.errors import require, require_given
from dynamics_cli.impact.conventions import (
    Axes,
    BodyName,
    ByMass,
    BySpeed,
    ByVelocity,
    ByWeight,
    Fixed,
    direction_of,
    mass_of,
    side_of,
    travel_of,
    velocity_of,
)
from dynamics_cli.impact.planar.path import Mobility
from dynamics_cli.numerics.elementary import multiply_add
from dynamics_cli.numerics.vectors import planar_cross as cross
from dynamics_cli.numerics.vectors import planar_dot as dot
from dynamics_cli.quantities import AngularSpeed, Annotated, Distance, Heading, Inertia, PlanarPosition
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

Pair = tuple[float, float]


@record
class ByInertia:
    """Inertia about the mass centre by its moment."""

    inertia: Annotated[
        Inertia, "Moment of inertia about the axis through the mass centre, out of the plane (yaw inertia) [kg·m²]."
    ]


@record
class ByGyration:
    """Inertia about the mass centre by the radius of gyration."""

    radius_of_gyration: Annotated[
        Distance, "Radius of gyration about the axis through the mass centre, out of the plane, e.g. 1.3 m [m]."
    ]


@record
class Lever:
    """The contact by its place relative to the mass centre."""

    lever: Annotated[PlanarPosition, "From the mass centre to the contact, along the axes of the scene [m]."]


@record
class Placed:
    """The contact by where the mass centre is; the contact point is then given for the scene."""

    centre: Annotated[PlanarPosition, "Place of the mass centre in the scene [m]."]


@record
class OnBody:
    """The contact as measured on the body."""

    contact_on_body: Annotated[
        PlanarPosition,
        "From the mass centre to the contact: x ahead along the nose, y across as the axes say (left; right in "
        "SAE) [m].",
    ]


@record
class RigidBody:
    """A rigid body that moves in the plane."""

    bulk: Annotated[ByMass | ByWeight, "Its mass or its weight."]
    turning: Annotated[ByInertia | ByGyration, "Its moment of inertia about the mass centre."]
    arm: Annotated[Lever | Placed | OnBody, "Where it is struck."]
    motion: Annotated[ByVelocity | BySpeed, "Velocity of the mass centre before; at rest when left out."] = ByVelocity(
        (0.0, 0.0)
    )
    spin: Annotated[AngularSpeed, "Angular velocity before, counted like headings from x towards y [rad/s]."] = 0.0
    nose: Annotated[
        Heading | None,
        "Heading of its nose, for PDOF and for a contact on the body; its direction of travel when left out [rad].",
    ] = None
    name: BodyName = None


@record
class RigidTarget:
    """The other rigid body, or a fixed barrier, which needs neither inertia nor lever."""

    bulk: Annotated[ByMass | ByWeight | Fixed, "Its mass or its weight, or that it is fixed."]
    turning: Annotated[ByInertia | ByGyration | None, "Its moment of inertia about the mass centre."] = None
    arm: Annotated[Lever | Placed | OnBody | None, "Where it is struck."] = None
    motion: Annotated[ByVelocity | BySpeed, "Velocity of the mass centre before; at rest when left out."] = ByVelocity(
        (0.0, 0.0)
    )
    spin: Annotated[AngularSpeed, "Angular velocity before, counted like headings from x towards y [rad/s]."] = 0.0
    nose: Annotated[
        Heading | None,
        "Heading of its nose, for PDOF and for a contact on the body; its direction of travel when left out [rad].",
    ] = None
    name: BodyName = None


@record
class Solid:
    """A body at the contact; mass and inertia are None if it is fixed."""

    mass: Annotated[float | None, "Mass [kg]."]
    inertia: Annotated[float | None, "Moment of inertia [kg·m²]."]
    lever: Annotated[Pair, "From the mass centre to the contact [m]."]
    velocity: Annotated[Pair, "Velocity of the mass centre [m/s]."]
    spin: Annotated[float, "Angular velocity [rad/s]."]
    nose: Annotated[Pair, "Unit vector of the nose."]


def solid(body: RigidBody | RigidTarget, contact: Pair | None, axes: Axes, gravity: float, name: str) -> Solid:
    """Read a body; refuses one without mass, inertia or lever that needs them."""
    velocity = velocity_of(body.motion, axes)
    nose = nose_of(body.nose, velocity, axes)
    if isinstance(body.bulk, Fixed):
        require(body.bulk.fixed, "{name} has neither mass nor weight and is not fixed", name=name, code="no-mass")
        lever = (0.0, 0.0) if body.arm is None else _lever(body.arm, contact, nose, name)
        return Solid(None, None, lever, velocity, body.spin, nose)
    mass = mass_of(body.bulk, gravity, name)
    side = side_of(name)
    require_given(
        body.turning is not None,
        "{name} has no inertia (bodies that cannot turn: dynamics impact oblique)",
        (f"{side}.inertia",),
        (f"{side}.radius_of_gyration",),
        name=name,
        code="no-inertia",
    )
    require_given(
        body.arm is not None,
        "{name} has no lever to the contact",
        (f"{side}.lever",),
        (f"{side}.centre", "contact_point"),
        (f"{side}.contact_on_body",),
        name=name,
        code="no-lever",
    )
    if isinstance(body.turning, ByGyration):
        radius = body.turning.radius_of_gyration
        inertia = mass * radius * radius
    else:
        inertia = body.turning.inertia  # type: ignore[union-attr]
    require(
        inertia > 0.0,
        "the moment of inertia of {name} must be above zero: a rigid body with a lever needs one",
        name=name,
        code="no-inertia",
        hint="impact oblique answers for particles",
    )
    return Solid(mass, inertia, _lever(body.arm, contact, nose, name), velocity, body.spin, nose)  # type: ignore[arg-type]


def struck(
    vehicle: "Any", velocity: Pair, spin: float, nose: float | None, contact: Pair | None, axes: Axes, gravity: float,
    name: str,
) -> Solid:  # fmt: skip
    """A vehicle at the contact by its bulk, turning and arm; without one of the latter it does not turn."""
    if vehicle.turning is None or vehicle.arm is None:
        return Solid(mass_of(vehicle.bulk, gravity, name), None, (0.0, 0.0), velocity, spin, (1.0, 0.0))
    require(
        not isinstance(vehicle.arm, OnBody) or nose is not None,
        "the contact is measured on the body of {name}, whose nose is not given",
        name=name,
        code="no-nose",
        hint="give the heading of its nose at the impact",
    )
    body = RigidBody(vehicle.bulk, vehicle.turning, vehicle.arm, ByVelocity(velocity), spin, nose)
    return solid(body, contact, axes, gravity, name)


def nose_of(nose: float | None, velocity: Pair, axes: Axes) -> Pair:
    """Direction of the nose: as given, else that of travel, or of heading zero for a body at rest."""
    return travel_of(velocity, axes) if nose is None else direction_of(nose, axes)


def _lever(arm: Lever | Placed | OnBody, contact: Pair | None, nose: Pair, name: str) -> Pair:
    if isinstance(arm, Lever):
        return arm.lever
    if isinstance(arm, OnBody):
        ahead, across = arm.contact_on_body
        return (
            multiply_add(ahead, nose[0], -(across * nose[1])),
            multiply_add(ahead, nose[1], across * nose[0]),
        )
    require_given(
        contact is not None,
        "{name} is placed by its centre, but there is no contact point in the same axes",
        ("contact_point",),
        (f"{side_of(name)}.lever",),
        name=name,
        code="no-contact-point",
    )
    return contact[0] - arm.centre[0], contact[1] - arm.centre[1]  # type: ignore[index]


def contact_velocity(a: Solid, b: Solid) -> Pair:
    """Velocity of body 1 relative to body 2 at the contact."""
    x = multiply_add(b.spin, b.lever[1], multiply_add(-a.spin, a.lever[1], a.velocity[0] - b.velocity[0]))
    y = multiply_add(-b.spin, b.lever[0], multiply_add(a.spin, a.lever[0], a.velocity[1] - b.velocity[1]))
    return x, y


def mobility(a: Solid, b: Solid, normal: Pair) -> tuple[Mobility, Pair]:
    """K in the frame of the contact, and the relative spin per tangential and normal impulse (Keller 1986).

    det K = s² + s·Σ r²/J + (r₁ × r₂)²/(J₁J₂), s = Σ 1/m: a sum of positive terms.
    """
    across = -normal[1], normal[0]
    bodies = [body for body in (a, b) if body.mass is not None and body.inertia is not None]
    freedom: float = 0.0
    kt = kx = kn = bt = bn = 0.0
    reach: float = 0.0
    for body in bodies:
        rn, rt = dot(body.lever, normal), dot(body.lever, across)
        turn = 1.0 / body.inertia  # type: ignore[operator]
        freedom = freedom + 1.0 / body.mass  # type: ignore[operator]
        kt = kt + turn * rn * rn
        kn = kn + turn * rt * rt
        kx = kx - turn * rn * rt
        bt = bt + turn * rn
        bn = bn - turn * rt
        reach = reach + turn * (rn * rn + rt * rt)
    det = freedom * (freedom + reach)
    if len(bodies) == 2:
        area = cross(a.lever, b.lever)
        det = det + area * area / (a.inertia * b.inertia)  # type: ignore[operator]
    return Mobility(kt + freedom, kx, kn + freedom, det), (bt, bn)
