"""The command `coords`: points with their units from one system of coordinates to another.

The physics (`coords.py`) is of plain numbers; whether a component is a length, a pure number or an angle depends on the
system, so units are dealt with here, exactly, and the rounding bounds with them.
"""

from dynamics_cli.convert import coords as physics
from dynamics_cli.core.units.conversion import from_si, to_si
from dynamics_cli.core.units.lookup import parse_unit
from dynamics_cli.core.units.unit import NUMBER, Unit, conformable
from dynamics_cli.errors import UsageError
from dynamics_cli.numerics.tracked import Tracked
from dynamics_cli.numerics.turns import turned
from dynamics_cli.quantities import Annotated, Remark
from dynamics_cli.records import Advice, Choice, Condition, ErrorBound, ExactQuantity, Measured, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

UNIT_ROUNDOFF = 2.0**-53
METRE = parse_unit("m")
RADIAN = parse_unit("rad")
DEGREE = parse_unit("deg")
NAMES = {"cartesian": ("x", "y", "z"), "cylindrical": ("r", "theta", "z"), "spherical": ("rho", "phi", "theta")}
ANGLES = ("theta", "phi")
CONVENTION = {
    "cartesian": "x, y, z right-handed",
    "cylindrical": "x = r cosθ, y = r sinθ, z",
    "spherical": "x = ρ sinφ cosθ, y = ρ sinφ sinθ, z = ρ cosφ: φ from the z-axis, θ in the x–y plane from x",
}


class System(Choice):
    """A system of coordinates."""

    names = ("cartesian", "cylindrical", "spherical")
    aliases = {  # noqa: RUF012
        **dict.fromkeys(("xyz", "cart", "rectangular"), "cartesian"),
        **{"cyl": "cylindrical", "polar": "cylindrical", "sph": "spherical"},
    }


@record
class Coordinates:
    """A point in the system asked for; angles in degrees unless the input's were in another unit."""

    x: Annotated[Measured | None, "Cartesian x."]
    y: Annotated[Measured | None, "Cartesian y."]
    r: Annotated[Measured | None, "Distance from the z-axis."]
    rho: Annotated[Measured | None, "Distance from the origin."]
    phi: Annotated[Measured | None, "Angle from the z-axis, 0 to π."]
    theta: Annotated[Measured | None, "Angle in the x–y plane from x, −π to π."]
    z: Annotated[Measured | None, "Height along the z-axis."]
    convention: Annotated[Remark, "What the angles mean."]
    numerics: Numerics
    advice: tuple[Advice, ...]


def coords(
    first: Annotated[ExactQuantity, "x, r or ρ: a length or a pure number, e.g. 3 m."],
    second: Annotated[
        ExactQuantity,
        "y (a length or a pure number), θ of cylindrical or φ of spherical coordinates, e.g. 30 deg.",
    ],
    third: Annotated[
        ExactQuantity | None, "z (a length or a pure number, 0 unless given) or θ of spherical coordinates, e.g. 2 m."
    ] = None,
    /,
    *,
    from_: Annotated[System, "The system the point is given in."],
    into: Annotated[System, "The system to convert to."],
) -> Coordinates:
    """Convert a point between Cartesian, cylindrical and spherical coordinates.

    Equation: x = r cosθ = ρ sinφ cosθ, y = r sinθ = ρ sinφ sinθ, z = ρ cosφ.

    Returns
    -------
    Coordinates
        The components by name; angles are 0 where the point leaves them undetermined, with a note.

    Raises
    ------
    UsageError
        When an angle has no unit, lengths and pure numbers are mixed, or both systems are the same.

    Notes
    -----
    Stable near the axes and for components from the smallest to the largest doubles.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 1.6.
    """
    if from_ == into:
        raise UsageError(f"from and into are both {from_}", parameter="into")
    components = _components(from_, first, second, third)
    lengths = _units(components)
    numbers = [_read(name, component, lengths) for name, component in components]
    # rows that are answered together have no bounds
    tracked = Tracked.inputs(numbers) if not any(hasattr(number, "ndim") for number in numbers) else numbers
    # the double of 90 deg in radians is not exactly a right angle; the typed value is
    turn = {"turn": turned} if from_ != "cartesian" and into != "spherical" and _in_turns(components) else {}
    converted = getattr(physics, f"{from_}_to_{into}")(*tracked, **turn)
    angle_unit = next((parse_unit(component.unit, RADIAN) for name, component in components if name in ANGLES), DEGREE)
    entries = {name: _show(name, getattr(converted, name), numbers, angle_unit, lengths) for name in NAMES[into]}
    empty = dict.fromkeys(("x", "y", "r", "rho", "phi", "theta", "z"))
    return Coordinates(
        **{**empty, **{name: entry[0] for name, entry in entries.items()}},
        convention=CONVENTION["spherical" if "spherical" in (from_, into) else "cylindrical"],
        numerics=Numerics(
            "closed form",
            tuple(entry[1] for entry in entries.values()),
            tuple(condition for entry in entries.values() for condition in entry[2]),
        ),
        advice=converted.advice,
    )


def _components(
    system: str, first: ExactQuantity, second: ExactQuantity, third: ExactQuantity | None
) -> tuple[tuple[str, ExactQuantity], ...]:
    """The components by name; a height not given is zero, and a unit after the last length holds for those before."""
    if third is None:
        if system == "spherical":
            raise UsageError("theta is missing", parameter="third", code="missing", hint="for example 30 deg")
        third = ExactQuantity(0, 1, first.unit)
    named = tuple(zip(NAMES[system], (first, second, third), strict=True))
    if system == "spherical" or not third.unit or any(part.unit for name, part in named[:2] if name not in ANGLES):
        return named
    return tuple((name, part if part.unit or name in ANGLES else _in_unit(part, third.unit)) for name, part in named)


def _in_unit(number: ExactQuantity, unit: str) -> ExactQuantity:
    return ExactQuantity(number.numerator, number.denominator, unit)


def _units(components: tuple[tuple[str, ExactQuantity], ...]) -> Unit:
    """The unit of the lengths, the first one's; pure numbers where none has one."""
    lengths = [(name, component) for name, component in components if name not in ANGLES]
    pure = [name for name, component in lengths if not component.unit]
    if pure and len(pure) < len(lengths):
        raise UsageError(
            f"{pure[0]} has no unit, the others have one", parameter=pure[0], hint="give all a length unit, or none"
        )
    return parse_unit(lengths[0][1].unit, METRE) if not pure else NUMBER


def _in_turns(components: tuple[tuple[str, ExactQuantity], ...]) -> bool:
    """Whether angles were given in parts of a turn, such as degrees."""
    return all(parse_unit(component.unit, RADIAN).pi == 1 for name, component in components if name in ANGLES)


def _read(name: str, component: ExactQuantity, lengths: Unit) -> float:
    expected = RADIAN if name in ANGLES else METRE if lengths is not NUMBER else NUMBER
    if name in ANGLES and not component.unit:
        raise UsageError(f"{name} is an angle and has no unit", parameter=name, hint="for example 30 deg")
    unit = parse_unit(component.unit, expected)
    if not conformable(unit, expected):
        from dynamics_cli.core.units.names import explain_mismatch

        message, hint = explain_mismatch(unit, expected)
        raise UsageError(message, parameter=name, hint=hint)
    return to_si(component.numerator, component.denominator, unit) if component.si is None else component.si


def _show(
    name: str, component: "Any", inputs: list[float], angle_unit: Unit, lengths: Unit
) -> tuple[Measured, ErrorBound, tuple[Condition, ...]]:
    """A component in its unit, with its bound and its condition numbers."""
    unit, coherent = (angle_unit, "rad") if name in ANGLES else (lengths, "m" if lengths is not NUMBER else "")
    converts = unit.text != coherent
    if hasattr(component, "ndim"):
        return Measured(_of_rows(component, unit) if converts else component, unit.text), ErrorBound(name, 0.0), ()
    number = component if isinstance(component, Tracked) else Tracked(component, 0.0, (0.0,) * 3)
    value = from_si(number.value, unit) if converts else number.value
    if number.value == 0.0:
        return Measured(value, unit.text, inherited=True), ErrorBound(name, number.error, relative=False), ()
    bound = number.error / abs(number.value) + (UNIT_ROUNDOFF if converts else 0.0)
    conditions = tuple(
        Condition(name, parameter, slope * entered / number.value)
        for parameter, slope, entered in zip(("first", "second", "third"), number.slopes, inputs, strict=True)
    )
    return Measured(value, unit.text, inherited=True), ErrorBound(name, bound), conditions


def _of_rows(numbers: "Any", unit: Unit) -> "Any":
    """Numbers of many rows in a unit, each rounded once."""
    from dynamics_cli.numerics.exact.factors import Factor, scale

    return scale(numbers, Factor(unit.denominator, unit.numerator, -unit.pi), lambda value: from_si(value, unit))
