"""The words and digits of short answers: labels, names of bodies, numbers rounded to their deviation."""

from math import ceil, floor, log10

from dynamics_cli.core.documents import decimals, flatten, given_inputs, is_quantity, number, quantity, singular

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable
    from typing import Any

    from dynamics_cli.core.answering.task import Task
    from dynamics_cli.quantities import Kind

# Digits of a result that stands in the label of another.
LABEL_DIGITS = 6
# Number of results shown where a task declares no headline.
MOST_UNDECLARED = 8
MOST_DIGITS = 15
# Ends of an interval that are off by an error are shown to the place of five times the error, at most one place fewer.
END_PLACES, ONE_PLACE = 50.0, 10.0
# An estimate of the calculation's own error is no better known.
ESTIMATE_DIGITS = 2
# Where it is smaller only its power of ten counts, and this is the smallest.
SMALL_ESTIMATE = 1e-6
LEAST_ESTIMATE = 1e-12


AXES = "xyz"
# Characters of input addresses; one of the marks distinguishes them from other words.
ADDRESS = frozenset("abcdefghijklmnopqrstuvwxyz0123456789_.[]")
ADDRESS_MARKS = frozenset("_.[")
# A number of so many digits was calculated, not typed.
CALCULATED = 16
# Units that tell which system a person thinks in.
METRIC = frozenset(("m", "km", "mm", "cm", "kg", "g", "N", "kN", "J", "kJ", "W", "kW", "Pa", "kPa", "MPa"))
US = frozenset(("ft", "in", "yd", "mi", "mph", "lb", "lbf", "lbs", "slug", "psi", "ftlb", "inlb", "oz", "hp"))
BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, "
# Components smaller than this share of a vector's largest are rounding.
ROUNDING = 1e-12


def headline_labels(task: "Task", flat: "dict[str, tuple[Any, str]]", tables: "list[str]") -> "dict[str, str]":
    """The addresses of the headline with their labels: as the task declares them, else the first results.

    The label "-" means none: the value stands alone. A name without an index covers all its items.
    """
    declared = dict(task.headline)
    # a table without rows is a result like others, without columns
    declared.update((name, declared[name].partition(" | ")[0]) for name in flat if name in declared)
    for name in flat:
        base = name.partition("[")[0]
        if base != name and base in declared:
            declared[name] = declared[base] if declared[base] == "-" else ""
    if not any(address in flat or address in tables for address in declared):
        numbers = [name for name, (value, _) in flat.items() if not isinstance(value, str)]
        declared = dict.fromkeys([*numbers[:MOST_UNDECLARED], *(() if numbers else tables[:1])], "")
    return {
        address: "" if label == "-" else _filled(label, flat) or in_words(address)
        for address, label in declared.items()
        if address in flat or address in tables
    }


def _filled(label: str, flat: "dict[str, tuple[Any, str]]") -> str:
    """A label with the result that it names in braces: distance at {time}; none where that result is missing."""
    before, brace, rest = label.partition("{")
    name, _, after = rest.partition("}")
    if not brace:
        return label
    value, unit = flat.get(name, ("", ""))
    return f"{before}{quantity(value, unit, LABEL_DIGITS)}{after}" if value != "" else ""


def label_in_words(task: "Task", name: str) -> str:
    """The label of a headline result for many answers at once: without what stands in it for one of them."""
    label = dict(task.headline).get(name, "")
    return label if label and "{" not in label else in_words(name)


def in_words(address: str) -> str:
    """`first.exit_speed` as words; a result beside an input of its name, `results.speed`, as speed (result)."""
    beside = address.startswith("results.")
    return address.removeprefix("results.").replace("_", " ").replace(".", " ") + (" (result)" if beside else "")


def bears_on_results(name: str, document: "dict[str, Any]") -> bool:
    """Whether an input may change any result, as far as the document's condition numbers tell."""
    conditions = document["numerics"].get("condition", {}).values()
    return not conditions or any(entry.get(name, 1.0) for entry in conditions)


def suits_us_units(document: "dict[str, Any]") -> bool:
    """Whether the inputs were typed in US units alone, and results are shown in metric ones that no input names."""
    given = [entry for entry in given_inputs(document["inputs"]) if entry[0] != "gravity"]
    typed = {part for _, _, unit in given for part in _symbols(unit)}
    named = {part for _, value, _ in given if isinstance(value, str) for part in _symbols(value)}
    shown = {part for _, _, unit in flatten(document["results"]) for part in _symbols(unit)}
    return bool(typed & US) and not typed & METRIC and bool(shown & METRIC - named) and not shown & US


def _symbols(unit: str) -> "list[str]":
    """The symbols of a unit without signs and exponents: `lbf*ft/s^2` has lbf, ft and s."""
    return "".join(character if character.isalpha() else " " for character in unit).split()


def input_in_words(address: str, inputs: "dict[str, Any]", names: "dict[str, str]") -> str:
    """An input as people name it: a body by its name, `segments[0].friction` as segment 1, `velocity[0]` along x."""
    words = with_name(in_words(address), names)
    node = node_at(inputs, address.rpartition("[")[0]) if address.endswith("]") else None
    parts = node.get("value") if isinstance(node, dict) else None
    if isinstance(parts, list) and len(parts) <= len(AXES):
        name = words[: words.rindex("[")]
        return name if len(parts) == 1 else f"{name} along {AXES[int(address[:-1].rpartition('[')[2])]}"
    return " ".join(_counted(word) for word in words.split(" "))


def _counted(word: str) -> str:
    """`segments[0]` as segment 1; regular expressions would cost a plain call too much."""
    if not word.endswith("]"):
        return word
    name, _, index = word[:-1].partition("[")
    return f"{singular(name)} {int(index) + 1}" if index.isdigit() else word


def message_in_words(message: str, inputs: "dict[str, Any]", names: "dict[str, str]") -> str:
    """A message whose first word is an address, with that input as people name it."""
    address, colon, rest = message.partition(": ")
    if colon and set(address) <= ADDRESS and not ADDRESS_MARKS.isdisjoint(address):
        return f"{input_in_words(address, inputs, names)}: {rest}"
    return message


def listed(entries: "Iterable[tuple[str, Any, str]]") -> "list[tuple[str, Any, str]]":
    """Inputs by address with the numbers of one list, `stations[0]`, `stations[1]` …, as one entry of several values.

    Vectors in a list stay apart, counted from one.
    """
    merged: list[tuple[str, Any, str]] = []
    for name, value, unit in entries:
        base, opened, rest = name.rpartition("[")
        place = rest.removesuffix("]")
        if not (opened and rest.endswith("]") and place.isdigit()):
            merged.append((name, value, unit))
        elif isinstance(value, list) or "@" in str(value):
            merged.append((f"{singular(base)} {int(place) + 1}:", value, unit))
        elif merged and merged[-1][0] == base and merged[-1][2] == unit and isinstance(merged[-1][1], list):
            merged[-1][1].append(value)
        else:
            merged.append((base, [value], unit))
    return merged


def value_in_words(value: "Any", unit: str) -> str:
    """An input with its unit in full; a list of one as its value."""
    if isinstance(value, list) and all(isinstance(item, list) and len(item) == 1 for item in value):
        value = [item[0] for item in value]
    if isinstance(value, list) and len(value) == 1:
        value = value[0]
    return quantity(_as_typed(value), unit, 17)


def _as_typed(value: "Any") -> "Any":
    """Numbers without the digits that nobody types: those that a conversion to components left."""
    if isinstance(value, list):
        return [_as_typed(item) for item in value]
    if isinstance(value, float) and len(repr(value).partition("e")[0].strip("-0.").replace(".", "")) >= CALCULATED:
        return float(f"{value:.6g}")
    return value


def letters(task: "Task") -> "dict[str, Kind]":
    """The parameters and results that standards designate by a letter, by name."""
    fields = (*task.specification.fields, *task.specification.result.fields)
    kinds = {field.key: getattr(field.node, "kind", None) for field in fields}
    return {key: kind for key, kind in kinds.items() if kind is not None and kind.letter}


def designated(text: str, kind: "Kind | None") -> str:
    """6.3 mm/s as standards designate a number of its kind, G 6.3; one in another unit, or without letter, as it is."""
    bare = text.removesuffix(f" {kind.si}") if kind else text
    return f"{kind.letter} {bare}" if kind and bare != text else text


def node_at(results: "Any", address: str) -> "Any":
    """The node of a result under an address without indices, or None."""
    node = results
    for key in address.split("."):
        if not isinstance(node, dict) or is_quantity(node):
            return None
        node = node.get(key)
    return node


def deviation(results: "Any", address: str) -> float:
    """Spread of an uncertain number: its deviation, or a quarter of its interval; 0 for a certain one."""
    node = node_at(results, address)
    if not isinstance(node, dict) or "std" not in node or isinstance(node["std"], list):
        return 0.0
    if node["std"]:
        return float(node["std"])
    low, high = node.get("interval") or (0.0, 0.0)
    return 0.25 * (high - low) if not isinstance(low, list) else 0.0


def is_uncertain_vector(node: "Any") -> bool:
    """Whether a result is a vector with an interval for each of its components."""
    return isinstance(node, dict) and isinstance(node.get("interval"), list) and isinstance(node["value"], list)


def vector_in_words(components: "list[float]", node: "dict[str, Any]", digits: int, *, asked: bool) -> str:
    """Components, each to the place that its deviation deserves unless digits are asked for."""
    stds = [0.25 * (high - low) for low, high in zip(*node["interval"], strict=True)]
    rounded = without_rounding(components)
    texts = [
        number(value, digits) if asked or not std else decimals(value, std)
        for value, std in zip(rounded, stds, strict=True)
    ]
    return f"[{', '.join(texts)}]"


def uncertain_in_words(value: "Any", node: "dict[str, Any]", std: float, digits: int, *, asked: bool) -> str:
    """A value of an uncertain result, or an end of its interval, to the place that its deviation deserves."""
    if is_in_parts(node):
        return parts_in_words(value, node, digits, asked=asked)
    if is_uncertain_vector(node):
        return vector_in_words(value, node, digits, asked=asked)
    return decimals(value, std) if std else number(value, digits)


def interval_in_words(document: "dict[str, Any]", address: str, std: float, digits: int, *, asked: bool) -> str:
    """The interval of an uncertain result: its ends to fewer places where they are known to a part of a deviation."""
    entry = document["numerics"].get("uncertainty", {}).get("results", {}).get(address, {})
    error = entry.get("estimate", 0.0)
    std *= ONE_PLACE if error is None else min(max(1.0, END_PLACES * error), ONE_PLACE)
    node = node_at(document["results"], address)
    low, high = (uncertain_in_words(end, node, std, digits, asked=asked) for end in node["interval"])
    return f"{100.0 * node['coverage']:.6g} %: {low} to {high}"


def is_in_parts(node: "dict[str, Any]") -> bool:
    """Whether a result is shown in the parts of compound units, as 5 ft 6 in."""
    return ";" in str(node.get("unit"))


def parts_in_words(parts: "list[float]", node: "dict[str, Any]", digits: int, *, asked: bool = False) -> str:
    """A number in parts, to the place that its deviation deserves unless its digits are asked for."""
    from dynamics_cli.core.units.compound import in_last_unit, rounded_parts

    unit, std = node["unit"], node["std"]
    spread = in_last_unit(std, unit) if std else 0.0
    if asked or not spread:
        return quantity(parts, unit, digits)
    place = 1 - floor(log10(float(f"{spread:.1e}")))
    return quantity(rounded_parts(parts, unit, place), unit, MOST_DIGITS)


def body_names(inputs: "dict[str, Any]") -> "dict[str, str]":
    """The user's names of bodies, by the words that labels begin with (also `surfaces[0]`)."""
    nodes = dict(inputs)
    for word, node in inputs.items():
        if isinstance(node, list):
            nodes.update((f"{word}[{index}]", item) for index, item in enumerate(node))
    names = {word: node.get("name") for word, node in nodes.items() if isinstance(node, dict)}
    return {word: name for word, name in names.items() if isinstance(name, str)}


def with_name(label: str, names: "dict[str, str]") -> str:
    """A label whose leading words are replaced by the body's name."""
    word, _, rest = label.partition(" ")
    return f"{names[word]} {rest}" if word in names else label


def without_rounding(value: "Any", bound: "dict[str, Any] | None" = None) -> "Any":
    """A vector or tensor with negligible components set to zero, and a number below its own error bound."""
    if isinstance(value, float):
        return 0.0 if bound and abs(value) <= bound.get("absolute", 0.0) else value
    largest = max((abs(item) for item in _numbers(value)), default=0.0)

    def cleared(node: "Any") -> "Any":
        if isinstance(node, list):
            return [cleared(item) for item in node]
        return 0.0 if isinstance(node, float) and abs(node) < ROUNDING * largest else node

    return cleared(value) if isinstance(value, list) else value


def _numbers(node: "Any") -> "list[float]":
    if isinstance(node, list):
        return [value for item in node for value in _numbers(item)]
    return [node] if isinstance(node, float) else []


def estimated(value: float, unit: str) -> str:
    """An estimate of the calculation's own error: two digits, of a small one the next power of ten."""
    if not 0.0 < value < SMALL_ESTIMATE:
        return quantity(value, unit, ESTIMATE_DIGITS)
    return f"< {quantity(10.0 ** ceil(log10(max(value, LEAST_ESTIMATE))), unit, 1)}"


def percent(probability: float) -> str:
    """A probability in per cent, never 0 or 100 unless it is."""
    percent = 100.0 * probability
    if 0.0 < percent < 0.01:
        return "< 0.01 %"
    if 99.99 < percent < 100.0:
        return "> 99.99 %"
    return f"{percent:.2g} %" if percent < 99.0 else f"{percent:.4g} %"


def short_source(source: str) -> str:
    """A source with the book that most tasks follow by its authors alone.

    >>> short_source("Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 10.10")
    'Josephs & Huston §10.10'
    """
    return source.replace(BOOK, "Josephs & Huston ").replace("section ", "§").replace("sections ", "§")


def limit_words(entry: "dict[str, Any]") -> str:
    """The text of a limit beside its result."""
    limit = quantity(entry["limit"]["value"], entry["limit"].get("unit", ""), 6)
    if "probability" in entry:
        return f"{limit} exceeded: {percent(entry['probability'])}"
    by = quantity(entry["by"]["value"], entry["by"].get("unit", ""), 6)
    if entry["beyond"]:
        return f"exceeds the limit of {limit} by {by}"
    return f"at the limit of {limit}" if not entry["by"]["value"] else f"within the limit of {limit} by {by}"


def asked_of(document: "dict[str, Any]", address: str) -> "list[str]":
    """What stands beside a result of its probabilities: of a yes or no, of limits, of quantiles."""
    chances = [entry["probability"] for name, entry in document.get("chances", {}).items() if name == address]
    said = node_at(document["results"], address)
    limits = [entry for entry in document.get("limits", ()) if entry["result"] == address]
    quantiles = [entry for entry in document.get("quantiles", ()) if entry["result"] == address]
    return [
        *(f"with a probability of {percent(p if said else 1.0 - p)}" for p in chances),
        *map(limit_words, limits),
        *(f"{100.0 * entry['probability']:.6g} % below {number(entry['value'], 6)}" for entry in quantiles),
    ]
