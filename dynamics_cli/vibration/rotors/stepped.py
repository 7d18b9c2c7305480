"""A stepped shaft with its disks: what a user gives, and its matrices."""

import math
from itertools import pairwise

from dynamics_cli.errors import require
from dynamics_cli.quantities import Annotated, Inertia, Mass, Size
from dynamics_cli.records import record
from dynamics_cli.vibration.rotors.beam_elements import Matrices, stations_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

# Elements of the shaft, and of samples of uncertain inputs: frequencies to about 1e-6 and 1e-5.
ELEMENTS, FEW_ELEMENTS = 60, 20
# A place this share of the length beyond an end is rounding.
BEYOND = 1e-12
# Rounding of an element of a matrix; the share of a lowest frequency that is refused.
ROUNDING, POOR = 2.3e-16, 1e-3


@record
class Section:
    """A stretch of the shaft; sections follow one another from the left end."""

    length: Annotated[Size, "Length of the section, e.g. 200 mm."]
    diameter: Annotated[Size, "Diameter of the section, e.g. 50 mm."]
    bore: Annotated[Size, "Diameter of its bore, e.g. 20 mm."] = 0.0


@record
class Disk:
    """A rigid disk on the shaft."""

    position: Annotated[Size, "From the left end, e.g. 300 mm."]
    mass: Annotated[Mass, "Its mass, e.g. 30 kg."]
    polar_inertia: Annotated[Inertia, "About its axis, e.g. 0.5 kg*m^2."] = 0.0
    diametral_inertia: Annotated[
        Inertia | None, "About a diameter; half the polar one, as of a thin disk, unless given, e.g. 0.25 kg*m^2."
    ] = None


@record
class Material:
    """Of the whole shaft."""

    elastic_modulus: float
    poisson_ratio: float
    density: float

    def require_solid(self) -> None:
        """Refuse what no shaft is made of."""
        require(self.elastic_modulus > 0.0 and self.density > 0.0, "the shaft has no stiffness, or no mass",
                code="material", hint="give an elastic modulus and a density above zero")  # fmt: skip
        require(-1.0 < self.poisson_ratio <= 0.5, "Poisson's ratio is {ratio}; wanted -1 to 0.5",
                ratio=f"{self.poisson_ratio:g}", code="poisson", hint="of steel it is 0.3")  # fmt: skip

    def section(self, diameter: float, bore: float) -> "tuple[float, float, float, float]":
        """Of a round section: bending and shear stiffness (Cowper's coefficient), mass and inertia along the shaft."""
        area = math.pi / 4.0 * (diameter - bore) * (diameter + bore)
        second = area / 16.0 * (diameter**2 + bore**2)
        nu, square = self.poisson_ratio, (bore / diameter) ** 2
        hollow = (20.0 + 12.0 * nu) * square / (1.0 + square) ** 2
        shearing = 3.0 * self.elastic_modulus * area / (7.0 + 6.0 * nu + hollow)
        return self.elastic_modulus * second, shearing, self.density * area, self.density * second


def checked(stretches: "Any", **parts: "Any") -> "tuple[float, list[float]]":
    """The volume of the shaft and where its sections end; refused are sizes and places that no shaft has."""
    volume, ends = 0.0, [0.0]
    for number, part in enumerate(stretches, 1):
        require(part.length > 0.0, "section {number} has no length", code="no-length", number=str(number))
        require(
            part.diameter > part.bore,
            "section {number} has a bore of {bore} in a diameter of {diameter}",
            code="section", number=str(number), bore=(part.bore, Size), diameter=(part.diameter, Size),
        )  # fmt: skip
        volume += math.pi / 4.0 * (part.diameter - part.bore) * (part.diameter + part.bore) * part.length
        ends.append(ends[-1] + part.length)
    for name, places in parts.items():
        for number, place in enumerate(places, 1):
            require(
                -BEYOND * ends[-1] <= place <= ends[-1] * (1.0 + BEYOND),
                "{name} {number} at {place} lies off the shaft, which is {length} long",
                code="position", name=name, number=str(number), place=(place, Size), length=(ends[-1], Size),
            )  # fmt: skip
    return volume, ends


def assembled(
    stretches: "Any", ends: "list[float]", disks: "Any", marks: "Sequence[float]", material: Material, elements: int
) -> Matrices:
    """The shaft with its disks, with stations at further marks; bearings are still to come."""
    material.require_solid()
    system = Matrices(stations_of([*ends, *(disk.position for disk in disks), *marks], elements))
    for number, (low, high) in enumerate(pairwise(system.stations)):
        middle = 0.5 * (low + high)
        part = next((one for one, end in zip(stretches, ends[1:], strict=True) if middle < end), stretches[-1])
        system.add_element(number, *material.section(part.diameter, part.bore))
    for disk in disks:
        across = 0.5 * disk.polar_inertia if disk.diametral_inertia is None else disk.diametral_inertia
        system.add_disk(disk.position, disk.mass, disk.polar_inertia, across)
    return system


def require_held(places: "set[float]", tilting: bool, stiffness: "Any") -> float:
    """Refuse a shaft that can move without bending; what rounding makes of its lowest frequency."""
    from scipy.linalg import eigvalsh

    require(
        len(places) > 1 or (len(places) == 1 and tilting),
        "the bearings leave the shaft free to move without bending",
        code="mechanism", hint="give two bearings at different places, or one that resists tilting (tilting=...)",
    )  # fmt: skip
    sizes = stiffness.diagonal() ** -0.5
    scaled = eigvalsh(sizes[:, None] * stiffness * sizes)
    rounding = ROUNDING * float(scaled[-1]) / max(float(scaled[0]), 1e-300)
    require(rounding < POOR, "the bearings are too soft beside the shaft: its lowest frequency is lost in rounding",
            code="soft-bearings", hint="check their stiffness and its unit")  # fmt: skip
    return rounding
