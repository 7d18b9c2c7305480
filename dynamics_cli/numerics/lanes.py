"""Arrays that go through formulas written for one case, branches included: many cases side by side, one in each lane.

A formula may branch on a number (`if depth > tip:`). A lane array answers if all its lanes agree; if they do not, the
cases are split by their answers, and each part runs again from the start. So every lane
takes exactly the steps that its case would take alone, and gives the same bits.
"""

import numpy as np

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]
    Rows = NDArray[np.int64]

# Fewer lanes than this are cheaper one by one.
FEWEST = 12
# Parts of one call: beyond this its cases share few steps.
MOST_PARTS = 400


class Diverged(BaseException):
    """The lanes take different branches; `mask` is the condition in each of them.

    Not an `Exception`, so that no formula handles it as its own failure.
    """

    def __init__(self, mask: "Array") -> None:
        super().__init__()
        self.mask = mask


class Lanes(np.ndarray):
    """Numbers of several cases; their decisions are recorded in `trail`, which identifies calls with the same steps."""

    trail: "list[Any]" = []  # noqa: RUF012  one for all, as there is one call at a time

    def __bool__(self) -> bool:
        """The common answer of all lanes."""
        if not self.ndim:
            return bool(self.item())
        truth = np.asarray(self, dtype=bool)
        answer = bool(truth[0]) if truth.size else False
        if truth.all() if answer else not truth.any():
            Lanes.trail.append(answer)
            return answer
        raise Diverged(truth)

    def _whole(self, rounded: "Array") -> int:
        """The integer common to all lanes."""
        first = rounded.flat[0]
        same = np.asarray(rounded == first)
        if same.all():
            Lanes.trail.append(int(first))
            return int(first)
        raise Diverged(same)

    def __int__(self) -> int:
        return self._whole(np.trunc(np.asarray(self)))

    __trunc__ = __int__

    def __floor__(self) -> int:
        return self._whole(np.floor(np.asarray(self)))

    def __ceil__(self) -> int:
        return self._whole(np.ceil(np.asarray(self)))

    def __round__(self, digits: "int | None" = None) -> "Any":
        if digits is None:
            return self._whole(np.rint(np.asarray(self)))
        from dynamics_cli.numerics.elementary import over_array

        return over_array(lambda number: round(number, digits), self)

    def __float__(self) -> float:
        """The number, where it is the same in all lanes."""
        first = self.flat[0]
        if (np.asarray(self) == first).all():
            return float(first)
        raise TypeError("lanes hold several numbers")

    @property
    def known(self) -> "dict[Any, Any]":
        """What functions have made of these numbers."""
        return self.__dict__.setdefault("made", {})  # type: ignore[no-any-return]

    def __iadd__(self, other: "Any") -> "Any":  # type: ignore[misc]
        """A new number, as among floats: what is known of this one stays true."""
        return self + other

    def __isub__(self, other: "Any") -> "Any":  # type: ignore[misc]
        return self - other

    def __imul__(self, other: "Any") -> "Any":  # type: ignore[misc]
        return self * other

    def __itruediv__(self, other: "Any") -> "Any":  # type: ignore[misc]
        return self / other

    def __pow__(self, power: "Any", modulus: None = None) -> "Any":
        """Power as Python calculates it; numpy's differs in the last bits."""
        return _raised(self, power)

    def __rpow__(self, base: "Any", modulus: None = None) -> "Any":
        return _raised(base, self)


def _raised(base: "Any", power: "Any") -> "Any":
    from dynamics_cli.numerics.elementary import over_array

    return over_array(pow, base, power)


class Part:
    """Cases that took the same branches: their indices, the result, and the steps."""

    __slots__ = ("outcome", "rows", "trail")

    def __init__(self, rows: "Rows", outcome: "Any", trail: "tuple[Any, ...]") -> None:
        self.rows = rows
        self.outcome = outcome
        self.trail = trail


def parts(
    call: "Callable[[dict[str, Array]], Any]",
    arrays: "dict[str, Array]",
    rows: "Rows",
    refused: "Callable[[Exception], Any]",
    kind: "type[Lanes]" = Lanes,
) -> "Iterator[Part]":
    """The results of `call` for all cases, part by part; refused cases are left out.

    `refused` is called with the error raised: the mask of cases that the formula refuses, True for all of them,
    or None if the cases are unknown: they are then halved until few remain. An error raised by it ends the search.
    """
    waiting = [rows]
    tries = 0
    while waiting:
        rows_now = waiting.pop()
        if len(rows_now) < FEWEST or tries > MOST_PARTS:
            continue
        tries += 1
        Lanes.trail = []
        try:
            outcome = call({name: _taken(array, rows_now).view(kind) for name, array in arrays.items()})
        except Diverged as parting:
            if parting.mask.shape != rows_now.shape:
                raise TypeError("lanes met an array of another shape") from None
            waiting += [rows_now[~parting.mask], rows_now[parting.mask]]
        except Exception as error:
            bad = refused(error)
            if bad is None:
                middle = len(rows_now) // 2
                waiting += [rows_now[middle:], rows_now[:middle]]
            elif bad is not True and np.shape(bad) == rows_now.shape and not np.all(bad):
                waiting.append(rows_now[~np.asarray(bad)])
        else:
            yield Part(rows_now, outcome, tuple(Lanes.trail))


def _taken(array: "Array", rows: "Rows") -> "Array":
    """The chosen rows of an array; the array itself where they are all of it."""
    return array if len(rows) == len(array) else array[rows]


def sign_changes(
    function: "Callable[[Any], Any]", low: "Any", high: "Any", width: float = 4e-16, halving: int = 8
) -> "Any":
    """Sign change of a function that is positive at `low` and not at `high`, lane by lane.

    Each lane takes the steps that `roots.sign_change` takes alone, and stays where these end.
    """
    f_low, f_high = function(low), function(high)
    kind = type(f_low)
    low, high, f_low, f_high = (np.array(x, dtype=float) for x in np.broadcast_arrays(low, high, f_low, f_high))
    going = np.ones(f_low.shape, dtype=bool)
    went_up = went_down = ~going
    with np.errstate(all="ignore"):
        for count in range(200):
            middle = 0.5 * (low + high)
            if count % halving != halving - 1:
                trial = (low * f_high - high * f_low) / (f_high - f_low)
                within = ((low < trial) & (trial < high)) | ((high < trial) & (trial < low))
                middle = np.where(within & (f_low > 0.0) & (f_high < 0.0), trial, middle)
            size = np.maximum(abs(low), abs(high))
            going &= (middle != low) & (middle != high) & (abs(high - low) > width * size)
            if not going.any():
                break
            value = np.asarray(function(middle.view(kind)))
            above = value > 0.0
            up, down = going & above, going & ~above
            f_low[down & went_down] *= 0.5
            f_high[up & went_up] *= 0.5
            for chosen, place, height in ((up, low, f_low), (down, high, f_high)):
                np.copyto(place, middle, where=chosen)
                np.copyto(height, value, where=chosen)
            went_up, went_down = up, down
    return np.where(abs(f_low) < abs(f_high), low, high).view(kind)
