"""Vectors with their kinds: a force is not added to a velocity, and a force times a length is a torque or an energy."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.exact.typed_products import as_typed, norm
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import (
    Acceleration,
    AngularImpulse,
    Area,
    Energy,
    Kind,
    Power,
    Speed,
    Torque,
    Volume,
)
from dynamics_cli.records import Quantity

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    Components = tuple[float, float, float]

NUMBER = Kind("number", "")
# Kinds of products by the units of their factors: of a scalar product, and of a vector product.
_SCALAR: "dict[tuple[str, str], Any]" = {
    ("N", "m"): Energy, ("N", "m/s"): Power, ("m", "m"): Area, ("m^2", "m"): Volume,
}  # fmt: skip
_VECTOR: "dict[tuple[str, str], Any]" = {
    ("N", "m"): Torque, ("N*s", "m"): AngularImpulse, ("m", "m"): Area,
    ("rad/s", "m"): Speed, ("rad/s", "m/s"): Acceleration, ("rad/s^2", "m"): Acceleration,
}  # fmt: skip


def parts_of(given: "Any") -> "tuple[Any, ...]":
    """The numbers of a vector as given: of a magnitude without a direction one."""
    value = given.value if isinstance(given, Quantity) else given
    return tuple(value) if isinstance(value, tuple | list) else (value,)


class Vector:
    """The three components of a vector in SI, its kind, and whether it was planar."""

    __slots__ = ("kind", "parts", "planar")

    def __init__(self, given: "Any", name: str = "the vector") -> None:
        self.kind: Any = given.kind if isinstance(given, Quantity) else NUMBER
        parts = parts_of(given)
        require(
            len(parts) in (2, 3),
            "{name} is a magnitude without a direction",
            name=name,
            code="no-direction",
            hint="write 20 N @ 30 deg, or components such as 3, 4 N",
        )
        self.planar = len(parts) == 2
        x, y, z = (as_typed(part) for part in (*parts, 0.0)[:3])
        self.parts: Components = (x, y, z)

    @property
    def is_zero(self) -> bool:
        """Whether every component is zero."""
        return all(plain(part) == 0.0 for part in self.parts)


def vectors(raw: "Sequence[Any]", names: "Sequence[str]" = ()) -> "list[Vector]":
    """Several vectors, by their names in messages."""
    return [Vector(item, names[index] if names else f"vector {index + 1}") for index, item in enumerate(raw)]


def require_same_kind(several: "Sequence[Vector]", context: str) -> None:
    """Refuse a sum of unlike kinds."""
    for index, other in enumerate(several[1:], 2):
        words = f"{context}: vector 1 is {{first}}, vector {index} {{other}}"
        require_one_kind(several[0].kind, other.kind, words, "give vectors of one kind, with their units")


def require_one_kind(first: "Any", other: "Any", message: str, hint: str) -> None:
    """Refuse two kinds where one is wanted; the message names them."""
    require(first.unit == other.unit, message, first=first.one, other=other.one, code="mixed-kinds", hint=hint)


def require_direction(vector: Vector, name: str) -> None:
    """Refuse a zero vector where a direction is needed."""
    require(
        not vector.is_zero,
        "{name} is a zero vector, which has no direction",
        name=name,
        code="zero-vector",
        hint="give a vector that is not zero",
    )


def scalar(kind: "Any") -> Kind:
    """The kind of one number of a vector."""
    return Kind(kind.name, kind.unit, si=kind.si, us=kind.us)


def number(value: float, kind: "Any") -> Quantity:
    """A number of the kind of a vector's components."""
    return Quantity(value, scalar(kind))


def vector(parts: "Sequence[float]", kind: "Any", *, planar: bool = False) -> Quantity:
    """A vector with its kind; a planar one has two components."""
    size = 2 if planar else 3
    form = "planar" if planar else "vector"
    return Quantity(tuple(parts[:size]), Kind(kind.name, kind.unit, form=form, si=kind.si, us=kind.us, size=size))


def direction(parts: "Sequence[float]", *, planar: bool = False) -> Quantity:
    """A unit vector."""
    return vector(parts, NUMBER, planar=planar)


def magnitude(of: Vector) -> Quantity:
    """A vector's magnitude."""
    return number(norm(of.parts), of.kind)


def times(a: "Any", b: "Any", *, cross: bool = False) -> Kind:
    """The kind of a product, shown in the units of its factors where these are not SI's."""
    if not a.unit or not b.unit:
        return scalar(a if a.unit else b)
    table = _VECTOR if cross else _SCALAR
    for first, second in ((a, b), (b, a)):
        kind = table.get((first.unit, second.unit))
        if kind is not None:
            return _known(kind, first, second)
    return Kind(f"{a.name} times {b.name}", _joined(a.unit, b.unit), si=_joined(a.si, b.si))


def over(a: "Any", b: "Any") -> Kind:
    """The kind of a quotient."""
    if not b.unit:
        return scalar(a)
    if a.unit == b.unit:
        return NUMBER
    return Kind(f"{a.name} per {b.name}", f"{a.unit or '1'}/({b.unit})", si=f"{a.si or '1'}/({b.si})")


def _known(known: "Any", first: "Any", second: "Any") -> Kind:
    own_units = (first.si, second.si) != (first.unit, second.unit) and "rad" not in first.unit
    if not own_units or known is Power:
        return Kind(known.name, known.unit, si=known.unit, us=known.us)
    # an energy is written length first, a torque force first
    joined = _joined(second.si, first.si) if known is Energy else _joined(first.si, second.si)
    return Kind(known.name, known.unit, si=joined, us=known.us)


def _joined(first_text: str, second_text: str) -> str:
    simple = first_text.isalpha() and second_text.isalpha()
    first, second = (f"({unit})" if "/" in unit else unit for unit in (first_text, second_text))
    return f"{first_text}^2" if first_text == second_text and simple else f"{first}*{second}"
