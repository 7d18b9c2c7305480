"""Preferences of `dynamics.toml` (units, digits, format, gravity), which environment variables override."""

import os

from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping

NAME = "dynamics.toml"
VARIABLES = {name: f"DYNAMICS_{name.upper()}" for name in ("units", "digits", "format", "gravity")}


def with_preferences(environ: "Mapping[str, str]") -> "Mapping[str, str]":
    """The environment over what `dynamics.toml` says, in the current folder or else in the user's configuration."""
    home = environ.get("XDG_CONFIG_HOME") or environ.get("APPDATA") or os.path.join(environ.get("HOME", ""), ".config")
    for path in (NAME, os.path.join(home, "dynamics", NAME)):
        if os.path.isfile(path):
            return {**_read(path), **environ}
    return environ


def _read(path: str) -> "dict[str, str]":
    from dynamics_cli.core.inputs.settings import FORMATS, SYSTEMS
    from dynamics_cli.core.inputs.sources.files import decode, parse_toml, read_bytes
    from dynamics_cli.core.terminal import Terminal

    preferences = parse_toml(decode(read_bytes(path, Terminal()), path), path)
    unknown = sorted(preferences.keys() - VARIABLES.keys())
    if unknown:
        raise UsageError(
            f"{path} sets {unknown[0]!r}, which is not a setting",
            code="preferences",
            hint=f"settings are {', '.join(VARIABLES)}",
        )
    for name, known in (("units", SYSTEMS), ("format", FORMATS)):
        if (value := preferences.get(name, known[0])) not in known:
            message = f"{path}: {name} is {value!r}, wanted one of {', '.join(known)}"
            raise UsageError(message, code="preferences")
    return {VARIABLES[name]: str(value) for name, value in preferences.items()}
