"""The task `free`: a rigid body turning without torque."""

from dynamics_cli.errors import MissingError, require, worded
from dynamics_cli.numerics.elementary import atan2, pi_beside, sqrt
from dynamics_cli.numerics.elliptic import mean
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import (
    Angle,
    AngularImpulse,
    AngularVelocity,
    Annotated,
    Direction,
    GrowthRate,
    Inertia,
    InertiaTensor,
    InertiaTriple,
    PotentialEnergy,
    Text,
    Time,
    TurnRate,
)
from dynamics_cli.records import Advice, record
from dynamics_cli.spin.principal import along_axes

NAMES = ("x", "y", "z")
# Of principal axes that were found.
NUMBERS = ("1", "2", "3")
ROUNDING = 1.0 + 1e-12
# Nearer than this to the separatrix the side is decided in fractions.
NEAR = 1e-9
# Share of the energy about the middle axis from which the body is said to tumble.
TUMBLING = 0.9
TYPE_CHECKING = False
if TYPE_CHECKING:
    Triple = tuple[float, float, float]


@record
class Free:
    """How a free body turns."""

    motion: Annotated[Text, "The axis the angular velocity goes round, in the body."]
    period: Annotated[Time | None, "Time after which the angular velocity in the body returns [s]."]
    greatest: Annotated[AngularVelocity, "Greatest size of each component, about x, y, z [rad/s]."]
    least: Annotated[AngularVelocity, "Least size of each component [rad/s]."]
    least_nutation: Annotated[Angle | None, "Least angle of that axis from the angular momentum [rad]."]
    greatest_nutation: Annotated[Angle | None, "Greatest angle [rad]."]
    least_precession: Annotated[TurnRate | None, "Least rate of that axis about the angular momentum [rad/s]."]
    greatest_precession: Annotated[TurnRate | None, "Greatest rate [rad/s]."]
    growth: Annotated[GrowthRate, "Growth of a disturbance, were all this speed about the middle axis [1/s]."]
    angular_momentum: Annotated[AngularImpulse, "Size of the angular momentum [N*m*s]."]
    energy: Annotated[PotentialEnergy, "Energy of rotation [J]."]
    principal_moments: Annotated[InertiaTriple | None, "Of a tensor, its principal moments 1, 2, 3 [kg*m^2]."] = None
    axes: Annotated[
        tuple[Direction, ...] | None, "Their axes, one a row, in the axes of the tensor; components are along them [-]."
    ] = None
    advice: tuple[Advice, ...] = ()


def free(
    *,
    moments: Annotated[InertiaTriple | None, "Principal moments of inertia about x, y, z, e.g. 1, 2, 3 kg*m^2."] = None,
    tensor: Annotated[InertiaTensor | None, "Or the inertia tensor about the mass centre in any axes."] = None,
    angular_velocity: Annotated[AngularVelocity, "Angular velocity along the same axes, e.g. 0.2, 1, 0.5 rad/s."],
) -> Free:
    """Rotation of a rigid body without torque: axis, period, extremes, nutation and precession.

    Equation
    --------
    T = 2π/M(λ, λ′), M the arithmetic–geometric mean; λ² = (I₃ − I₂)·D₁/(I₁I₂I₃) where D₂ > 0, else
    (I₂ − I₁)·D₃/(I₁I₂I₃); λ′² = (I₃ − I₁)·|D₂|/(I₁I₂I₃), with D₁ = H² − 2E·I₁, D₂ = H² − 2E·I₂, D₃ = 2E·I₃ − H²
    and E the energy, each formed without cancellation.

    Returns
    -------
    Free
        The motion; there is no period on the separatrix and where nothing changes.

    Raises
    ------
    InadmissibleError
        When a moment is not above zero, one is above the sum of the others, or the body does not turn.
    UsageError
        When neither moments nor a tensor are given, or both.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 14.4.

    Examples
    --------
    >>> round(free(moments=(1.0, 2.0, 3.0), angular_velocity=(0.2, 1.0, 0.5)).period, 9)
    10.178247966
    """
    axes, labels = None, NAMES
    require(moments is None or tensor is None, "principal moments and a tensor are both given", code="both",
            hint="give --moments or --tensor")  # fmt: skip
    if tensor is not None:
        moments, angular_velocity, axes = along_axes(tensor, angular_velocity)
        labels = NUMBERS
    elif moments is None:
        raise MissingError("the inertia of the body is not given", [("moments",), ("tensor",)])
    order = sorted(range(3), key=lambda k: plain(moments[k]))
    body = _body(moments, order)
    rates: Triple = tuple(abs(angular_velocity[k]) for k in order)  # type: ignore[assignment]
    require(any(plain(w) != 0.0 for w in rates), "the body does not turn", code="at-rest",
            hint="give an angular velocity")  # fmt: skip
    low, middle, high = body
    p, q, r = rates
    momentum = sqrt((low * p) * (low * p) + (middle * q) * (middle * q) + (high * r) * (high * r))
    names = [labels[k] for k in order]
    most, least, split = extremes(body, rates)
    motion, about = _motion(body, rates, most, least, split, names)
    near = far = slower = faster = period = None
    if about >= 0:
        other = 2 - about
        near = atan2(body[other] * most[other], body[about] * most[about])
        far = atan2(middle * most[1], body[about] * least[about])
        if "steady" not in motion:
            slower, faster = (momentum / middle, momentum / low) if about == 2 else (momentum / high, momentum / middle)
        first, second = moduli(body, rates, split)
        if plain(second) > 0.0:
            period = 2.0 * pi_beside(first) / mean(first, second)
    growth = sqrt(p * p + q * q + r * r) * _root((middle - low) * (high - middle) / (low * high))
    back = [order.index(k) for k in range(3)]
    return Free(
        motion=motion,
        period=period,
        greatest=(most[back[0]], most[back[1]], most[back[2]]),
        least=(least[back[0]], least[back[1]], least[back[2]]),
        least_nutation=near,
        greatest_nutation=far,
        least_precession=slower,
        greatest_precession=faster,
        growth=growth,
        angular_momentum=momentum,
        energy=0.5 * (low * p * p + middle * q * q + high * r * r),
        principal_moments=moments if axes else None,
        axes=axes,
        advice=_advice(period, motion, plain(middle * q * q / (low * p * p + middle * q * q + high * r * r)), names[1]),
    )


def _body(moments: "Triple", order: "list[int]") -> "Triple":
    """The moments from the least to the greatest, of a body that can be."""
    low, middle, high = (moments[k] for k in order)
    require(low > 0.0, "a moment of inertia of {least} is not above zero", least=(low, Inertia),
            code="impossible-body", hint="give three moments above zero")  # fmt: skip
    require(
        high <= (low + middle) * ROUNDING,
        "no body has these moments: {high} is above the sum of {low} and {middle}",
        high=(high, Inertia), low=(low, Inertia), middle=(middle, Inertia), code="impossible-body",
        hint="check them with dynamics inertia tensor",
    )  # fmt: skip
    return low, middle, high


def differences(body: "Triple", rates: "Triple") -> "Triple":
    """H² − 2E·I₁, H² − 2E·I₂ and 2E·I₃ − H², without their cancellation."""
    low, middle, high = body
    p, q, r = rates
    first = middle * (middle - low) * q * q + high * (high - low) * r * r
    outer, inner = _root(high * (high - middle)) * r, _root(low * (middle - low)) * p
    second = (outer - inner) * (outer + inner)
    scale = plain(outer) ** 2 + plain(inner) ** 2
    if abs(plain(second)) <= NEAR * scale and _on_separatrix(body, rates):
        second = 0.0 * second
    third = low * (high - low) * p * p + middle * (high - middle) * q * q
    return first, second, third


def _on_separatrix(body: "Triple", rates: "Triple") -> bool:
    """Whether the decimals as typed lie on it."""
    from fractions import Fraction

    low, middle, high = (Fraction(repr(plain(x))) for x in body)
    p, _, r = (Fraction(repr(plain(x))) for x in rates)
    return high * (high - middle) * r * r == low * (middle - low) * p * p


def moduli(body: "Triple", rates: "Triple", split: "Triple") -> "tuple[float, float]":
    """λ and λ′."""
    low, middle, high = body
    first, second, third = split
    volume = low * middle * high
    above = (high - middle) * first if plain(second) > 0.0 else (middle - low) * third
    return _root(above / volume), _root((high - low) * abs(second) / volume)


def extremes(body: "Triple", rates: "Triple") -> "tuple[Triple, Triple, Triple]":
    """Greatest and least sizes of the components from the least moment to the greatest, and the differences."""
    low, middle, high = body
    split = first, second, third = differences(body, rates)
    p, q, r = rates
    zero = 0.0 * q
    if plain(high) == plain(low):
        return rates, rates, split
    most_p, most_r = _root(third / (low * (high - low))), _root(first / (high * (high - low)))
    if plain(second) > 0.0:
        most_q = _root(third / (middle * (high - middle)))
        return (most_p, most_q, most_r), (zero, zero, _root(second / (high * (high - middle)))), split
    if plain(second) < 0.0:
        most_q = _root(first / (middle * (middle - low)))
        return (most_p, most_q, most_r), (_root(-second / (low * (middle - low))), zero, zero), split
    if plain(middle) == plain(low) or plain(middle) == plain(high) or (plain(p) == 0.0 and plain(r) == 0.0):
        return rates, rates, split
    most_q = _root(third / (middle * (high - middle)))
    return (most_p, most_q, most_r), (zero, zero, zero), split


def _motion(
    body: "Triple", rates: "Triple", most: "Triple", least: "Triple", split: "Triple", names: "list[str]"
) -> "tuple[str, int]":
    """What it does in words, and which axis the angular velocity goes round; -1 where it goes round none."""
    low, middle, high = (plain(x) for x in body)
    p, q, r = (plain(x) for x in rates)
    side = plain(split[1])
    if high == low:
        return "turns steadily: all moments are alike", -1
    if side > 0.0:
        steady = p == 0.0 and q == 0.0
        return f"{'steady' if steady else 'goes round'} about {names[2]}, the axis of greatest moment", 2
    if side < 0.0:
        steady = q == 0.0 and r == 0.0
        return f"{'steady' if steady else 'goes round'} about {names[0]}, the axis of least moment", 0
    if middle in (low, high):
        return "turns steadily across its axis of symmetry", -1
    if p == 0.0 and r == 0.0:
        return f"about {names[1]}, the middle axis: unstable, it will tumble", -1
    return f"separatrix: ends about {names[1]}, the middle axis", -1


def _advice(period: "float | None", motion: str, middle_share: float, name: str) -> "tuple[Advice, ...]":
    """No period; or, as of a tennis racket, most of the energy about the middle axis."""
    if period is not None:
        if middle_share < TUMBLING:
            return ()
        message = worded(
            "it is spun almost wholly about {name}, the middle axis, and tumbles: that axis turns over every {half:3}",
            name=name, half=(0.5 * plain(period), Time),
        )  # fmt: skip
        return (Advice("tumbles", message, severity="note"),)
    return (Advice("no-period", f"no period: {motion}", severity="note", result="period"),)


def _root(squared: float) -> float:
    return sqrt(squared) if plain(squared) > 0.0 else 0.0 * squared
