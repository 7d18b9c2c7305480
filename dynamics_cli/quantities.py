"""The vocabulary of signatures: what a number is, which unit it is in inside the program, and what it may be.

For a type checker `Length` is plain `float`; at run time it is a `Kind` that says: a length, in metres, shown in m or
ft. Importing this module must cost nothing a shell user can feel, so it uses neither typing nor dataclasses.
"""

TYPE_CHECKING = False


class Kind:
    """What a leaf of a signature means: its name, SI unit, bounds, the units it is shown in, and an example.

    `form` says how it is read: "scalar", "slope" (rise over run, or an angle), "vector", "planar" (a planar vector),
    "tensor", "free vector" and "free" (a vector or a number of any kind, held by a `Quantity`), "matrix" (exact
    ratios), "whole" (a whole number), "range" (the first and last of whole numbers), "fraction" (an exact ratio),
    "exact" (an exact rational with its unit), "unit", "text", "file", "flag", "formula" (an expression with its unit at
    its end), "let" (a variable of formulas and its value) or "measured" (a result with a unit of its own).

    A vector of a `flat` kind may leave out z, which is zero then: a motion in the x–y plane.

    A number of a kind that is `exact` keeps the decimals it was typed as, beside the double nearest to them. One of a
    kind that is `certain` takes no distribution: it says itself how uncertain something is. One with a `letter` may be
    written as standards designate it, G 6.3 or 6.3, in the unit it is shown in. One of a `compass` is a heading, which
    has words where the axes are those of a compass: north, NE, N 30 E.

    A kind with a `default` is never missing: the environment `variable`, else the default, stands in and is shown among
    the inputs; with `needs`, only when the parameter of that name is given.
    """

    __slots__ = (
        "about", "above", "below", "certain", "compass", "default", "exact", "example", "flat", "form", "high", "letter", "low",
        "name", "needs", "si", "size", "unit", "us", "variable",
    )  # fmt: skip

    def __init__(
        self,
        name: str,
        unit: str,
        *,
        form: str = "scalar",
        si: str = "",
        us: str = "",
        low: float | None = None,
        high: float | None = None,
        above: float | None = None,
        below: float | None = None,
        example: str = "",
        about: str = "",
        size: int = 0,
        default: str = "",
        variable: str = "",
        needs: str = "",
        exact: bool = False,
        certain: bool = False,
        flat: bool = False,
        letter: str = "",
        compass: bool = False,
    ) -> None:
        self.name = name
        self.unit = unit
        self.form = form
        self.si = si or unit
        self.us = us or self.si
        self.low = low
        self.high = high
        self.above = above
        self.below = below
        self.example = example
        self.about = about
        self.size = size
        self.default = default
        self.variable = variable
        self.needs = needs
        self.exact = exact
        self.certain = certain
        self.flat = flat
        self.letter = letter
        self.compass = compass

    def shown_in(self, system: str) -> str:
        """The unit this kind is shown in by the system "si", "us" or "base"."""
        return {"si": self.si, "us": self.us, "base": self.unit}[system]

    def outside(self, value: float) -> str | None:
        """What `value` (SI) should have been, or None when it is within bounds."""
        if self.low is not None and not value >= self.low:
            return f"at least {self.low:g}"
        if self.above is not None and not value > self.above:
            return f"greater than {self.above:g}"
        if self.high is not None and not value <= self.high:
            return f"at most {self.high:g}"
        if self.below is not None and not value < self.below:
            return f"less than {self.below:g}"
        return None

    @property
    def one(self) -> str:
        """Its name with the article: a force, an angle."""
        return f"a{'n' * (self.name[:1] in ('a', 'e', 'i', 'o', 'u'))} {self.name}"

    def __or__(self, other: object) -> "Alternatives":
        return Alternatives(self, other)

    def __ror__(self, other: object) -> "Alternatives":
        return Alternatives(other, self)

    def __repr__(self) -> str:
        return f"Kind({self.name!r})"


def vector(name: str, unit: str, *, size: int = 3, **more: "Any") -> Kind:
    """A kind of vectors in space, or of other rows of numbers of one unit."""
    return Kind(name, unit, form="vector", size=size, **more)


def planar(name: str, unit: str, **more: "Any") -> Kind:
    """A kind of vectors in the plane."""
    return Kind(name, unit, form="planar", size=2, **more)


def formula(name: str, unit: str, **more: "Any") -> Kind:
    """A kind of formulas with their unit at their end."""
    return Kind(name, unit, form="formula", **more)


class Alternatives:
    """What `Length | None` is at run time."""

    __slots__ = ("__args__",)

    def __init__(self, *members: object) -> None:
        self.__args__ = members

    def __or__(self, other: object) -> "Alternatives":
        return Alternatives(*self.__args__, other)

    def __ror__(self, other: object) -> "Alternatives":
        return Alternatives(other, *self.__args__)


class Described:
    """What `Annotated[Length, "its description"]` is at run time; typing's own would cost two interpreter starts."""

    __slots__ = ("inner", "text")

    def __init__(self, inner: object, text: str) -> None:
        self.inner = inner
        self.text = text

    def __class_getitem__(cls, given: "tuple[object, str]") -> "Described":
        return cls(*given)


if TYPE_CHECKING:
    from typing import Annotated as Annotated
else:
    Annotated = Described

STANDARD_GRAVITY = 9.80665
STANDARD_GRAVITY_TEXT = "9.80665 m/s²"

if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.records import Formula, Let, Quantity

    # lengths, areas, volumes
    Length = float
    Noise = float
    Distance = float
    Size = float
    Coordinate = float
    SectionSize = float
    SectionCoordinate = float
    SurveyCoordinate = float
    Area = float
    Volume = float
    FloorArea = float
    RoomVolume = float
    Module = float
    DiametralPitch = float
    Curvature = float
    # mass and its densities
    Mass = float
    SignedMass = float
    Density = float
    ArealDensity = float
    LinearDensity = float
    Inertia = float
    ProductOfInertia = float
    SecondMoment = float
    SectionModulus = float
    # time and motion
    Time = float
    EvaluationTime = float
    Speed = float
    RoadSpeed = float
    RoadVelocity = float
    Acceleration = float
    Deceleration = float
    Gravity = float
    Jerk = float
    CamVelocity = float
    CamAcceleration = float
    CamJerk = float
    SwingVelocity = float
    SwingAcceleration = float
    SwingJerk = float
    Frequency = float
    AngularSpeed = float
    ShaftSpeed = float
    AngularRate = float
    AngularAcceleration = float
    GrowthRate = float
    SlowTurnRate = float
    LongTime = float
    LongDistance = float
    TurnRate = float
    # angles and pure numbers
    Angle = float
    Heading = float
    Ratio = float
    Positive = float
    Friction = float
    Restitution = float
    Fraction = float
    DragFactor = float
    Gain = float
    # forces and energy
    Force = float
    Weight = float
    Torque = float
    Energy = float
    PotentialEnergy = float
    Power = float
    MusclePower = float
    Impulse = float
    AngularImpulse = float
    Pressure = float
    Stiffness = float
    TorsionStiffness = float
    LineForce = float
    DistributedForce = float
    CrushStiffness = float
    SpeedSlope = float
    SpeedFade = float
    Damping = float
    Temperature = float
    Unbalance = float
    CoupleUnbalance = float
    Eccentricity = float
    BalanceGrade = float
    BalanceMass = float
    DampingRatio = float
    ViscousDamping = float
    TorsionDamping = float
    SpringRate = float
    Receptance = float
    VibrationSpeed = float
    SagGravity = float
    # read in a way of their own
    Slope = float
    Count = int
    Teeth = int
    Vector = tuple[float, float, float]
    Position = tuple[float, float, float]
    SpacePosition = tuple[float, float, float]
    Direction = tuple[float, float, float]
    Velocity = tuple[float, float, float]
    SpaceVelocity = tuple[float, float, float]
    AngularVelocity = tuple[float, float, float]
    AngularAccelerationVector = tuple[float, float, float]
    AccelerationVector = tuple[float, float, float]
    JerkVector = tuple[float, float, float]
    HandPosition = tuple[float, float, float]
    PartPosition = tuple[float, float, float]
    PartLengths = tuple[float, float, float]
    InertiaTriple = tuple[float, float, float]
    TorqueVector = tuple[float, float, float]
    LoadPoint = tuple[float, float, float]
    MassMoment = tuple[float, float, float]
    ForceVector = tuple[float, float, float]
    AngularMomentumVector = tuple[float, float, float]
    Quaternion = tuple[float, float, float, float]
    AngleTriple = tuple[float, float, float]
    AngleRates = tuple[float, float, float]
    AngleAccelerations = tuple[float, float, float]
    RotationVector = tuple[float, float, float]
    RotationMatrix = tuple[tuple[float, float, float], tuple[float, float, float], tuple[float, float, float]]
    ImpulseVector = tuple[float, float, float]
    MomentVector = tuple[float, float, float]
    PlanarPosition = tuple[float, float]
    PlanarVelocity = tuple[float, float]
    PlanarImpulse = tuple[float, float]
    PartPoint = tuple[float, float]
    PartVelocity = tuple[float, float]
    PartAcceleration = tuple[float, float]
    PlanarForce = tuple[float, float]
    InertiaTensor = tuple[tuple[float, float, float], tuple[float, float, float], tuple[float, float, float]]
    FreeVector = Quantity
    FreeNumber = Quantity
    Matrix = tuple[tuple[tuple[int, int], ...], ...]
    MatrixOfNumbers = tuple[tuple[float, ...], ...]
    ExactRatio = tuple[int, int]
    WholeRange = tuple[int, int]
    LengthFormula = Formula
    AngleFormula = Formula
    AccelerationFormula = Formula
    EnergyFormula = Formula
    ForceFormula = Formula
    TorqueFormula = Formula
    TurnRateFormula = Formula
    SpeedFormula = Formula
    Variable = Let
    Text = str
    Remark = str
    Unit = str
    InputFile = str
else:
    # fmt: off
    # lengths, areas, volumes
    Length = Kind("length", "m", us="ft", example="60 ft", about="a length, distances on a scene")
    Noise = Kind("length", "m", us="ft", example="3 cm", about="the standard deviation of a position", certain=True)
    Distance = Kind("length", "m", us="ft", low=0.0, example="60 ft", about="a length that cannot be negative")
    Size = Kind("size", "m", si="mm", us="in", low=0.0, example="12 mm", about="a machine part's length")
    Coordinate = Kind("size", "m", si="mm", us="in", example="-4 mm", about="a signed length on a machine part")
    SectionSize = Kind("size", "m", si="mm", us="in", low=0.0, example="12 mm", about="a machine part's length",
        exact=True)
    SectionCoordinate = Kind("size", "m", si="mm", us="in", example="-4 mm", about="a signed length on a machine part",
        exact=True)
    SurveyCoordinate = Kind("length", "m", us="ft", example="5.2 m", about="a coordinate of a survey, of either sign",
        exact=True)
    Area = Kind("area", "m^2", si="mm^2", us="in^2", low=0.0, example="3 in^2", about="an area")
    FloorArea = Kind("floor area", "m^2", us="ft^2", low=0.0, example="3 m^2", about="an area that a machine covers")
    RoomVolume = Kind("room", "m^3", us="ft^3", low=0.0, example="2 m^3", about="a volume that a machine covers")
    Volume = Kind("volume", "m^3", si="mm^3", us="in^3", low=0.0, example="2 cm^3", about="a volume")
    Module = Kind("module", "m", si="mm", above=0.0, example="2.5 mm", about="a gear module")
    DiametralPitch = Kind("diametral pitch", "1/m", si="1/in", above=0.0, example="8 1/in",
        about="teeth per inch of pitch diameter")
    Curvature = Kind("curvature", "1/m", us="1/ft", example="0.01 1/m", about="a curvature")
    # mass and its densities
    Mass = Kind("mass", "kg", us="lb", low=0.0, example="1500 kg", about="a mass")
    SignedMass = Kind("mass", "kg", us="lb", example="-2 kg", about="a mass, negative when it is taken away")
    Density = Kind("density", "kg/m^3", us="lb/ft^3", low=0.0, example="7850 kg/m^3", about="mass per volume")
    ArealDensity = Kind("areal density", "kg/m^2", us="lb/ft^2", low=0.0, example="8 kg/m^2", about="mass per area")
    LinearDensity = Kind("linear density", "kg/m", us="lb/ft", low=0.0, example="2 kg/m", about="mass per length")
    Inertia = Kind("moment of inertia", "kg*m^2", us="slug*ft^2", low=0.0, example="2500 kg*m^2",
        about="a moment of inertia")
    ProductOfInertia = Kind("product of inertia", "kg*m^2", us="slug*ft^2", example="-0.2 kg*m^2",
        about="a product of inertia, of either sign")
    SecondMoment = Kind("second moment of area", "m^4", si="mm^4", us="in^4", example="1e4 mm^4",
        about="a second moment of area")
    SectionModulus = Kind("section modulus", "m^3", si="mm^3", us="in^3", low=0.0, example="5000 mm^3",
        about="an elastic section modulus")
    # time and motion
    Time = Kind("time", "s", low=0.0, example="1.5 s", about="a duration")
    LongTime = Kind("time", "s", si="h", low=0.0, example="24 h", about="a time of hours")
    LongDistance = Kind("length", "m", si="km", us="mi", low=0.0, example="100 km", about="a distance on the earth")
    EvaluationTime = Kind("time", "s", si="us", low=0.0, example="3 us", about="the time of a calculation")
    Speed = Kind("speed", "m/s", us="ft/s", example="12 m/s", about="a speed or velocity component")
    RoadVelocity = Kind("road velocity", "m/s", si="km/h", us="mph", example="-12 km/h",
        about="a velocity component on a road")
    RoadSpeed = Kind("road speed", "m/s", si="km/h", us="mph", low=0.0, example="50 mph", about="a speed on a road")
    Acceleration = Kind("acceleration", "m/s^2", us="ft/s^2", example="9.81 m/s^2", about="an acceleration")
    Deceleration = Kind("acceleration", "m/s^2", us="ft/s^2", above=0.0, example="0.7 g",
        about="a rate of slowing down")
    Gravity = Kind("acceleration", "m/s^2", us="ft/s^2", above=0.0, example="32.2 ft/s^2",
        about="the acceleration of gravity", default=STANDARD_GRAVITY_TEXT, variable="DYNAMICS_GRAVITY")
    Jerk = Kind("jerk", "m/s^3", us="ft/s^3", example="3 m/s^3", about="rate of change of acceleration")
    CamVelocity = Kind("lift per angle", "m/rad", si="mm/rad", us="in/rad", example="5 mm/rad",
        about="a lift per cam angle")
    CamAcceleration = Kind("lift per angle squared", "m/rad^2", si="mm/rad^2", us="in/rad^2", example="10 mm/rad^2",
        about="a lift per cam angle squared")
    CamJerk = Kind("lift per angle cubed", "m/rad^3", si="mm/rad^3", us="in/rad^3", example="20 mm/rad^3",
        about="a lift per cam angle cubed")
    SwingVelocity = Kind("angle per angle", "", example="0.3", about="an arm's angle per cam angle")
    SwingAcceleration = Kind("angle per angle squared", "1/rad", example="0.5 1/rad",
        about="an arm's angle per cam angle squared")
    SwingJerk = Kind("angle per angle cubed", "1/rad^2", example="2 1/rad^2",
        about="an arm's angle per cam angle cubed")
    Frequency = Kind("frequency", "Hz", low=0.0, example="50 Hz", about="events per time (not an angular velocity)")
    AngularSpeed = Kind("angular velocity", "rad/s", si="deg/s", example="1500 rpm", about="an angular velocity")
    AngularRate = Kind("angular velocity", "rad/s", example="2 rad/s", about="an angular velocity")
    ShaftSpeed = Kind("angular velocity", "rad/s", si="rpm", example="1500 rpm", about="the speed of a shaft")
    SlowTurnRate = Kind("angular velocity", "rad/s", si="deg/h", example="15 deg/h",
        about="a rate of turning with the earth")
    GrowthRate = Kind("growth rate", "1/s", example="-2 1/s", about="a rate of growth, negative for decay")
    AngularAcceleration = Kind("angular acceleration", "rad/s^2", example="3 rad/s^2", about="an angular acceleration")
    TurnRate = Kind("angular velocity", "rad/s", example="10 rad/s", about="the angular velocity of a link")
    # angles and pure numbers
    Angle = Kind("angle", "rad", si="deg", example="30 deg", about="an angle")
    Heading = Kind("angle", "rad", si="deg", example="90 deg", about="a heading", compass=True)
    Ratio = Kind("ratio", "", example="0.5", about="a pure number")
    Positive = Kind("ratio", "", above=0.0, example="2", about="a pure number above zero")
    Friction = Kind("friction", "", low=0.0, example="0.7", about="a coefficient of friction")
    Restitution = Kind("restitution", "", low=0.0, high=1.0, example="0.3", about="a coefficient of restitution")
    Fraction = Kind("fraction", "", si="%", low=0.0, high=1.0, example="80 %", about="a share between nothing and all")
    DragFactor = Kind("drag factor", "", low=0.0, example="0.65", about="deceleration over gravity")
    Gain = Kind("gain", "", example="2.5", about="a pure number of either sign", exact=True)
    # forces and energy
    Force = Kind("force", "N", us="lbf", example="200 lbf", about="a force")
    Weight = Kind("force", "N", us="lbf", above=0.0, example="3400 lbf", about="a weight")
    Torque = Kind("torque", "N*m", us="lbf*ft", example="30 lbf*ft", about="a torque (not an energy)")
    PotentialEnergy = Kind("energy", "J", us="ft*lbf", example="20 J", about="a potential energy")
    Energy = Kind("energy", "J", si="kJ", us="ft*lbf", example="20 kJ", about="an energy (not a torque)")
    Power = Kind("power", "W", si="kW", us="hp", example="15 kW", about="a power")
    MusclePower = Kind("power", "W", us="ft*lbf/s", example="250 W", about="a power of muscles")
    Impulse = Kind("impulse", "N*s", us="lbf*s", example="4000 N*s", about="an impulse or momentum")
    AngularImpulse = Kind("angular impulse", "N*m*s", us="lbf*ft*s", example="300 N*m*s",
        about="an angular impulse or momentum")
    Pressure = Kind("pressure", "Pa", si="MPa", us="psi", example="30 psi", about="a pressure or stress")
    Stiffness = Kind("stiffness", "N/m", si="N/mm", us="lbf/in", low=0.0, example="20 N/mm",
        about="force per deflection")
    TorsionStiffness = Kind("torsion stiffness", "N*m/rad", us="lbf*in/rad", low=0.0, example="20 N*m/rad",
        about="torque per angle of twist")
    LineForce = Kind("force per width", "N/m", si="N/cm", us="lbf/in", low=0.0, example="350 lbf/in",
        about="force per width crushed")
    DistributedForce = Kind("force per length", "N/m", us="lbf/ft", example="300 N/m", about="force per length of a beam")
    CrushStiffness = Kind("crush stiffness", "N/m^2", si="N/cm^2", us="lbf/in^2", above=0.0, example="60 lbf/in^2",
        about="force per width and per depth of crush")
    SpeedSlope = Kind("speed per crush", "1/s", si="km/h/cm", us="mph/in", above=0.0, example="1.6 mph/in",
        about="impact speed per depth of crush")
    SpeedFade = Kind("acceleration per speed", "1/s", low=0.0, example="0.12 1/s", about="acceleration per speed")
    Damping = Kind("damping", "N*s/m", us="lbf*s/ft", low=0.0, example="50 N*s/m", about="force per speed")
    Temperature = Kind("temperature", "K", si="degC", us="degF", low=0.0, example="20 degC", about="a temperature")
    # balancing
    Unbalance = Kind("unbalance", "kg*m", si="g*mm", us="oz*in", low=0.0, example="240 g*mm",
        about="a mass times its radius")
    CoupleUnbalance = Kind("couple unbalance", "kg*m^2", si="g*mm*m", us="oz*in^2", low=0.0, example="50 g*mm*m",
        about="an unbalance times its distance from the opposite one")
    Eccentricity = Kind("eccentricity", "m", si="um", us="mil", low=0.0, example="20 um",
        about="a centre of mass off the axis")
    BalanceGrade = Kind("balance grade", "m/s", si="mm/s", above=0.0, example="G6.3", letter="G",
        about="eccentricity times angular velocity: G 6.3 is 6.3 mm/s")
    BalanceMass = Kind("mass", "kg", si="g", us="oz", low=0.0, example="20 g", about="a small mass")
    # vibration; what is negative is refused by physics, which says what becomes of the motion
    DampingRatio = Kind("damping ratio", "", example="0.05", about="damping over critical damping")
    ViscousDamping = Kind("damping", "N*s/m", us="lbf*s/in", example="50 N*s/m", about="force per speed")
    TorsionDamping = Kind("torsion damping", "N*m*s/rad", us="lbf*in*s/rad", low=0.0, example="2 N*m*s/rad",
        about="torque per angular velocity")
    SpringRate = Kind("stiffness", "N/m", si="N/mm", us="lbf/in", example="20 N/mm", about="force per deflection")
    Receptance = Kind("receptance", "m/N", si="um/N", us="in/lbf", example="5 um/N", about="amplitude per force")
    SagGravity = Kind("acceleration", "m/s^2", us="ft/s^2", above=0.0, example="32.2 ft/s^2",
        about="the acceleration of gravity", default=STANDARD_GRAVITY_TEXT, variable="DYNAMICS_GRAVITY",
        needs="static_deflection")
    VibrationSpeed = Kind("vibration velocity", "m/s", si="mm/s", us="in/s", example="4.5 mm/s",
        about="a velocity of vibration")
    # read in a way of their own
    Slope = Kind("slope", "", form="slope", si="%", example="-3 %", about="rise over run, or an angle; uphill positive")
    Count = Kind("count", "", form="whole", low=0.0, example="3", about="a whole number")
    Teeth = Kind("teeth", "", form="whole", low=1.0, example="24", about="a number of teeth")
    Vector = vector("vector", "", example="1, 0, 2", about="three pure numbers")
    Position = vector("position", "m", us="ft", example="1, 2, 3 m", about="a point", flat=True)
    LoadPoint = vector("point", "m", us="ft", example="1, 2 m", about="a point, in the x–y plane or in space",
        exact=True, flat=True)
    MassMoment = vector("first moment", "kg*m", us="lb*ft", example="1, 2, 0 kg*m", about="mass times position")
    # of bodies in space, where a missing z is a mistake
    SpacePosition = vector("position", "m", us="ft", example="1, 2, 3 m", about="a point")
    SpaceVelocity = vector("velocity", "m/s", us="ft/s", example="3, 0, 1 m/s", about="a velocity")
    Direction = vector("direction", "", example="0, 0, 1", about="a direction")
    Velocity = vector("velocity", "m/s", us="ft/s", example="3, 0, 1 m/s", about="a velocity", flat=True)
    AngularVelocity = vector("angular velocity vector", "rad/s", example="0, 0, 2 rad/s", about="an angular velocity")
    AngularAccelerationVector = vector("angular acceleration vector", "rad/s^2", example="0, 0, 5 rad/s^2",
        about="an angular acceleration")
    AccelerationVector = vector("acceleration vector", "m/s^2", us="ft/s^2", example="0, 0, 3 m/s^2",
        about="an acceleration", flat=True)
    JerkVector = vector("jerk vector", "m/s^3", us="ft/s^3", example="0, 1, 0 m/s^3",
        about="a rate of change of acceleration", flat=True)
    HandPosition = vector("hand position", "m", si="mm", us="in", example="450, 100, 600 mm",
        about="a place that a machine reaches", flat=True)
    PartPosition = vector("part position", "m", si="mm", us="in", example="10, 0, 25 mm",
        about="a point of a machine part")
    PartLengths = vector("part lengths", "m", si="mm", us="in", example="10, 20, 30 mm",
        about="three lengths of a machine part")
    InertiaTriple = vector("moments of inertia", "kg*m^2", us="slug*ft^2", example="2, 3, 4 kg*m^2",
        about="three moments or products of inertia")
    TorqueVector = vector("torque vector", "N*m", us="lbf*ft", example="0, 0, 5 N*m", about="a torque")
    ForceVector = vector("force vector", "N", us="lbf", example="0, 0, 5 N", about="a force")
    ImpulseVector = vector("impulse vector", "N*s", us="lbf*s", example="0, 3, 1 N*s", about="an impulse in space")
    MomentVector = vector("angular impulse vector", "N*m*s", us="lbf*ft*s", example="0, 3, 1 N*m*s",
        about="an angular impulse in space")
    AngularMomentumVector = vector("angular momentum vector", "N*m*s", us="lbf*ft*s", example="0, 0, 5 N*m*s",
        about="an angular momentum")
    Quaternion = vector("quaternion", "", size=4, example="0.92388, 0, 0, 0.382683",
        about="a rotation as the quaternion w, x, y, z, its scalar first")
    AngleTriple = vector("three angles", "rad", si="deg", example="30, 20, -40 deg", about="three angles")
    AngleRates = vector("rates of three angles", "rad/s", example="0.1, 0.2, 0.3 rad/s", about="rates of angles")
    AngleAccelerations = vector("second rates of three angles", "rad/s^2", example="0.4, -0.5, 0.6 rad/s^2",
        about="second rates of angles")
    RotationVector = vector("rotation vector", "rad", example="0, 0, 1.2 rad",
        about="a rotation as its axis times its angle")
    RotationMatrix = Kind("rotation matrix", "", form="tensor", size=3,
        about="a rotation as its matrix, the turned axes in its columns")
    PlanarPosition = planar("planar position", "m", us="ft", example="1, 2 m", about="a point in the plane")
    PlanarVelocity = planar("planar velocity", "m/s", si="km/h", us="mph", example="30 mph @ 45 deg",
        about="a velocity in the plane")
    PlanarImpulse = planar("planar impulse", "N*s", us="lbf*s", example="3000, 400 N*s",
        about="an impulse in the plane")
    PartPoint = planar("part point", "m", si="mm", us="in", example="60, 40 mm", about="a point in the plane")
    PartVelocity = planar("velocity in the plane", "m/s", us="ft/s", example="1, 2 m/s",
        about="a velocity in the plane")
    PartAcceleration = planar("acceleration in the plane", "m/s^2", us="ft/s^2", example="3, -4 m/s^2",
        about="an acceleration in the plane")
    PlanarForce = planar("force in the plane", "N", us="lbf", example="60, -20 N", about="a force in the plane")
    InertiaTensor = Kind("inertia tensor", "kg*m^2", form="tensor", size=3, us="slug*ft^2",
        example="[[2, 0, 0], [0, 3, 0], [0, 0, 4]] kg*m^2",
        about="a symmetric tensor, as its matrix or as moments and products")
    FreeVector = Kind("vector", "", form="free vector", example="20 N @ 30 deg",
        about="a vector of any kind, planar or in space")
    FreeNumber = Kind("quantity", "", form="free", about="a number whose kind is that of the inputs")
    Matrix = Kind("matrix", "", form="matrix", example="2, 1; 1, 3", about="rows of exact numbers, up to six by six")
    MatrixOfNumbers = Kind("matrix", "", form="matrix", about="rows of numbers")
    ExactRatio = Kind("exact ratio", "", form="fraction", example="365.2422/27.3217", about="an exact ratio")
    WholeRange = Kind("range", "", form="range", low=0.0, example="12..120", about="whole numbers from one to another")
    LengthFormula = formula("length formula", "m", example="20*t - 2*t^2 m",
        about="a length over time, its unit at its end")
    AngleFormula = formula("angle formula", "rad", example="90*t deg", about="an angle over time, its unit at its end")
    AccelerationFormula = formula("acceleration formula", "m/s^2", example="-0.004*v^2 m/s^2",
        about="an acceleration, its unit at its end")
    EnergyFormula = formula("energy formula", "J", example="4*x^4 - 2*x^2 J", about="an energy, its unit at its end")
    ForceFormula = formula("force formula", "N", example="20*sin(5*t) N",
        about="a force over time, its unit at its end")
    TorqueFormula = formula("torque formula", "N*m", example="2 - 0.01*speed N*m",
        about="a torque, its unit at its end")
    TurnRateFormula = formula("angular velocity formula", "rad/s", example="300*t rpm",
        about="an angular velocity over time, its unit at its end")
    SpeedFormula = formula("speed formula", "m/s", example="R*phi_dot - x_dot m/s",
        about="a speed, its unit at its end")
    Variable = Kind("variable", "", form="let", example="a=3 m", about="a variable of the formulas")
    Text = Kind("text", "", form="text", example="a name", about="words")
    Remark = Kind("remark", "", form="text", about="words about every case, which rows leave out")
    Unit = Kind("unit", "", form="unit", example="ft/s", about="a unit")
    InputFile = Kind("file", "", form="file", example="data.csv", about="a file to read")
    # fmt: on
