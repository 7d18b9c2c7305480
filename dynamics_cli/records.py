"""Shapes of data that physics takes and gives: frozen records, named choices, columns, checks and advice."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any, ClassVar, Generic, Literal, Self, TypeVar, dataclass_transform

    Row = TypeVar("Row")
    Class = TypeVar("Class", bound=type)

    @dataclass_transform(frozen_default=True)
    def record(cls: Class) -> Class:
        """Make a frozen record of an annotated class."""

    class Columns(Generic[Row]):
        """Many rows of one record, held as one array per field."""

        row: type[Row]
        arrays: dict[str, Any]

        def __init__(self, row: type[Row], **arrays: Any) -> None: ...
        def __len__(self) -> int: ...
else:
    # dataclasses would cost two interpreter starts; this costs nothing measurable.
    def record(cls):
        """Make a frozen record of an annotated class; fields in order, defaults from the class body.

        `__post_init__`, where there is one, checks what was given.
        """
        names = tuple(cls.__annotations__)
        defaults = {name: cls.__dict__[name] for name in names if name in cls.__dict__}
        after = cls.__dict__.get("__post_init__")

        def __init__(self, *args, **kwargs):
            own = self.__dict__
            if args:
                if len(args) > len(names):
                    raise TypeError(f"{cls.__name__} takes {len(names)} fields")
                given = dict(zip(names, args, strict=False))
                if given.keys() & kwargs.keys():
                    raise TypeError(f"{cls.__name__} got a field twice")
                kwargs.update(given)
            values = {**defaults, **kwargs} if defaults else kwargs
            try:
                for name in names:
                    own[name] = values[name]
            except KeyError:
                pass
            if len(values) != len(names) or len(own) != len(names):
                wrong = sorted(values.keys() ^ set(names))
                raise TypeError(f"{cls.__name__}: missing or unknown fields: {', '.join(wrong)}")
            if after is not None:
                after(self)

        def __setattr__(self, name, value):
            raise AttributeError(f"{cls.__name__} is frozen")

        def __eq__(self, other):
            return type(other) is cls and self.__dict__ == other.__dict__

        def __hash__(self):
            return hash(tuple(self.__dict__.values()))

        def __repr__(self):
            return f"{cls.__name__}({', '.join(f'{name}={value!r}' for name, value in self.__dict__.items())})"

        for method in (__init__, __setattr__, __eq__, __hash__, __repr__):
            setattr(cls, method.__name__, method)
        cls.fields = names
        cls.defaults = defaults
        return cls

    class Columns:
        """Many rows of one record, held as one array per field."""

        def __init__(self, row, **arrays):
            if set(arrays) != set(row.fields):
                raise TypeError(f"columns of {row.__name__} are {', '.join(row.fields)}")
            self.row = row
            self.arrays = arrays

        def __len__(self):
            return len(next(iter(self.arrays.values())))

        __class_getitem__ = classmethod(type(list[int]))


class Choice(str):
    """One of a few named things; subclasses list `names` and, by other spellings, `aliases`."""

    __slots__ = ()
    names: "ClassVar[tuple[str, ...]]" = ()
    aliases: "ClassVar[dict[str, str]]" = {}  # noqa: RUF012

    def __new__(cls, text: str) -> "Self":
        """Read `text`, in any case, with spaces or underscores for hyphens."""
        name = text.strip().lower().replace("_", "-").replace(" ", "-")
        name = cls.aliases.get(name, name)
        if name not in cls.names:
            raise ValueError(f"{text!r} is not one of {', '.join(cls.names)}")
        return super().__new__(cls, name)


def tagged(key: str) -> "Callable[[Class], Class]":
    """Mark a record as one alternative of a union, chosen by `key`: `shape = "cylinder"`."""

    def mark(cls: "Class") -> "Class":
        name = "".join("-" + c.lower() if c.isupper() else c for c in cls.__name__).lstrip("-")
        cls.tag = (key, name)  # type: ignore[attr-defined]
        return cls

    return mark


def over_parts(tree: "Any", function: "Callable[[Any], Any]") -> "Any":
    """A record, tuple or dictionary again, of what `function` makes of each of its parts; anything else as it is."""
    if isinstance(tree, tuple):
        return tuple(function(part) for part in tree)
    if isinstance(tree, dict):
        return {name: function(part) for name, part in tree.items()}
    if hasattr(tree, "fields"):
        return type(tree)(**{name: function(getattr(tree, name)) for name in tree.fields})
    return tree


@record
class Check:
    """One machine-checked property of an answer: its residual beside the tolerance it must keep."""

    name: str
    passed: bool
    value: float | None = None
    tolerance: float | None = None


@record
class Advice:
    """Something a user should know about an answer, with the number that would remedy it.

    `result` names a result that does not exist for this reason: it is shown as null, not left out.
    """

    code: str
    message: str
    severity: "Literal['note', 'caution', 'serious']" = "caution"
    remedy: str | None = None
    result: str | None = None


@record
class ErrorBound:
    """A bound that a solver states for one of its results; absolute ones in SI, or in the unit the result carries."""

    result: str
    bound: float
    relative: bool = True


@record
class Condition:
    """Relative changes of a result per relative change of an input, stated by a calculation that is not tracked."""

    result: str
    parameter: str
    value: float


@record
class Numerics:
    """How a solver answered: its method and the bounds and condition numbers it states for its results."""

    method: str
    bounds: tuple[ErrorBound, ...] = ()
    conditions: tuple[Condition, ...] = ()


class LateNumerics(Numerics):
    """Numerics whose bounds are calculated where they are asked for: rows do without them."""

    def __init__(self, method: str, bounds: "Callable[[], tuple[ErrorBound, ...]]") -> None:
        self.__dict__.update(method=method, conditions=(), late=bounds)

    @property
    def bounds(self) -> tuple[ErrorBound, ...]:
        """The bounds, calculated once."""
        if "found" not in self.__dict__:
            self.__dict__["found"] = self.__dict__["late"]()
        return self.__dict__["found"]  # type: ignore[no-any-return]


@record
class Measured:
    """A result that carries its own unit; compound units give a tuple of numbers and `ft;in`.

    With `inherited` the unit is that of an input, which gives way to coherent units where these are asked for.
    """

    value: float | tuple[float, ...]
    unit: str
    inherited: bool = False


@record
class Quantity:
    """A number, or the components of a vector, in SI, with the kind that the inputs have made it.

    Where a signature says `FreeVector` or `FreeNumber`, this says what was written: a force, a velocity, a length.
    """

    value: "Any"
    kind: "Any"


@record
class ExactQuantity:
    """An exact rational number with the unit it was written in; `si`: those of many rows, an array in SI, instead."""

    numerator: int
    denominator: int
    unit: str
    text: str = ""
    si: "Any" = None


@record
class Formula:
    """A formula as written, without the unit at its end, and how many of the SI unit one of that unit is.

    Where its numbers have units, these with their sizes and dimensions, and the dimension that is wanted in `unit`.
    """

    text: str
    factor: float
    unit: str
    units: "tuple[tuple[str, float, tuple[int, ...]], ...]" = ()
    wanted: "tuple[int, ...]" = ()


@record
class Let:
    """A variable of formulas: its name, its value in SI, the unit it was written in, and the dimension of that."""

    name: str
    value: float
    unit: str
    dimension: "tuple[int, ...] | None" = None


def docstring(thing: "type | Callable[..., Any]") -> str:
    """What is documented of a class or a function, from its source where the interpreter has dropped it (-OO)."""
    # This module's own shows whether the interpreter did so.
    if thing.__doc__ or __doc__:
        return thing.__doc__ or ""
    import ast
    import inspect
    from textwrap import dedent

    try:
        (statement,) = ast.parse(dedent(inspect.getsource(thing))).body
    except OSError:
        return ""  # there is no source beside the compiled files
    return ast.get_docstring(statement, clean=False) or ""  # type: ignore[arg-type]
