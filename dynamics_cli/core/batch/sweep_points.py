"""The points of a sweep: START:STOP:COUNT in exact ratios, each point rounded once, in the unit written."""

from dynamics_cli.core.answering.task import Task
from dynamics_cli.core.inputs.forms.leading import pairs_of
from dynamics_cli.core.inputs.forms.splitting import split_list
from dynamics_cli.core.inputs.quantity_text import read_amount, total
from dynamics_cli.core.inputs.sources.references import split_address
from dynamics_cli.core.inputs.specification import Leaf, Many, Record
from dynamics_cli.core.inputs.values import Bound, Constant, Fields, Several, Value, VectorValue
from dynamics_cli.core.units.conversion import convert, nearest
from dynamics_cli.core.units.unit import Unit, conformable
from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.core.inputs.specification import Field, Node

    Raw = dict[str, Any]

EXAMPLE = 'for example --sweep "friction=0.3:0.9:7" or --sweep "distance=20:60 ft:5"'
MOST = 1_000_000


class Axis:
    """One swept parameter: its address, the unit of its points, and the points as doubles in that unit."""

    def __init__(self, name: str, path: "tuple[str | int, ...]", unit: str, values: "list[float]") -> None:
        self.name = name
        self.path = path
        self.unit = unit
        self.values = values
        self.count = len(values)

    def number(self, place: int) -> str:
        """A point's number, as it would be typed."""
        return repr(self.values[place])

    def text(self, place: int) -> str:
        """A point, as it would be typed."""
        return f"{self.values[place]!r} {self.unit}".rstrip()

    def echo(self) -> "dict[str, Any]":
        """The axis as the document shows it."""
        ends: list[dict[str, Any]] = [{"value": self.values[0]}, {"value": self.values[-1]}]
        if self.unit:
            ends = [{**end, "unit": self.unit} for end in ends]
        return {"parameter": self.name, "from": ends[0], "to": ends[1], "count": self.count}

    def check(self, bound: Fields) -> None:
        """Refuse an address that holds no number."""
        if not _has_number(bound, self.name):
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
    parts = [part.strip() for part in text.split(":")]
    if len(parts) != 3 or not all(parts):
        raise UsageError(f"read {text!r}, wanted START:STOP:COUNT", parameter="sweep", code="syntax", hint=EXAMPLE)
    if not (parts[2].isascii() and parts[2].isdigit()) or not 2 <= int(parts[2][:9]) <= MOST:
        message = f"read {parts[2]!r}, wanted a count of points from 2 to {MOST:,}"
        raise UsageError(message, parameter="sweep", code="count", hint=_by_step(name, *parts) or EXAMPLE)
    try:
        start, stop, unit = _ends(parts[0], parts[1])
        values = _points(start, stop, int(parts[2]))
    except UsageError as error:
        error.parameter = "sweep"
        raise
    address = ""
    for step in path:
        address += f"[{step}]" if isinstance(step, int) else f".{step}"
    return Axis(address.lstrip("."), path, unit, values)


def _by_step(name: str, first: str, last: str, third: str) -> str:
    """How a sweep is written whose third part is the step: with the points that it gives."""
    try:
        start, stop, unit = _ends(first, last)
        up, down, own = _read(third)
        unit = unit or own.text
        if own.text and own.text != unit:
            up, down, _ = convert(up, down, own, _read(first if _read(first)[2].text else last)[2])
    except UsageError:
        return ""
    if up <= 0:
        return ""
    steps, rest = divmod((stop[0] * start[1] - start[0] * stop[1]) * down, start[1] * stop[1] * up)
    if rest or not 0 < steps < MOST:
        return ""
    last = last if _read(last)[2].text else f"{last} {unit}".rstrip()
    return f'in steps of {third}: --sweep "{name}={first}:{last}:{steps + 1}"'


def _path(task: Task, name: str) -> "tuple[str | int, ...]":
    from dynamics_cli.core.answering.gather import keys_of

    parameters = {key for field in task.specification.fields for key in keys_of(field)}
    address = name.replace("-", "_")
    steps = tuple(split_address(address))
    if steps[0] in parameters:
        return steps
    option = task.options.get(name.replace("_", "-"))
    if option is not None and not option.repeats:
        return option.path
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


def with_list(raw: "Raw", name: str) -> "Raw":
    """A vector given as one text, or as a list with a unit, as a list of components each with its unit."""
    value = raw.get(name)
    if isinstance(value, dict) and isinstance(value.get("value"), list):
        return {**raw, name: [f"{item} {value.get('unit') or ''}".strip() for item in value["value"]]}
    if not isinstance(value, str):
        return raw
    items = split_list(value.strip().removeprefix("(").removesuffix(")"))
    unit = read_amount(items[-1]).parts[-1][2]
    return {**raw, name: [item if read_amount(item).parts[-1][2] else f"{item} {unit}".strip() for item in items]}


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
        if isinstance(node, Record) and isinstance(value, dict):
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
