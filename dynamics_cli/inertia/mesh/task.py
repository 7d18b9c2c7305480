"""Mass properties of a body bounded by triangles, or of a thin shell along them."""

from dynamics_cli.errors import require
from dynamics_cli.inertia.bodies.amount import Amount, OfArealDensity, OfMass, mass_of
from dynamics_cli.inertia.bodies.mass_moments import Lump
from dynamics_cli.inertia.bodies.principal_tracked import SHOWN
from dynamics_cli.inertia.bodies.properties import Axes, MassProperties, ProductSign, properties, view_of
from dynamics_cli.inertia.bodies.records import Shaft
from dynamics_cli.inertia.mesh.measurement import measured, require_closed, require_extent, unit_of
from dynamics_cli.inertia.mesh.report import advice_of, checks_of, surface_of
from dynamics_cli.inertia.mesh.surface import LengthUnit
from dynamics_cli.inertia.mesh.tracked_integrals import Lift
from dynamics_cli.numerics.elementary import only_in_doubles
from dynamics_cli.numerics.number import carriers, is_tracked
from dynamics_cli.numerics.orientation.rotations import Turn
from dynamics_cli.quantities import Annotated, InputFile, PartPosition, Size, Text
from dynamics_cli.records import Advice, Check, ErrorBound, Numerics

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

METHOD = "divergence theorem over triangles by edges and centroids, in blocks; Jacobi on the second moments"
METHODS = {
    "once": METHOD,
    "again": METHOD + "; once more from the mass centre in the principal axes",
    "whole": "divergence theorem over few triangles in whole numbers, rounded once; Jacobi on the second moments",
}


def mesh(
    file: Annotated[
        InputFile, "STL, binary or ASCII; OBJ, PLY, 3MF, GLB, GLTF and OFF where trimesh is installed, e.g. part.stl."
    ],
    /,
    *,
    length_unit: Annotated[LengthUnit | None, "Unit of the file's numbers; a 3MF file states its own."] = None,
    amount: Annotated[
        Amount, "Mass; or density or material of a solid or of a shell of given thickness; or areal density of a shell."
    ],
    thickness: Annotated[
        Size | None,
        "Wall thickness, when the triangles are the middle of a thin wall and not the surface of a solid, e.g. 1.5 mm.",
    ] = None,
    allow_open: Annotated[
        bool,
        "Accept an open surface, treated as if closed towards a point near its first triangles.",
    ] = False,
    flip: Annotated[bool, "Reverse all triangles: for a closed surface that is inside out."] = False,
    diagnose: Annotated[
        bool,
        "Look for faulty edges, flipped, duplicated and crossing triangles and overlaps. Done always where it takes up "
        "to about 0.3 s: for 20,000 triangles of even shapes, 1,000 long ones. 100,000 even ones take about 2 s.",
    ] = False,
    about: Annotated[Text, "Reference point of moments and products: centroid, or origin of the file."] = "centroid",
    about_point: Annotated[PartPosition | None, "Another point to refer them to, in the axes of the file [m]."] = None,
    axes: Annotated[Axes, "Axes of moments and products: given (the file's), or principal."] = Axes("given"),  # noqa: B008
    turn: Annotated[Turn | None, "How the axes of moments and products are turned from the file's."] = None,
    product_sign: Annotated[
        ProductSign, "Sign of products: negative (Ixy = −∫ x y dm, the tensor's element) or positive (+∫ x y dm)."
    ] = ProductSign("negative"),  # noqa: B008
    shaft: Annotated[Shaft | None, "A line to give the moment about, with WR², GD² and lbf·in·s²."] = None,
) -> MassProperties:
    """Mass, centroid, inertia tensor and principal axes of a body given by the triangles of its surface.

    Equation
    --------
    V = Σ a·(e × f)/6; S = ρ ∫ r rᵀ dV = ρ Σ d·(p pᵀ + q qᵀ/18 + f fᵀ/24)/10 − m c cᵀ, d = a·(e × f), p = a + (e + f)/3,
    q = e − f/2; a shell has |e × f|/2 for d/10.

    Returns
    -------
    MassProperties
        The mass properties of the body, and its `surface`.

    Raises
    ------
    InadmissibleError
        When the file is damaged, the surface is open, flipped in part or inside out, a coordinate is not finite, or a
        density is of the wrong dimension.

    Notes
    -----
    Bounds are of rounding, given the corners as stored. Up to 128 triangles the sums are formed in whole numbers and
    each result is rounded once; of more in doubles, with bounds calibrated by search. That the surface closes is proved
    by a 64-bit sum over its directed edges; crossing, overlapping or duplicated surfaces are found by the diagnosis.
    A thin shell has its mass on the triangles: the thickness only determines the mass.

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
    numbers = list(carriers((amount, thickness, about_point, turn, shaft)))
    only_in_doubles(*numbers)
    _require_thickness(amount, thickness)
    shell = thickness is not None or isinstance(amount, OfArealDensity)
    measurement = measured(file, shell=shell, diagnosed=diagnose)
    if not shell:
        require_closed(measurement, allowed=allow_open, flip=flip)
    require_extent(measurement, shell=shell)
    width = next((len(number.slopes) for number in numbers), None)
    lift = Lift(measurement, unit_of(measurement, length_unit), width or 0)
    measure = lift.measure()
    mass, density = _mass_and_density(amount, measure, thickness, shell=shell)
    view = view_of(about, about_point, turn, axes=axes, product_sign=product_sign, shaft=shaft)
    report = properties(
        Lump(mass, lift.centroid(), lift.second(density)),
        view,
        volume=None if shell else measure,
        area=measure if shell else None,
        spread=lift.spread(density),
        checks=checks_of(measurement, shell),
        advice=advice_of(measurement, shell=shell, wall=lift.in_file_unit(thickness)),
        numerics=Numerics(METHODS[measurement.way]),
    )
    with_surface = MassProperties(**{**report.__dict__, "surface": surface_of(measurement, lift)})
    return with_surface if width is not None else _plain(with_surface)


def _require_thickness(amount: Amount, thickness: float | None) -> None:
    require(
        thickness is None or not isinstance(amount, OfArealDensity),
        "an areal density already includes the thickness",
        code="exclusive",
        hint="leave out the thickness, or give a density per volume",
    )
    require(thickness is None or thickness > 0.0, "the thickness must be greater than zero", code="thickness")


def _mass_and_density(amount: Amount, measure: float, thickness: float | None, *, shell: bool) -> "tuple[float, float]":
    """The mass, and the mass per measure of the surface or the solid."""
    dimension = 2 if shell and thickness is None else 3
    volume = measure if thickness is None else measure * thickness
    mass = mass_of(amount, volume, dimension, "the shell" if shell else "the body")
    # a density that is given is not taken from mass over measure, which has the rounding of both
    if isinstance(amount, OfMass):
        return mass, mass / measure
    return mass, mass_of(amount, 1.0 if thickness is None else thickness, dimension)


def _plain(report: MassProperties) -> MassProperties:
    """The record with floats for tracked numbers, and their bounds stated beside it."""
    bounds: list[ErrorBound] = []
    out = _floats(report, "", bounds)
    assert report.numerics is not None
    numerics = Numerics(report.numerics.method, (*bounds, *report.numerics.bounds))
    return MassProperties(**{**out.__dict__, "numerics": numerics})


def _floats(value: "Any", address: str, bounds: list[ErrorBound]) -> "Any":
    if is_tracked(value):
        if value.value and value.error < 0.5 * abs(value.value):
            bounds.append(ErrorBound(address, value.error / (abs(value.value) - value.error) + SHOWN))
        return value.value
    if isinstance(value, tuple):
        inner: list[ErrorBound] = []
        out = tuple(_floats(part, address, inner) for part in value)
        if inner and len(inner) == sum(1 for _ in carriers(value)):
            bounds.append(ErrorBound(address, max(bound.bound for bound in inner)))
        return out
    if hasattr(value, "fields") and not isinstance(value, Check | Advice | Numerics):
        return type(value)(
            **{
                name: _floats(getattr(value, name), f"{address}.{name}" if address else name, bounds)
                for name in value.fields
            }
        )
    return value
