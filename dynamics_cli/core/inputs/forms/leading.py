"""Parts of a repeated option that begin with their first value: `pin at 0, 0 m`, `braking, distance=14 m`."""

from dynamics_cli.core.inputs.forms.splitting import PAIRS, split_pairs, with_names
from dynamics_cli.core.inputs.quantity_text import number_end
from dynamics_cli.core.inputs.specification import Leaf, Record, Tagged
from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable
    from typing import Any

    from dynamics_cli.core.inputs.specification import Node


def pairs_of(text: str, node: "Node") -> "dict[str, Any]":
    """Names and values of a part; the first value may stand without its name where it is a number or a choice."""
    if isinstance(node, Record) and text:
        first = node.fields[0]
        if isinstance(first.node, Leaf) and (number_end(text, 0) or _chosen(first.node, text)):
            text = with_names(text, first.key, node.names)
    return {key.replace("-", "_"): value for key, value in with_choice(split_pairs(text), node).items()}


def _chosen(node: Leaf, text: str) -> bool:
    """Whether a text begins with one of the words that may be chosen here."""
    word = text.replace(",", " ").split(" ")[0].lower()
    return node.choice is not None and (word in node.choice.names or word in node.choice.aliases)


def with_choice(pairs: "dict[str, Any]", node: "Node") -> "dict[str, Any]":
    """Pairs that begin with a word alone, `braking, distance=14 m`, with the name of the choice that comes first."""
    if "" not in pairs:
        return pairs
    names: Iterable[str] = ()
    if isinstance(node, Tagged):
        key, names = node.key, node.members
    elif isinstance(node, Record) and isinstance(node.fields[0].node, Leaf) and node.fields[0].node.choice is not None:
        key, names = node.fields[0].key, node.fields[0].node.choice.names
    if pairs[""] not in names:
        raise UsageError(f"read {pairs['']!r}, wanted NAME=VALUE", code="syntax", hint=PAIRS)
    return {name or key: value for name, value in pairs.items()}
