"""Options that several tasks of gears share: their kinds, words and defaults."""

from dynamics_cli.gear.single.gear import Hand, Sign
from dynamics_cli.gear.single.rack import Profile
from dynamics_cli.quantities import Angle, Annotated, Coordinate, Count, Ratio, Size

RACK_A, ISO, RIGHT = Profile("a"), Sign("iso"), Hand("right")

RackName = Annotated[
    Profile, "Basic rack: a to d of ISO 53, stub, agma-coarse, agma-fine; the factors below replace its own."
]
AddendumFactor = Annotated[Ratio | None, "Addendum factor h_a*, in modules, e.g. 1."]
DedendumFactor = Annotated[Ratio | None, "Dedendum factor h_fP*, in modules, e.g. 1.25."]
RackCorner = Annotated[
    Ratio | None,
    "Radius of the rack's corner ρ_fP*; a basic rack's radius that does not fit becomes a full round, e.g. 0.38.",
]
# Of tasks that follow the root of an internal gear.
RootRadius = Annotated[
    Ratio | None, "Radius of the rack's corner ρ_fP*; of an internal gear's fillet (0.2 unless given), e.g. 0.38."
]
PressureAngle = Annotated[Angle, "Normal pressure angle α_n [rad]."]
NormalAngle = Annotated[Angle | None, "Normal pressure angle α_n; 20 degrees unless one is given, e.g. 20 deg [rad]."]
TransverseAngle = Annotated[
    Angle | None, "Transverse pressure angle α_t, in place of the normal one, e.g. 20 deg [rad]."
]
HelixAngle = Annotated[Angle, "Helix angle β at the reference cylinder; 0 for a spur gear [rad]."]
HelixHand = Annotated[Hand, "Hand of the helix."]
ShiftSign = Annotated[
    Sign, "Sign of an internal gear's shift: iso, positive towards its tips, or outward, as KHK and JIS have it."
]
Internal = Annotated[bool, "An internal gear (ring)."]
AvoidUndercut = Annotated[
    bool, "Choose the smallest shift, not below zero, that avoids undercut, in place of a given one."
]
TipShortening = Annotated[Size, "How much the tips are cut back, radially [m]."]
TipDiameter = Annotated[Size | None, "Tip diameter, in place of that of the rack, e.g. 80 mm [m]."]
Pin = Annotated[Size | None, "Diameter of pins or balls; the nearest standard one unless given, e.g. 5.5 mm [m]."]
Over = Annotated[Count | None, "Teeth to span (spaces of an internal gear); the best number if left out, e.g. 4."]
UpperAllowance = Annotated[
    Coordinate | None, "Upper deviation of the normal tooth thickness, E_sns, negative for backlash, e.g. -0.05 mm [m]."
]
LowerAllowance = Annotated[
    Coordinate | None, "Lower deviation of the normal tooth thickness, E_sni, e.g. -0.09 mm [m]."
]
