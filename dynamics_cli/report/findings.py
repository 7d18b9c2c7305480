"""The findings of a calculation in sentences: as its task words them, else by the labels of its first results."""

import re

from dynamics_cli.core.output.answer_words import body_names
from dynamics_cli.core.units.unit import conformable
from dynamics_cli.errors import DynamicsError
from dynamics_cli.report.calculation import Calculation, leaves, limit_words, node_at

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.core.units.unit import Unit
    from dynamics_cli.report.blocks import Text

# So many results of one calculation are findings, beside those with limits.
MOST_FOUND = 4
SIDES = ("first", "second", "leader", "follower")
# What a clause holds in braces: a result by address, a body, or the words for yes and for no.
_BRACES = re.compile(r"\{([^}]*)\}")
# Labels that are no nouns by themselves: "of friction", "contact after".
_STARTS = (
    "above", "across", "add", "after", "along", "as", "at", "by", "from", "if", "in", "it", "its", "of", "off", "on",
    "once", "or", "outside", "over", "the", "this", "to", "together", "under", "with", "within", "without",
)  # fmt: skip
_ENDS = ("above", "after", "at", "before", "below", "by", "for", "from", "in", "on", "than", "through", "to", "with")
_MOMENT, AT_IMPACT = re.compile(r" (before|after)( \S+)?$"), r" \1 the impact"
# A result is an input again where they differ by no more than this part.
SAME = 1e-12


def finding(case: Calculation) -> "Text":
    """The findings of a calculation as sentences, with bold numbers."""
    if case.document is None:
        return f"{case.name}: {case.again.words}."
    pieces: list[str] = []
    for address in found(case):
        clause = _clause(case, address)
        if clause:
            clause[-1] += "".join(f", {limit_words(entry)}" for entry in case.limits(address))
            start = "; " if pieces else f"{case.name}: "
            pieces = [*pieces[:-1], pieces[-1] + start + clause[0]] if pieces else [start + clause[0]]
            pieces += clause[1:]
    if not pieces:
        # a sweep against a limit
        messages = "; ".join(entry["message"] for entry in case.document.get("limits", ()))
        return f"{case.name}: {messages or f'see section {case.section}'}."
    pieces[-1] += "."
    return tuple(pieces)


def found(case: Calculation) -> "list[str]":
    """The results that are findings.

    Those with limits; then those that the task words, or the first of the headline with others of its unit.
    """
    labels = case.labels()
    worded = [address for address, _ in case.task.findings] if case.task is not None else []
    limited = [address for address in labels if case.limits(address)]
    findings = [*limited, *(address for address in worded if address not in limited)]
    if not worded:
        first = "none" if limited else ""
        for address in labels:
            node = node_at(case.results, address)
            if isinstance(node, str) and node and not findings:
                findings.append(address)  # slides down
            if not isinstance(node, dict) or isinstance(node.get("value"), list | str | None) or address in limited:
                continue
            unit = node.get("unit", "-")
            if not _typed(case, node, address):
                first = first or unit
                if unit == first and len(findings) < MOST_FOUND:
                    findings.append(address)
    # an answer in words alone: stable for 0 < K < 6
    return findings or [address for address in labels if isinstance(node_at(case.results, address), str)][:1]


def subject(case: Calculation, address: str) -> str:
    """A result as the subject of a sentence: "the Ford's speed before the impact"."""
    label = case.labels().get(address) or "result"
    side, dot, _ = address.partition(".")
    owner = f"{case.named(side)} "
    if _by_itself(label):
        return f"“{label}”"
    if not dot or side not in SIDES or not label.startswith(owner):
        return f"the {label}"
    return f"{_body(case, side)}'s {_MOMENT.sub(AT_IMPACT, label.removeprefix(owner))}"


def _clause(case: Calculation, address: str) -> "list[str]":
    """A clause in which text and numbers alternate, text first and last; none without its result."""
    node = node_at(case.results, address)
    if node is None:
        return []
    side = case.source.document["inputs"].get(address.partition(".")[0])
    if isinstance(side, dict) and side.get("fixed"):
        return []
    pieces = [""]
    for nth, part in enumerate(_BRACES.split(_template(case, address, node))):
        if nth % 2 == 0:
            pieces[-1] += part
        elif "|" in part:
            yes, no = part.split("|")
            pieces[-1] += yes if node else no
        elif part in SIDES:
            pieces[-1] += _body(case, part)
        else:
            pieces += _shown(case, part or address)
    chance = case.chance(address)
    pieces[-1] += f" {chance}" if chance else ""
    return pieces


def _template(case: Calculation, address: str, node: "Any") -> str:
    """The clause of a result as the task words it, where all its numbers are there; else from its label."""
    verb = "was" if case.past else "is"
    worded = dict(case.task.findings).get(address, "") if case.task is not None else ""
    named = [part for part in _BRACES.findall(worded) if part and "|" not in part and part not in SIDES]
    if worded and all(node_at(case.results, name) is not None for name in named):
        return worded if "{}" in worded or "|" in worded else f"{worded} {verb} {{}}"
    label = case.labels().get(address) or "result"
    counts = isinstance(node, dict) and isinstance(node.get("value"), int) and not node.get("unit")
    if isinstance(node, str):
        sentence = f"{label} " if label.endswith(_ENDS) else f"{label}: "
    else:
        sentence = f"{label}: " if counts or _by_itself(label) else f"{subject(case, address)} {verb} "
    # a name may have braces of its own
    return sentence.replace("{", "(").replace("}", ")") + "{}"


def _by_itself(label: str) -> bool:
    """Whether a label is no noun."""
    words = label.split()
    return words[0] in _STARTS or words[-1] in _ENDS


def _body(case: Calculation, side: str) -> str:
    """A body as its name in a sentence, "the Ford", "car 2"; without a name "the first body"."""
    inputs = case.source.document["inputs"]
    name = body_names(inputs).get(side)
    if name is None:
        noun = "" if side in ("leader", "follower") else " body" if "mass" in inputs.get(side, {}) else " party"
        return f"the {side}{noun}"
    last = name.split()[-1] if name.split() else name
    return name if len(last) == 1 or not last.isalpha() else f"the {name}"


def _shown(case: Calculation, address: str) -> "tuple[str, str]":
    """A result as typed where an input gives it, else as the report shows it; and its interval in brackets."""
    typed = _typed(case, node_at(case.results, address))
    # a task without findings may have been asked for another unit
    if typed and case.task is not None and case.task.findings:
        return typed, ""
    value = case.value(address, brief=True)
    return value.whole, f" ({value.coverage}: {value.interval})" if value.interval else ""


def _typed(case: Calculation, node: "Any", name: str = "") -> str:
    """The text of an input, any or the one named, that gives a certain result in whatever unit; none if calculated."""
    result = _si(node) if isinstance(node, dict) and "interval" not in node else None
    for address, given in leaves(case.document["inputs"] if case.document else {}):
        if isinstance(given, dict) and "distribution" not in given and name in ("", address):
            entered = _si(given)
            same = result and entered and entered[0] and conformable(result[1], entered[1])
            if result and entered and same and abs(result[0] - entered[0]) <= SAME * abs(entered[0]):
                return case.input_text(address, given)
    return ""


def _si(node: "dict[str, Any]") -> "tuple[float, Unit] | None":
    """A lone quantity in SI, and its unit; None where it is several numbers, or the unit none of the program's."""
    from dynamics_cli.core.units.conversion import to_si
    from dynamics_cli.core.units.lookup import parse_unit

    if not isinstance(node.get("value"), int | float):
        return None
    try:
        unit = parse_unit(node.get("unit", ""))
        return to_si(*float(node["value"]).as_integer_ratio(), unit), unit
    except DynamicsError:
        return None
