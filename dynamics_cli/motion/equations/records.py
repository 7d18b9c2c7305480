"""Bodies and loads as formulas of generalized coordinates, and what becomes of them at an instant."""

from dynamics_cli.quantities import (
    Angle,
    AngleFormula,
    Annotated,
    Damping,
    Direction,
    ForceFormula,
    FreeNumber,
    FreeVector,
    Inertia,
    InertiaTriple,
    Length,
    LengthFormula,
    Mass,
    PotentialEnergy,
    Power,
    Ratio,
    Speed,
    SpeedFormula,
    Stiffness,
    Text,
    TorqueFormula,
    TorsionDamping,
    TorsionStiffness,
    TurnRate,
    TurnRateFormula,
)
from dynamics_cli.records import Check, Choice, Numerics, record

ORIGIN = "origin"


class Axis(Choice):
    """A coordinate axis."""

    names = ("x", "y", "z")


class Upward(Choice):
    """Which axis points up."""

    names = ("x", "y", "z", "none")


@record
class Turning:
    """A coordinate that is an angle."""

    name: Annotated[Text, "Its name in formulas, in radians there; NAME_dot is its rate."]
    angle: Annotated[Angle, "Its value, e.g. 20 deg."]
    rate: Annotated[TurnRate, "Its rate, e.g. 2 rad/s."] = 0.0


@record
class Sliding:
    """A coordinate that is a length."""

    name: Annotated[Text, "Its name in formulas, in metres there; NAME_dot is its rate."]
    position: Annotated[Length, "Its value, e.g. 0.1 m."]
    velocity: Annotated[Speed, "Its rate, e.g. 0.5 m/s."] = 0.0


@record
class Turn:
    """One of successive turns of a body, each about its own axis."""

    axis: Annotated[Axis, "The axis: x, y or z."]
    angle: Annotated[AngleFormula, "By how much, e.g. psi rad."]


@record
class Body:
    """A rigid body, or a particle."""

    name: Annotated[Text, "Its name, which stands for its centre too."]
    mass: Annotated[Mass, "Its mass, e.g. 2 kg."]
    x: Annotated[LengthFormula, "Its mass centre, e.g. x + L/2*sin(theta) m."]
    y: Annotated[LengthFormula, "Its mass centre, e.g. -L/2*cos(theta) m."]
    z: Annotated[LengthFormula | None, "Its mass centre, in space."] = None
    angle: Annotated[AngleFormula | None, "Its turn in the plane, e.g. theta rad."] = None
    inertia: Annotated[Inertia, "Central inertia in the plane, e.g. 0.05 kg*m^2."] = 0.0
    turns: Annotated[tuple[Turn, ...], "Its turns in space, the first from the fixed axes."] = ()
    moments: Annotated[InertiaTriple | None, "Central principal moments, in space, e.g. 2, 3, 4 kg*m^2."] = None


@record
class Point:
    """A point that loads or springs act at, or whose partial velocities are asked for."""

    name: Annotated[Text, "Its name."]
    x: Annotated[LengthFormula, "Where it is, e.g. x + L*sin(theta) m."]
    y: Annotated[LengthFormula, "Where it is, e.g. -L*cos(theta) m."]
    z: Annotated[LengthFormula | None, "Where it is, in space."] = None


@record
class Force:
    """A force at a point."""

    name: Annotated[Text, "Its name."]
    at: Annotated[Text, "The point, or the body at whose centre it acts."]
    x: Annotated[ForceFormula | None, "Its component, e.g. -20*x_dot N."] = None
    y: Annotated[ForceFormula | None, "Its component, e.g. 5*sin(3*t) N."] = None
    z: Annotated[ForceFormula | None, "Its component, in space."] = None


@record
class Torque:
    """A torque on a body, from the ground or from another body."""

    name: Annotated[Text, "Its name."]
    body: Annotated[Text, "The body."]
    torque: Annotated[TorqueFormula, "The torque, e.g. 3*sin(2*t) N*m."]
    axis: Annotated[Direction, "Its axis in space, e.g. 0, 0, 1."] = (0.0, 0.0, 1.0)
    against: Annotated[Text, "The body that is turned the other way; the ground by default."] = ""


@record
class Spring:
    """A spring or a damper between two points."""

    name: Annotated[Text, "Its name."]
    start: Annotated[Text, "The point or body it is fixed to, or origin."]
    end: Annotated[Text, "Its other end."]
    stiffness: Annotated[Stiffness, "Its stiffness, e.g. 200 N/m."] = 0.0
    free_length: Annotated[Length, "Its free length, e.g. 0.2 m."] = 0.0
    damping: Annotated[Damping, "Its damping, e.g. 5 N*s/m."] = 0.0


@record
class TorsionSpring:
    """A torsion spring or damper over an angle."""

    name: Annotated[Text, "Its name."]
    angle: Annotated[AngleFormula, "The angle that it is turned by, e.g. theta2 - theta1 rad."]
    stiffness: Annotated[TorsionStiffness, "Its stiffness, e.g. 3 N*m/rad."] = 0.0
    free_angle: Annotated[Angle, "The angle at which it is slack, e.g. 10 deg."] = 0.0
    damping: Annotated[TorsionDamping, "Its damping, e.g. 0.1 N*m*s/rad."] = 0.0


@record
class Condition:
    """What rates must keep: rolling without slip, a knife edge."""

    name: Annotated[Text, "Its name."]
    zero: Annotated[SpeedFormula, "What stays zero, linear in the rates, e.g. cos(theta)*y_dot - sin(theta)*x_dot m/s."]


@record
class GeneralizedSpeed:
    """A generalized speed, linear in the rates."""

    name: Annotated[Text, "Its name."]
    velocity: Annotated[SpeedFormula | None, "A speed, e.g. cos(theta)*x_dot + sin(theta)*y_dot m/s."] = None
    rate: Annotated[TurnRateFormula | None, "Or an angular velocity, e.g. theta_dot rad/s."] = None

    @property
    def angular(self) -> bool:
        """Whether it is an angular velocity."""
        return self.rate is not None


@record
class Scene:
    """A system of bodies by generalized coordinates."""

    coordinates: Annotated[tuple[Turning | Sliding, ...], "The generalized coordinates."]
    bodies: Annotated[tuple[Body, ...], "The bodies."]
    points: Annotated[tuple[Point, ...], "Further points."] = ()
    forces: Annotated[tuple[Force, ...], "Forces, besides gravity."] = ()
    torques: Annotated[tuple[Torque, ...], "Torques."] = ()
    springs: Annotated[tuple[Spring, ...], "Springs and dampers between points."] = ()
    torsion_springs: Annotated[tuple[TorsionSpring, ...], "Torsion springs and dampers."] = ()
    conditions: Annotated[tuple[Condition, ...], "Conditions on rates, which no formula of coordinates keeps."] = ()
    speeds: Annotated[tuple[GeneralizedSpeed, ...], "Generalized speeds, in place of rates."] = ()


@record
class CoordinateEquation:
    """The equation of one coordinate."""

    name: Annotated[Text, "The coordinate."]
    acceleration: Annotated[FreeNumber, "Second derivative of the coordinate, from F_r + F*_r = 0."]
    by_lagrange: Annotated[FreeNumber, "The same from d/dt ∂T/∂q̇_r − ∂T/∂q_r = Q_r."]
    active_force: Annotated[FreeNumber, "Generalized active force F_r."]
    lagrange_force: Annotated[FreeNumber, "Q_r, from potentials and powers."]
    inertia_force: Annotated[FreeNumber, "Generalized inertia force F*_r; with F_r it gives zero."]
    velocity_force: Annotated[FreeNumber, "Its part quadratic in the speeds: F*_r where all q̈ are zero."]


@record
class SpeedEquation:
    """The equation of one generalized speed."""

    name: Annotated[Text, "The speed."]
    value: Annotated[FreeNumber, "Its value u_r."]
    acceleration: Annotated[FreeNumber, "Its derivative u̇_r, from F̃_r + F̃*_r = 0."]
    active_force: Annotated[FreeNumber, "Generalized active force F̃_r, that of a condition left out."]


@record
class ConditionForce:
    """The force that keeps a condition."""

    name: Annotated[Text, "The condition."]
    force: Annotated[FreeNumber, "Its force, along what the condition keeps at zero."]
    by_lagrange: Annotated[FreeNumber, "The same as Lagrange's multiplier."]


@record
class MassRow:
    """A row of the mass matrix."""

    name: Annotated[Text, "The coordinate of the row."]
    entries: Annotated[tuple[FreeNumber, ...], "Its entries, by column."]


@record
class Partial:
    """How a point or a body moves with one coordinate alone."""

    coordinate: Annotated[Text, "The coordinate."]
    of: Annotated[Text, "The body's centre, or the point."]
    velocity: Annotated[FreeVector, "Partial velocity: velocity per rate of the coordinate."]
    angular_velocity: Annotated[FreeVector | None, "Partial angular velocity of a body."]


@record
class Share:
    """What one load, or the inertia of one body, contributes to a generalized force."""

    coordinate: Annotated[Text, "The coordinate."]
    of: Annotated[Text, "The load or the body."]
    sort: Annotated[Text, "weight, force, torque, spring or inertia."]
    velocity: Annotated[FreeVector | None, "Partial velocity of the point where it acts; of a spring's end, relative."]
    force: Annotated[FreeVector | None, "The force; −m·a of inertia."]
    angular_velocity: Annotated[FreeVector | None, "Partial angular velocity."]
    moment: Annotated[FreeVector | None, "The moment; −dH/dt of inertia."]
    share: Annotated[FreeNumber, "Force · partial velocity + moment · partial angular velocity."]


@record
class Equations:
    """The equations of motion at an instant."""

    equations: Annotated[tuple[CoordinateEquation, ...], "The equation of each coordinate."]
    difference: Annotated[
        Ratio, "Largest difference of Kane's and Lagrange's accelerations, as a share of their terms [-]."
    ]
    kinetic_energy: Annotated[PotentialEnergy, "Kinetic energy T [J]."]
    potential_energy: Annotated[PotentialEnergy, "Potential energy V of gravity and springs [J]."]
    drive_power: Annotated[
        Power | None, "Power of what imposes the motion that formulas with t prescribe; null where none does [W]."
    ]
    mass_matrix: Annotated[tuple[MassRow, ...], "The mass matrix ∂²T/∂q̇_r∂q̇_s."]
    speeds: Annotated[tuple[SpeedEquation, ...] | None, "The equation of each generalized speed."]
    conditions: Annotated[tuple[ConditionForce, ...] | None, "The forces that keep the conditions."]
    terms: Annotated[tuple[Share, ...] | None, "What makes up the equation that was asked for."]
    partials: Annotated[tuple[Partial, ...], "Partial velocities and partial angular velocities."]
    shares: Annotated[tuple[Share, ...], "What each load and each body's inertia contributes."]
    numerics: Numerics
    checks: tuple[Check, ...] = ()
