"""Axes in the units they are shown in: SI numbers scaled and labelled."""

from math import floor, log10

from dynamics_cli.core.documents import quantity
from dynamics_cli.core.units.display import Shown
from dynamics_cli.errors import Wording, filled

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from dynamics_cli.pictures import Axis, Ruler
    from dynamics_cli.quantities import Kind


class Scale:
    """Conversion of an axis's SI numbers to the numbers shown, and its label."""

    def __init__(self, axis: "Axis", system: str) -> None:
        self.factor, self.offset, unit = 1.0, 0.0, ""
        self.system = system
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


def words(text: str, system: str) -> str:
    """A title or a label, its typed values in the units of a system."""
    if not isinstance(text, Wording):
        return text

    def write(value: float, kind: "Kind", digits: int) -> str:
        shown = Shown(kind, kind.shown_in(system))
        return quantity(_number(shown.value(value)), shown.text, digits)

    return filled(text.template, text.values, write)


def rounded(ruler: "Ruler", system: str) -> "tuple[float, str]":
    """The metres of a scale and its words: the greatest round number of the unit shown that has room."""
    shown = Shown(ruler.kind, ruler.kind.shown_in(system))
    each = ruler.per / shown.width(1.0)
    most = ruler.longest / each
    power = 10.0 ** floor(log10(most))
    number = next((digit * power for digit in (5.0, 2.0) if digit * power <= most), power)
    return number * each, f"{ruler.title}: {quantity(number, shown.text, 1)}"


def _number(value: "float | list[float]") -> float:
    return value if isinstance(value, float) else float(value)  # type: ignore[arg-type]


def finite(values: "Sequence[float]") -> "list[float]":
    """The finite numbers."""
    return [value for value in values if value - value == 0.0]


def sentence(text: str) -> str:
    """A title, its first letter large where it begins a word."""
    return text[:1].upper() + text[1:] if text[1:2].isalpha() or text.startswith("a ") else text
