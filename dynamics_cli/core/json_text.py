"""Plain data as compact JSON; short answers do without it."""

try:
    from _json import encode_basestring
except ImportError:  # a Python other than CPython
    from json.encoder import encode_basestring

from math import isfinite

from dynamics_cli.errors import FaultError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

quote = encode_basestring


def to_json(value: "Any") -> str:
    """Compact JSON on one line."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{quote(str(key))}: {to_json(item)}" for key, item in value.items()) + "}"
    if isinstance(value, list | tuple):
        return "[" + ", ".join(map(to_json, value)) + "]"
    if isinstance(value, str):
        return quote(value)
    if value is True:
        return "true"
    if value is False:
        return "false"
    if value is None:
        return "null"
    if isinstance(value, float) and not isfinite(value):
        raise FaultError(f"{value} has no place in a document", code="not-finite")
    return repr(value)
