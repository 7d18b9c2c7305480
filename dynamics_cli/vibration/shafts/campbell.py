"""Free whirl of a disk that tilts, over the speed of its shaft: forward and backward, and where orders meet it."""

from dynamics_cli.numerics.elementary import maximum, minimum, pi_beside, sqrt
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.roots import sign_change
from dynamics_cli.quantities import Annotated, Count, Frequency, Ratio, ShaftSpeed, Text
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

DIAGRAM_STEPS = 20
# A root of this relative width is exact after one step of Newton.
NEAR = 1e-9
FORWARD, BACKWARD = "forward", "backward"


@record
class FreeWhirl:
    """One free whirl at one speed."""

    mode: Annotated[Count, "1 mostly shifts the disk, 2 mostly tilts it [-]."]
    whirl: Annotated[Text, "forward, with the rotation, or backward, against it."]
    frequency: Annotated[Frequency, "Its frequency [Hz]."]
    order: Annotated[Ratio, "That over the speed [-]."]


@record
class WhirlCritical:
    """A speed at which an excitation meets a free whirl."""

    speed: Annotated[ShaftSpeed, "Speed of the shaft [rad/s]."]
    order: Annotated[Ratio, "Excitations per turn [-]."]
    whirl: Annotated[Text, "forward or backward."]
    mode: Annotated[Count, "The mode [-]."]
    frequency: Annotated[Frequency, "Frequency of the whirl there [Hz]."]


@record
class WhirlsAtSpeed:
    """A row of the Campbell diagram."""

    speed: Annotated[ShaftSpeed, "Speed of the shaft [rad/s]."]
    first_backward: Annotated[Frequency, "First backward whirl [Hz]."]
    first_forward: Annotated[Frequency, "First forward whirl [Hz]."]
    second_backward: Annotated[Frequency, "Second backward whirl [Hz]."]
    second_forward: Annotated[Frequency, "Second forward whirl [Hz]."]


class TiltingDisk:
    """A disk on a shaft that shifts and tilts: (k₁₁ − mλ²)(k₂₂ + I_pΩλ − I_dλ²) = k₁₂², λ < 0 for backward whirl."""

    def __init__(self, mass: "Any", springs: "tuple[Any, Any, Any]", polar: "Any", diametral: "Any") -> None:
        self.mass, self.polar, self.diametral = mass, polar, diametral
        # against shift, against tilt, and the determinant k₁₁·k₂₂ − k₁₂²
        self.direct, self.tilting, self.determinant = springs
        self.parts = (mass, *springs, polar, diametral)

    def whirls(self, speed: "Any") -> "tuple[Any, Any, Any, Any]":
        """Angular frequencies at a speed: first backward, first forward, second backward, second forward."""
        backward, forward = (self._root(speed, sign, 0.0) for sign in (-1.0, 1.0))
        return (backward, forward, self._root(speed, -1.0, 1.0), self._root(speed, 1.0, 1.0))

    def _root(self, speed: "Any", sign: float, upper: float) -> "Any":
        """One of them: found in doubles, then one step of Newton in the arithmetic of the inputs."""
        turning = sign * self.polar * speed
        numbers = (self.mass, self.direct, self.tilting, self.determinant, self.diametral, turning)
        start = _between_zeros(*map(plain, (*numbers, upper))) + 0.0 * turning
        value, slope = _characteristic(*numbers, start)
        return start - value / slope

    def criticals(self, order: "Any") -> "list[tuple[Any, str, int]]":
        """Speeds at which an order meets a whirl, which way it goes, and its mode."""
        crossings = []
        for sign, whirl in ((-1.0, FORWARD), (1.0, BACKWARD)):
            # m·I·x² − (k₁₁·I + k₂₂·m)·x + k₁₁·k₂₂ − k₁₂² = 0, x = λ² = (order·Ω)²
            moment = self.diametral + sign * self.polar / order
            middle = self.direct * moment + self.tilting * self.mass
            room = sqrt(middle * middle - 4.0 * self.mass * moment * self.determinant)
            if middle > 0.0:
                first = 2.0 * self.determinant / (middle + room)
            else:
                first = (middle - room) / (2.0 * self.mass * moment)
            crossings.append((sqrt(first) / order, whirl, 1))
            if moment > 0.0:
                second = (middle + room) / (2.0 * self.mass * moment)
                crossings.append((sqrt(second) / order, whirl, 2))
        return crossings


def _characteristic(
    mass: "Any", direct: "Any", tilting: "Any", determinant: "Any", diametral: "Any", turning: "Any", rate: "Any"
) -> "tuple[Any, Any]":
    """k₁₁·k₂₂ − k₁₂² + k₁₁·g − mλ²·(k₂₂ + g) with g = λ(I_pΩ − I_dλ), and its slope; `turning` is ±I_pΩ for λ > 0."""
    lift, slope = rate * (turning - diametral * rate), turning - 2.0 * diametral * rate
    inertia = mass * rate * rate
    value = determinant + direct * lift - inertia * (tilting + lift)
    return value, direct * slope - 2.0 * mass * rate * (tilting + lift) - inertia * slope


def _between_zeros(
    mass: float, direct: float, tilting: float, determinant: float, diametral: float, turning: float, upper: float
) -> float:
    """The lower or upper root λ > 0: between them lie the zeros of both factors, where the product is below zero.

    At twice the larger zero the product is more than 3·k₁₁·k₂₂, above k₁₂².
    """
    shift = sqrt(direct / mass)
    tilt = (turning + sqrt(turning * turning + 4.0 * diametral * tilting)) / (2.0 * diametral)
    numbers = (mass, direct, tilting, determinant, diametral, turning)
    outside, inside = (2.0 * maximum(shift, tilt), maximum(shift, tilt)) if upper else (0.0, minimum(shift, tilt))
    return sign_change(lambda rate: _characteristic(*numbers, rate)[0], outside, inside, NEAR)


def whirls_at(disk: TiltingDisk, speed: "Any") -> "tuple[FreeWhirl, ...]":
    """The free whirls at one speed, from the lowest of each mode."""
    rates = disk.whirls(speed)
    kinds = ((1, BACKWARD), (1, FORWARD), (2, BACKWARD), (2, FORWARD))
    return tuple(
        FreeWhirl(mode, whirl, rate / (2.0 * pi_beside(rate)), rate / speed)
        for rate, (mode, whirl) in zip(rates, kinds, strict=True)
    )


def diagram(disk: TiltingDisk, top: "Any", steps: int = DIAGRAM_STEPS) -> "tuple[WhirlsAtSpeed, ...]":
    """Whirl frequencies at even speeds from standstill to `top`."""
    rows = []
    for nth in range(steps + 1):
        speed = top * (nth / steps)
        rows.append(WhirlsAtSpeed(speed, *(rate / (2.0 * pi_beside(rate)) for rate in disk.whirls(speed))))
    return tuple(rows)


def meetings(disk: "TiltingDisk | None", critical: "Any", orders: "tuple[Any, ...]") -> "tuple[WhirlCritical, ...]":
    """Every meeting of an order with a whirl, the lowest speed first within each order."""
    rows = []
    for order in orders:
        crossings = [(critical / order, "both ways", 1)] if disk is None else disk.criticals(order)
        for speed, whirl, mode in sorted(crossings, key=lambda crossing: (crossing[2], crossing[1])):
            rows.append(WhirlCritical(speed, order, whirl, mode, speed * order / (2.0 * pi_beside(speed))))
    return tuple(rows)
