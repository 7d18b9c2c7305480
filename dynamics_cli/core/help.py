"""Help, from the signature and the docstrings that stand beside it."""

from dynamics_cli.core.specification import REQUIRED, Leaf, Option, Record, Tagged
from dynamics_cli.core.task import Task

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping

    from dynamics_cli.quantities import Kind


def placeholder(option: Option) -> str:
    """What stands for an option's value in help."""
    if option.leaf is None:
        return "NAME=VALUE,…"
    if option.leaf.choice is not None:
        return "NAME"
    return option.leaf.kind.name.upper().replace(" ", "-")


def described(docstring: "str | None") -> "dict[str, str]":
    """The parameters a docstring describes: name and text, from its numpydoc Parameters section."""
    found: dict[str, str] = {}
    lines = (docstring or "").expandtabs().splitlines()
    heads = [i for i, line in enumerate(lines) if line.strip() in ("Parameters", "Attributes")]
    for head in heads:
        indent = len(lines[head]) - len(lines[head].lstrip())
        name = ""
        for line in lines[head + 2 :]:
            text = line.strip()
            depth = len(line) - len(line.lstrip())
            if text.startswith("---"):
                break
            if text and depth <= indent and " : " not in text:
                break
            if text and depth <= indent:
                name = text.partition(" : ")[0].strip("*` ")
                found[name] = ""
            elif name:
                found[name] = f"{found[name]} {text}".strip()
    return found


def option_help(option: Option, texts: "Mapping[tuple[str, ...], str]") -> str:
    """One option's line: what it is (by the docstrings' `texts`), its default, an example."""
    if option.leaf is None:
        return "One of several, with its own values (repeatable)."
    leaf = option.leaf
    text = leaf.kind.about
    if leaf.choice is not None:
        text = "one of " + ", ".join(leaf.choice.names)
    text = (texts.get(option.path) or text).replace(" [-]", "").rstrip(".")
    if option.required:
        text += " [required]"
    elif option.default is not REQUIRED and option.default is not None and option.default is not False:
        default = _default(option)
        text += f" [default: {default}]" if default else ""
    if leaf.kind.example and leaf.choice is None and leaf.kind.form != "text":
        text += f", e.g. {leaf.kind.example}"
    return text


def _default(option: Option) -> str:
    leaf = option.leaf
    if leaf is not None and leaf.kind.default:
        return leaf.kind.default
    if leaf is not None and leaf.kind.form == "range":
        return "..".join(map(str, option.default))  # type: ignore[call-overload]
    if leaf is not None and isinstance(option.default, tuple):
        return ", ".join(f"{part:g}" for part in option.default)
    if (leaf is not None and leaf.kind.form == "fraction") or not isinstance(option.default, float):
        return str(option.default)
    return default_text(option.default, leaf.kind) if leaf is not None else f"{option.default:g}"


def default_text(value: float, kind: "Kind") -> str:
    """A number of the signature, which is in the unit inside, as a user would write it.

    >>> from dynamics_cli.quantities import Angle
    >>> default_text(0.3490658503988659, Angle)
    '20 deg'
    """
    if kind.si == kind.unit or not value:
        return f"{value:g} {kind.si}".strip()
    from dynamics_cli.core.messages import factor
    from dynamics_cli.core.units import parse_unit

    inside = parse_unit(kind.unit)
    return f"{value * factor(inside) / factor(parse_unit(kind.si, inside)):g} {kind.si}"


def describe_options(task: Task) -> "Mapping[tuple[str, ...], str]":
    """What the docstrings of the function and of its records say of each option."""
    made: dict[tuple[str, ...], str] = {}
    own = described(task.models[0].call().__doc__)
    for field in task.specification.fields:
        if field.place and isinstance(field.node, Record):
            _describe_fields(field.node, (), made, set())
        else:
            _describe(field.node, (), made, own, field.key, set())
    return made


def _describe(
    node: object,
    prefix: "tuple[str, ...]",
    made: "dict[tuple[str, ...], str]",
    texts: "Mapping[str, str]",
    key: str,
    seen: "set[type]",
) -> None:
    item = getattr(node, "item", node)
    members = getattr(item, "members", ())
    records = members.values() if isinstance(members, dict) else members
    if isinstance(item, Tagged):
        made.setdefault((*prefix, item.key), f"One of {', '.join(item.members)}")
    if isinstance(item, Leaf):
        text = texts.get(key) or texts.get(key + "_")
        if text:
            made.setdefault((*prefix, key), text)
    for record in [item] if isinstance(item, Record) else records:
        if record.cls not in seen:
            inner = prefix if item is not node or not isinstance(item, Record) else (*prefix, key)
            _describe_fields(record, inner, made, seen)


def _describe_fields(
    record: Record, prefix: "tuple[str, ...]", made: "dict[tuple[str, ...], str]", seen: "set[type]"
) -> None:
    own = described(record.cls.__doc__)
    for field in record.fields:
        _describe(field.node, prefix, made, own, field.key, seen | {record.cls})


def command_help(task: Task) -> str:
    """A task's long help: its claim, its formula, its sources and examples that run."""
    blocks = [task.summary]
    for model in task.models:
        lines = [f"{model.name}:"] if len(task.models) > 1 else []
        if any(model.formulas):
            from dynamics_cli.core.explain import filled

            said = dict.fromkeys(filled(formula, {}) for formula in model.formulas)
            lines += [_wrapped(f"Formula: {formula}") for formula in said]
        lines.append(_wrapped(f"Source: {model.source}"))
        blocks.append("\b\n" + "\n".join(lines))
    if task.examples:
        # \b keeps the lines of a block as they stand.
        blocks.append("\b\n" + "\n".join(["Examples:", *map(_example, task.examples)]))
    return "\n\n".join(blocks)


def _width() -> int:
    """How long the lines of a help text may be: what a terminal has, within what reads well."""
    import shutil

    return max(48, min(shutil.get_terminal_size((80, 24)).columns - 2, 78))


def _wrapped(line: str) -> str:
    """A line in several where it is long."""
    from textwrap import fill

    return fill(line, _width() - 2, subsequent_indent="    ", break_long_words=False, break_on_hyphens=False)


def _example(command: str) -> str:
    """A command in several lines where it is long, broken before options as a shell takes it: it can be copied."""
    made = "  "
    lines = []
    for nth, part in enumerate(command.split(" --")):
        word = f" --{part}" if nth else part
        if nth and len(made) + len(word) > _width() - 2:
            lines.append(f"{made} \\")
            made = f"    {word}"
        else:
            made += word
    return "\n".join([*lines, made])


def undescribed(task: Task) -> "list[str]":
    """Options that no docstring describes: a test keeps this empty."""
    texts = describe_options(task)
    return [name for name, option in task.options.items() if option.leaf is not None and option.path not in texts]
