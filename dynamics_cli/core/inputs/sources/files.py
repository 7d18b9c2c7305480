"""Inputs from files: JSON, TOML, an earlier result document, or standard input."""

from dynamics_cli.core.inputs.context import Token
from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, BinaryIO

    from dynamics_cli.core.terminal import Terminal

# More than any scene or document; an endless device must not fill the memory.
MOST_BYTES = 1 << 28
DOCUMENT_SCHEMA = "dynamics/2"
# Earlier documents are read too.
READABLE_SCHEMAS = ("dynamics/1", DOCUMENT_SCHEMA)


def read_bytes(name: str, terminal: "Terminal") -> bytes:
    """The bytes of a file, or of standard input for `-`."""
    if name == "-":
        return _limited(terminal.stdin, name)
    try:
        with open(name, "rb") as file:
            return _limited(file, name)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise UsageError(f"cannot read {name!r}: {reason}", code="unreadable") from None


def named(name: str) -> str:
    """A source in a message: standard input, the row of `--rows`, or the file in quotes."""
    return {"-": "standard input", "the row": name}.get(name) or repr(name)


def _limited(file: "BinaryIO", name: str) -> bytes:
    data = file.read(MOST_BYTES + 1)
    if len(data) > MOST_BYTES:
        message = f"{named(name)} holds more than {MOST_BYTES >> 20} MB: too much for parameters"
        raise UsageError(message, code="too-long", hint="a stream of cases goes to --rows")
    return data


def decode(data: bytes, name: str) -> str:
    """UTF-8 text, with or without a byte-order mark."""
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise UsageError(
            f"{named(name)} is not UTF-8 text: byte {error.start} is 0x{data[error.start]:02x}",
            code="encoding",
            hint="save it as UTF-8",
        ) from None


def read_object(name: str, terminal: "Terminal") -> "tuple[dict[str, Any], bytes]":
    """A JSON or TOML file as raw input, with its bytes; TOML by its name, else by its first character."""
    data = read_bytes(name, terminal)
    text = decode(data, name)
    is_toml = name.endswith(".toml") or (not name.endswith(".json") and not text.lstrip().startswith(("{", "[{")))
    raw = parse_toml(text, name) if is_toml and text.strip() else parse_json(text, name)
    if not isinstance(raw, dict):
        raise UsageError(
            f"{named(name)} holds {type(raw).__name__}, wanted one object",
            code="json",
            hint="a list of cases goes to --rows",
        )
    return raw, data


def parse_json(text: str, name: str) -> "Any":
    """Strict JSON, numbers kept as text; refuses duplicate names, NaN and infinities."""
    import json

    try:
        return json.loads(
            text, parse_float=Token, parse_int=Token, parse_constant=_no_constant, object_pairs_hook=_unique
        )
    except json.JSONDecodeError as error:
        where = f"line {error.lineno}, column {error.colno}"
        hint = "it is empty" if not text.strip() else None
        raise UsageError(f"{named(name)} is not JSON: {error.msg} at {where}", code="json", hint=hint) from None
    except RecursionError:
        raise UsageError(f"{named(name)} is nested too deeply", code="json") from None


def parse_toml(text: str, name: str) -> "dict[str, Any]":
    """TOML, numbers kept as text."""
    import tomllib

    try:
        return _plain(tomllib.loads(text, parse_float=_finite_token))  # type: ignore[no-any-return]
    except tomllib.TOMLDecodeError as error:
        raise UsageError(
            f"{named(name)} is not TOML: {error}", code="toml", hint=_toml_hint(text, str(error))
        ) from None
    except RecursionError:
        raise UsageError(f"{named(name)} is nested too deeply", code="toml") from None
    except ValueError:
        # Python reads and writes whole numbers of some thousands of digits at most.
        message = f"{named(name)} is not TOML that can be read: a whole number has thousands of digits"
        raise UsageError(message, code="toml", hint="write it as 1e99") from None


# What a parser complains of, and what was mostly meant.
TOML_SLIPS = {
    "Invalid value": 'text stands in quotes: name = "Ford"',
    "declare": "each [table] is written once; one of several has double brackets: [[table]]",
    "overwrite": "each name is given once; one table of several has double brackets: [[table]]",
    "Expected ']'": 'a name with a space stands in quotes: [surfaces."wet grass"]',
    "Expected '='": "a line is name = value",
}


def _toml_hint(text: str, message: str) -> str | None:
    """The line that cannot be read, and what was mostly meant."""
    number = message.partition("at line ")[2].partition(",")[0]
    line = "".join(text.split("\n")[int(number) - 1 : int(number)]).strip() if number.isdigit() else ""
    meant = next((hint for word, hint in TOML_SLIPS.items() if word in message), "")
    return "; ".join(part for part in (f"that line is: {line}" if line else "", meant) if part) or None


def parameters_of(raw: "dict[str, Any]", known: "set[str]", command: str) -> "dict[str, Any]":
    """Raw parameters: an earlier document's inputs if it is of the same command, else its results of the same name."""
    if "schema" not in raw:
        return raw
    if raw["schema"] not in READABLE_SCHEMAS:
        raise UsageError(f"read a document of schema {raw['schema']!r}, wanted {DOCUMENT_SCHEMA!r}", code="schema")
    results = raw.get("results")
    if not isinstance(results, dict):
        raise UsageError("the document has no results", code="schema")
    if raw.get("command") == command and isinstance(raw.get("inputs"), dict):
        return {key: value for key, value in raw["inputs"].items() if key != "sweep"}
    return {key: value for key, value in results.items() if key in known}


def _no_constant(text: str) -> "Any":
    raise UsageError(f"read {text}: a number must be finite", code="json")


def _finite_token(text: str) -> Token:
    if text.lstrip("+-") in ("nan", "inf"):
        raise UsageError(f"read {text}: a number must be finite", code="toml")
    return Token(text.replace("_", ""))


def _unique(pairs: "list[tuple[str, Any]]") -> "dict[str, Any]":
    object_: dict[str, Any] = {}
    for name, value in pairs:
        if name in object_:
            raise UsageError(f"the name {name!r} is given twice", code="json", parameter=name)
        object_[name] = value
    return object_


def _plain(value: "Any") -> "Any":
    """TOML's own numbers and dates as the raw input's text."""
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, list):
        return [_plain(item) for item in value]
    if isinstance(value, int) and not isinstance(value, bool):
        return Token(value)
    if isinstance(value, str | bool):
        return value
    raise UsageError(f"read a date or time, {value}", code="toml", hint="write quantities as text with a unit")
