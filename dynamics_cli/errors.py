"""Kinds of failure, one exit status for each, and the one word physics uses to refuse: `require`."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence


class ExitStatus:
    """What the process tells its caller; the numbers are part of the contract."""

    DONE = 0
    FAULT = 1
    USAGE = 2
    INADMISSIBLE = 3
    SOME_FAILED = 4
    OUTPUT = 5
    INTERRUPTED = 130


class DynamicsError(Exception):
    """A failure that can be told to a user: what is wrong, with which parameter, and how to mend it."""

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

    def all(self) -> "Sequence[DynamicsError]":
        """Every single failure this one stands for."""
        return (self,)


class FaultError(DynamicsError):
    """A fault of ours: a residual check that failed, a state that cannot be."""


class UsageError(DynamicsError):
    """The call is wrong: an unknown name, a bad unit, a value outside its kind's bounds."""

    status = ExitStatus.USAGE
    code = "usage"


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

    `refused` is the array of refused rows when the inputs were arrays, else None.
    """

    status = ExitStatus.INADMISSIBLE
    code = "inadmissible"

    def __init__(
        self, message: str, *, code: str | None = None, hint: str | None = None, refused: object = None
    ) -> None:
        super().__init__(message, code=code, hint=hint)
        self.refused = refused


class OutputError(DynamicsError):
    """The answer exists but could not be written."""

    status = ExitStatus.OUTPUT
    code = "output"


def require(condition: object, message: str, *values: object, code: str | None = None, hint: str | None = None) -> None:
    """Refuse with `message` unless `condition` holds; on arrays, refuse just the rows where it does not.

    `message` may hold `{0:.6g}` places for `values`: the numbers that decide.
    """
    if condition is True:
        return
    if not hasattr(condition, "all") or getattr(condition, "ndim", 0) == 0:
        if condition:
            return
        plain = [getattr(value, "value", value) for value in values]
        raise InadmissibleError(message.format(*plain), code=code, hint=hint)
    if not condition.all():
        raise InadmissibleError("some rows are refused", code=code, hint=hint, refused=~condition)  # type: ignore[operator]
