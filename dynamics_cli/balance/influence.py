"""Complex least squares in one or two unknowns, on doubles or tracked numbers, with how well they are told apart."""

from dynamics_cli.balance.phasors import Phasor, total
from dynamics_cli.numerics.elementary import sqrt
from dynamics_cli.numerics.number import plain

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any


def norm(column: "Sequence[Phasor]") -> "Any":
    """Length of a column."""
    return sqrt(sum((one.x * one.x + one.y * one.y for one in column), start=0.0))


def _inner(one: "Sequence[Phasor]", other: "Sequence[Phasor]") -> Phasor:
    return total(a.conjugate * b for a, b in zip(one, other, strict=True))


def condition(columns: "Sequence[Sequence[Phasor]]") -> float:
    """Condition of the columns scaled to length 1; infinite of columns that depend on one another."""
    if len(columns) == 1:
        return 1.0
    first, second = columns
    lengths = plain(norm(first)), plain(norm(second))
    along = plain(_inner(first, second).size) / (lengths[0] * lengths[1])
    apart = plain(norm(_apart(first, second))) / lengths[1]
    return float("inf") if apart == 0.0 else (1.0 + along) / apart


def _apart(first: "Sequence[Phasor]", second: "Sequence[Phasor]") -> "list[Phasor]":
    """What of the second column is square to the first; taken twice, so that nothing of the first is left."""
    square = norm(first) * norm(first)
    for _ in range(2):
        inner = _inner(first, second)
        share = Phasor(inner.x / square, inner.y / square)
        second = [b - a * share for a, b in zip(first, second, strict=True)]
    return list(second)


def solved(columns: "Sequence[Sequence[Phasor]]", right: "Sequence[Phasor]") -> "list[Phasor]":
    """The x of least |Σ columns·x − right|, by orthogonal columns."""
    if len(columns) == 1:
        return [_share(columns[0], right)]
    first, second = columns
    apart = _apart(first, second)
    other = _share(apart, right)
    left = [value - b * other for value, b in zip(right, second, strict=True)]
    return [_share(first, left), other]


def solved_together(columns: "Sequence[Sequence[Phasor]]", right: "Sequence[Phasor]") -> "list[Phasor]":
    """The x of what two columns do together: least squares without the smaller singular value of scaled columns.

    Of columns of length 1 with the inner product c = |c|·e^{iγ} the larger singular value is √(1 + |c|), its
    direction (1, e^{−iγ})/√2.
    """
    lengths = [norm(column) for column in columns]
    first, second = ([a.times(1.0 / length) for a in column] for column, length in zip(columns, lengths, strict=True))
    inner = _inner(first, second)
    turn = inner.conjugate.times(1.0 / inner.size)
    common = [a + b * turn for a, b in zip(first, second, strict=True)]
    share = _share(common, right)
    return [share.times(1.0 / lengths[0]), (turn * share).times(1.0 / lengths[1])]


def _share(column: "Sequence[Phasor]", right: "Sequence[Phasor]") -> Phasor:
    inner, length = _inner(column, right), norm(column)
    return Phasor(inner.x / (length * length), inner.y / (length * length))
