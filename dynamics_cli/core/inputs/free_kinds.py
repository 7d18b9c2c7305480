"""Vectors whose kind follows from the unit they are written in, and matrices of exact numbers.

A vector is written by components (`3, 4 N`, `1, 2, 3 m`, `3i + 4j N`), or by its magnitude with the angle from x
in the plane (`20 N @ 30 deg`), with its three direction angles (`20 N @ 60, 45, 60 deg`), with any vector along its
direction (`20 N along 1, 2, 2`, `20 N @ (1, 2, 2)`), with two points on it (`20 N from 0, 0, 0 to 1, 2, 2 m`) or with
a word (`20 N down`, `up`, `left`, `right`). A number alone is a magnitude.
"""

from dynamics_cli.core.inputs import leaves
from dynamics_cli.core.inputs.forms.lists import share_unit
from dynamics_cli.core.inputs.forms.splitting import split_list
from dynamics_cli.core.inputs.quantity_text import is_uncertain, number_end, read_fraction
from dynamics_cli.core.inputs.values import NOTHING, Bound, Constant, PolarVector, Value, VectorValue
from dynamics_cli.core.units.conversion import nearest
from dynamics_cli.core.units.lookup import parse_unit
from dynamics_cli.core.units.unit import NONE, conformable
from dynamics_cli.errors import UsageError
from dynamics_cli.numerics.elementary import cos, hypot
from dynamics_cli.quantities import (
    Acceleration,
    Angle,
    AngularAcceleration,
    AngularImpulse,
    AngularSpeed,
    DistributedForce,
    Force,
    Impulse,
    Kind,
    Length,
    Speed,
    Torque,
)
from dynamics_cli.records import Quantity

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import Any

    from dynamics_cli.core.inputs.context import Context
    from dynamics_cli.core.inputs.values import Values

# In this order a unit with two readings takes the first one: lb is a force, g an acceleration.
KNOWN: "tuple[Any, ...]" = (
    Force, Length, Speed, Acceleration, Torque, Impulse, AngularImpulse, AngularSpeed, AngularAcceleration,
    DistributedForce,
)  # fmt: skip
NUMBER = Kind("number", "", form="vector", exact=True)
MOST_ROWS = 6
# Deviation of measured direction angles' squared cosines from 1: refused above the first, unremarked below the second.
MOST_OFF, WORTH_SAYING = 1e-2, 1e-9
WORDS = {"up": (0.0, 1.0), "down": (0.0, -1.0), "left": (-1.0, 0.0), "right": (1.0, 0.0)}
HINT = "for example '3, 4 N', '1, 2, 3 m', '20 N @ 30 deg', '20 N along 1, 2, 2' or '20 N from 0, 0 m to 3, 4 m'"


def kind_of_unit(text: str, size: int) -> Kind:
    """The kind of a vector with this unit and number of components; it keeps the unit for display."""
    form = "planar" if size == 2 else "vector"
    if not text:
        return Kind("number", "", form=form, size=size, example="3, 4 N", exact=True)
    for kind in KNOWN:
        base_unit = parse_unit(kind.unit)
        if conformable(parse_unit(text, base_unit), base_unit):
            return Kind(
                kind.name, kind.unit, form=form, si=text, us=kind.us, size=size, example="3, 4 N", about=kind.about,
                exact=True,
            )  # fmt: skip
    from dynamics_cli.core.units.names import base_expression, kind_name

    unit = parse_unit(text)
    if unit.offset[0]:
        raise UsageError(f"a vector cannot be in {text}", code="kind", hint=HINT)
    if unit.dimension == NONE:
        return Kind("number", "", form=form, si=text, us=text, size=size, example="3, 4 N")
    return Kind(kind_name(unit), base_expression(unit.dimension), form=form, si=text, size=size, example="3, 4 N")


class OfAnyKind(VectorValue):
    """A vector as read, passed to the physics with its kind."""

    def __init__(self, inner: VectorValue) -> None:
        super().__init__(inner.address, inner.kind, inner.si, inner.shown, inner.unit)
        self._inner = inner
        self.parts = inner.parts

    def assemble(self, values: "Values" = NOTHING) -> "Any":
        """The components with their kind."""
        return Quantity(self._inner.assemble(values), self.kind)

    def leaves(self) -> "Iterator[tuple[str, Kind, float]]":
        """Its components."""
        return self._inner.leaves()

    def echo(self) -> "Any":
        """As written; an amplitude alone as a number."""
        echo = self._inner.echo()
        lone = len(self.si) == 1 and echo.keys() <= {"value", "unit"}
        return echo | {"value": echo["value"][0]} if lone else echo


class DirectedVector(VectorValue):
    """A vector by its magnitude and a certain direction, which is a unit vector."""

    def __init__(self, address: str, kind: Kind, magnitude: Value, along: "tuple[float, ...]") -> None:
        self.parts = (magnitude,)
        self._along = along
        self._direction = _normed(along)
        si = self.assemble()
        super().__init__(address, kind, si, list(si), kind.unit)

    def assemble(self, values: "Values" = NOTHING) -> "Any":
        """The components."""
        size = self.parts[0].assemble(values)
        return tuple(size * cosine for cosine in self._direction)

    def leaves(self) -> "Iterator[tuple[str, Kind, float]]":
        """The magnitude."""
        return self.parts[0].leaves()

    def echo(self) -> "Any":
        """The JSON form, which reads back: nominal components, magnitude and direction."""
        return {**super().echo(), "magnitude": self.parts[0].echo(), "direction": {"value": list(self._along)}}


def _read(raw: "Any", address: str, context: "Context") -> VectorValue:
    if isinstance(raw, dict) and "magnitude" in raw and "direction" in raw:
        size, direction = raw["magnitude"], raw["direction"]
        cosines = direction.get("value") if isinstance(direction, dict) else direction
        if isinstance(cosines, list):
            return _directed(size, _certain(cosines, address, context).si, address, context)
        return _planar(size, direction, address, context)
    if isinstance(raw, str):
        raw = _by_unit_vectors(raw.replace("∠", "@").replace(" at ", " @ ", 1))
        if "@" in raw:
            size, _, direction = (part.strip() for part in raw.partition("@"))
            if direction[:1] + direction[-1:] == "()":
                direction = direction[1:-1].strip()
                if not _unit_of(split_list(direction)[-1].strip()):
                    return _directed(size, _certain(direction, address, context).si, address, context)
            if len(split_list(direction)) == 1:
                return _planar(size, direction, address, context)
            return _directed(size, _from_angles(direction, address, context), address, context)
        size, _, word = raw.strip().rpartition(" ")
        if size and word.lower() in WORDS:
            return _directed(size, WORDS[word.lower()], address, context)
        if " along " in raw:
            size, _, direction = (part.strip() for part in raw.partition(" along "))
            return _directed(size, _certain(direction, address, context).si, address, context)
        if " from " in raw and " to " in raw:
            size, _, rest = raw.partition(" from ")
            start, _, end = rest.partition(" to ")
            return _directed(size.strip(), _between(*_placed(start, end, context), address, context), address, context)
    return _components(raw, address, context)


def _by_unit_vectors(text: str) -> str:
    """`3i + 4j - k N`, as textbooks write components, as `3, 4, -1 N`; any other text as it is."""
    rest = text.replace("−", "-").strip()
    if rest.startswith("("):
        rest = rest[1:].replace(")", " ", 1).strip()
    components: dict[str, str] = {}
    while rest:
        sign = rest[0] if rest[0] in "+-" else ""
        term = rest.removeprefix(sign).lstrip()
        end = number_end(term, 0) if term else 0
        letter, after = term[end:].lstrip(" *")[:1], term[end:].lstrip(" *")[1:]
        if letter not in ("i", "j", "k") or letter in components or after[:1].isalnum() or (components and not sign):
            break
        components[letter] = sign + (term[:end] or "1")
        rest = after.strip()
    if not components or rest[:1] in ("+", "-"):
        return text
    if list(components) == ["k"]:
        hint = f"write 0, 0, {components['k']} {rest}".rstrip() + ", or thousands with their zeros"
        raise UsageError(f"{text!r} may be along z or in thousands", code="ambiguous", hint=hint)
    letters = "ijk" if "k" in components else "ij"
    return f"{', '.join(components.get(letter, '0') for letter in letters)} {rest}".strip()


def _components(raw: "Any", address: str, context: "Context") -> VectorValue:
    items = _items(raw)
    if not 1 <= len(items) <= 3:
        raise UsageError(f"read {len(items)} components, wanted 2 or 3", code="components", hint=HINT)
    if len(items) == 2 and all(isinstance(item, str) for item in items) and _is_angle(items[1]) > _is_angle(items[0]):
        size, angle = (item.strip() for item in items)
        message = f"read the components {size} and {angle}, wanted both in one unit"
        raise UsageError(message, code="kind", hint=f"a magnitude and its angle are written {size} @ {angle}")
    return leaves.read_vector(kind_of_unit(_unit_of(items[-1]), len(items)), _with_items(raw, items), address, context)


def _is_angle(item: str) -> bool:
    unit = _unit_of(item)
    return bool(unit) and conformable(parse_unit(unit), parse_unit("rad"))


def _items(raw: "Any") -> "list[Any]":
    if isinstance(raw, dict) and isinstance(raw.get("value"), list):
        return list(raw["value"]) and [{"value": item, "unit": raw.get("unit")} for item in raw["value"]]
    if isinstance(raw, list | dict):
        return raw if isinstance(raw, list) else [raw]
    return leaves.components_of(NUMBER, raw)


def _with_items(raw: "Any", items: "list[Any]") -> "Any":
    """The input in the form that the vector reader takes; a result of an earlier document keeps its distribution."""
    return raw if isinstance(raw, dict) and isinstance(raw.get("value"), list) else items


def _unit_of(item: "Any") -> str:
    if isinstance(item, dict):
        return str(item.get("unit") or "")
    if not isinstance(item, str):
        return ""
    if is_uncertain(item):
        from dynamics_cli.core.inputs.uncertain.vectors import trailing_unit

        return trailing_unit(item)
    end = number_end(item, 0) if item else 0
    if not end:
        raise UsageError(f"read {item!r}, wanted the components of a vector", code="syntax", hint=HINT)
    return item[end:].strip()


def _planar(size: "Any", way: "Any", address: str, context: "Context") -> VectorValue:
    kind = kind_of_unit(_unit_of(size), 2)
    magnitude = leaves.read_number_of(kind, size, f"{address}.magnitude", context, "")
    angle = leaves.read_number_of(Angle, way, f"{address}.direction", context, "")  # type: ignore[arg-type]
    return PolarVector(address, kind, magnitude, angle)


def _directed(size: "Any", direction: "tuple[float, ...]", address: str, context: "Context") -> VectorValue:
    kind = kind_of_unit(_unit_of(size), len(direction))
    magnitude = leaves.read_number_of(kind, size, f"{address}.magnitude", context, "")
    return DirectedVector(address, kind, magnitude, direction)


def _certain(raw: "Any", address: str, context: "Context") -> VectorValue:
    vector = _components(raw, address, context)
    if type(vector) is not VectorValue or len(vector.si) == 1:
        raise UsageError("a direction is given by 2 or 3 certain numbers", code="direction", hint=HINT)
    return vector


def _placed(start: str, end: str, context: "Context") -> "tuple[str, str]":
    """Two points, those that the scene names as text of their coordinates."""
    if not context.points:
        return start, end
    from dynamics_cli.core.inputs.sources.named_points import coordinates

    places = (coordinates(text, context.points) for text in (start, end))
    first, last = (", ".join(place) if isinstance(place, list) else place for place in places)
    return first, last


def _between(start: str, end: str, address: str, context: "Context") -> "tuple[float, ...]":
    unit = _unit_of(split_list(end)[-1])
    shared = start if _unit_of(split_list(start)[-1]) or not unit else f"{start.strip()} {unit}"
    one, finish = _certain(shared, address, context), _certain(end, address, context)
    if len(one.si) != len(finish.si) or one.kind.unit != finish.kind.unit:
        raise UsageError("the two points of a direction differ in kind or in dimension", code="direction", hint=HINT)
    return tuple(b - a for a, b in zip(one.si, finish.si, strict=True))


def _normed(parts: "tuple[float, ...]") -> "tuple[float, ...]":
    largest = max(map(abs, parts))
    if not largest:
        raise UsageError("the direction is a zero vector", code="zero-vector", hint="give a direction that is not zero")
    parts = tuple(part / largest for part in parts)
    length = hypot(hypot(parts[0], parts[1]), parts[2] if len(parts) == 3 else 0.0)
    return tuple(part / length for part in parts)


def _from_angles(text: str, address: str, context: "Context") -> "tuple[float, ...]":
    items = share_unit(split_list(text))
    if len(items) != 3:
        raise UsageError(f"read {len(items)} direction angles, wanted 1 or 3", code="direction", hint=HINT)
    angles = [leaves.read_number_of(Angle, item, address, context, "") for item in items]  # type: ignore[arg-type]
    cosines = tuple(cos(angle.si) for angle in angles)
    total = sum(cosine * cosine for cosine in cosines)
    if not abs(total - 1.0) <= MOST_OFF:
        raise UsageError(
            f"the squared cosines of the three direction angles add to {total:.4g}; of a direction they add to 1",
            code="direction-angles",
            hint="measure each angle from its axis, or give the direction by `along`",
        )
    if abs(total - 1.0) > WORTH_SAYING:
        context.notes.append(f"{address}: squared cosines of its direction angles add to {total:.6g}, scaled to 1")
    return cosines


def _matrix(raw: "Any") -> Bound:
    rows = _rows(raw)
    width = len(rows[0])
    for number, row in enumerate(rows, 1):
        if len(row) != width:
            lengths = f"row {number} has {len(row)}, row 1 has {width}"
            raise UsageError(f"the rows differ in length: {lengths}", code="matrix", hint="for example '2, 1; 1, 3'")
    if len(rows) > MOST_ROWS or width > MOST_ROWS:
        raise UsageError(f"the matrix is {len(rows)} by {width}, the largest is 6 by 6", code="matrix")
    numbers = tuple(tuple(read_fraction(str(cell).strip()) for cell in row) for row in rows)
    return Constant(numbers, {"value": [[_shown(cell) for cell in row] for row in numbers]})


def _shown(cell: "tuple[int, int]") -> "int | float":
    return cell[0] if cell[1] == 1 and abs(cell[0]) < 2**53 else nearest(*cell)


def _rows(raw: "Any") -> "list[list[Any]]":
    if isinstance(raw, dict):
        raw = raw.get("value")
    if isinstance(raw, str):
        text = raw.strip()
        if text.startswith("["):
            inner = [split_list(row.strip()[1:-1]) if row.startswith("[") else row for row in split_list(text[1:-1])]
            raw = inner
        else:
            raw = [split_list(row) if "," in row else row.split() for row in text.split(";")]
    if not isinstance(raw, list) or not raw:
        raise UsageError("read no rows, wanted a matrix", code="matrix", hint="for example '2, 1; 1, 3'")
    rows = raw if isinstance(raw[0], list) else [raw]
    if not all(isinstance(row, list) and row for row in rows):
        raise UsageError("a row of the matrix is empty", code="matrix", hint="for example '2, 1; 1, 3'")
    return rows


def read_free(kind: Kind, raw: "Any", address: str, context: "Context") -> Bound:
    """Bind a vector of any kind, or a matrix; raises UsageError, whose parameter the caller fills in."""
    if isinstance(raw, str) and raw.startswith("@"):
        from dynamics_cli.core.inputs.sources.references import resolve

        raw = resolve(raw, context, address)
    return _matrix(raw) if kind.form == "matrix" else OfAnyKind(_read(raw, address, context))
