"""A commented scene: every field of a task's input as TOML, with its description and an example.

As printed it is a case with an answer: required fields, or the values of the task's scene, are active and the others
are commented out.
"""

from dynamics_cli.core.command.help import written_default
from dynamics_cli.core.inputs.options import Option
from dynamics_cli.core.inputs.specification import Leaf, Many, OneOf, Record, Tagged, description
from dynamics_cli.core.output.wrapping import wrapped

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.core.answering.task import Task
    from dynamics_cli.core.inputs.specification import Field, Node

WIDTH = 80
# Column where descriptions begin.
COLUMN = 36
# Of more alternatives than this only one is written out.
MOST_ALTERNATIVES = 8
HEAD = 'Remove the # of a line "#name = value" to give an optional value.'
EXAMPLE = "e.g. "


def takes_scene(task: "Task") -> bool:
    """Whether a file holds all of a task's input: it looks nothing up, and no word of a call is a number or a name."""
    return not task.listing and all(isinstance(field.node, Record) for field in task.specification.words)


def template(task: "Task") -> str:
    """The scene of a task as TOML."""
    option = "" if task.specification.words else "--input "
    scene = _Scene(task.scene or _of_example(task))
    for line in (task.summary, f"Use: dynamics {task.path} {option}FILE.toml", HEAD):
        scene.comment(line)
    scene.lines.append("")
    fields: list[Field] = []
    for field in task.specification.fields:
        fields += field.node.fields if field.place and isinstance(field.node, Record) else [field]
    scene.table(tuple(fields), "", active=True, inside=())
    return "\n".join(scene.lines) + "\n"


def _of_example(task: "Task") -> "dict[str, str]":
    """The values of a task's first example, by address; of groups that may be repeated every field shows its own."""
    from shlex import split

    from dynamics_cli.core.command.direct import read_plainly

    if not task.examples or any(option.repeats for option in task.options.values()):
        return {}
    call = read_plainly(task, split(task.examples[0])[1 + len(task.path.split()) :])
    values = call.options if call is not None else {}
    return {".".join(task.options[name].path): str(value).replace("True", "true") for name, value in values.items()}


def _without_example(text: str) -> str:
    return description(text).partition(f", {EXAMPLE}")[0]


def example(field: "Field") -> str:
    """An example of a field's value as a user would type it: of its description, else of its kind."""
    node = field.node.item if isinstance(field.node, Many) else field.node
    assert isinstance(node, Leaf)
    if field.example:
        return field.example
    usual = written_default(Option(field.key, (), node, default=field.default, required=field.required))
    if usual and node.kind.form in ("scalar", "slope", "whole") and node.choice is None:
        return usual
    if node.choice is not None:
        return str(field.default if field.default in node.choice.names else node.choice.names[0])
    if node.kind.form == "flag":
        return "true"
    return node.kind.example or field.key


def is_text(field: "Field") -> bool:
    """Whether a field holds words, which may look like a number."""
    kind = getattr(field.node, "kind", None)
    return kind is not None and kind.form == "text"


def _value(text: str, *, words: bool = False) -> str:
    """A value as TOML: numbers and truth values as such, anything else as text."""
    if words:
        return f'"{text}"'
    if text == "true":
        return text
    try:
        float(text)
    except ValueError:
        return f'"{text}"'
    return text.replace("_", "")


class _Scene:
    """Lines of a scene; the values of a table come before the tables within it."""

    def __init__(self, values: "dict[str, str]") -> None:
        self.lines: list[str] = []
        # The task's scene by address; the first item of a list without its index.
        self.values = {_first_unnumbered(address): value for address, value in values.items()}
        # Records already written in full, by the header of the first one.
        self.written: dict[type, str] = {}
        self.brief = False

    def table(self, fields: "tuple[Field, ...]", path: str, *, active: bool, inside: "tuple[type, ...]") -> None:
        """The fields of one table, then its tables."""
        inner: list[Callable[[], None]] = []
        active_fields = {field.name for field in fields if field.required or _chosen(field)}
        # without required values, one value shows the form of a scene
        active_fields = active_fields or {fields[0].name}
        if self.values:
            active_fields = {field.name for field in fields if self._shown(f"{path}{field.key}")}
        for field in fields:
            self._field(field, path, inner, active=active and field.name in active_fields, inside=inside)
        for write in inner:
            write()

    def _field(
        self,
        field: "Field",
        path: str,
        inner: "list[Callable[[], None]]",
        *,
        active: bool,
        inside: "tuple[type, ...]",
    ) -> None:
        node = field.node
        item = node.item if isinstance(node, Many) else node
        if isinstance(item, Leaf):
            value = _value(self.values.get(f"{path}{field.key}") or example(field), words=is_text(field))
            active = active and (not self.values or f"{path}{field.key}" in self.values)
            self._line(field.key, value, _without_example(field.text), active=active)
        elif isinstance(node, OneOf | Tagged):
            self._alternatives(field, node, path, inner, active=active, inside=inside)
        else:
            several = isinstance(node, Many)
            address = f"{path}{field.key}"
            inner.append(lambda: self._nested(field, item, address, several=several, active=active, inside=inside))

    def _shown(self, address: str) -> bool:
        """Whether the task's scene has a value at or below an address."""
        return any(name == address or name.startswith((f"{address}.", f"{address}[")) for name in self.values)

    def _wanted(self, field: "Field", key: str, named: "dict[str, Any]", path: str) -> str:
        """The alternative in the task's scene, else the one that a description gives as an example, else the first."""
        chosen = self.values.get(f"{path}{key}", "")
        if not key:
            # alternatives may share a name
            count = {name: sum(self._shown(f"{path}{member}") for member in name.split()) for name in named}
            most = max(named, key=lambda name: count[name])
            chosen = most if count[most] else ""
        if chosen in named:
            return chosen
        return next((name for name in named if _chosen(field) in name.split()), next(iter(named)))

    def _alternatives(
        self,
        field: "Field",
        node: "OneOf | Tagged",
        path: str,
        inner: "list[Callable[[], None]]",
        *,
        active: bool,
        inside: "tuple[type, ...]",
    ) -> None:
        """One alternative active, the others commented out."""
        named = node.members if isinstance(node, Tagged) else {_names(member): member for member in node.members}
        key = node.key if isinstance(node, Tagged) else ""
        chosen = self._wanted(field, key, named, path)
        active = active or any(self._shown(f"{path}{member.key}") for member in named[chosen].fields)
        active = active and (not self.values or not key or f"{path}{key}" in self.values)
        text = _without_example(field.text)
        if isinstance(node, OneOf):
            self.comment(f"{text or 'One of these'}:")
        many = isinstance(node, Tagged) and len(named) > MOST_ALTERNATIVES
        for name in [chosen] if many else [chosen, *(name for name in named if name != chosen)]:
            live = active and name == chosen
            if isinstance(node, Tagged):
                comment = f"{text}: {', '.join(named)}" if name == chosen and not many else text if many else ""
                self._line(node.key, f'"{name}"', comment, active=live)
            elif name != chosen:
                self.comment("or:")
            for member in named[name].fields:
                self._field(member, path, inner, active=live and (member.required or bool(self.values)), inside=inside)

    def _nested(
        self,
        field: "Field",
        item: "Node",
        address: str,
        *,
        several: bool,
        active: bool,
        inside: "tuple[type, ...]",
    ) -> None:
        header = f"[[{address}]]" if several else f"[{address}]"
        if self.lines[-1]:
            self.lines.append("")
        self.comment(description(field.text) + (" (repeat for more)" if several else ""))
        outer = self.brief
        if isinstance(item, Record):
            same = self.written.setdefault(item.cls, header)
            if same != header:
                self.comment(f"It takes the same fields as {same}.")
                self.brief = True
            if item.cls in inside:
                self.lines.append(f"#{header}")
                return
        self.lines.append(header if active else f"#{header}")
        if isinstance(item, Record):
            self.table(item.fields, f"{address}.", active=active, inside=(*inside, item.cls))
            self.brief = outer
            self._more(header, address)
        elif isinstance(item, OneOf | Tagged):
            inner: list[Callable[[], None]] = []
            self._alternatives(field, item, f"{address}.", inner, active=active, inside=inside)
            for write in inner:
                write()
            self._more(header, address)

    def _more(self, header: str, address: str) -> None:
        """Further items of a list, with lists within them, as in the task's scene."""
        last = ""
        for name, value in self.values.items():
            if name.startswith(f"{address}["):
                item, _, key = name.rpartition("].")
                within = "".join(part.partition("]")[2] for part in f"{item}]".removeprefix(address).split("["))
                self.lines += ["", header.replace(address, address + within)] if item != last else []
                last = item
                self.lines.append(f"{key} = {_value(value)}")

    def comment(self, text: str) -> None:
        """A paragraph of comment."""
        if self.brief and not text.startswith("It "):
            return
        self.lines += [f"# {line}" for line in wrapped(text, WIDTH - 2, 0)]

    def _line(self, key: str, value: str, text: str, *, active: bool) -> None:
        """A value with its description beside it, or above it where it is long."""
        if self.brief and not active:
            return
        head = f"{'' if active else '#'}{key} = {value}"
        if len(head) > COLUMN - 2:
            if text:
                self.comment(text)
            self.lines.append(head)
            return
        first, *more = wrapped(text, WIDTH - COLUMN - 2, 0)
        self.lines.append(f"{head:<{COLUMN}}# {first}" if text else head)
        self.lines += [f"{'':<{COLUMN}}# {line}" for line in more]


def _first_unnumbered(address: str) -> str:
    """An address without the indices of first items, up to the first other item."""
    head, other, rest = address.partition("[")
    while other and rest.startswith("0]"):
        more, other, rest = rest.removeprefix("0]").partition("[")
        head += more
    return head + other + rest


def _chosen(field: "Field") -> str:
    """The alternative that a description gives as an example."""
    return field.example if isinstance(field.node, OneOf | Tagged) else ""


def _names(record: Record) -> str:
    return " ".join(field.key for field in record.fields)
