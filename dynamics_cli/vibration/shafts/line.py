"""A torsional line as users give it, and its reduction to one speed: gears turn all behind them with their ratio."""

import math

from dynamics_cli.errors import require
from dynamics_cli.quantities import (
    Annotated,
    Inertia,
    Pressure,
    Ratio,
    Size,
    Teeth,
    Text,
    TorsionDamping,
    TorsionStiffness,
)
from dynamics_cli.records import record
from dynamics_cli.vibration.systems.inputs import FIXED, Bodies, Body, Coupling, System

TYPE_CHECKING = False

STEEL = 79.3e9
# Ratios round a closed train that differ by more, relatively, lock it.
LOCKED = 1e-9


@record
class Rotor:
    """A body that turns."""

    name: Annotated[Text, "Its name."]
    inertia: Annotated[Inertia, "Moment of inertia about its axis, e.g. 0.5 kg*m^2."]


@record
class Rate:
    """A shaft by its stiffness."""

    stiffness: Annotated[TorsionStiffness, "Torque per angle of twist, e.g. 2000 N*m/rad."]

    @property
    def rate(self) -> float:
        """The stiffness."""
        return self.stiffness


@record
class Round:
    """A round shaft by its size."""

    diameter: Annotated[Size, "Outer diameter, e.g. 50 mm."]
    length: Annotated[Size, "Length that twists, e.g. 600 mm."]
    bore: Annotated[Size, "Inner diameter of a hollow shaft, e.g. 20 mm."] = 0.0
    shear_modulus: Annotated[Pressure, "Shear modulus; steel unless given, e.g. 79300 MPa."] = STEEL

    @property
    def rate(self) -> float:
        """G·J/L, J = π/32·(D − d)(D + d)(D² + d²)."""
        outer, inner = self.diameter, self.bore
        require(outer > inner, "the bore of {bore} leaves nothing of a shaft of {outer}", bore=(inner, Size),
                outer=(outer, Size), code="bore")  # fmt: skip
        require(self.length > 0.0, "a shaft of length zero is rigid", code="rigid",
                hint="put the two inertias into one rotor")  # fmt: skip
        polar = math.pi / 32.0 * (outer - inner) * (outer + inner) * (outer * outer + inner * inner)
        return self.shear_modulus * polar / self.length


@record
class Shaft:
    """A shaft between two rotors."""

    from_: Annotated[Text, "The rotor at one end."]
    to: Annotated[Text, "The rotor at the other end, or ground."]
    spring: Annotated[Rate | Round, "Its stiffness, or its size."]
    damping: Annotated[TorsionDamping, "Torque per angular velocity of twist, e.g. 2 N*m*s/rad."] = 0.0


@record
class ByTeeth:
    """A ratio by teeth."""

    driver_teeth: Annotated[Teeth, "Teeth of the driver, e.g. 20."]
    driven_teeth: Annotated[Teeth, "Teeth of the driven wheel, e.g. 60."]

    @property
    def turns(self) -> float:
        """Turns of the driver for one of the driven wheel."""
        return self.driven_teeth / self.driver_teeth


@record
class BySpeeds:
    """A ratio by speeds."""

    ratio: Annotated[Ratio, "Speed of the driver over that of the driven wheel; its sign is left out, e.g. 3."]

    @property
    def turns(self) -> float:
        """Turns of the driver for one of the driven wheel."""
        require(self.ratio != 0.0, "a ratio of zero drives nothing", code="ratio", hint="give --gear ratio=3")
        return abs(self.ratio)


@record
class Gear:
    """Two rotors that mesh."""

    driver: Annotated[Text, "The rotor that is the driver."]
    driven: Annotated[Text, "The rotor that it drives."]
    ratio_of: Annotated[ByTeeth | BySpeeds, "Teeth, or a ratio of speeds."]
    internal: Annotated[bool, "An internal mesh or a chain: both turn in one sense."] = False


class ShaftLine:
    """Rotors with their speed over that of the reference, and the system reduced to the reference's speed."""

    def __init__(
        self, rotors: "tuple[Rotor, ...]", shafts: "tuple[Shaft, ...]", gears: "tuple[Gear, ...]", reference: str
    ) -> None:
        self.names = [rotor.name for rotor in rotors]
        require(bool(rotors), "no rotor is given", code="missing")
        for name in self.names:
            require(self.names.count(name) == 1 and name != FIXED, "there are two rotors named {name}",
                    name=repr(name), code="names")  # fmt: skip
        for name in [end for one in shafts for end in (one.from_, one.to)] + [
            end for gear in gears for end in (gear.driver, gear.driven)
        ]:
            require(
                name in (*self.names, FIXED),
                "there is no rotor {name}",
                name=repr(name),
                code="names",
                hint="the names are {known}",
                known=", ".join([*self.names, FIXED]),
            )
        first = reference or self.names[0]
        require(first in self.names, "there is no rotor {name}", name=repr(first), code="names")
        self.reference = self.names.index(first)
        self.shafts, self.gears = shafts, gears
        self.speeds = self._speeds()
        self.station = self._stations()
        self.system = self._reduced(rotors)

    def _speeds(self) -> "list[float]":
        """Speed of every rotor when the reference turns once."""
        links: list[tuple[str, str, float]] = [
            (one.from_, one.to, 1.0) for one in self.shafts if FIXED not in (one.from_, one.to)
        ]
        for gear in self.gears:
            require(gear.driver != gear.driven, "{a} drives itself", a=repr(gear.driver), code="loop")
            links.append((gear.driver, gear.driven, (1.0 if gear.internal else -1.0) / gear.ratio_of.turns))
        known = {self.names[self.reference]: 1.0}
        for start in [self.names[self.reference], *self.names]:
            known.setdefault(start, 1.0)
            moving = True
            while moving:
                moving = False
                for a, b, factor in links:
                    for one, other, times in ((a, b, factor), (b, a, 1.0 / factor)):
                        if one in known and other not in known:
                            known[other] = known[one] * times
                            moving = True
        for a, b, factor in links:
            require(
                abs(known[a] * factor - known[b]) <= LOCKED * abs(known[b]),
                "the line is locked: round a loop, {b} would turn {one:6} times and {other:6} times",
                b=repr(b),
                one=(known[a] * factor, Ratio),
                other=(known[b], Ratio),
                code="locked",
                hint="gears of a closed loop must agree in their ratios",
            )
        return [known[name] for name in self.names]

    def _stations(self) -> "list[int]":
        """For each rotor, the first of those that it is geared to: they turn as one."""
        of = list(range(len(self.names)))
        for gear in [*self.gears] * len(self.names):
            a, b = self.names.index(gear.driver), self.names.index(gear.driven)
            of[a] = of[b] = min(of[a], of[b])
        return of

    def _reduced(self, rotors: "tuple[Rotor, ...]") -> System:
        """Inertias and stiffnesses times the square of their speed; meshed rotors as one."""
        inertia = dict.fromkeys(self.station, 0.0)
        for nth, rotor in enumerate(rotors):
            inertia[self.station[nth]] += rotor.inertia * self.speeds[nth] ** 2
        bodies = tuple(Body(self.names[place], value) for place, value in inertia.items())
        couplings = []
        for one in self.shafts:
            ends = [name if name == FIXED else self.names[self.station[self.names.index(name)]]
                    for name in (one.from_, one.to)]  # fmt: skip
            place = self.names.index(one.from_ if one.from_ != FIXED else one.to)
            square = self.speeds[place] ** 2
            if ends[0] != ends[1]:
                couplings.append(Coupling(ends[0], ends[1], one.spring.rate * square, one.damping * square))
        return System(Bodies(bodies, tuple(couplings)))

    def angles(self, shape: "list[float]") -> "list[float]":
        """The true angles of all rotors, in their own senses, from a shape of the reduced system."""
        whole = dict(zip(self.system.names, shape, strict=True))
        return [whole[self.names[self.station[nth]]] * self.speeds[nth] for nth in range(len(self.names))]
