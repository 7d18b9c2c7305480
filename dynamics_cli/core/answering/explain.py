"""`--explain`: the formula with symbols and with numbers, the source, the assumptions, the model and why."""

from dynamics_cli.core.answering.task import load
from dynamics_cli.core.documents import flatten, is_table, quantity

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.core.answering.models import Answer
    from dynamics_cli.core.answering.task import Model, Task
    from dynamics_cli.quantities import Kind

# A sensitivity this small relative to a result's largest, or beside one, is rounding: the input has no effect.
ROUNDING = 1e-12


def explanation(task: "Task", document: "dict[str, Any]", answered: "Answer") -> "dict[str, Any]":
    """How the answer was obtained, in terms of its formula."""
    model = answered.model
    out: dict[str, Any] = {}
    numbers = {**_defaults(task), **_numbers(document)}
    formula = _fitting(_formulas(model, document), numbers)
    if formula:
        out["formula"] = filled(formula, {})
        if _addresses(formula) and _addresses(formula) <= numbers.keys():
            out["with_numbers"] = filled(formula, numbers)
        out["symbols"] = _symbols(formula)
    out["model"] = model.name
    if answered.why:
        out["why"] = answered.why
    out["assumptions"] = list(model.assumptions)
    out["source"] = model.source
    conditions = document["numerics"].get("condition", {})
    out["sensitivity"] = {
        result: kept
        for result, entry in conditions.items()
        if (kept := {name: value for name, value in entry.items() if abs(value) > _rounding(entry)})
    }
    return {key: value for key, value in out.items() if value}


def _rounding(entry: "dict[str, float]") -> float:
    """The size of a sensitivity that is only rounding, beside the largest of the same result."""
    return ROUNDING * max(1.0, *map(abs, entry.values()))


def filled(formula: str, numbers: "dict[str, str]") -> str:
    """The formula with each `{address|symbol}` replaced by its number where there is one, else by its symbol."""
    out = []
    rest = formula
    while "{" in rest:
        before, _, rest = rest.partition("{")
        inside, _, rest = rest.partition("}")
        address, _, symbol = inside.partition("|")
        number = numbers.get(address, symbol)
        if before.endswith("(") and rest.startswith(")") and number.startswith("("):
            number = number[1:-1]  # cos(20 deg) has its brackets
        out += [before, number]
    return "".join(out) + rest


def _addresses(formula: str) -> "set[str]":
    return {piece.partition("}")[0].partition("|")[0] for piece in formula.split("{")[1:]}


def _formulas(model: "Model", document: "dict[str, Any]") -> "tuple[str, ...]":
    """The model's formulas, or that of this very case."""
    own = load(model.formula_of)(document["inputs"]) if model.formula_of else ""
    return (own,) if own else model.formulas


def _fitting(formulas: "tuple[str, ...]", numbers: "dict[str, str]") -> str:
    """The first of a model's formulas with all its numbers available; else the first with most of them."""
    return max(formulas, key=lambda formula: -len(_addresses(formula) - numbers.keys()), default="")


def _symbols(formula: str) -> "list[str]":
    symbols: dict[str, str] = {}
    for piece in formula.split("{")[1:]:
        address, _, symbol = piece.partition("}")[0].partition("|")
        words = address.removeprefix("inputs.").removeprefix("results.").replace("_", " ")
        table, point, column = words.partition(".")
        plural = point and table.endswith("s")
        words = f"{column} of each {table[:-1]}" if plural else words.replace(".", " ")
        symbols.setdefault(f"{symbol} is {words}", symbol)
    return list(symbols)


def _grouped(text: str) -> str:
    return f"({text})" if " " in text else text


def _defaults(task: "Task") -> "dict[str, str]":
    """The numbers of parameters that were not given."""
    defaults: dict[str, str] = {}
    for name, option in task.options.items():
        if isinstance(option.default, float) and option.leaf is not None:
            kind = option.leaf.kind
            text = default_text(option.default, kind) if kind.unit else f"{option.default:g}"
            defaults[name.replace("-", "_")] = _grouped(text)
    return defaults


def _numbers(document: "dict[str, Any]") -> "dict[str, str]":
    """Every input and result by its address; a table's column as its values, a lone value plainly."""
    numbers: dict[str, str] = {}
    for side in ("results", "inputs"):
        digits = 17 if side == "inputs" else 6
        for name, value, unit in flatten(document[side]):
            numbers[name] = numbers[f"{side}.{name}"] = _grouped(quantity(value, unit, digits))
        for name, table in document[side].items():
            if is_table(table) and isinstance(table, list):
                for key in table[0]:
                    cells = [row[key] for row in table if isinstance(row.get(key), dict) and "value" in row[key]]
                    texts = [quantity(cell["value"], cell.get("unit", ""), digits) for cell in cells]
                    joined = _grouped(texts[0]) if len(texts) == 1 else "(" + "; ".join(texts) + ")"
                    if texts:
                        numbers[f"{name}.{key}"] = joined
                        numbers.setdefault(key, joined)
                        numbers.setdefault(f"{side}.{key}", joined)
    return numbers


def default_text(value: float, kind: "Kind") -> str:
    """A default from the signature, which is in SI, as a user would write it.

    >>> from dynamics_cli.quantities import Angle
    >>> default_text(0.3490658503988659, Angle)
    '20 deg'
    """
    if kind.si == kind.unit or not value:
        return f"{value:g} {kind.si}".strip()
    from dynamics_cli.core.answering.messages import factor
    from dynamics_cli.core.units.lookup import parse_unit

    inside = parse_unit(kind.unit)
    return f"{value * factor(inside) / factor(parse_unit(kind.si, inside)):g} {kind.si}"


def formulas_with_numbers(
    task: "Task", document: "dict[str, Any]", numbers: "dict[str, str]", piece: "Callable[[str, str], str]"
) -> "list[list[str]]":
    """Each clause of a document's formula as its steps: symbols, input numbers, result.

    `piece` joins a number and its unit.
    """
    model = next((model for model in task.models if model.name == document["model"]["name"]), None)
    if model is None:
        return []
    defaults = {name: text.strip("()").partition(" ") for name, text in _defaults(task).items()}
    numbers = {**{name: piece(number, unit) for name, (number, _, unit) in defaults.items()}, **numbers}
    lines = []
    for clause in _clauses(_fitting(_formulas(model, document), numbers)):
        left_side, sign, right_side = clause.partition(" = ")
        result = left_side[1:].partition("|")[0] if left_side.startswith("{") and left_side.endswith("}") else ""
        steps = [f"{filled(left_side, {})} = {filled(right_side, {})}" if sign else filled(clause, {})]
        if sign and result in numbers:
            needed = _addresses(right_side)
            if needed and needed <= numbers.keys():
                # single numbers are a table of one row: no sum to form
                steps.append(filled(right_side.replace("Σ {", "{"), numbers))
            steps.append(numbers[result])
        lines.append(list(dict.fromkeys(steps)))
    return lines


def _clauses(formula: str) -> "list[str]":
    """The parts of a formula, split at commas and semicolons outside brackets."""
    clauses, depth, start = [], 0, 0
    for place, letter in enumerate(formula):
        depth += (letter in "([{") - (letter in ")]}")
        if not depth and letter in ",;" and formula[place + 1 : place + 2] == " ":
            clauses.append(formula[start:place].strip())
            start = place + 1
    return [*clauses, formula[start:].strip()] if formula else []
