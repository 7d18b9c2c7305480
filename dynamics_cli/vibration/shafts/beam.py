"""Bending vibration of uniform beams: frequencies and shapes that stay right in high modes."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import cos, exp, pi_beside, sin, sqrt
from dynamics_cli.numerics.polynomials import bisected
from dynamics_cli.quantities import (
    Annotated,
    Count,
    Density,
    Frequency,
    LinearDensity,
    Pressure,
    Ratio,
    SecondMoment,
    Size,
)
from dynamics_cli.records import Choice, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

MOST_MODES, STEPS = 60, 8
# Places at which shapes are looked at for nodes.
LOOKS = 400


class Ends(Choice):
    """How the beam is held."""

    names = ("pinned-pinned", "clamped-free", "clamped-clamped", "clamped-pinned", "free-free", "free-pinned")
    aliases = {  # noqa: RUF012
        "cantilever": "clamped-free", "simply-supported": "pinned-pinned", "fixed-fixed": "clamped-clamped",
        "fixed-free": "clamped-free", "propped": "clamped-pinned", "fixed-pinned": "clamped-pinned",
    }  # fmt: skip


# cos β + a·cosh⁻¹ β = 0 (a = 1 cantilever, −1 both alike), or tan β = tanh β.
KINDS = {
    "clamped-free": 1.0, "clamped-clamped": -1.0, "free-free": -1.0, "clamped-pinned": 0.0, "free-pinned": 0.0,
}  # fmt: skip


@record
class Rectangle:
    """A rectangular section."""

    width: Annotated[Size, "Width of a rectangular section, e.g. 40 mm."]
    height: Annotated[Size, "Its height, in the plane of the vibration, e.g. 10 mm."]
    density: Annotated[Density, "Density; steel unless given, e.g. 7850 kg/m^3."] = 7850.0

    def stiff_and_heavy(self) -> "tuple[float, float]":
        """Second moment of area and mass by length."""
        require(self.width > 0.0, "the width is zero", code="section")
        require(self.height > 0.0, "the height is zero", code="section")
        area = self.width * self.height
        return area * self.height * self.height / 12.0, self.density * area


@record
class Circle:
    """A round section."""

    diameter: Annotated[Size, "Diameter of a round section, e.g. 30 mm."]
    bore: Annotated[Size, "Inner diameter of a tube, e.g. 20 mm."] = 0.0
    density: Annotated[Density, "Density; steel unless given, e.g. 7850 kg/m^3."] = 7850.0

    def stiff_and_heavy(self) -> "tuple[float, float]":
        """Second moment of area and mass by length."""
        outer, inner = self.diameter, self.bore
        require(outer > inner, "the bore of {bore} leaves nothing of a diameter of {outer}", bore=(inner, Size),
                outer=(outer, Size), code="section")  # fmt: skip
        ring = (outer - inner) * (outer + inner)
        pi = pi_beside(outer, inner)
        return pi / 64.0 * ring * (outer * outer + inner * inner), self.density * 0.25 * pi * ring


@record
class Section:
    """Any section."""

    second_moment: Annotated[SecondMoment, "Second moment of area about the bending axis, e.g. 3333 mm^4."]
    line_mass: Annotated[LinearDensity, "Mass by length, e.g. 3.14 kg/m."]

    def stiff_and_heavy(self) -> "tuple[float, float]":
        """Second moment of area and mass by length."""
        require(self.second_moment > 0.0, "the second moment of area is zero", code="section")
        require(self.line_mass > 0.0, "the mass by length is zero", code="no-mass")
        return self.second_moment, self.line_mass


@record
class BeamMode:
    """A mode of the beam."""

    number: Annotated[Count, "From the lowest that is not rigid [-]."]
    frequency: Annotated[Frequency, "Natural frequency [Hz]."]
    root: Annotated[Ratio, "βL, the root of the frequency equation [-]."]
    nodes: Annotated[tuple[Ratio, ...], "Where the shape stands still between the ends, as share of the length [-]."]


@record
class Beam:
    """Vibration of a beam."""

    first_frequency: Annotated[Frequency, "Lowest natural frequency [Hz]."]
    modes: Annotated[tuple[BeamMode, ...], "The modes."]


def beam(
    *,
    ends: Annotated[Ends, "pinned-pinned, clamped-free, clamped-clamped, clamped-pinned, free-free or free-pinned."],
    length: Annotated[Size, "Length of the beam, e.g. 800 mm."],
    section: Annotated[Rectangle | Circle | Section, "Its section."],
    elastic_modulus: Annotated[Pressure, "Elastic modulus; steel unless given, e.g. 210000 MPa."] = 210e9,
    count: Annotated[Count, "How many modes."] = 4,
) -> Beam:
    """Bending frequencies and shapes of a uniform slender beam.

    Equation
    --------
    f = (βL)²/(2πL²)·√(EI/m'), βL from cos βL·cosh βL = ∓1, tan βL = tanh βL, or sin βL = 0.

    Returns
    -------
    Beam
        Frequencies, roots and nodes.

    Raises
    ------
    InadmissibleError
        When length, section, mass or modulus is zero, or more than 60 modes are asked for.

    References
    ----------
    Thomson, Theory of Vibration with Applications, appendix D (roots and their squares as printed).

    Examples
    --------
    >>> made = beam(ends=Ends("clamped-free"), length=1.0, section=Section(1e-8, 1.0), elastic_modulus=1e8)
    >>> round(made.modes[0].root, 12)
    1.875104068712
    """
    require(length > 0.0, "the length is zero", code="no-length")
    require(elastic_modulus > 0.0, "the elastic modulus is zero", code="no-stiffness")
    require(1 <= count <= MOST_MODES, "{count} modes: give 1 to {most}", count=str(count), most=str(MOST_MODES),
            code="count", hint="slender beam theory ends long before")  # fmt: skip
    stiff, heavy = section.stiff_and_heavy()
    pace = sqrt(elastic_modulus * stiff / heavy) / (2.0 * pi_beside(length) * length * length)
    rows = []
    for nth in range(1, count + 1):
        root = root_of(str(ends), nth, length)
        rows.append(BeamMode(nth, pace * root * root, root, nodes(str(ends), nth)))
    return Beam(first_frequency=rows[0].frequency, modes=tuple(rows))


def root_of(ends: str, nth: int, beside: "Any" = 0.0) -> "Any":
    """βL of a mode: Newton's method on forms without overflow, its last step in the arithmetic of `beside`."""
    pi = pi_beside(beside)
    if ends == "pinned-pinned":
        return float(nth) * pi
    kind = KINDS[ends]
    if kind == 0.0:
        beta: Any = (float(nth) + 0.25) * pi_beside(0.0)
    else:
        beta = (float(nth) - 0.5 if kind > 0.0 else float(nth) + 0.5) * pi_beside(0.0)
    for step in range(STEPS):
        if step == STEPS - 1:
            beta = beta + 0.0 * beside
        decay = exp(0.0 - beta)
        square = decay * decay
        if kind == 0.0:
            value = sin(beta) * (1.0 + square) - cos(beta) * (1.0 - square)
            slope = cos(beta) * (1.0 + square) + sin(beta) * (1.0 - square) - 2.0 * square * (sin(beta) + cos(beta))
        else:
            value = cos(beta) * (1.0 + square) + 2.0 * kind * decay
            slope = 0.0 - sin(beta) * (1.0 + square) - 2.0 * square * cos(beta) - 2.0 * kind * decay
        beta = beta - value / slope
    return beta


def shape(ends: str, nth: int, x: float) -> float:
    """The shape at a share of the length: growing and decaying parts by exponentials from their own ends."""
    return shape_of(ends, root_of(ends, nth), x)


def shape_of(ends: str, beta: float, x: float) -> float:
    """The same by the root of the mode."""
    if ends == "pinned-pinned":
        return sin(beta * x)
    if ends == "clamped-free":
        return _clamped(beta, x, 1.0)
    if ends == "clamped-clamped":
        return _clamped(beta, x, -1.0)
    if ends == "free-free":
        return _clamped(beta, x, -1.0, free=True)
    y = beta * (1.0 - x)
    # from the pinned end: sin βy/sin β and sinh βy/sinh β
    ratio = (exp(y - beta) - exp(0.0 - y - beta)) / (1.0 - exp(-2.0 * beta))
    return sin(y) / sin(beta) - ratio if ends == "clamped-pinned" else sin(y) / sin(beta) + ratio


def _clamped(beta: float, x: float, kind: float, free: bool = False) -> float:
    """½(1 − s)e^{βx} + ½(1 + s)e^{−βx} − cos βx + s·sin βx, with 1 − s formed without cancellation."""
    decay = exp(-beta)
    if kind > 0.0:
        short = (decay + cos(beta) + sin(beta)) / (0.5 / decay + 0.5 * decay + cos(beta))
    else:
        short = (cos(beta) - sin(beta) - decay) / (0.5 / decay - 0.5 * decay - sin(beta))
    s = 1.0 - short
    grown, fallen = 0.5 * short * exp(beta * x), 0.5 * (1.0 + s) * exp(-beta * x)
    wave = s * sin(beta * x) - cos(beta * x)
    return grown + fallen - wave if free else grown + fallen + wave


def nodes(ends: str, nth: int) -> "tuple[float, ...]":
    """Where the shape changes its sign between the ends."""
    beta = root_of(ends, nth)
    places = [i / LOOKS for i in range(1, LOOKS)]
    values = [shape_of(ends, beta, x) for x in places]
    made = []
    for i in range(len(places) - 1):
        if values[i] * values[i + 1] < 0.0 or values[i] == 0.0:
            a, b = (places[i], places[i + 1]) if values[i] else (places[i] - 0.5 / LOOKS, places[i] + 0.5 / LOOKS)
            made.append(bisected(lambda x: shape_of(ends, beta, x), a, b))
    return tuple(made)
