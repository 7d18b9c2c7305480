"""From a call to the raw input: words and options placed as the signature says, over the values from files."""

from dynamics_cli.core.answering.task import Task
from dynamics_cli.core.inputs.reader import Reader
from dynamics_cli.core.inputs.settings import Call, Settings
from dynamics_cli.core.inputs.specification import Field, Leaf, Many, OneOf, Record, Tagged
from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.core.terminal import Terminal


TEMPERATURES = ("F", "C", "K", "R", "°F", "°C", "degF", "degC")
# Words that may stand between a quantity and its target unit, among the first few words.
CONNECTIVES = ("to", "into", "->", "→")
MOST_WORDS = 7


class Gathered:
    """Raw input, and the reader that knows where it came from."""

    __slots__ = ("raw", "reader")

    def __init__(self, raw: "dict[str, Any]", reader: Reader) -> None:
        self.raw = raw
        self.reader = reader


def gather(task: Task, call: Call, settings: Settings, terminal: "Terminal", *, rows: bool = False) -> Gathered:
    """All parameters given by a call; with `rows`, words bind only to parameters that the rows do not give."""
    fields = task.specification.fields
    raw, scene = read_words(fields, call.words, rows=rows or bool(settings.input))
    for name, value in call.options.items():
        put(raw, task.options[name].path, value)
    file = settings.input or scene
    if scene and settings.input:
        raise UsageError("give a scene or --input, not both", parameter="input", code="exclusive")
    gathered = over_file(task, raw, file, terminal) if file else Gathered(raw, Reader(terminal.environ))
    gathered.reader.spell = _spelling(task, call, gathered.raw, file=bool(file) or rows)
    return gathered


def _spelling(task: Task, call: Call, raw: "dict[str, Any]", *, file: bool) -> "Callable[[str], str]":
    """How this call writes a parameter; only messages ask."""

    def spell(address: str) -> str:
        from dynamics_cli.core.inputs.spelling import Spelling

        return Spelling(task.options, call.options, raw, file=file)(address)

    return spell


def over_file(task: Task, raw: "dict[str, Any]", file: str, terminal: "Terminal") -> Gathered:
    """Raw input over the parameters of a file."""
    import os

    from dynamics_cli.core.inputs.sources.files import parameters_of, read_object
    from dynamics_cli.core.inputs.sources.hashes import entry_of

    try:
        loaded, data = read_object(file, terminal)
    except UsageError as error:
        if error.code == "unreadable" and not os.path.splitext(file)[1]:
            # a word such as the name of a shape
            error.hint = f"a file belongs here: dynamics {task.path} --template > {file}.toml writes one"
        raise
    parameters = {key for field in task.specification.fields for key in keys_of(field)}
    units = loaded.pop("units", {}) if "units" not in parameters else {}
    if not isinstance(units, dict):
        raise UsageError("[units] names default units, one for each kind", parameter="units")
    folder = "" if file == "-" else os.path.dirname(file)
    reader = Reader(terminal.environ, folder=folder, units=units)
    points = loaded.get("points") if "points" not in parameters else None
    if isinstance(points, dict):
        from dynamics_cli.core.inputs.sources.named_points import any_named

        if any_named(points, [value for key, value in (*loaded.items(), *raw.items()) if key != "points"]):
            reader.points = loaded.pop("points")
    if file != "-":
        reader.files.append(entry_of(file, data))
    below = parameters_of({k: v for k, v in loaded.items() if k not in task.unused}, parameters, task.path)
    results = "covariance" not in parameters and loaded.get("command") != task.path
    covariance = loaded.get("covariance") if results else None
    if covariance is not None:
        reader.origins.update((name, (file, name, covariance)) for name in below if name not in raw)
    return Gathered(merge(task, below, raw), reader)


def merge(task: Task, below: "dict[str, Any]", above: "dict[str, Any]") -> "dict[str, Any]":
    """The file's parameters overridden by options; those that an option excludes are left out."""
    merged = dict(below)
    for field in task.specification.fields:
        for key in _excluded(field, below, above):
            merged.pop(key, None)
    return _deep(merged, above)


def _excluded(field: Field, below: "dict[str, Any]", above: "dict[str, Any]") -> "set[str]":
    """Keys of the file that conflict with the command line's value of the same parameter."""
    keys = keys_of(field)
    given_keys = keys.intersection(above)
    if not given_keys:
        return set()
    if isinstance(field.node, Many) and field.node.single:
        # A list replaces a lone item's fields, and a lone item's fields replace a list.
        return keys - {field.key} if field.key in given_keys else {field.key}
    if isinstance(field.node, OneOf):
        together = given_keys.union(keys.intersection(below))
        fits = any(member.names >= together for member in field.node.members)
        return set() if fits else keys
    return set()


def _deep(below: "dict[str, Any]", above: "dict[str, Any]") -> "dict[str, Any]":
    merged = dict(below)
    for key, value in above.items():
        old = merged.get(key)
        merged[key] = _deep(old, value) if isinstance(old, dict) and isinstance(value, dict) else value
    return merged


def keys_of(field: Field) -> "set[str]":
    """The keys under which a task's parameter may be given."""
    if isinstance(field.node, Record) and field.place:
        return set(field.node.names)
    return set(field.spread())


def put(raw: "dict[str, Any]", path: "tuple[str, ...]", value: "Any") -> None:
    """Put a value at its path of keys."""
    for key in path[:-1]:
        raw = raw.setdefault(key, {})
    raw[path[-1]] = value


def read_words(fields: "tuple[Field, ...]", words: "list[str]", *, rows: bool) -> "tuple[dict[str, Any], str]":
    """Words assigned to the positional parameters in order; a number's unit may be a separate word."""
    raw: dict[str, Any] = {}
    rest = list(words)
    scene = ""
    # 5 ft 6 in, where no other number can follow
    alone = [field.place for field in fields if field.place][1:] == ["words"]
    for field in fields:
        if not field.place or not rest:
            continue
        node = field.node
        if field.place == "words":
            raw[field.key] = rest
            rest = []
        elif isinstance(node, Record):
            scene = rest.pop(0)
        elif isinstance(node, Tagged):
            raw[node.key] = rest.pop(0)
        elif isinstance(node, Leaf) and node.kind.form == "exact" and (split := _at_connective(rest)) != rest:
            raw[field.key] = split[0]
            rest = split[1:]
        elif rows and isinstance(node, Leaf) and node.kind.form == "exact" and not _has_number(rest[0]):
            continue
        else:
            raw[field.key] = _with_unit(rest) if _takes_unit(node) else rest.pop(0)
            while rest and alone and _takes_unit(node) and _has_number(rest[0]):
                raw[field.key] += " " + _with_unit(rest)
    if rest:
        raise UsageError(f"unexpected word {rest[0]!r}", code="unexpected", hint="quote a value that has spaces")
    return raw, scene


def _at_connective(words: "list[str]") -> "list[str]":
    """The words of `60 mph to m/s`, in any quoting, as the quantity and the units."""
    for place, word in enumerate(words[:MOST_WORDS]):
        if place and word in CONNECTIVES:
            return [" ".join(words[:place]), *words[place + 1 :]]
    for connective in CONNECTIVES:
        quantity, separator, unit = words[0].partition(f" {connective} ")
        if separator:
            return [quantity, unit, *words[1:]]
    parts = words[0].split()
    # nobody converts farad times coulomb
    if len(words) == 1 and len(parts) > 1 and all(part in TEMPERATURES for part in parts[-2:]):
        return [" ".join(parts[:-1]), parts[-1]]
    return words


def _with_unit(rest: "list[str]") -> str:
    """The next word and, after a bare number, those of a fraction and of its unit: 5 1/2 in."""
    word = rest.pop(0)
    if rest and _is_bare(word) and _is_bare(rest[0]) and "/" in rest[0]:
        word += " " + rest.pop(0)
    if not rest or not _is_bare(word) or _has_number(rest[0]):
        return word
    count = _unit_words(rest)
    unit = " ".join(rest[:count])
    del rest[:count]
    return f"{word} {unit}"


def _unit_words(rest: "list[str]") -> int:
    """How many words spell the unit that comes first: long ton, bar gauge, miles per gallon; else one."""
    from dynamics_cli.core.units.table import NAMES

    count = 2 if rest[0] in ("square", "sq", "cubic", "cu") and len(rest) > 1 else 1
    for number in (3, 2):
        words = rest[:number]
        unknown = len(words) == number and any(f" {word}|" not in NAMES for word in words)
        if unknown and f" {'_'.join(words)}|" in NAMES:
            count = number
            break
    while rest[count : count + 1] == ["per"] and len(rest) > count + 1:
        count += 2
    return count


def _takes_unit(node: object) -> bool:
    """Whether the word after a bare number can only be its unit."""
    return isinstance(node, Leaf) and (node.kind.form == "exact" or bool(node.kind.unit))


def _has_number(word: str) -> bool:
    """Whether a word begins with a number that is not the 1 of a unit such as 1/in."""
    return word.lstrip("+-−.")[:1].isdigit() and not word.startswith("1/")


def _is_bare(word: str) -> bool:
    """Whether a word is a number and nothing more."""
    return bool(word) and not word.strip("+-−./ 0123456789eE,^×*½¼¾")
