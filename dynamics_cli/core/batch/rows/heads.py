"""Heads of columns: the parameter that a column gives, and its unit."""

from dynamics_cli.core.batch.rows.case import Case
from dynamics_cli.core.inputs.sources.references import split_address
from dynamics_cli.core.output.csv_text import without_guard
from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.quantities import Kind


class Column:
    """A column of CSV: the path of the parameter it gives (none when it only passes through), and its unit."""

    __slots__ = ("address", "flag", "name", "path", "unit")

    def __init__(self, text: str, case: Case) -> None:
        self.name, self.unit = split_header(text)
        self.address = self.name.replace("-", "_")
        self.path: tuple[str | int, ...] = ()
        if self.address.startswith("results."):
            self.address = self.address.removeprefix("results.")
        try:
            steps = tuple(split_address(self.address))
        except UsageError:
            return
        option = case.task.options.get(str(steps[0]).replace("_", "-"))
        if steps[0] in case.names:
            self.path = steps
        elif option is not None and not option.repeats:
            # first_velocity[0]
            self.path = (*option.path, *steps[1:])
            self.address = ".".join(option.path) + self.address[len(str(steps[0])) :]

    def take_title(self, text: str, case: Case, taken: "set[tuple[str | int, ...]]") -> None:
        """Give the parameter that a title like `End speed (km/h)` or `distance_ft` means, if no other column does."""
        name, unit = split_title(text)
        path: tuple[str | int, ...] = (name,) if name in case.names else ()
        if not path:
            path, unit = split_suffix(text, case)
        if path and path not in taken:
            self.name = self.address = ".".join(map(str, path))
            self.unit, self.path = unit, path

    def raw(self, cell: str) -> "Any":
        """A cell as raw input; a bare number takes the header's unit."""
        cell = without_guard(cell)
        size, at, direction = cell.partition("@")
        if self.unit and size.rstrip()[-1:] in tuple("0123456789."):
            return f"{size} {self.unit} {at}{direction}" if at else f"{cell} {self.unit}"
        return cell

    @property
    def is_error(self) -> bool:
        """Whether it holds the errors of an earlier step."""
        return not self.path and self.address.split(".")[-1] == "error"


def split_header(text: str) -> "tuple[str, str]":
    """`distance[ft]` as its name and unit; `segments[1]` has no unit."""
    text = text.strip()
    name, bracket, unit = text.rpartition("[")
    if not bracket or not text.endswith("]") or (unit[:-1].isascii() and unit[:-1].isdigit()):
        return text, ""
    return name.strip(), unit[:-1].strip()


def split_title(text: str) -> "tuple[str, str]":
    """`End speed (km/h)` as the parameter's name that it may mean, and its unit."""
    name, unit = split_header(text)
    if not unit and name.endswith(")"):
        name, _, unit = name[:-1].partition("(")
    return name.strip().lower().replace(" ", "_").replace("-", "_"), unit.strip()


def split_suffix(text: str, case: Case) -> "tuple[tuple[str | int, ...], str]":
    """`distance_ft` as the path of the parameter and its unit, where the ending is a unit of it; or empty."""
    words = text.strip().replace("-", "_").replace(" ", "_").split("_")
    for size in (1, 2):
        option = case.task.options.get("-".join(words[:-size]).lower())
        if option is None or option.repeats or option.leaf is None or not option.leaf.kind.unit:
            continue
        # end_speed_km_h, torque_N_m
        for unit in dict.fromkeys(sign.join(words[-size:]) for sign in "/*"):
            if unit[:1].isalpha() and _fits(unit, option.leaf.kind):
                return option.path, unit
    return (), ""


def _fits(unit: str, kind: "Kind") -> bool:
    """Whether a parameter of this kind may have this unit: `lb` is one of a mass and of a force."""
    from dynamics_cli.core.inputs.quantity_text import read_scalar

    try:
        read_scalar(f"1 {unit}", kind)
    except UsageError as error:
        return error.code == "bounds"
    return True
