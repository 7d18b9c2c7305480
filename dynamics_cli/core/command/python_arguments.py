"""Arguments of Python callers: the options that apply there, and numbers of other libraries converted to Python's."""

from dynamics_cli.core.inputs.settings import UNIVERSAL_OPTIONS
from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any

# Command-line options without meaning for a function that returns a dictionary, with their replacements.
REFUSED = {
    **dict.fromkeys(
        ("json", "format", "output"), "the call returns the document as a dictionary: write it with json.dump"
    ),
    "template": "write it with the command: dynamics FAMILY TASK --template",
    "rows": "for a stream of cases use dynamics_cli.run_rows, or one call for each case",
    "digits": "the document has all digits: round when you print",
}
# Python prints integers of some thousands of digits at most; no double is that large.
MOST_BITS = 4000


def plain_parameters(parameters: "Mapping[str, object]") -> "dict[str, Any]":
    """Parameters by name (`from_` is `from`), their values as JSON has them."""
    return {name.rstrip("_"): _plain(value, name) for name, value in parameters.items()}


def options_of(raw: "dict[str, Any]") -> "dict[str, Any]":
    """Separate the universal options from the parameters, in the form of the command line."""
    keys = {name: name.replace("-", "_") for name in UNIVERSAL_OPTIONS}
    settings = {name: value for name, key in keys.items() if (value := raw.pop(key, None)) is not None}
    for name, value in settings.items():
        how = UNIVERSAL_OPTIONS[name][0]
        if name in REFUSED or (name == "plot" and value == "-"):
            hint = REFUSED.get(name, "name a file")
            raise UsageError(f"{name}={value!r} is an option of the command line only", parameter=name, hint=hint)
        if how == "flag":
            if not isinstance(value, bool):
                raise UsageError(f"read {name}={value!r}, wanted True or False", parameter=name)
        elif how == "many":
            settings[name] = [_text(name, item) for item in (value if isinstance(value, list) else [value])]
        else:
            settings[name] = _text(name, value)
    return settings


def _text(name: str, value: object) -> str:
    if isinstance(value, bool) or not isinstance(value, str | int | float):
        raise UsageError(f"read {name}={value!r}, wanted text", parameter=name, hint=UNIVERSAL_OPTIONS[name][2])
    return str(value)


def _plain(value: "Any", name: str) -> "Any":
    if isinstance(value, dict):
        return {key: _plain(item, name) for key, item in value.items()}
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, list | tuple):
        return [_plain(item, name) for item in value]
    if isinstance(value, int) and value.bit_length() > MOST_BITS:
        raise UsageError(f"{name} is beyond the range of a double", code="range", parameter=name)
    return value
