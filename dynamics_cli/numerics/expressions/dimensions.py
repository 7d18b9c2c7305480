"""The dimension of a formula: powers of metre, kilogram, second, kelvin, ampere, mole and candela.

Angles have none here: an arc is a radius times an angle.
"""

from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping
    from fractions import Fraction
    from typing import Any, TypeAlias

    from dynamics_cli.records import Formula

    Dimension: TypeAlias = tuple[int | Fraction, ...]

NONE = (0, 0, 0, 0, 0, 0, 0)
# kilograms are written first
ORDER, BASE = (1, 0, 2, 3, 4, 5, 6), ("m", "kg", "s", "K", "A", "mol", "cd")
NAMED = {(1, 1, -2, 0, 0, 0, 0): "N", (2, 1, -2, 0, 0, 0, 0): "N*m", (2, 1, -3, 0, 0, 0, 0): "W"}
LENGTH, SPEED, RATE, TIME = (1, *NONE[1:]), (1, 0, -1, *NONE[3:]), (0, 0, -1, *NONE[3:]), (0, 0, 1, *NONE[3:])
# What variables of tasks are in.
VARIABLES = {
    "t": TIME, "x": LENGTH, "y": LENGTH, "z": LENGTH, "v": SPEED, "vx": SPEED, "vy": SPEED,
    "angle": NONE, "theta": NONE, "θ": NONE, "speed": RATE,
}  # fmt: skip


def written(dimension: "Dimension") -> str:
    """A dimension as a unit."""
    if dimension in NAMED:
        return NAMED[dimension]
    above = [_raised(BASE[k], dimension[k]) for k in ORDER if dimension[k] > 0]
    below = [_raised(BASE[k], -dimension[k]) for k in ORDER if dimension[k] < 0]
    return "/".join(["*".join(above) or "1", *below]) if above or below else "a plain number"


def _raised(unit: str, power: "int | Fraction") -> str:
    return unit if power == 1 else f"{unit}^{power}"


def check_dimension(formula: "Formula", tree: "tuple[Any, ...]", names: "Mapping[str, Dimension | None]") -> None:
    """Refuse a formula that adds what cannot be added, or whose result is not what is wanted.

    Where the formula has a unit at its end alone, its plain numbers may stand for anything, and so may t and x.
    """
    found = _Dimensions(formula.text, names, strict=bool(formula.units)).of(tree)
    if found is not None and found != formula.wanted:
        raise UsageError(
            f"the formula {formula.text!r} gives {written(found)}, wanted {formula.unit or 'a plain number'}",
            code="dimension", hint=f"numbers and variables have units here, as in 2 {formula.unit}*sin(3 rad/s*t)",
        )  # fmt: skip


class _Dimensions:
    """The dimensions of trees; None where one is not known, as that of zero."""

    def __init__(self, text: str, names: "Mapping[str, Dimension | None]", *, strict: bool) -> None:
        self.text, self.names, self.strict = text, names, strict

    def of(self, tree: "tuple[Any, ...]") -> "Dimension | None":
        """The dimension of a tree."""
        operation = tree[0]
        if operation == "number":
            return tree[2] if len(tree) > 2 else NONE if self.strict and tree[1] else None
        if operation in ("name", "pi"):
            return self.names.get(tree[1]) if operation == "name" else NONE
        first = self.of(tree[1])
        if operation in ("neg", "abs"):
            return first
        if operation == "sqrt":
            return first and _times(first, 0.5)
        if len(tree) == 2:
            self.require_plain(first, f"{operation}(…)")
            return NONE
        second = self.of(tree[2])
        if operation == "^":
            return self.power(first, second, tree[2])
        if operation in ("*", "/"):
            sign = 1 if operation == "*" else -1
            known = first is not None and second is not None
            return tuple(a + sign * b for a, b in zip(first, second, strict=True)) if known else None  # type: ignore[arg-type]
        if first is not None and second is not None and first != second:
            word = "adds" if operation == "+" else "subtracts"
            self.refuse(f"{word} {written(first)} and {written(second)}", "give every number its unit: 3 m, 2 m/s")
        return second if first is None else first

    def power(
        self, base: "Dimension | None", exponent: "Dimension | None", tree: "tuple[Any, ...]"
    ) -> "Dimension | None":
        """The dimension of a power."""
        from dynamics_cli.numerics.expressions.grammar import constant

        self.require_plain(exponent, "a power")
        if base is None or base == NONE:
            return base
        whole = constant(tree)
        if whole is None:
            self.refuse(f"raises {written(base)} to a power that varies", "such powers are of plain numbers")
        return _times(base, whole or 0.0)

    def require_plain(self, dimension: "Dimension | None", what: str) -> None:
        """Refuse an argument with a dimension."""
        if self.strict and dimension is not None and dimension != NONE:
            hint = "its argument is an angle or a plain number, such as 3 rad/s*t"
            self.refuse(f"has {what} of something in {written(dimension)}", hint)

    def refuse(self, why: str, hint: str) -> None:
        """Say what does not fit."""
        raise UsageError(f"the formula {self.text!r} {why}", code="dimension", hint=hint)


def _times(dimension: "Dimension", times: float) -> "Dimension":
    from fractions import Fraction

    return tuple(power * Fraction(times).limit_denominator(1000) for power in dimension)
