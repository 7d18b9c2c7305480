"""Parts of a repeated option that begin with their first value: `pin at 0, 0 m`, `braking, distance=14 m`."""

from dynamics_cli.core.inputs.forms.splitting import split_pairs, with_names
from dynamics_cli.core.inputs.quantity_text import number_end
from dynamics_cli.core.inputs.specification import Leaf, Record, Tagged

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.core.inputs.specification import Node


def pairs_of(text: str, node: "Node") -> "dict[str, Any]":
    """Names and values of a part; the first value may stand without its name where it is a number or a choice."""
    if isinstance(node, Record | Tagged) and (first := _first_name(text, node)):
        text = with_names(text, first, node.names)
    return {key.replace("-", "_"): value for key, value in split_pairs(text).items()}


def _first_name(text: str, node: "Record | Tagged") -> str:
    """The name of the first value, where a text begins with that value."""
    word = text.replace(",", " ").split(" ")[0].lower()
    if isinstance(node, Tagged):
        return node.key if node.member(word) else ""
    first = node.fields[0]
    if not isinstance(first.node, Leaf) or not text:
        return ""
    choice = first.node.choice
    chosen = choice is not None and (word in choice.names or word in choice.aliases)
    return first.key if chosen or number_end(text, 0) else ""
