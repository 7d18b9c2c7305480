"""Context for reading one leaf, and by-products of reading: notes, files, distributions."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping
    from typing import Any

    from dynamics_cli.core.inputs.uncertain.distributions import Distribution
    from dynamics_cli.quantities import Kind


class Token(str):
    """Text of a bare number in JSON or TOML, so that it is read exactly and once."""

    __slots__ = ()


class Context:
    """The environment, the folder files are found in, default units; notes, files and distributions met on the way."""

    def __init__(self, environ: "Mapping[str, str]", folder: str = "") -> None:
        self.environ = environ
        self.folder = folder
        self.notes: list[str] = []
        self.files: list[dict[str, Any]] = []
        # Distributions by address; None where only certain values are taken.
        self.uncertain: dict[str, Distribution] | None = None
        # Texts that are allowed to refer to files; None: all.
        self.references: tuple[str, ...] | None = None
        # Which inputs are results of earlier documents: file, address there, and its covariance.
        self.origins: dict[str, tuple[str, str, Any]] = {}
        self.default_units: Mapping[str, str] = {}
        # Points of the scene by their names.
        self.points: Mapping[str, Any] = {}
        # The axes of the scene, where it has some.
        self.axes = ""
        # How the caller writes the parameter at an address.
        self.spell: Callable[[str], str] = str

    def note(self, address: str, notes: "Iterable[str]") -> None:
        """Record how one input was interpreted, once for all numbers of a list."""
        list_address = address.rpartition("[")[0] if address.endswith("]") else address
        self.notes.extend(text for text in (f"{list_address}: {note}" for note in notes) if text not in self.notes)

    def named(self, names: "Iterable[str]", value: "dict[str, Any]") -> "dict[str, Any]":
        """The values of a record; without a name of its own it has that of the point where it is."""
        point = str(value.get("at")).strip() if self.points else ""
        return {"name": point, **value} if "name" in names and point in self.points else value

    def default_unit(self, kind: "Kind") -> str:
        """The unit that `[units]` gives to bare numbers of this kind, or nothing."""
        return self.default_units.get(kind.name, "")
