"""Models whose results' distributions are known, written once for arrays and for numbers of other libraries."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any

    # Inputs in order and a library's elementary functions in, the result out.
    Formula = Callable[[Sequence[Any], Any], Any]

TWICE_GRAVITY = 2.0 * 9.80665


def total(x: "Sequence[Any]", m: "Any") -> "Any":
    """Σx."""
    result = x[0]
    for value in x[1:]:
        result = result + value
    return result


def product(x: "Sequence[Any]", m: "Any") -> "Any":
    """Πx."""
    result = x[0]
    for value in x[1:]:
        result = result * value
    return result


def squares(x: "Sequence[Any]", m: "Any") -> "Any":
    """Σx²."""
    return total([value * value for value in x], m)


def largest(x: "Sequence[Any]", m: "Any") -> "Any":
    """The greatest: max(a, b) = (a + b + |a − b|)/2, as not every library compares."""
    result = x[0]
    for value in x[1:]:
        result = 0.5 * (result + value + m.fabs(result - value))
    return result


def smallest(x: "Sequence[Any]", m: "Any") -> "Any":
    """The least."""
    return -largest([-value for value in x], m)


FORMULAS: "dict[str, Formula]" = {
    "skid": lambda x, m: m.sqrt(TWICE_GRAVITY * x[0] * x[1]),
    "same": lambda x, m: 1.0 * x[0],
    "exp": lambda x, m: m.exp(x[0]),
    "reciprocal": lambda x, m: 1.0 / x[0],
    "square": lambda x, m: x[0] * x[0],
    "cube": lambda x, m: x[0] * x[0] * x[0],
    "absolute": lambda x, m: m.fabs(x[0]),
    "positive": lambda x, m: 0.5 * (x[0] + m.fabs(x[0])),
    "root": lambda x, m: m.sqrt(x[0]),
    "sine": lambda x, m: m.sin(x[0]),
    "tangent": lambda x, m: m.tan(x[0]),
    "logarithm": lambda x, m: m.log(x[0]),
    "step": lambda x, m: m.atan(1000.0 * x[0]),
    "total": total,
    "product": product,
    "quotient": lambda x, m: x[0] / x[1],
    "difference": lambda x, m: x[0] - x[1],
    "apart": lambda x, m: m.fabs(x[0] - x[1]),
    "squares": squares,
    "radius": lambda x, m: m.sqrt(squares(x, m)),
    "largest": largest,
    "smallest": smallest,
}


class Arrays:
    """The elementary functions of numpy under the names of `math`."""

    def __init__(self) -> None:
        import numpy as np

        self.sqrt, self.exp, self.log, self.fabs = np.sqrt, np.exp, np.log, np.abs
        self.sin, self.tan, self.atan = np.sin, np.tan, np.arctan
