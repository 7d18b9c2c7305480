"""The names of the command line: a specification flattened to options."""

from dynamics_cli.core.inputs.specification import (
    FLAG,
    PLAIN_TEXT,
    REQUIRED,
    Field,
    Leaf,
    Many,
    OneOf,
    Record,
    Tagged,
    members_of,
)
from dynamics_cli.records import Choice


class Option:
    """One name on the command line: `--first-mass`, and the path of keys its value goes to in the input."""

    __slots__ = ("default", "group", "leaf", "name", "path", "required")

    def __init__(
        self, name: str, path: "tuple[str, ...]", leaf: Leaf | None, *, group: str = "", default: object, required: bool
    ) -> None:
        self.name = name
        self.path = path
        self.leaf = leaf
        self.group = group
        self.default = default
        self.required = required

    @property
    def flag(self) -> bool:
        """Whether the option takes no value."""
        return self.leaf is not None and self.leaf.kind is FLAG

    @property
    def repeats(self) -> bool:
        """Whether the option may be given several times: `--segment …`."""
        return self.leaf is None


def kebab(name: str) -> str:
    """`end_speed` and `TestSkid` as the command line writes them: `end-speed`, `test-skid`."""
    text = name if name.islower() else "".join("-" + c.lower() if c.isupper() else c for c in name)
    return text.strip("-_").replace("_", "-")


def options(fields: "tuple[Field, ...]") -> "dict[str, Option]":
    """Every option of a task by its name, positionals apart."""
    by_name: dict[str, Option] = {}
    for field in fields:
        if not field.place:
            _spread_options(field, (), by_name, (), field.required)
        elif isinstance(field.node, Record):
            # A scene: options override its file.
            _record_options(field.node, (), by_name, (), False)
        elif isinstance(field.node, Tagged):
            for member in field.node.members.values():
                for inner in member.fields:
                    _spread_options(inner, (), by_name, (member.cls,), False)
    return by_name


def _spread_options(
    field: Field, prefix: "tuple[str, ...]", by_name: "dict[str, Option]", inside: "tuple[type, ...]", required: bool
) -> None:
    node = field.node
    path = (*prefix, field.key)
    name = kebab("_".join(path))
    if isinstance(node, Leaf) or (isinstance(node, Many) and isinstance(node.item, Leaf)):
        leaf = node if isinstance(node, Leaf) else node.item
        if name not in by_name:
            by_name[name] = Option(name, path, leaf, default=field.default, required=required)  # type: ignore[arg-type]
    elif isinstance(node, Record):
        _record_options(node, path, by_name, inside, required)
    elif isinstance(node, OneOf):
        for member in node.members:
            _record_options(member, prefix, by_name, inside, False)
    elif isinstance(node, Tagged):
        key_path = (*prefix, node.key)
        key_name = kebab("_".join(key_path))
        by_name[key_name] = Option(key_name, key_path, _tag_leaf(node), default=REQUIRED, required=required)
        for member in node.members.values():
            _record_options(member, prefix, by_name, inside, False)
    else:
        item = members_of(node.item)
        if node.single:
            for member in item:
                _record_options(member, prefix, by_name, inside, required and node.columns)
        if not node.columns:
            group = group_name(node, path)
            by_name[group] = Option(group, path, None, group=name, default=(), required=False)


def group_name(node: Many, path: "tuple[str, ...]") -> str:
    """The option that gives one record of a list: `first-phase`."""
    item = members_of(node.item)
    last = item[0].cls.__name__ if len(item) == 1 else path[-1]
    return kebab("_".join((*path[:-1], kebab(last))))


def _tag_leaf(node: Tagged) -> Leaf:
    """The leaf of the option that chooses among tagged records; its values are their names."""
    return Leaf(PLAIN_TEXT, type(node.key, (Choice,), {"names": tuple(node.members)}))


def _record_options(
    record: Record,
    prefix: "tuple[str, ...]",
    by_name: "dict[str, Option]",
    inside: "tuple[type, ...]",
    required: bool,
) -> None:
    if record.cls in inside:
        return  # a tree of records within itself is a scene: it is read from a file
    for field in record.fields:
        _spread_options(field, prefix, by_name, (*inside, record.cls), required and field.required)
