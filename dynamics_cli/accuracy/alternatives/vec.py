"""Vectors as textbooks have them: angles by arc cosines, sums of magnitudes by the law of cosines."""

import math

from dynamics_cli.accuracy.questions import textbooks

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence


def _dot(a: "Sequence[float]", b: "Sequence[float]") -> float:
    return sum(x * y for x, y in zip(a, b, strict=False))


def angle(
    first: "Sequence[float]", second: "Sequence[float]", *, axis: "Sequence[float] | None" = None
) -> "dict[str, float]":
    """The arc cosine of a·b/(‖a‖‖b‖); it has no sign about an axis."""
    if axis is not None:
        raise ArithmeticError
    cosine = _dot(first, second) / (math.sqrt(_dot(first, first)) * math.sqrt(_dot(second, second)))
    turn = math.acos(min(1.0, max(-1.0, cosine)))
    return {"angle": turn, "supplement": math.pi - turn, "cosine": cosine, "sine": math.sqrt(1.0 - cosine * cosine)}


def direction(vector: "Sequence[float]", point: "Sequence[float] | None" = None) -> "dict[str, float]":
    """Direction angles by arc cosines."""
    way = vector if point is None else [q - p for p, q in zip(vector, point, strict=True)]
    size = math.sqrt(_dot(way, way))
    return {"magnitude": size} | {
        f"angle_{axis}": math.acos(part / size) for axis, part in zip("xyz", way, strict=False)
    }


def resultant(*vectors: "Sequence[float]", between: "float | None" = None) -> "dict[str, float]":
    """Sums as they stand, two magnitudes by the law of cosines."""
    if between is not None:
        a, b = vectors
        return {"magnitude": math.sqrt(a * a + b * b + 2.0 * a * b * math.cos(between))}  # type: ignore[operator]
    total = [sum(parts) for parts in zip(*vectors, strict=True)]
    return {"magnitude": math.sqrt(_dot(total, total))}


QUESTIONS = textbooks(
    "vec", "vec.json", "dynamics_cli.accuracy.alternatives.vec:",
    ("angle", "textbook: arc cosine", "angle"),
    ("direction", "textbook: arc cosines", "direction"),
    ("resultant", "textbook: law of cosines", "resultant"),
)  # fmt: skip
