"""A function's signature, read as the specification of a calculation.

`specification(function)` gives the parameters as a small tree of nodes. Reading `__annotations__`, `__defaults__` and
`__code__` directly takes microseconds; importing inspect
and typing would cost a shell user more than the calculation.
"""

import sys

from dynamics_cli.quantities import Described, Kind
from dynamics_cli.records import Choice, Columns, ExactQuantity, Measured

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from typing import Any, TypeAlias

    Node: TypeAlias = "Leaf | Record | OneOf | Tagged | Many"

PLAIN_RATIO = Kind("number", "", example="1.5", about="a pure number")
PLAIN_COUNT = Kind("count", "", form="whole", example="3", about="a whole number")
PLAIN_TEXT = Kind("text", "", form="text", about="words")
FLAG = Kind("flag", "", form="flag", about="true or false")
EXACT = Kind("exact quantity", "", form="exact", example="60 mph", about="a number and its unit, kept exact")
DRAWING = Kind("drawing", "", form="drawing", about="outlines of ordered pieces")
DEVIATION = Kind("deviation", "m", si="mm", us="in", low=0.0, about="a bound on the distance from the exact curve")
# Descriptions that begin so continue the parameter's name.
CONTINUING = ("of ", "from ", "at ", "about ", "between ", "along ", "in ", "on ", "across ")
MEASURED = Kind("quantity", "", form="measured", about="a number with a unit of its own")

_PLAIN = {
    float: PLAIN_RATIO,
    int: PLAIN_COUNT,
    str: PLAIN_TEXT,
    bool: FLAG,
    ExactQuantity: EXACT,
    Measured: MEASURED,
}


class _Required:
    def __repr__(self) -> str:
        return "REQUIRED"


REQUIRED = _Required()


class SpecificationError(TypeError):
    """A signature that cannot be a specification: a mistake in the program, found when the task is registered."""


class Leaf:
    """One quantity, choice, flag, text or file."""

    __slots__ = ("choice", "kind")

    def __init__(self, kind: Kind, choice: "type[Choice] | None" = None) -> None:
        self.kind = kind
        self.choice = choice


class Record:
    """A record of named fields, read from the class when first asked for, so that records may be recursive."""

    __slots__ = ("_fields", "_names", "_required", "cls")

    def __init__(self, cls: type) -> None:
        self.cls = cls
        self._fields: tuple[Field, ...] | None = None
        self._names: frozenset[str] | None = None
        self._required: frozenset[str] | None = None

    @property
    def fields(self) -> "tuple[Field, ...]":
        """The record's fields in order."""
        if self._fields is None:
            namespace = vars(sys.modules[self.cls.__module__])
            defaults = self.cls.defaults  # type: ignore[attr-defined]
            self._fields = tuple(
                _field(name, annotation, defaults.get(name, REQUIRED), namespace)
                for name, annotation in self.cls.__annotations__.items()
            )
        return self._fields

    @property
    def names(self) -> "frozenset[str]":
        """Every name that may be given for this record."""
        if self._names is None:
            self._names = frozenset(self.keys())
        return self._names

    def keys(self) -> "tuple[str, ...]":
        """The same names in the order of the fields."""
        return tuple(dict.fromkeys(name for field in self.fields for name in field.spread()))

    @property
    def required(self) -> "frozenset[str]":
        """The names that must be given for this record."""
        if self._required is None:
            self._required = frozenset(field.name for field in self.fields if field.required and not field.spreads)
        return self._required


class OneOf:
    """Alternatives distinguished by the names given: radius, or chord and middle ordinate."""

    __slots__ = ("members",)

    def __init__(self, members: "tuple[Record, ...]") -> None:
        self.members = members
        for i, member in enumerate(members):
            for other in members[i + 1 :]:
                if member.required | other.required <= member.names & other.names:
                    raise SpecificationError(
                        f"{member.cls.__name__} and {other.cls.__name__} cannot be distinguished by the names given"
                    )


class Tagged:
    """Alternatives distinguished by a key: shape = "cylinder"."""

    __slots__ = ("_names", "key", "members")

    def __init__(self, key: str, members: "dict[str, Record]") -> None:
        self.key = key
        self.members = members
        self._names: frozenset[str] | None = None

    def member(self, name: str) -> "Record | None":
        """The alternative of a name, or of a further one that it goes by: `disc` for `disk`."""
        further = (record for record in self.members.values() if name in getattr(record.cls, "also", ()))
        return self.members.get(name) or next(further, None)

    @property
    def names(self) -> "frozenset[str]":
        """Every name that may be given for one of the alternatives."""
        if self._names is None:
            self._names = frozenset(name for member in self.members.values() for name in member.names)
        return self._names


class Many:
    """Several of one item; `single` if one item may be given by its plain fields."""

    __slots__ = ("columns", "item", "single")

    def __init__(self, item: "Node", *, single: bool = False, columns: bool = False) -> None:
        self.item = item
        self.single = single
        self.columns = columns

    def by_plain(self, plain: "list[str]") -> bool:
        """Whether one item is read from its plain fields; without any, items of several kinds are asked for as such."""
        if not self.single or isinstance(self.item, Leaf):
            return False
        kinds = isinstance(self.item, Record) and getattr(self.item.fields[0].node, "choice", None) is not None
        return bool(plain) or not kinds

    @property
    def plain(self) -> "frozenset[str]":
        """The names by which one item may be given without the list's."""
        if not self.single or isinstance(self.item, Leaf):
            return frozenset()
        return Field("", self.item, (), "word").known


def description(text: str) -> str:
    """A description without the SI unit in brackets."""
    text = text.strip().rstrip(".")
    start = text.rfind(" [")
    return text[:start].rstrip(".") if text.endswith("]") and start > 0 and " " not in text[start + 2 :] else text


class Field:
    """A named node with its default and description; `place` is "", "word" (positional) or "words" (any number)."""

    __slots__ = ("_known", "_spread", "default", "key", "name", "node", "place", "text")

    def __init__(self, name: str, node: "Node", default: object, place: str = "", text: str = "") -> None:
        self.name = name
        # The name a user writes: a trailing underscore is dropped.
        self.key = name.rstrip("_")
        self.node = node
        self.default = default
        self.place = place
        self.text = text
        self._spread: tuple[str, ...] | None = None
        self._known: frozenset[str] | None = None

    @property
    def known(self) -> "frozenset[str]":
        """Every name in its object that this field reads."""
        if self._known is None:
            node = self.node
            if isinstance(node, Record) and self.place:
                self._known = node.names
            else:
                self._known = frozenset(self.spread()) | (node.plain if isinstance(node, Many) else frozenset())
        return self._known

    @property
    def example(self) -> str:
        """The example that its description gives; empty where it gives none."""
        return description(self.text).partition("e.g. ")[2]

    @property
    def meaning(self) -> str:
        """What it is: its description without its example and what follows a colon, a semicolon or in brackets."""
        words = description(self.text)
        for mark in (", e.g. ", "; ", ": ", " ("):
            words = words.partition(mark)[0]
        words = words[:1].lower() + words[1:] if words[1:2].islower() else words
        return f"{self.key.replace('_', ' ')} {words}" if words.startswith(CONTINUING) else words

    @property
    def required(self) -> bool:
        """Whether the parameter must be given."""
        return self.default is REQUIRED and self.place != "words"

    @property
    def spreads(self) -> bool:
        """Whether this field's own fields stand beside its siblings, without its name."""
        return isinstance(self.node, OneOf | Tagged) or (isinstance(self.node, Many) and self.node.single)

    def spread(self) -> "tuple[str, ...]":
        """The keys under which this field may be given in its object."""
        if self._spread is None:
            self._spread = tuple(self._keys())
        return self._spread

    def _keys(self) -> "Iterator[str]":
        node = self.node
        if isinstance(node, OneOf):
            for member in node.members:
                yield from member.keys()
        elif isinstance(node, Tagged):
            yield node.key
            for member in node.members.values():
                yield from member.keys()
        else:
            yield self.key
            if isinstance(node, Many) and node.single and isinstance(node.item, Record):
                yield from node.item.keys()


def _field(name: str, annotation: object, default: object, namespace: "dict[str, Any]", place: str = "") -> Field:
    annotation, text = _unwrapped(annotation, namespace)
    return Field(name, interpret(annotation, namespace), default, place, text)


def _unwrapped(annotation: object, namespace: "dict[str, Any]") -> "tuple[object, str]":
    """An annotation without its description, and the description."""
    if isinstance(annotation, str):
        annotation = eval(annotation, namespace)
    return (annotation.inner, annotation.text) if isinstance(annotation, Described) else (annotation, "")


def interpret(annotation: object, namespace: "dict[str, Any]") -> "Node":
    """The node of an annotation."""
    if isinstance(annotation, str):
        annotation = eval(annotation, namespace)
    if isinstance(annotation, Kind):
        return Leaf(annotation)
    if getattr(annotation, "__origin__", None) is tuple:
        return Many(interpret(annotation.__args__[0], namespace))  # type: ignore[attr-defined]
    if getattr(annotation, "__origin__", None) is Columns:
        return Many(interpret(annotation.__args__[0], namespace), columns=True)  # type: ignore[attr-defined]
    if isinstance(annotation, type):
        return _interpret_class(annotation)
    if hasattr(annotation, "__args__"):
        return _interpret_union(annotation.__args__, namespace)
    raise SpecificationError(f"{annotation!r} cannot stand in a signature")


def _interpret_class(annotation: type) -> "Node":
    if annotation in _PLAIN:
        return Leaf(_PLAIN[annotation])
    if issubclass(annotation, Choice):
        return Leaf(PLAIN_TEXT, annotation)
    if hasattr(annotation, "fields"):
        return Leaf(DRAWING) if hasattr(annotation, "is_drawing") else Record(annotation)
    raise SpecificationError(f"{annotation.__name__} has no meaning in a signature")


def _interpret_union(members: "tuple[Any, ...]", namespace: "dict[str, Any]") -> "Node":
    nodes = [interpret(member, namespace) for member in members if member is not None and member is not type(None)]
    if len(nodes) == 1:
        return nodes[0]
    if len(nodes) == 2 and isinstance(nodes[0], Record | Tagged | Leaf) and isinstance(nodes[1], Many):
        return Many(nodes[0], single=True)
    flat = [record for node in nodes for record in (members_of(node))]
    keys = {getattr(record.cls, "tag", (None, ""))[0] for record in flat}
    if len(keys) == 1 and None not in keys:
        return Tagged(str(keys.pop()), {record.cls.tag[1]: record for record in flat})  # type: ignore[attr-defined]
    return OneOf(tuple(flat))


def members_of(node: "Node") -> "tuple[Record, ...]":
    """The records of alternatives."""
    if isinstance(node, Record):
        return (node,)
    if isinstance(node, OneOf):
        return node.members
    if isinstance(node, Tagged):
        return tuple(node.members.values())
    raise SpecificationError("alternatives are records")


class Specification:
    """The parameters of a function, and its result."""

    __slots__ = ("fields", "result")

    def __init__(self, fields: "tuple[Field, ...]", result: Record) -> None:
        self.fields = fields
        self.result = result

    @property
    def words(self) -> "tuple[Field, ...]":
        """The positional parameters."""
        return tuple(field for field in self.fields if field.place)


def specification(function: "Callable[..., Any]") -> Specification:
    """Read a function's signature: `/` for positional, `*name` for any number of them, all the rest options."""
    code = function.__code__
    annotations = function.__annotations__
    namespace = function.__globals__
    named = code.co_varnames[: code.co_argcount]
    optional = function.__defaults__ or ()
    defaults = dict(zip(named[len(named) - len(optional) :], optional, strict=True))
    defaults.update(function.__kwdefaults__ or {})
    keywords = code.co_varnames[code.co_argcount : code.co_argcount + code.co_kwonlyargcount]
    fields = []
    for index, name in enumerate(named):
        place = "word" if index < code.co_posonlyargcount else ""
        fields.append(_field(name, annotations[name], defaults.get(name, REQUIRED), namespace, place))
    if code.co_flags & 0x04:
        name = code.co_varnames[code.co_argcount + code.co_kwonlyargcount]
        annotation, text = _unwrapped(annotations[name], namespace)
        fields.append(Field(name, Many(interpret(annotation, namespace)), (), "words", text))
    fields.extend(_field(name, annotations[name], defaults.get(name, REQUIRED), namespace) for name in keywords)
    result = interpret(annotations["return"], namespace)
    if not isinstance(result, Record):
        raise SpecificationError(f"{function.__name__} does not return a record")
    return Specification(tuple(fields), result)
