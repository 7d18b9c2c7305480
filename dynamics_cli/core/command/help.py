"""Help, from the signature and the descriptions beside its annotations."""

from dynamics_cli.core.answering.explain import default_text
from dynamics_cli.core.answering.task import Task
from dynamics_cli.core.inputs.options import Option
from dynamics_cli.core.inputs.settings import UNIVERSAL_OPTIONS
from dynamics_cli.core.inputs.specification import REQUIRED, Field, Leaf, Many, Record, Tagged
from dynamics_cli.core.output.wrapping import wrapped
from dynamics_cli.records import Advice, Check, Numerics

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping

# The options of every task in groups: title and names.
OPTION_GROUPS = (
    ("Output", ("json", "format", "output", "all", "only", "table", "quiet", "explain", "timing", "plot", "drawing")),
    ("Units and digits", ("units", "to", "digits")),
    ("Limits", ("limit", "fail", "fail-above")),
    ("Input", ("input", "template", "model")),
    ("Batches", ("rows", "column", "sweep", "jobs")),
)
UNCERTAIN = 'An uncertain value: "0.7 ± 0.05" (or 0.7 +- 0.05) by its standard deviation, "0.6..0.8" when any value is '
UNCERTAIN += 'as likely, "0.6..0.7..0.8" with the likeliest, "[0.71, 0.74, 0.70]" for readings.'
SHORT_FORMS = "-h is --help, -o --output, -q --quiet, -j --json. Variables: DYNAMICS_UNITS, DYNAMICS_DIGITS, "
SHORT_FORMS += "DYNAMICS_FORMAT, DYNAMICS_GRAVITY; a dynamics.toml sets the same (units, digits, format, gravity)."


def placeholder(option: Option) -> str:
    """Placeholder of an option's value in help."""
    if option.leaf is None:
        return "NAME=VALUE,…"
    if option.leaf.choice is not None:
        return "NAME"
    return option.leaf.kind.name.upper().replace(" ", "-")


def word_name(field: Field) -> str:
    """Name of a positional argument in help, in brackets where it may be left out."""
    name = str(field.node.key if isinstance(field.node, Tagged) else field.key).upper()
    word = f"{name}..." if field.place == "words" else name
    return word if field.required or not field.text else f"[{word}]"


def option_help(option: Option, texts: "Mapping[tuple[str, ...], str]") -> str:
    """One option's line: its description (from `texts`), its default, an example."""
    if option.leaf is None:
        return "One of several, with its own values (repeatable)."
    leaf = option.leaf
    text = leaf.kind.about
    if leaf.choice is not None:
        text = "one of " + ", ".join(leaf.choice.names)
    text = (texts.get(option.path) or text).replace(" [-]", "").rstrip(".")
    if option.required:
        text += " [required]"
    elif default := written_default(option):
        text += f" [default: {default}]"
    if leaf.kind.example and leaf.choice is None and leaf.kind.form != "text":
        text += f", e.g. {leaf.kind.example}"
    return text


def written_default(option: Option) -> str:
    """The default of an option as a user would write it; empty without one."""
    if option.required or option.default is REQUIRED or option.default is None or option.default is False:
        return ""
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


def describe_options(task: Task) -> "Mapping[tuple[str, ...], str]":
    """Descriptions of all options, from the annotations of the function and of its records."""
    texts: dict[tuple[str, ...], str] = {}
    # an option's own words go before those of a group's field of the same name
    for field in sorted(task.specification.fields, key=lambda field: not isinstance(field.node, Leaf)):
        if field.place and isinstance(field.node, Record):
            _describe_fields(field.node, (), texts, set())
        else:
            _describe(field, (), texts, set())
    return texts


def describe_record(record: Record) -> "dict[tuple[str, ...], str]":
    """Descriptions of one record's fields, from its annotations."""
    texts: dict[tuple[str, ...], str] = {}
    _describe_fields(record, (), texts, set())
    return texts


def _describe(field: Field, prefix: "tuple[str, ...]", texts: "dict[tuple[str, ...], str]", seen: "set[type]") -> None:
    node, key = field.node, field.key
    item = getattr(node, "item", node)
    members = getattr(item, "members", ())
    records = members.values() if isinstance(members, dict) else members
    if isinstance(item, Tagged):
        texts.setdefault((*prefix, item.key), f"One of {', '.join(item.members)}")
    if isinstance(item, Leaf) and field.text:
        texts.setdefault((*prefix, key), field.text)
    for record in [item] if isinstance(item, Record) else records:
        if record.cls not in seen:
            inner = prefix if item is not node or not isinstance(item, Record) else (*prefix, key)
            _describe_fields(record, inner, texts, seen)


def _describe_fields(
    record: Record, prefix: "tuple[str, ...]", texts: "dict[tuple[str, ...], str]", seen: "set[type]"
) -> None:
    for field in record.fields:
        _describe(field, prefix, texts, seen | {record.cls})


def result_fields(record: Record, address: str = "") -> "Iterator[tuple[str, Field]]":
    """Every result by its address; a table as one, fields of lone records singly; no checks, warnings or numerics."""
    for field in record.fields:
        node = field.node
        item = node.item if isinstance(node, Many) else node
        if isinstance(item, Record) and item.cls in (Check, Advice, Numerics):
            continue
        if isinstance(node, Record):
            yield from result_fields(node, f"{address}{field.key}.")
        else:
            yield f"{address}{field.key}", field


def undescribed(task: Task) -> "list[str]":
    """Options without a description: a test keeps this empty."""
    texts = describe_options(task)
    return [name for name, option in task.options.items() if option.leaf is not None and option.path not in texts]


def common_options(width: int) -> str:
    """The options that every task has, in groups."""
    grouped = {name for _, names in OPTION_GROUPS for name in names}
    rest = ("Uncertainty and others", tuple(name for name in UNIVERSAL_OPTIONS if name not in grouped))
    lines = ["Options that every task has"]
    for title, names in (*OPTION_GROUPS, rest):
        lines += ["", f"{title}:", *option_lines(names, width)]
    return "\n".join([*lines, "", *wrapped(UNCERTAIN, width, 0), "", *wrapped(SHORT_FORMS, width, 0)]) + "\n"


def option_lines(names: "Iterable[str]", width: int) -> "list[str]":
    """Options that every task has, with their values and what they do."""
    lines = []
    for name in names:
        _, value, text = UNIVERSAL_OPTIONS[name]
        first, *more_lines = wrapped(text, width - 24, 0)
        head = f"--{name} {value}".rstrip()
        lines += [f"  {head:<20}  {first}" if len(head) <= 20 else f"  {head}\n{'':24}{first}"]
        lines += [f"{'':24}{line}" for line in more_lines]
    return lines
