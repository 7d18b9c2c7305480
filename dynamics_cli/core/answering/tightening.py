"""Loose rounding bounds, replaced by the error that a second pass in more digits measures.

A running bound adds up the worst case of every operation. For a result near zero, or one whose roundings happened to
cancel, it is far above the error; the formula is then run once more in 60 decimal digits, from the same doubles.
"""

from dynamics_cli.errors import DynamicsError
from dynamics_cli.numerics.tracked import UNIT_ROUNDOFF, Tracked

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from typing import Any

    from dynamics_cli.numerics.exact.many_digits import ManyDigits

# Bounds above this many half units in the last place are worth a second pass.
ROOM = 100.0
# In an answer that shows its bounds only where fewer than nine digits are left.
ROOM_UNSEEN = 1e6
# Bounds below this come from underflow, which would affect a measured error too.
_UNDERFLOW = 1e-290


def tighten(record: "Any", numbers: "list[float]", again: "Callable[[list[Any]], Any]", *, seen: bool = True) -> None:
    """Make the bounds in `record` tight where any is loose; `again` gives the record of other numbers for `numbers`.

    Where bounds are not `seen`, they may be looser before a second pass is worth its time.
    Where the pass in more digits takes another branch (a refusal, a gap, a table of another length) the bounds stay.
    """
    looseness = ROOM if seen else ROOM_UNSEEN
    if not any(_is_loose(number, looseness) for number, _ in _beside(record, record)):
        return
    from dynamics_cli.numerics.exact.many_digits import ManyDigits, measured_error, run

    try:
        exact = run(lambda: again(ManyDigits.inputs(numbers)))
    except (DynamicsError, ArithmeticError):
        return
    for number, precise in _beside(record, exact):
        if type(precise) is ManyDigits and _is_loose(number):
            number.error = measured_error(number.value, precise, number.error)


def _is_loose(number: Tracked, room: float = ROOM) -> bool:
    return number.error > max(room * UNIT_ROUNDOFF * abs(number.value), _UNDERFLOW)


def _beside(first: "Any", second: "Any") -> "Iterator[tuple[Tracked, Tracked | ManyDigits]]":
    """Every tracked number of an answer with its counterpart in another; nothing where the shapes differ."""
    kind = type(first)
    if kind is Tracked:
        yield first, second
    elif kind is not type(second):
        return
    elif kind is tuple or kind is list:
        if len(first) == len(second):
            for first_item, second_item in zip(first, second, strict=True):
                yield from _beside(first_item, second_item)
    elif kind is dict:
        for name, first_item in first.items():
            yield from _beside(first_item, second.get(name))
    elif hasattr(kind, "fields"):
        for name in kind.fields:
            yield from _beside(getattr(first, name), getattr(second, name))
