"""Errors for people, or as one JSON object, on standard error."""

from dynamics_cli.core.render import to_json
from dynamics_cli.errors import DynamicsError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any


def wants_json(argv: "list[str]", environ: "Mapping[str, str]") -> bool:
    """Whether errors go out as JSON: asked for by option or environment, however badly the rest is written."""
    for index, word in enumerate(argv):
        if word == "--json" or word in ("--format=json", "--format=ndjson"):
            return True
        if word == "--format" and argv[index + 1 : index + 2] in (["json"], ["ndjson"]):
            return True
    return environ.get("DYNAMICS_FORMAT") in ("json", "ndjson")


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
        name = f"{one.parameter}: " if one.parameter and one.parameter not in one.message else ""
        lines.append(f"dynamics: {name}{_printable(one.message)}")
        if one.hint:
            lines.append(f"  {_printable(one.hint)}")
    return "\n".join(lines) + "\n"


def _printable(text: str) -> str:
    return "".join(c if c.isprintable() or c == "\n" else repr(c)[1:-1] for c in text)
