"""The points of a sweep: START:STOP:COUNT, or a list; in exact ratios, each rounded once, in the unit written."""

import re

from dynamics_cli.core.answering.task import Task
from dynamics_cli.core.inputs.forms.leading import pairs_of
from dynamics_cli.core.inputs.forms.splitting import split_list
from dynamics_cli.core.inputs.quantity_text import read_amount, total
from dynamics_cli.core.inputs.sources.references import split_address
from dynamics_cli.core.inputs.specification import Leaf, Many, Record, Tagged, members_of
from dynamics_cli.core.inputs.values import Bound, Constant, Fields, Several, Value, VectorValue
from dynamics_cli.core.units.conversion import convert, nearest
from dynamics_cli.core.units.unit import Unit, conformable
from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence
    from typing import Any

    from dynamics_cli.core.inputs.specification import Field, Node

    Raw = dict[str, Any]

EXAMPLE = 'for example --sweep "friction=0.3:0.9:7", --sweep "distance=20:60:10 ft" or --sweep "friction=0.3, 0.5, 0.7"'
WANTED = "START:STOP:COUNT, START:STOP:STEP with the step's unit or a decimal, or a list A, B, C"
MOST = 1_000_000
# 0,5, 0,7
_DECIMAL_COMMAS = re.compile(r"-?\d+,\d+(, +-?\d+,\d+)+(?![\d,]).*").fullmatch


class Axis:
    """One swept parameter: its address, the unit of its points, and the points as doubles in that unit, or as words."""

    def __init__(
        self,
        name: str,
        path: "tuple[str | int, ...]",
        unit: str,
        values: "Sequence[float | str]",
        *,
        listed: bool = False,
    ) -> None:
        self.name = name
        self.path = path
        self.unit = unit
        self.values = values
        self.count = len(values)
        self.listed = listed
        self.words = isinstance(values[0], str)

    def number(self, place: int) -> str:
        """A point's number, as it would be typed."""
        return repr(self.values[place])

    def text(self, place: int) -> str:
        """A point, as it would be typed."""
        if self.words:
            return str(self.values[place])
        return f"{self.values[place]!r} {self.unit}".rstrip()

    def echo(self) -> "dict[str, Any]":
        """The axis as the document shows it."""
        if self.listed:
            listed = {"parameter": self.name, "values": list(self.values), "count": self.count}
            return {**listed, "unit": self.unit} if self.unit else listed
        ends: list[dict[str, Any]] = [{"value": self.values[0]}, {"value": self.values[-1]}]
        if self.unit:
            ends = [{**end, "unit": self.unit} for end in ends]
        return {"parameter": self.name, "from": ends[0], "to": ends[1], "count": self.count}

    def check(self, bound: Fields) -> None:
        """Refuse an address that holds no number."""
        if not self.words and not _has_number(bound, self.name):
            raise UsageError(
                f"{self.name} is not a number that can be swept", parameter="sweep", code="not-a-number", hint=EXAMPLE
            )


def read_axes(task: Task, texts: "dict[str, str]") -> "list[Axis]":
    """The axes of `--sweep NAME=START:STOP:COUNT`, given once or twice."""
    axes = [_axis(task, name, text) for name, text in texts.items()]
    if len({axis.path for axis in axes}) < len(axes):
        raise UsageError(f"{axes[0].name} is swept twice", parameter="sweep", code="exclusive")
    return axes


def _axis(task: Task, name: str, text: str) -> Axis:
    path = _path(task, name)
    address = "".join(f"[{step}]" if isinstance(step, int) else f".{step}" for step in path).lstrip(".")
    parts = [part.strip() for part in text.split(":")]
    try:
        nodes = list(_nodes_at(task.specification.fields, path))
        if nodes and all(map(_is_vector, nodes)):
            hint = f'sweep one component of it: --sweep "{address}[0]={text}"'
            raise UsageError(f"{address} is a vector", code="not-a-number", hint=hint)
        words = any(map(_takes_words, nodes))
        if not words:
            _check_points(text)
        items = [item.strip() for item in split_list(text)]
        if len(parts) == 1 and len(items) > 1 and all(items):
            return Axis(address, path, *(("", items) if words else _listed(items)), listed=True)
        if len(parts) != 3 or not all(parts):
            raise UsageError(f"read {text!r}, wanted {WANTED}", code="syntax", hint=EXAMPLE)
        start, stop, unit = _ends(parts[0], parts[1])
        count = _count(name, *parts)
        # 20:60:10 ft
        return Axis(address, path, unit or _read(parts[2])[2].text, _points(start, stop, count))
    except UsageError as error:
        error.parameter = "sweep"
        raise


def _nodes_at(fields: "tuple[Field, ...]", path: "tuple[str | int, ...]") -> "Iterator[Leaf | Tagged]":
    """What stands at a path: a leaf, or alternatives that its word distinguishes; several where alternatives differ."""
    for field in fields:
        node: Node = field.node.item if isinstance(field.node, Many) else field.node
        steps = path[1:] if field.key == path[0] else path if path[0] in field.known else None
        if steps is None:
            continue
        if isinstance(node, Leaf):
            if not steps:
                yield node
            continue
        steps = steps[1:] if steps and isinstance(steps[0], int) else steps
        if isinstance(node, Tagged) and steps == (node.key,):
            yield node
        elif steps:
            for member in members_of(node):
                yield from _nodes_at(member.fields, steps)


def _takes_words(node: "Leaf | Tagged") -> bool:
    """Whether it is a choice, a name, yes or no."""
    return isinstance(node, Tagged) or node.choice is not None or node.kind.form in ("text", "flag")


def _is_vector(node: "Leaf | Tagged") -> bool:
    """Whether one number is not enough: what is placed exactly may be given by its x alone."""
    kind = node.kind if isinstance(node, Leaf) else None
    return kind is not None and kind.form in ("vector", "planar") and kind.size > 1 and not (kind.flat and kind.exact)


def _listed(items: "list[str]") -> "tuple[str, list[float | str]]":
    """The unit and the numbers of a list in that of its first unit; words as they are typed."""
    try:
        read = [_read(item) for item in items]
    except UsageError:
        if any(item[:1] in "+-.0123456789" for item in items):
            raise
        return "", list(items)
    units = [own for _, _, own in read if own.text]
    values: list[float | str] = []
    for item, (up, down, own) in zip(items, read, strict=True):
        pi = 0
        if own.text and own.text != units[0].text:
            if not conformable(own, units[0]):
                raise UsageError(f"{item!r} is not in the kind of {units[0].text}", code="kind", hint=EXAMPLE)
            up, down, pi = convert(up, down, own, units[0])
        values.append(nearest(up, down, pi))
    return units[0].text if units else "", values


def _check_points(text: str) -> None:
    """Refuse uncertain points, and numbers that may be read in two ways."""
    if any(mark in text for mark in ("±", "+/-", "..")):
        hint = f"only other parameters may be uncertain; {EXAMPLE}"
        raise UsageError(f"the points {text!r} are uncertain", code="uncertain", hint=hint)
    if _DECIMAL_COMMAS(text.strip()):
        hint = "write decimals with a point and thousands without a comma, or a space after every comma of a list"
        raise UsageError(f"{text!r} may be numbers with decimal commas", code="number", hint=hint)


def _count(name: str, first: str, last: str, third: str) -> int:
    """The number of points, given itself or by the step from one to the next."""
    if third.isascii() and third.isdigit():
        if 2 <= int(third[:9]) <= MOST:
            return int(third)
        by_step = _steps(first, last, third)
        hint = f'in steps of {third}: --sweep "{name}={first}:{last}:{by_step}"' if by_step else EXAMPLE
    else:
        if by_step := _steps(first, last, third):
            return by_step
        hint = f"from {first} to {last} is not a whole number of steps of {third}"
        reached = _reached(first, last, third)
        hint += f': --sweep "{name}={first}:{reached}:{third}"' if reached else f"; {EXAMPLE}"
    message = f"read {third!r}, wanted a count of points from 2 to {MOST:,}, or a step"
    raise UsageError(message, code="count", hint=hint)


def _stepped(first: str, last: str, third: str) -> "tuple[int, tuple[int, int], str]":
    """The steps that fit between both ends, where the last of them ends, and its unit; none where the third is no step.

    From a larger number to a smaller one they go downwards, with or without the sign of the step.
    """
    try:
        start, stop, unit = _ends(first, last)
        up, down, own = _read(third)
        if own.text and unit and own.text != unit:
            up, down, _ = convert(up, down, own, _read(first if _read(first)[2].text else last)[2])
    except UsageError:
        return 0, (0, 1), ""
    way = stop[0] * start[1] - start[0] * stop[1]
    up = -abs(up) if way < 0 else up
    if up * way <= 0:
        return 0, (0, 1), ""
    steps = way * down // (start[1] * stop[1] * up)
    return steps, (start[0] * down + steps * up * start[1], start[1] * down), unit


def _steps(first: str, last: str, third: str) -> int:
    """The number of points of a sweep whose third part is the step; 0 where it is none, or does not reach the end."""
    steps, end, _ = _stepped(first, last, third)
    stop = _ends(first, last)[1] if steps else end
    return steps + 1 if end[0] * stop[1] == stop[0] * end[1] and 0 < steps < MOST else 0


def _reached(first: str, last: str, step: str) -> str:
    """Where steps that do not reach the end stop, as it would be typed."""
    steps, end, unit = _stepped(first, last, step)
    unit = unit if _read(last)[2].text else ""
    return f"{nearest(*end, 0):.12g} {unit}".rstrip() if 0 < steps < MOST else ""


def _path(task: Task, name: str) -> "tuple[str | int, ...]":
    from dynamics_cli.core.answering.gather import keys_of

    parameters = {key for field in task.specification.fields for key in keys_of(field)}
    address = name.replace("-", "_")
    steps = tuple(split_address(address))
    if steps[0] in parameters:
        return steps
    option = task.options.get(str(steps[0]).replace("_", "-"))
    if option is not None and not option.repeats:
        return *option.path, *steps[1:]
    from dynamics_cli.core.units.near_names import nearest_words

    near = nearest_words(address, parameters)
    hint = f"did you mean {' or '.join(near)}?" if near else f"known here: {', '.join(sorted(parameters))}"
    raise UsageError(f"there is no parameter {name!r}", parameter="sweep", code="unknown-parameter", hint=hint)


def _ends(first: str, last: str) -> "tuple[tuple[int, int], tuple[int, int], str]":
    """Both ends as exact numbers in the unit written first; a unit at one end holds for both."""
    up, down, unit = _read(first)
    end_up, end_down, end_unit = _read(last)
    if not unit.text or not end_unit.text or unit.text == end_unit.text:
        return (up, down), (end_up, end_down), unit.text or end_unit.text
    if not conformable(unit, end_unit):
        raise UsageError(f"{first!r} and {last!r} are of different kinds", code="kind", hint=EXAMPLE)
    end_up, end_down, pi = convert(end_up, end_down, end_unit, unit)
    if pi:
        raise UsageError(f"{first!r} and {last!r} have no exact ratio", code="kind", hint="write both in one unit")
    return (up, down), (end_up, end_down), unit.text


def _read(text: str) -> "tuple[int, int, Unit]":
    return total(read_amount(text))


def _points(start: "tuple[int, int]", stop: "tuple[int, int]", count: int) -> "list[float]":
    """The points start + (stop − start)·i/(count − 1), each rounded once."""
    common = start[1] * stop[1]
    first, last = start[0] * stop[1], stop[0] * start[1]
    steps = count - 1
    return [nearest(first * (steps - i) + last * i, common * steps) for i in range(count)]


def _has_number(bound: Bound, address: str) -> bool:
    if isinstance(bound, Value | VectorValue):
        return bound.address == address or any(leaf == address for leaf, _, _ in bound.leaves())
    if isinstance(bound, Fields):
        name = address.rpartition(".")[2]
        for key, item in bound.fields.items():
            if isinstance(item, Constant) and key.rstrip("_") == name and _is_number(item):
                return True
        return any(_has_number(item, address) for item in bound.fields.values())
    return isinstance(bound, Several) and any(_has_number(item, address) for item in bound.items)


def _is_number(item: Constant) -> bool:
    return isinstance(item.value, int) and not isinstance(item.value, bool)


def copied(raw: "Any") -> "Any":
    """A copy whose lists and objects may be changed."""
    if isinstance(raw, dict):
        return {key: copied(value) for key, value in raw.items()}
    if isinstance(raw, list):
        return [copied(item) for item in raw]
    return raw


def with_list(raw: "Raw", path: "tuple[str | int, ...]") -> "Raw":
    """A vector given as one text, or as a list with a unit, as a list of components each with its unit."""
    raw = copied(raw)
    inner: Any = raw
    try:
        for step in path[:-1]:
            inner = inner[step]
        value = inner[path[-1]]
    except (KeyError, IndexError, TypeError):
        return raw
    if isinstance(value, dict) and isinstance(value.get("value"), list):
        inner[path[-1]] = [f"{item} {value.get('unit') or ''}".strip() for item in value["value"]]
    elif isinstance(value, str) and "@" not in value:
        items = split_list(value.strip().removeprefix("(").removesuffix(")"))
        unit = read_amount(items[-1]).parts[-1][2]
        inner[path[-1]] = [item if read_amount(item).parts[-1][2] else f"{item} {unit}".strip() for item in items]
    return raw


def with_polar(raw: "Raw", path: "tuple[str | int, ...]") -> "Raw":
    """A vector given as `20 N @ 30 deg` by its magnitude and its direction, so that either may be swept."""
    raw = copied(raw)
    inner: Any = raw
    try:
        for step in path[:-1]:
            inner = inner[step]
        size, polar, direction = str(inner[path[-1]]).partition("@")
    except (KeyError, IndexError, TypeError):
        return raw
    if size.strip() and polar:
        inner[path[-1]] = {"magnitude": size.strip(), "direction": direction.strip()}
    return raw


def with_objects(raw: "Raw", fields: "tuple[Field, ...]") -> "Raw":
    """The input with an object for each item of a list that is written as one text, `pin at 0 m`."""
    raw = dict(raw)
    for field in fields:
        node, value = field.node, raw.get(field.key)
        if isinstance(node, Record) and field.place:
            raw = with_objects(raw, node.fields)
        elif isinstance(node, Record) and isinstance(value, dict):
            raw[field.key] = with_objects(value, node.fields)
        elif isinstance(node, Many) and not isinstance(node.item, Leaf) and isinstance(value, list):
            raw[field.key] = [_as_object(item, node.item) for item in value]
    return raw


def _as_object(item: "Any", node: "Node") -> "Any":
    if not isinstance(item, str) or item[:1] == "@":
        return item
    try:
        return pairs_of(item, node)
    except UsageError:
        return item  # the reader says what is wrong with it
