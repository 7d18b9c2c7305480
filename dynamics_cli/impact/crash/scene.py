"""A crash as stated in a scene file: surfaces, two vehicles before and after, their impact."""

from dynamics_cli.errors import require
from dynamics_cli.impact.conventions import AXES, PDOF_ZERO, Axes, BodyName, ByMass, ByWeight, PdofZero
from dynamics_cli.impact.reconstruction.momentum_records import CrushEnergies, EquivalentSpeeds
from dynamics_cli.impact.reconstruction.momentum_terms import Branch
from dynamics_cli.numerics.road.phases import Kind, Phase
from dynamics_cli.quantities import (
    Acceleration,
    Annotated,
    Distance,
    Fraction,
    Friction,
    Heading,
    PlanarPosition,
    Positive,
    RoadSpeed,
    Slope,
    Text,
    Time,
)
from dynamics_cli.records import record

BRAKING = Kind("braking")
ORIGIN = (0.0, 0.0)
# A car of common size if no size is given; the picture says so.
LENGTH, WIDTH = 4.5, 1.8


@record
class NamedSurface:
    """A surface of the scene, one friction for every vehicle and phase that refers to it."""

    name: Annotated[Text, "Name by which it is referred to, e.g. road."]
    friction: Annotated[Friction, "Coefficient of friction between tyre and surface [-]."]


@record
class PhaseBefore:
    """One phase before the impact; skid marks are a phase of braking with their length."""

    kind: Annotated[Kind, "What it does: waiting, constant, reaction, build-up, braking, coasting or accelerating."] = (
        BRAKING
    )
    duration: Annotated[Time | None, "How long it takes, e.g. 1.2 s [s]."] = None
    distance: Annotated[Distance | None, "How far it goes: the length of the marks, e.g. 12.4 m [m]."] = None
    speed: Annotated[RoadSpeed | None, "Speed where it begins, when that is known [m/s]."] = None
    surface: Annotated[Text | None, "The surface that it brakes on, by name, e.g. road."] = None
    friction: Annotated[Friction | None, "Friction, where no surface is named [-]."] = None
    grade: Annotated[Slope, "Rise over run in the direction of travel, uphill positive [-]."] = 0.0
    braking: Annotated[Fraction, "Share of the friction that the brakes use [-]."] = 1.0
    acceleration: Annotated[
        Acceleration | None, "Change of speed in its amount, in place of friction, e.g. 2 m/s^2 [m/s^2]."
    ] = None


@record
class SegmentAfter:
    """A stretch of the slide after the impact."""

    distance: Annotated[Distance, "Its length along the path of the mass centre [m]."]
    surface: Annotated[Text | None, "The surface, by name, e.g. road."] = None
    friction: Annotated[Friction | None, "Friction, where no surface is named [-]."] = None
    grade: Annotated[Slope, "Rise over run in the direction of travel, uphill positive [-]."] = 0.0
    braking: Annotated[
        Fraction, "Share of the friction that slows it: 1 sliding sideways or with all wheels locked [-]."
    ] = 1.0


@record
class SlideAfter:
    """The slide after the impact with its spin, on four wheels, to the rest position and the nose there."""

    rest_nose: Annotated[
        Heading, "Heading of its nose at rest, whole turns since the impact counted, e.g. 200 deg [rad]."
    ]
    front_axle: Annotated[Distance, "Distance from the mass centre ahead to the front axle, e.g. 1.2 m [m]."]
    rear_axle: Annotated[Distance, "Distance from the mass centre back to the rear axle, e.g. 1.4 m [m]."]
    track: Annotated[Distance, "Distance between its left and right wheels, e.g. 1.5 m [m]."]
    radius_of_gyration: Annotated[Distance, "Radius of gyration of yaw, e.g. 1.35 m [m]."]
    braking: Annotated[
        Fraction, "Share of its friction that a wheel's rotation is braked with: 100 % locked, 2 % rolling [-]."
    ]
    surface: Annotated[Text | None, "The surface, by name, e.g. road."] = None
    friction: Annotated[Friction | None, "Friction, where no surface is named [-]."] = None
    left_front: Annotated[Fraction | None, "The share of the left front wheel, where it differs [-]."] = None
    right_front: Annotated[Fraction | None, "Of the right front wheel [-]."] = None
    left_rear: Annotated[Fraction | None, "Of the left rear wheel [-]."] = None
    right_rear: Annotated[Fraction | None, "Of the right rear wheel [-]."] = None
    grip_slope: Annotated[Positive, "Slip angle (as its tangent) from which a rolling tyre slides [-]."] = 0.1


@record
class CrashVehicle:
    """A vehicle of the crash; what is left out is unknown."""

    bulk: Annotated[ByMass | ByWeight, "Its mass or its weight."]
    approach_heading: Annotated[
        Heading | None, "Direction of travel just before; on a compass also NE or north; e.g. 90 deg [rad]."
    ] = None
    approach_speed: Annotated[
        RoadSpeed | None, "Speed just before the impact, where it is known otherwise and used: 0 standing [m/s]."
    ] = None
    exit_heading: Annotated[
        Heading | None,
        "Direction of travel of the mass centre just after; towards its rest when left out [rad].",
    ] = None
    exit_speed: Annotated[
        RoadSpeed | None, "Speed just after, where it is known otherwise than by the slide [m/s]."
    ] = None
    before: Annotated[tuple[PhaseBefore, ...], "Phases and marks before the impact, in order of time."] = ()
    after: Annotated[tuple[SegmentAfter, ...], "Stretches of the slide after the impact, in order."] = ()
    slide: Annotated[SlideAfter | None, "The slide with spin to its rest, in place of stretches."] = None
    end_speed: Annotated[RoadSpeed, "Speed where the slide ends; at rest when left out [m/s]."] = 0.0
    rest: Annotated[PlanarPosition | None, "Where its mass centre came to rest, e.g. 7.2, 8.0 m [m]."] = None
    recorded_speed: Annotated[
        RoadSpeed | None, "Speed into the impact by another source: compared, not used [m/s]."
    ] = None
    recorded_delta_v: Annotated[RoadSpeed | None, "ΔV by another source: compared, not used [m/s]."] = None
    nose: Annotated[Heading | None, "Heading of its nose, for PDOF; its approach heading when left out [rad]."] = None
    length: Annotated[Distance, "Length of its outline in the picture [m]."] = LENGTH
    width: Annotated[Distance, "Width of its outline in the picture; below 1.1 m a two-wheeler [m]."] = WIDTH
    name: BodyName = None


@record
class ImpactLink:
    """Known quantities of the impact."""

    point: Annotated[
        PlanarPosition, "Where the mass centres are taken to be at the impact, along the axes of the scene [m]."
    ] = ORIGIN
    damage: Annotated[
        CrushEnergies | EquivalentSpeeds | None, "Energies of deformation, for vehicles that met on one line."
    ] = None
    branch: Annotated[Branch | None, "Which solution, where two close the equation."] = None


HEAD_ON = ImpactLink()


@record
class CrashScene:
    """The whole crash."""

    first: Annotated[CrashVehicle, "The first vehicle."]
    second: Annotated[CrashVehicle, "The second vehicle."]
    surfaces: Annotated[tuple[NamedSurface, ...], "Surfaces by name: one road is one friction."] = ()
    impact: Annotated[ImpactLink, "The impact."] = HEAD_ON
    speed_limit: Annotated[RoadSpeed | None, "Speed limit of the road, e.g. 50 km/h [m/s]."] = None
    axes: Annotated[Axes, "Axes of positions and headings: mathematical, compass, sae or iso."] = AXES
    pdof_zero: Annotated[PdofZero, "Where a force of PDOF zero comes from: heading, travel or scene."] = PDOF_ZERO


@record
class Ground:
    """A stretch with its friction, taken from its surface if named."""

    distance: float
    friction: float
    grade: float
    braking: float


def named(vehicle: CrashVehicle, side: str) -> str:
    """Name of a vehicle."""
    return vehicle.name or f"the {side}"


def grounds(scene: CrashScene, side: str) -> "tuple[Ground, ...]":
    """The stretches of a vehicle's slide on their surfaces."""
    listed = []
    for index, part in enumerate(getattr(scene, side).after):
        place = f"{side}.after[{index}]: "
        friction = surface_friction(scene, part, place)
        require(
            friction is not None,
            "{place}neither a surface nor a friction is given",
            code="no-surface",
            hint="name one of the [surfaces], or give friction",
            place=place,
        )
        assert friction is not None
        listed.append(Ground(part.distance, friction, part.grade, part.braking))
    return tuple(listed)


def phases(scene: CrashScene, side: str) -> "tuple[Phase, ...]":
    """A vehicle's phases before the impact on their surfaces."""
    listed = []
    for index, part in enumerate(getattr(scene, side).before):
        friction = surface_friction(scene, part, f"{side}.before[{index}]: ")
        numbers = part.duration, part.distance, part.speed, friction, part.grade, part.braking, part.acceleration
        listed.append(Phase(part.kind, *numbers))
    return tuple(listed)


def surface_friction(scene: CrashScene, part: "PhaseBefore | SegmentAfter | SlideAfter", place: str) -> "float | None":
    """Friction of a stretch: that which it states, or its surface's."""
    if part.surface is None:
        return part.friction
    require(
        part.friction is None,
        "{place}a surface and a friction are both given",
        code="twice",
        hint="give one of them",
        place=place,
    )
    matching = [surface for surface in scene.surfaces if surface.name == part.surface]
    known = ", ".join(surface.name for surface in scene.surfaces) or "none"
    require(
        len(matching) == 1,
        "{place}there is no surface '{name}'" if not matching else "{place}there is more than one surface '{name}'",
        code="unknown-surface",
        hint="surfaces here: {known}",
        place=place,
        name=part.surface,
        known=known,
    )
    return matching[0].friction
