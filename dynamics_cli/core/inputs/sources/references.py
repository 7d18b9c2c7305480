"""`@crash.json:first.speed`: a result of an earlier document as an input."""

import os

from dynamics_cli.core.inputs.sources.files import decode, parse_json, read_bytes
from dynamics_cli.core.inputs.sources.hashes import entry_of
from dynamics_cli.core.terminal import Terminal
from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.core.inputs.context import Context


LONGEST_INDEX = 9


def split_address(address: str) -> "list[str | int]":
    """`parts[3].radius` as its steps: "parts", 3, "radius"."""
    steps: list[str | int] = []
    for name in address.split("."):
        key, *indices = name.split("[")
        steps.append(key)
        for index in indices:
            number = index.removesuffix("]")
            if number == index or not (number.isascii() and number.isdigit() and len(number) <= LONGEST_INDEX):
                raise UsageError(f"{address!r} is not an address", hint="for example parts[3].radius")
            steps.append(int(number))
    return steps


def _near_results(raw: "Any", address: str) -> "str | None":
    """The results of a document with similar names, else all of them."""
    results = raw.get("results") if isinstance(raw, dict) else None
    if not isinstance(results, dict) or not results:
        return "a result document is wanted, as --json writes it"
    from dynamics_cli.core.documents import flatten
    from dynamics_cli.core.units.near_names import nearest_words

    names = [name for name, _, unit in flatten(results) if unit] or list(results)
    near = nearest_words(address, names)
    return f"did you mean {' or '.join(near)}?" if near else f"there is {', '.join(names)}"


def resolve(text: str, context: "Context", target: str) -> "Any":
    """The raw value of a reference at the address `target`; the file is recorded for the document."""
    if context.references is not None and not any(text in allowed for allowed in context.references):
        message = f"read {text!r}: rows may not read from files"
        raise UsageError(message, code="reference", hint="add --references to allow it, for rows that you trust")
    name, colon, address = text[1:].rpartition(":")
    if not colon or not name or not address:
        raise UsageError(f"read {text!r}, wanted a file and an address", hint="for example @crash.json:first.speed")
    if name == "-":
        raise UsageError(
            "a reference names a file: standard input is for --input", hint="to read a document use --input -"
        )
    path = name if os.path.isabs(name) else os.path.join(context.folder, name)
    data = read_bytes(path, Terminal())
    raw = parse_json(decode(data, name), name)
    context.files.append(entry_of(path, data))
    value = raw.get("results") if isinstance(raw, dict) else None
    for step in split_address(address):
        try:
            if isinstance(step, int) and isinstance(value, dict):
                # a component has the unit of its vector
                value = {**value, "value": value["value"][step]}
            else:
                value = value[step]  # type: ignore[index]
        except (KeyError, IndexError, TypeError):
            hint = _near_results(raw, address)
            raise UsageError(f"{name!r} has no result {address!r}", code="no-value", hint=hint) from None
    context.origins[target] = (path, address, raw.get("covariance"))
    return value
