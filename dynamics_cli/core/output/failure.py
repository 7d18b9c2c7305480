"""Errors for people, or as one JSON object, on standard error."""

from dynamics_cli.core.json_text import to_json
from dynamics_cli.core.output.wrapping import wrapped
from dynamics_cli.core.terminal import RED, painted
from dynamics_cli.errors import DynamicsError, MissingError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from typing import Any


def wants_json(argv: "list[str]", environ: "Mapping[str, str]") -> bool:
    """Whether errors go out as JSON: requested by option or environment, however malformed the rest of the call is."""
    requested = environ.get("DYNAMICS_FORMAT", "")
    for index, word in enumerate(argv):
        if word == "--json":
            return True
        if word.startswith("--format="):
            requested = word.partition("=")[2]
        elif word == "--format":
            requested = "".join(argv[index + 1 : index + 2])
    return requested in ("json", "ndjson")


def as_object(error: DynamicsError) -> "dict[str, Any]":
    """One error as the contract's object."""
    return {"code": error.code, "parameter": error.parameter, "message": error.message, "hint": error.hint}


def error_text(
    error: DynamicsError, *, json: bool, typed: "Sequence[str]" = (), columns: int = 0, colours: bool = False
) -> str:
    """The text for standard error; a parameter is named as typed, --roller-radius.

    Lines are wrapped to the columns of a terminal, and red where it has `colours`; elsewhere a message is one line.
    """
    if json:
        body = as_object(error)
        if len(error.all()) > 1:
            body["errors"] = [as_object(item) for item in error.all()]
        return to_json({"error": body}) + "\n"
    lines = []
    for item in error.all():
        name = item.named or _as_typed(item.parameter or "", typed)
        said = (name,) if name.startswith("--") else (repr(name), f"{name}=", f"-{name}")
        named = not name or item.message.startswith((name, f"--{name}", item.parameter or ""))
        named = (
            named or any(part in item.message for part in said) or (isinstance(item, MissingError) and bool(item.hint))
        )
        message = "dynamics: " + _printable(item.message if named else f"{name}: {item.message}")
        hint = _printable(item.hint or "")
        message_lines = wrapped(message, columns, 4) if columns else [message]
        lines += [painted(line, RED) for line in message_lines] if colours else message_lines
        if hint:
            lines += [f"  {line}" for line in (wrapped(hint, columns - 2, 2) if columns else [hint])]
    return "\n".join([*lines, *error.example]) + "\n"


def _as_typed(parameter: str, typed: "Sequence[str]") -> str:
    """The option that gave a parameter, where one was typed for it; else the parameter's address."""
    for name in (parameter, parameter.rpartition(".")[2]):
        option = f"--{name.replace('_', '-').replace('.', '-')}"
        if any(word.partition("=")[0] == option for word in typed):
            return option
    return parameter


def _printable(text: str) -> str:
    return "".join(c if c.isprintable() else repr(c)[1:-1] for c in text)
