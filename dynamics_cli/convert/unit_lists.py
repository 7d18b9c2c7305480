"""The units known: listed by kind, one shown whole, searched by name; and the book's own conversion table."""

from fractions import Fraction

from dynamics_cli.core.units.conversion import nearest
from dynamics_cli.core.units.lookup import candidates
from dynamics_cli.core.units.names import all_units, conformable_names, kind_name, si_name
from dynamics_cli.core.units.near_names import names_like
from dynamics_cli.errors import UsageError
from dynamics_cli.quantities import Annotated, Count, Ratio, Text
from dynamics_cli.records import Choice, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.core.units.unit import Unit


@record
class UnitEntry:
    """One unit."""

    unit: Annotated[Text, "Its symbol."]
    kind: Annotated[Text, "What it measures."]
    size: Annotated[Text, "SI units in one of it; … where more digits follow."]
    si: Annotated[Text, "The SI unit."]
    factor: Annotated[Text, "The size exactly, as a fraction."]
    zero: Annotated[Text | None, "The SI value at its zero, for temperatures."]
    names: Annotated[Text, "Every spelling, prefixes apart."]


@record
class UnitList:
    """Units found."""

    count: Annotated[Count, "How many."]
    units: Annotated[tuple[UnitEntry, ...], "The units."]


@record
class UnitShown:
    """One unit in full; one reading for each thing its name may mean."""

    readings: Annotated[tuple[UnitEntry, ...], "What the unit means."]
    conformable: Annotated[Text, "Units that it converts to."]


class Table(Choice):
    """A published table of conversion factors."""

    names = ("josephs-huston",)
    aliases = {"book": "josephs-huston"}  # noqa: RUF012


@record
class TableRow:
    """One row of the book's table."""

    quantity: Annotated[Text, "The book's name of the kind."]
    from_unit: Annotated[Text, "Unit converted from, as printed."]
    to_unit: Annotated[Text, "Unit converted to, as printed."]
    printed: Annotated[Text, "The factor as printed."]
    factor: Annotated[Ratio, "The correct factor, correctly rounded."]
    exact: Annotated[Text, "The correct factor exactly."]
    note: Annotated[Text, "What is wrong with the printed factor, or what it is based on."]


@record
class BookTable:
    """The book's table of conversion factors beside the exact ones."""

    count: Annotated[Count, "Rows."]
    misprints: Annotated[Count, "Rows whose printed factor is a misprint."]
    inexact: Annotated[Count, "Rows whose last printed digit is off or was cut."]
    rows: Annotated[tuple[TableRow, ...], "The rows."]


def list_units(
    *, kind: Annotated[Text | None, "Kind of quantity to list: length, speed, torque, moment of inertia, …"] = None
) -> UnitList:
    """List the common units, all or of one kind.

    Raises
    ------
    UsageError
        When no unit is of that kind.
    """
    entries = [_entry(unit, names, symbol) for symbol, names, unit, _ in all_units()]
    if kind is not None:
        query = kind.strip().lower().replace("_", " ").replace("-", " ")
        kinds = sorted({entry.kind for entry in entries})
        entries = [entry for entry in entries if query == entry.kind or query in entry.kind.split(" or ")]
        if not entries:
            from dynamics_cli.core.units.near_names import nearest_words

            near = nearest_words(query, kinds)
            hint = f"did you mean {' or '.join(near)}?" if near else f"kinds are {', '.join(kinds)}"
            raise UsageError(f"there is no kind of unit {kind!r}", parameter="kind", hint=hint)
    return UnitList(len(entries), tuple(entries))


def show_unit(name: Annotated[Text, "A unit or an expression of units: slug, lbf*ft, ft/sec2."], /) -> UnitShown:
    """Show the exact definition of a unit, and the units it converts to.

    Raises
    ------
    UsageError
        When it is unknown.
    """
    readings = candidates(name)
    spelled = {symbol: names for symbol, names, _, _ in all_units()}
    return UnitShown(
        tuple(_entry(unit, spelled.get(unit.text, ()), name) for unit in readings),
        ", ".join(dict.fromkeys(other for unit in readings for other in conformable_names(unit))),
    )


def search_units(text: Annotated[Text, "Text to look for."], /) -> UnitList:
    """Search the common units by any part of a name, a description or a kind.

    Raises
    ------
    UsageError
        When nothing is found; near names are offered.
    """
    query = text.strip().lower()
    entries = [
        _entry(unit, names, symbol)
        for symbol, names, unit, description in all_units()
        if any(query in word.lower() for word in (symbol, *names, description, kind_name(unit)))
    ]
    if not entries:
        near = names_like(text)
        hint = f"did you mean {' or '.join(near)}?" if near else "dynamics units list shows them all"
        raise UsageError(f"no unit has {text!r} in its name or kind", parameter="text", hint=hint)
    return UnitList(len(entries), tuple(entries))


def book_table(name: Annotated[Table, "The table: josephs-huston, the book's table 1.7.1."], /) -> BookTable:
    """Print a published table of conversion factors with the exact ones, and mark its misprints.

    Notes
    -----
    The book's rows for `g` rest on 32.2 ft/s², not on standard gravity, and say so.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, table 1.7.1.
    """
    rows = tuple(map(_row, _book_lines()))
    return BookTable(
        len(rows),
        sum("misprint" in row.note for row in rows),
        sum("digit" in row.note and "misprint" not in row.note for row in rows),
        rows,
    )


def _entry(unit: "Unit", names: tuple[str, ...], text: str) -> UnitEntry:
    n, d = unit.numerator, unit.denominator
    power = {0: "", 1: "·π", -1: "/π"}.get(unit.pi, f"·π^{unit.pi}")
    zero = None
    if unit.offset[0]:
        zero = f"{unit.offset[0]}/{unit.offset[1]}"
    near = nearest(n, d, unit.pi)
    size = f"{near:.17g}" if near.is_integer() else repr(near)
    exactly = not unit.pi and Fraction(size) == Fraction(n, d)
    return UnitEntry(
        unit=text,
        kind=kind_name(unit),
        size=size + ("" if exactly else "…"),
        si=si_name(unit),
        factor=(str(n) if d == 1 else f"{n}/{d}") + power,
        zero=zero,
        names=", ".join(names),
    )


def _book_lines() -> list[list[str]]:
    from importlib.resources import files

    text = files(__package__).joinpath("data", "josephs_huston_table_1_7_1.csv").read_text(encoding="utf-8")
    return [line.split(",", 6) for line in text.splitlines()][1:]


def _row(cells: list[str]) -> TableRow:
    quantity, source, target, printed, _, exact, note = cells
    top, _, bottom = exact.partition("/")
    pi = (top == "pi") - (bottom == "pi")
    numerator = 1 if top == "pi" else int(top)
    denominator = 1 if bottom == "pi" else int(bottom or 1)
    factor = nearest(numerator, denominator, pi)
    return TableRow(quantity, source, target, printed, factor, exact.replace("pi", "π").removesuffix("/1"), note)
