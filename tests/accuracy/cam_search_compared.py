"""What the search compares: a result, the bound stated of it, and its exact value."""

from math import isinf
from typing import Any, NamedTuple

from cam_search_motion import Turn
from precise import Exact, exact_pi

UNIT_ROUNDOFF = 2.0**-53


class Compared(NamedTuple):
    """A result beside its exact value.

    `size` is what the result is a share of (its own magnitude, a peak, the size of a cam); `stated` tells a bound that
    the answer states from one that the documentation promises. Results of one `row` are one evaluation.
    """

    name: str
    value: float
    bound: float
    exact: Any
    size: float
    stated: bool
    row: str

    @property
    def error(self) -> float:
        """How far the result is off, less what the exact side may be: climbs end within 2⁻¹⁰⁰ of the size."""
        own = Exact(2) ** -90 * max(Exact(self.size), abs(self.exact))
        return float(max(abs(Exact(self.value) - self.exact) - own, Exact(0)))


def column_of(name: str) -> str:
    """The address of a result's column."""
    return name[: name.index("[")] + name[name.index("]") + 1 :] if "[" in name else name


class Stated:
    """The bounds of an answer by address; those of a column hold for each of its rows."""

    def __init__(self, answer: Any) -> None:
        numerics = answer.numerics
        self.bounds = {one.result: one for one in numerics.bounds} if numerics else {}
        self.used: set[str] = set()

    def compare(
        self, name: str, value: float | None, exact: Any, promised: float | None = None, *, size: float | None = None,
        row: str = "",
    ) -> list[Compared]:  # fmt: skip
        """One result; `promised` is the absolute bound where none is stated, and without either it is not compared."""
        if value is None or exact is None:
            return []
        value = float(value)
        own = self.bounds.get(name) or self.bounds.get(column_of(name))
        if own is not None:
            self.used.add(own.result)
            # an infinite share of zero is no bound
            bound = own.bound if isinf(own.bound) or not own.relative else own.bound * abs(value)
        elif promised is not None:
            bound = promised
        else:
            return []
        return [Compared(name, value, bound, exact, abs(value) if size is None else size, own is not None, row or name)]


def placed(name: str, at: float | None, turn: Turn, quantity: Any, exact: Any, room: float) -> list[Compared]:
    """Whether an extreme is taken where the answer says: its exact value there, which no bound is stated of."""
    if at is None or exact is None:
        return []
    values = [quantity(*zone.at(meant, 2)) for zone, meant in turn.zones_at(float(at))]
    value = float(min(values, key=lambda one: abs(one - exact)))
    return [Compared(f"{name}_at", value, room, exact, room, False, f"{name}_at")]


def nearest(pairs: list[Any], value: float) -> Any:
    """Of what an exact value may be (either side of a joint, an angle as written or as meant), the nearest."""
    return min(pairs, key=lambda exact: abs(exact - Exact(value)))


def table_angles(turn: Turn, index: int, count: int, theta: float) -> list[tuple[Any, Any, Any]]:
    """(zone, angle within it, angle to turn the cam by) that a row of a table of `count` equal steps may mean."""
    meant = 2 * exact_pi() * index / count
    found = []
    for zone, at in turn.zones_at(theta):
        found.append((zone, at, meant))
        found.append((zone, meant, meant))
    return found
