"""The one protocol of numbers: which sort it is (double, array, tracked, many digits), and the double in it.

A formula is written once for all sorts. Where a branch depends on the sort, it is asked here.
"""

from dynamics_cli.records import over_parts

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import Any


def plain(x: "Any") -> float:
    """The double inside a tracked or many-digit number; anything else unchanged.

    >>> plain(2.5)
    2.5
    """
    return getattr(x, "value", x)  # type: ignore[no-any-return]


def over_plain(tree: "Any") -> "Any":
    """Doubles in place of every number of a record or a tuple."""
    return over_parts(tree, over_plain) if isinstance(tree, tuple) or hasattr(tree, "fields") else plain(tree)


def is_array(x: object) -> bool:
    """Whether this is a numpy array, or a scalar taken from one."""
    return hasattr(x, "dtype")


def single(*values: object) -> bool:
    """Whether these are single numbers: advice and checks concern one case, not arrays."""
    return not any(getattr(value, "ndim", 0) for value in values)


def decides(*values: object) -> bool:
    """Whether formulas may branch on these: single numbers, or lanes, which part where their branches differ."""
    return not any(getattr(value, "ndim", 0) and not hasattr(value, "known") for value in values)


def is_carrier(x: object) -> bool:
    """Whether this carries more than a double: its error and slopes, or many digits."""
    return hasattr(x, "apply")


def carriers(tree: "Any") -> "Iterator[Any]":
    """Every number of a record or a tuple that carries more than a double, in order."""
    if is_carrier(tree):
        yield tree
    elif isinstance(tree, tuple):
        for part in tree:
            yield from carriers(part)
    elif hasattr(tree, "fields"):
        for name in tree.fields:
            yield from carriers(getattr(tree, name))


def is_tracked(x: object) -> bool:
    """Whether this carries a rounding bound and derivatives."""
    return hasattr(x, "slopes")


def is_many(x: object) -> bool:
    """Whether this has many digits and goes through formulas as a tracked number does."""
    return hasattr(x, "many_digits")


def like(number: float, beside: "Any") -> "Any":
    """A double as an exact number of the same sort as another; other numbers unchanged."""
    if is_carrier(number) or not is_carrier(beside):
        return number
    if is_tracked(beside):
        return type(beside)(number, 0.0, (0.0,) * len(beside.slopes))
    return type(beside).inputs([number])[0]
