"""Errors for people, or as one JSON object, on standard error."""

from dynamics_cli.core.render import to_json
from dynamics_cli.errors import DynamicsError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any


def wants_json(argv: "list[str]", environ: "Mapping[str, str]") -> bool:
    """Whether errors go out as JSON: asked for by option or environment, however badly the rest is written."""
    asked = environ.get("DYNAMICS_FORMAT", "")
    for index, word in enumerate(argv):
        if word == "--json":
            return True
        if word.startswith("--format="):
            asked = word.partition("=")[2]
        elif word == "--format":
            asked = "".join(argv[index + 1 : index + 2])
    return asked in ("json", "ndjson")


def as_object(error: DynamicsError) -> "dict[str, Any]":
    """One error as the contract's object."""
    return {"code": error.code, "parameter": error.parameter, "message": error.message, "hint": error.hint}


def error_text(error: DynamicsError, *, json: bool) -> str:
    """What goes to standard error."""
    if json:
        body = as_object(error)
        if len(error.all()) > 1:
            body["errors"] = [as_object(one) for one in error.all()]
        return to_json({"error": body}) + "\n"
    lines = []
    for one in error.all():
        named = not one.parameter or one.message.startswith((one.parameter, f"--{one.parameter}"))
        lines.append("dynamics: " + _printable(one.message if named else f"{one.parameter}: {one.message}"))
        if one.hint:
            lines.append(f"  {_printable(one.hint)}")
    return "\n".join(lines) + "\n"


def _printable(text: str) -> str:
    return "".join(c if c.isprintable() else repr(c)[1:-1] for c in text)
