"""Kinds of failure, one exit status for each, and how physics refuses: `require` and, by judgement, `judge`."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence
    from typing import Any


class ExitStatus:
    """The exit status of the process; the numbers are part of the contract."""

    DONE = 0
    FAULT = 1
    USAGE = 2
    INADMISSIBLE = 3
    SOME_FAILED = 4
    OUTPUT = 5
    VERDICT = 6
    INTERRUPTED = 130


class DynamicsError(Exception):
    """A failure to report to a user: what is wrong, with which parameter, and the remedy."""

    status = ExitStatus.FAULT
    code = "fault"

    def __init__(
        self, message: str, *, code: str | None = None, parameter: str | None = None, hint: str | None = None
    ) -> None:
        super().__init__(message)
        self.message = message
        self.code = code or type(self).code
        self.parameter = parameter
        self.hint = hint
        # The parameter as the caller writes it, where that is known.
        self.named = ""
        # Lines of a call that works, for one that gave nothing at all.
        self.example: Sequence[str] = ()

    def all(self) -> "Sequence[DynamicsError]":
        """Every single failure this one stands for."""
        return (self,)


class FaultError(DynamicsError):
    """An internal error: a residual check that failed, a state that cannot be."""


class UsageError(DynamicsError):
    """The call is wrong: an unknown name, a bad unit, a value outside its kind's bounds."""

    status = ExitStatus.USAGE
    code = "usage"


class MissingError(UsageError):
    """Something is missing that may be given in several ways, each of some parameters by their addresses."""

    code = "missing"

    def __init__(self, message: str, ways: "Sequence[tuple[str, ...]]", *, code: str | None = None) -> None:
        super().__init__(message, code=code, parameter=ways[0][0])
        self.ways = tuple(ways)
        self.name(str)

    def name(self, spell: "Callable[[str], str]") -> None:
        """Say in the hint what may be given, parameters as the caller writes them."""
        self.hint = "give " + ", or ".join(" and ".join(map(spell, way)) for way in self.ways)


class ManyErrors(UsageError):
    """Every bad parameter of one call, reported together."""

    def __init__(self, errors: "Sequence[DynamicsError]") -> None:
        super().__init__("; ".join(error.message for error in errors), code="several")
        self.errors = tuple(errors)

    def all(self) -> "Sequence[DynamicsError]":
        """Every single failure this one stands for."""
        return self.errors


class InadmissibleError(DynamicsError):
    """Well-formed input that physics cannot answer.

    `refused` is the array of refused rows when the inputs were arrays, else None. `judged` names the results that a
    judgement calls undetermined; their numbers exist, and `left` says what uncertain inputs leave of them.
    """

    status = ExitStatus.INADMISSIBLE
    code = "inadmissible"

    def __init__(
        self, message: str, *, code: str | None = None, hint: str | None = None, refused: object = None
    ) -> None:
        super().__init__(message, code=code, hint=hint)
        self.refused = refused
        self.judged: tuple[str, ...] = ()
        self.left = ""


class OutputError(DynamicsError):
    """The answer exists but could not be written."""

    status = ExitStatus.OUTPUT
    code = "output"


class Wording(str):
    """A sentence of physics with typed values, in SI as it stands; the core writes it in the units of the inputs.

    Places are `{name}`, with the digits where four are not right: `{name:6}`.
    """

    __slots__ = ("template", "values")
    template: str
    values: "Mapping[str, Any]"


def worded(template: str, **values: "Any") -> Wording:
    """A sentence whose values are `(number in SI, kind)`, or words and counts as they are.

    >>> from dynamics_cli.quantities import Distance
    >>> worded("the mark of {mark} is too long", mark=(12.5, Distance))
    'the mark of 12.5 m is too long'
    """
    wording = Wording(filled(template, values, lambda value, kind, digits: f"{value:.{digits}g} {kind.unit}".rstrip()))
    wording.template = template
    wording.values = values
    return wording


def filled(template: str, values: "Mapping[str, Any]", write: "Callable[[float, Any, int], str]") -> str:
    """A template with its places filled; `write` gives the text of a number of a kind in so many digits."""
    out = []
    rest = template
    while "{" in rest:
        before, _, rest = rest.partition("{")
        place, _, rest = rest.partition("}")
        name, _, digits = place.partition(":")
        value = values[name]
        if isinstance(value, Wording):
            value = filled(value.template, value.values, write)
        elif isinstance(value, tuple):
            number: Any = getattr(value[0], "value", value[0])
            if getattr(number, "ndim", 0):  # of many cases at once, the first: their words are not shown
                number = number.flat[0]
            value = write(float(number), value[1], int(digits or 4))
        out += [before, str(value)]
    return "".join(out) + rest


def require(
    condition: object, message: str, *values: object, code: str | None = None, hint: str | None = None, **typed: "Any"
) -> None:
    """Refuse with `message` unless `condition` holds; on arrays, refuse just the rows where it does not.

    `message` and `hint` may hold `{name}` places for `typed` values, the numbers that decide (see `worded`). What a
    user typed is such a value too, never a part of the template; a message without values stands as it is. With
    positional `values`, `message` holds `{0:.6g}` places for them.
    """
    if condition is True:
        return
    if not hasattr(condition, "all") or getattr(condition, "ndim", 0) == 0:
        if condition:
            return
        if typed:
            raise InadmissibleError(worded(message, **typed), code=code, hint=worded(hint, **typed) if hint else None)
        plain = [getattr(value, "value", value) for value in values]
        raise InadmissibleError(message.format(*plain) if values else message, code=code, hint=hint)
    if not condition.all():
        raise InadmissibleError("some rows are refused", code=code, hint=hint, refused=~condition)  # type: ignore[operator]


def require_given(given: bool, message: str, *ways: "tuple[str, ...]", code: str | None = None, **typed: "Any") -> None:
    """Refuse a call that lacks a parameter; `ways` are the addresses of what would do, each of which may be several."""
    if not given:
        raise MissingError(worded(message, **typed), ways, code=code)


def judge(
    condition: object,
    message: str,
    *values: object,
    code: str = "undetermined",
    hint: str | None = None,
    results: "tuple[str, ...]" = (),
    **typed: "Any",
) -> None:
    """Refuse an answer that physics allows but nobody should rely on; `results` name what is not determined.

    A judgement is of the inputs as given. Samples of uncertain inputs pass: only `require` removes points from a
    distribution.
    """
    from dynamics_cli.sampling import drawing

    if drawing():
        return
    try:
        require(condition, message, *values, code=code, hint=hint, **typed)
    except InadmissibleError as error:
        error.judged = results
        raise
