"""Comparison of two bodies: masses, mass centres, principal moments, and the rotation between their principal axes."""

from math import inf

from dynamics_cli.errors import DynamicsError, require
from dynamics_cli.inertia.assembly.assembly import Assembly, compose_scene
from dynamics_cli.inertia.assembly.parts import each_number
from dynamics_cli.inertia.assembly.report import stated
from dynamics_cli.inertia.bodies.mass_moments import tensor_of
from dynamics_cli.inertia.bodies.principal_tracked import in_many_digits
from dynamics_cli.numerics.elementary import atan2, hypot, sqrt, total
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.orientation.rotations import product, transposed
from dynamics_cli.numerics.vectors import subtract
from dynamics_cli.quantities import (
    Angle,
    Annotated,
    Mass,
    PartPosition,
    ProductOfInertia,
    Ratio,
    Remark,
    SignedMass,
    Size,
    Text,
)
from dynamics_cli.records import Advice, ErrorBound, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.inertia.bodies.compose import Composed
    from dynamics_cli.inertia.bodies.mass_moments import Matrix

UNIT_ROUNDOFF = 2.0**-53
# Bounds of more roundings than this are worth a second pass.
ROOM = 50.0
# Rounding of the products of unit vectors behind the rotation between two frames.
TURN_ROUNDINGS = 32.0
SIGNS = ((1.0, 1.0, 1.0), (1.0, -1.0, -1.0), (-1.0, 1.0, -1.0), (-1.0, -1.0, 1.0))


@record
class Pair:
    """Two bodies."""

    first: Annotated[Assembly, "One body."]
    second: Annotated[Assembly, "The other body, in the same frame."]


@record
class MomentRow:
    """One moment or product of both bodies."""

    moment: Annotated[
        Text, "Which one: xx to zx about each body's mass centre in the common axes, or a principal moment."
    ]
    first: Annotated[ProductOfInertia, "Of the first body [kg*m^2]."]
    second: Annotated[ProductOfInertia, "Of the second body [kg*m^2]."]
    difference: Annotated[ProductOfInertia, "Second less first [kg*m^2]."]
    ratio: Annotated[Ratio | None, "Second over first [-]."] = None


@record
class Compared:
    """The differences of two bodies."""

    first_mass: Annotated[Mass, "Mass of the first body [kg]."]
    second_mass: Annotated[Mass, "Mass of the second body [kg]."]
    mass_difference: Annotated[SignedMass, "Second less first [kg]."]
    mass_ratio: Annotated[Ratio, "Second over first [-]."]
    centroid_shift: Annotated[PartPosition, "From the first mass centre to the second [m]."]
    centroid_distance: Annotated[Size, "Its length [m]."]
    axes_angle: Annotated[
        Angle | None, "The smallest turn that takes the principal axes of the first to those of the second [rad]."
    ]
    tensor_distance: Annotated[
        Ratio, "Size of the difference of the two inertia tensors over that of the first: 0 when they are equal [-]."
    ]
    product_sign: Annotated[Remark, "Sign convention of the products."]
    moments: Annotated[tuple[MomentRow, ...], "Moments and products of both."]
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


def compare(scene: Annotated[Pair, "The bodies, `first` and `second`, each with its parts."], /) -> Compared:
    """Two bodies compared: mass, mass centre, moments about each one's own mass centre, and principal axes.

    Returns
    -------
    Compared
        Differences and ratios, second against first.

    Raises
    ------
    InadmissibleError
        When the mass of one is zero.

    Notes
    -----
    Principal axes have no sense, so the turn between them is the smallest of four; where moments are equal the axes
    are not determined and no angle is given.

    Examples
    --------
    >>> from dynamics_cli.inertia.bodies.amount import OfMass
    >>> from dynamics_cli.inertia.assembly.parts import Part
    >>> from dynamics_cli.inertia.shapes import Block
    >>> block = Part(shape=Block(width=1.0, depth=2.0, height=3.0), amount=OfMass(mass=2.0))
    >>> double = Part(shape=Block(width=1.0, depth=2.0, height=3.0), amount=OfMass(mass=4.0))
    >>> compare(Pair(first=Assembly(parts=(block,)), second=Assembly(parts=(double,)))).mass_ratio
    2.0
    """
    a, b = compose_scene(scene.first), compose_scene(scene.second)
    shift = subtract(b.lump.centroid, a.lump.centroid)
    rows = tuple(_row(*row) for row in _numbers(a, b))
    angle, advice = _angle(a, b)
    tilt = None if angle is None or in_many_digits(a.spread.axes) else _turn_error(scene, a, b, angle)
    first, second = a.lump.mass, b.lump.mass
    results = {
        "first_mass": first,
        "second_mass": second,
        "mass_difference": second - first,
        "mass_ratio": second / first,
        "centroid_distance": hypot(hypot(shift[0], shift[1]), shift[2]),
        "tensor_distance": _distance(rows),
    }
    bounds: list[ErrorBound] = []
    scalars = results if a.sloped else {name: stated(name, value, bounds) for name, value in results.items()}
    if tilt is not None and tilt < 0.5:
        bounds.append(ErrorBound("axes_angle", tilt, relative=False))
    return Compared(
        **scalars,
        centroid_shift=shift,
        axes_angle=angle,
        product_sign="negative: Ixy = -∫ x y dm",
        moments=rows,
        advice=advice,
        numerics=Numerics("composition of each about its mass centre; Jacobi rotations", tuple(bounds)),
    )


def _numbers(a: "Composed", b: "Composed") -> "list[tuple[str, float, float]]":
    first, second = tensor_of(a.lump.second), tensor_of(b.lump.second)
    names = (("xx", 0, 0), ("yy", 1, 1), ("zz", 2, 2), ("xy", 0, 1), ("yz", 1, 2), ("zx", 2, 0))
    rows = [(name, first[i][j], second[i][j]) for name, i, j in names]
    return rows + [(f"principal {k + 1}", a.spread.moments[k], b.spread.moments[k]) for k in range(3)]


def _row(name: str, first: float, second: float) -> MomentRow:
    return MomentRow(name, first, second, second - first, second / first if first > 0.0 or first < 0.0 else None)


def _distance(rows: "tuple[MomentRow, ...]") -> float:
    """Frobenius norm of the difference, relative to that of the first."""
    weights = (1.0, 1.0, 1.0, 2.0, 2.0, 2.0)
    away = total(w * row.difference * row.difference for w, row in zip(weights, rows, strict=False))
    size = total(w * row.first * row.first for w, row in zip(weights, rows, strict=False))
    require(size > 0.0, "the first body has no inertia to compare with: it is one point", code="point")
    if away > 0.0:
        return sqrt(away / size)
    error = getattr(away, "error", 0.0)
    # differences that are all zero: of their tracked squares only the errors remain
    return type(away)(0.0, (error / (plain(size) - size.error)) ** 0.5, away.slopes) if error else 0.0  # type: ignore[attr-defined, call-arg]


def _angle(a: "Composed", b: "Composed") -> "tuple[float | None, tuple[Advice, ...]]":
    words = [side.spread.degeneracy for side in (a, b) if not side.spread.degeneracy.startswith("none")]
    if words:
        message = f"no angle between principal axes: {words[0]}"
        return (None, (Advice("axes-undetermined", message, severity="note", result="axes_angle"),))
    return min(turn_between(a.spread.axes, b.spread.axes, signs) for signs in SIGNS), ()


def _turn_error(scene: Pair, a: "Composed", b: "Composed", angle: float) -> float:
    """Error of the angle between the axes: from the tilts of both, or as measured in many digits."""
    tilt = _tilt(a) + _tilt(b) + TURN_ROUNDINGS * UNIT_ROUNDOFF
    if not ROOM * UNIT_ROUNDOFF * (1.0 + angle) < tilt < inf:
        return tilt
    from dynamics_cli.numerics.exact.many_digits import ManyDigits, measured_error, run
    from dynamics_cli.numerics.tracked import Tracked

    first, second = each_number((scene.first, scene.second), lambda x: ManyDigits.inputs((x.value,))[0], Tracked)
    try:
        exact = run(lambda: _angle(compose_scene(first), compose_scene(second))[0])
    except (DynamicsError, ArithmeticError):
        return tilt
    return tilt if exact is None else measured_error(angle, exact, tilt)


def _tilt(composed: "Composed") -> float:
    """Possible rotation of the principal axes from the true ones; infinite if unknown.

    A turn by ω moves the three by |ω × eₖ|, whose squares add up to 2 ω².
    """
    tilts = composed.spread.tilts
    return inf if tilts is None else float((0.5 * sum(tilt * tilt for tilt in tilts)) ** 0.5)


def turn_between(a: "Matrix", b: "Matrix", signs: "tuple[float, ...]") -> float:
    """The angle of rotation from one set of axes to another, for given senses."""
    changed = tuple(tuple(s * x for x in row) for s, row in zip(signs, b, strict=True))
    r = product(transposed(changed), a)  # type: ignore[arg-type]
    sine = hypot(hypot(r[2][1] - r[1][2], r[0][2] - r[2][0]), r[1][0] - r[0][1])
    return atan2(sine, r[0][0] + r[1][1] + r[2][2] - 1.0)
