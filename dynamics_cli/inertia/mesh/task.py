"""Mass properties of a body bounded by triangles, or of a thin shell along them."""

from dynamics_cli.errors import require
from dynamics_cli.inertia.amount import Amount, OfArealDensity, OfMass, mass_of
from dynamics_cli.inertia.lump import Lump
from dynamics_cli.inertia.mesh.lift import Lift
from dynamics_cli.inertia.mesh.measured import measured, require_closed
from dynamics_cli.inertia.mesh.report import advice_of, checks_of, surface_of
from dynamics_cli.inertia.mesh.surface import LengthUnit
from dynamics_cli.inertia.properties import Axes, MassProperties, ProductSign, Shaft, View, named_point, properties
from dynamics_cli.inertia.rotation import Turn, matrix_of
from dynamics_cli.inertia.spread import SHOWN
from dynamics_cli.numerics.elementary import only_in_doubles
from dynamics_cli.quantities import InputFile, PartPosition, Size, Text
from dynamics_cli.records import Advice, Check, ErrorBound, Numerics

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import Any

METHOD = "divergence theorem over triangles by edges and centroids, in blocks; Jacobi on the second moments"
METHODS = {
    "once": METHOD,
    "again": METHOD + "; once more from the mass centre in the principal axes",
    "whole": "divergence theorem over few triangles in whole numbers, rounded once; Jacobi on the second moments",
}


def mesh(
    file: InputFile,
    /,
    *,
    length_unit: LengthUnit,
    amount: Amount,
    thickness: Size | None = None,
    allow_open: bool = False,
    diagnose: bool = False,
    about: Text = "centroid",
    about_point: PartPosition | None = None,
    axes: Axes = Axes("given"),  # noqa: B008
    turn: Turn | None = None,
    product_sign: ProductSign = ProductSign("negative"),  # noqa: B008
    shaft: Shaft | None = None,
) -> MassProperties:
    """Mass, centroid, inertia tensor and principal axes of a body given by the triangles of its surface.

    Equation
    --------
    V = Σ a·(e × f)/6; S = ρ ∫ r rᵀ dV = ρ Σ d·(p pᵀ + q qᵀ/18 + f fᵀ/24)/10 − m c cᵀ, d = a·(e × f), p = a + (e + f)/3,
    q = e − f/2; a shell has |e × f|/2 for d/10.

    Parameters
    ----------
    file : InputFile
        STL, binary or ASCII; OBJ, PLY, 3MF, GLB and others where trimesh is installed.
    length_unit : LengthUnit
        The unit of the file's numbers, which it does not say itself.
    amount : Amount
        Mass; or density or material of a solid or of a shell of given thickness; or areal density of a shell.
    thickness : Size
        Wall thickness, when the triangles are the middle of a thin wall and not the surface of a solid [m].
    allow_open : bool
        Answer for an open surface too; what is missing then counts as closed towards a point near the first triangles.
    diagnose : bool
        Count faulty edges, flipped, duplicated and degenerate triangles and say where they are; takes memory.
    about : Text
        What moments and products are about: centroid, or origin of the file.
    about_point : PartPosition
        Another point to refer them to, in the axes of the file [m].
    axes : Axes
        Axes of moments and products: given (the file's), or principal.
    turn : Turn
        How the axes of moments and products are turned from the file's.
    product_sign : ProductSign
        Sign of products: negative (Ixy = −∫ x y dm, the tensor's element) or positive (+∫ x y dm).
    shaft : Shaft
        A line to give the moment about, with WR², GD² and lbf·in·s².

    Returns
    -------
    MassProperties
        Everything about the body's mass, and `surface`.

    Raises
    ------
    InadmissibleError
        When the file is damaged, the surface is open, flipped in part or inside out, a coordinate is not finite, or a
        density is of the wrong dimension.

    Notes
    -----
    Bounds are of rounding, given the corners as stored. Up to 128 triangles the sums are formed in whole numbers and
    each result is rounded once; of more in doubles, with bounds calibrated by search. That the surface closes is proved
    by a 64-bit sum over its directed edges; it sees neither surfaces that cross one another nor a closed surface given
    twice. A thin shell has its mass on the triangles: the thickness makes mass, and is neglected against the size.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 7.2 to 7.9; the divergence theorem over
    triangles as in Eberly, Polyhedral mass properties (2002), and Mirtich, Fast and accurate computation of polyhedral
    mass properties, J. Graphics Tools 1(2) (1996).

    Examples
    --------
    >>> mesh("part.stl", length_unit=LengthUnit("mm"), amount=OfMass(mass=2.0)).volume  # doctest: +SKIP
    0.000120
    """
    numbers = list(_tracked((amount, thickness, about_point, turn, shaft)))
    only_in_doubles(*numbers)
    shell = thickness is not None or isinstance(amount, OfArealDensity)
    require(
        thickness is None or not isinstance(amount, OfArealDensity),
        "an areal density holds the thickness already",
        code="exclusive",
        hint="leave out the thickness, or give a density per volume",
    )
    require(thickness is None or thickness > 0.0, "a wall has a thickness", code="thickness")
    found = measured(file, shell=shell, diagnosed=diagnose)
    if not shell:
        require_closed(found, allowed=allow_open)
    require(
        found.moments.measure != 0.0,
        "the triangles {0}",
        "have no area" if shell else "enclose nothing",
        code="no-volume",
    )
    width = next((len(number.slopes) for number in numbers), None)
    lift = Lift(found, length_unit, width or 0)
    measure = lift.measure()
    body = measure * thickness if thickness is not None else measure
    dimension = 2 if shell and thickness is None else 3
    mass = mass_of(amount, body, dimension, "the shell" if shell else "the body")
    words, point = named_point(about, about_point)
    view = View(
        words,
        point,
        axes=axes,
        rotation=None if turn is None else matrix_of(turn),
        product_sign=product_sign,
        shaft=shaft,
    )
    # a density that is given need not come back from mass over measure, with the rounding of both
    given_mass = isinstance(amount, OfMass)
    density = mass / measure if given_mass else mass_of(amount, thickness if thickness is not None else 1.0, dimension)
    made = properties(
        Lump(mass, lift.centroid(), lift.second(density)),
        view,
        volume=None if shell else measure,
        area=measure if shell else None,
        spread=lift.spread(density),
        checks=checks_of(found, shell),
        advice=advice_of(found, shell=shell, wall=lift.in_file_unit(thickness)),
        numerics=Numerics(METHODS[found.way]),
    )
    whole = MassProperties(**{**made.__dict__, "surface": surface_of(found, lift)})
    return whole if width is not None else _plain(whole)


def _tracked(thing: "Any") -> "Iterator[Any]":
    """Every tracked number within arguments."""
    if hasattr(thing, "apply"):
        yield thing
    elif isinstance(thing, tuple):
        for part in thing:
            yield from _tracked(part)
    elif hasattr(thing, "fields"):
        for name in thing.fields:
            yield from _tracked(getattr(thing, name))


def _plain(made: MassProperties) -> MassProperties:
    """The record with floats for tracked numbers, and their bounds stated beside it."""
    bounds: list[ErrorBound] = []
    out = _floats(made, "", bounds)
    assert made.numerics is not None
    kept = Numerics(made.numerics.method, tuple(bounds))
    return MassProperties(**{**out.__dict__, "numerics": kept})


def _floats(thing: "Any", address: str, bounds: list[ErrorBound]) -> "Any":
    if hasattr(thing, "slopes"):
        if thing.value and thing.error < 0.5 * abs(thing.value):
            bounds.append(ErrorBound(address, thing.error / (abs(thing.value) - thing.error) + SHOWN))
        return thing.value
    if isinstance(thing, tuple):
        inner: list[ErrorBound] = []
        out = tuple(_floats(part, address, inner) for part in thing)
        if inner and len(inner) == sum(1 for _ in _tracked(thing)):
            bounds.append(ErrorBound(address, max(bound.bound for bound in inner)))
        return out
    if hasattr(thing, "fields") and not isinstance(thing, Check | Advice | Numerics):
        return type(thing)(
            **{
                name: _floats(getattr(thing, name), f"{address}.{name}" if address else name, bounds)
                for name in thing.fields
            }
        )
    return thing
