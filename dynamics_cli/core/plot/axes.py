"""Axes in the units they are shown in: SI numbers scaled and labelled."""

from dynamics_cli.core.shown import Shown

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from dynamics_cli.pictures import Axis


class Scale:
    """How an axis shows its SI numbers, and what it is called."""

    def __init__(self, axis: "Axis", system: str) -> None:
        self.factor, self.offset, unit = 1.0, 0.0, ""
        if axis.kind is not None:
            shown = Shown(axis.kind, axis.kind.shown_in(system))
            self.factor, unit = shown.width(1.0), shown.text
            self.offset = _number(shown.value(0.0))
        self.label = f"{axis.title} [{unit}]" if unit else axis.title
        self.logarithmic = axis.logarithmic

    def __call__(self, values: "Iterable[float]") -> "list[float]":
        """Numbers as shown."""
        return [self.factor * value + self.offset for value in values]

    def width(self, value: float) -> float:
        """A difference as shown."""
        return self.factor * value


def _number(value: "float | list[float]") -> float:
    return value if isinstance(value, float) else float(value)  # type: ignore[arg-type]


def finite(values: "Sequence[float]") -> "list[float]":
    """The numbers that are."""
    return [value for value in values if value - value == 0.0]
