"""Mass properties of a body bounded by triangles, or of a thin shell along them."""

import os

from dynamics_cli.errors import require
from dynamics_cli.inertia.amount import Amount, OfArealDensity, OfMass, mass_of
from dynamics_cli.inertia.lump import Lump
from dynamics_cli.inertia.mesh.surface import Faults, LengthUnit, Surface
from dynamics_cli.inertia.principal import principal
from dynamics_cli.inertia.properties import Axes, MassProperties, ProductSign, Shaft, View, named_point, properties
from dynamics_cli.inertia.rotation import Turn, matrix_of
from dynamics_cli.inertia.spread import Spread
from dynamics_cli.numerics.tracked import UNIT_ROUNDOFF, Tracked
from dynamics_cli.quantities import InputFile, PartPosition, Size, Text
from dynamics_cli.records import Advice, Check, ErrorBound, Numerics

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import Any

    from dynamics_cli.inertia.mesh.integrals import Moments, Sums
    from dynamics_cli.inertia.mesh.stl import Source

# A body this much thinner one way than another is integrated once more in its principal axes; the second ratio is for
# small files, where that costs nothing that can be felt.
GRADED, FELT = 1e-4, 0.25
SMALL = 100_000
# Single precision this coarse against the mean edge is worth a warning.
COARSE = 1e-3
METHOD = "divergence theorem over triangles by edges and centroids, in blocks; Jacobi on the second moments"
AGAIN = METHOD + "; once more from the mass centre in the principal axes"


class Measured:
    """A mesh read, proved and integrated, in the unit of its file."""

    def __init__(self, name: str, *, shell: bool, diagnosed: bool) -> None:
        from dynamics_cli.inertia.mesh.integrals import first_pass, second_pass
        from dynamics_cli.inertia.mesh.opening import open_mesh

        source = open_mesh(name)
        self.form = source.form
        self.single = source.single
        self.sums, self.moments = first_pass(source, shell=shell, prove=not shell)
        self.again = False
        self.faults: Faults | None = None
        if diagnosed:
            from dynamics_cli.inertia.mesh.diagnosis import diagnose

            self.faults = diagnose(source)
        if self.moments.measure and self._graded():
            first = self.moments
            axes = principal(_rows(first.second if first.measure > 0.0 else -first.second)).axes
            self.moments = second_pass(source, self.sums, first, _array(axes))
            self.again = True

    def _graded(self) -> bool:
        seconds = principal(_rows(self.moments.second * (1.0 if self.moments.measure > 0.0 else -1.0))).seconds
        return seconds[2] < (FELT if self.sums.count <= SMALL else GRADED) * seconds[0]

    @property
    def closed(self) -> bool:
        """Whether every edge is met by one the other way."""
        return self.sums.boundary is not None and self.sums.boundary.empty


# The last file integrated: the trials of an uncertain density do not read it again.
_LAST: "dict[tuple[Any, ...], Measured]" = {}


def measured(name: str, *, shell: bool, diagnosed: bool = False) -> Measured:
    """Integrate over a file, unless it was the last one and has not changed."""
    state = os.stat(name)
    key = (name, state.st_mtime_ns, state.st_size, shell, diagnosed)
    if key not in _LAST:
        made = Measured(name, shell=shell, diagnosed=diagnosed)
        _LAST.clear()
        _LAST[key] = made
    return _LAST[key]


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
    Bounds are of rounding, given the corners as stored. That the surface closes is proved by a 64-bit sum over its
    directed edges; it sees neither surfaces that cross one another nor a closed surface given twice. A thin shell has
    its mass on the triangles: the thickness makes mass, and is neglected against the size.

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
    given = (amount, thickness, about_point, turn, shaft)
    width = next((len(number.slopes) for number in _tracked(given)), None)
    lift = _Lift(found, length_unit, width or 0)
    measure = lift.measure()
    body = measure * thickness if thickness is not None else measure
    mass = mass_of(amount, body, 2 if shell and thickness is None else 3, "the shell" if shell else "the body")
    words, point = named_point(about, about_point)
    view = View(
        words,
        point,
        axes=axes,
        rotation=None if turn is None else matrix_of(turn),
        product_sign=product_sign,
        shaft=shaft,
    )
    density = mass / measure
    made = properties(
        Lump(mass, lift.centroid(), lift.second(density)),
        view,
        volume=None if shell else measure,
        area=measure if shell else None,
        spread=lift.spread(density),
        checks=_checks(found, shell),
        advice=_advice(found, shell),
        numerics=Numerics(AGAIN if found.again else METHOD),
    )
    whole = MassProperties(**{**made.__dict__, "surface": _surface(found, lift)})
    return whole if width is not None else _plain(whole)


class _Lift:
    """A mesh's integrals in SI, each with its bound and no slopes."""

    def __init__(self, found: Measured, unit: LengthUnit, width: int) -> None:
        self.found = found
        self.moments = found.moments
        self.slopes = (0.0,) * width
        self.ratio = unit.ratio

    def number(self, value: float, error: float, power: int) -> float:
        """A number in the file's unit to some power, as a tracked number in metres to that power."""
        up, down = self.ratio
        tracked = Tracked(float(value), float(error), self.slopes)
        for _ in range(abs(power)):
            up, down = up * self.ratio[0], down * self.ratio[1]
        return tracked * (up / self.ratio[0]) / (down / self.ratio[1])  # type: ignore[return-value]

    def measure(self) -> float:
        """Volume or area."""
        own = self.moments
        return self.number(abs(own.measure), own.measure_error, 2 if own.shell else 3)

    def point(self, values: "Any", errors: "Any") -> "tuple[float, float, float]":
        """A point."""
        return tuple(self.number(value, error, 1) for value, error in zip(values, errors, strict=True))  # type: ignore[return-value]

    def centroid(self) -> "tuple[float, float, float]":
        """The mass centre, with the rounding of the sum that it is."""
        own = self.moments
        centroid, error = own.centroid, own.centre_error
        if own.frame is not None:
            error = abs(own.frame.T) @ (error + 4.0 * UNIT_ROUNDOFF * abs(own.centre))
        return self.point(centroid, error + UNIT_ROUNDOFF * abs(centroid))

    def second(self, density: float) -> "Any":
        """Second moments in the axes of the file."""
        own = self.moments
        matrix, error = own.second, own.second_error
        if own.frame is not None:
            turn = abs(own.frame.T)
            error = turn @ (error + 8.0 * UNIT_ROUNDOFF * abs(matrix)) @ turn.T
            matrix = own.frame.T @ matrix @ own.frame
        return self._matrix(matrix, error, density)

    def _matrix(self, matrix: "Any", error: "Any", density: float) -> "Any":
        sign = 1.0 if self.moments.measure > 0.0 else -1.0
        power = 4 if self.moments.shell else 5
        cell = {
            (i, j): density * self.number(sign * matrix[i][j], error[i][j], power)
            for i in range(3)
            for j in range(i + 1)
        }
        return tuple(tuple(cell[max(i, j), min(i, j)] for j in range(3)) for i in range(3))

    def spread(self, density: float) -> Spread:
        """Principal second moments; their bounds are those of the axes they were integrated in."""
        own = self.moments
        sign = 1.0 if own.measure > 0.0 else -1.0
        matrix = _rows(sign * own.second)
        errors = own.second_error
        frame = None if own.frame is None else _rows(own.frame)
        blur = float(errors.sum(axis=1).max()) if own.frame is None else float(max(errors.sum(axis=1)[:2]))
        found = principal(matrix, 0.0, frame)
        power = 4 if own.shell else 5
        seconds = []
        for k, value in enumerate(found.seconds):
            error = _weyl(own, k) if own.frame is not None else blur
            seconds.append(density * self.number(value, error + found.bounds[k], power))
        return Spread(tuple(seconds), found.axes, found.degeneracy)  # type: ignore[arg-type]


def _weyl(own: "Moments", k: int) -> float:
    """How far the k-th second moment may be off: its own row's errors, scaled as graded matrices are."""
    import numpy as np

    scale = np.sqrt(np.abs(np.diag(own.second)))
    order = np.argsort(-scale)
    i = order[k]
    total = sum(
        float(own.second_error[i][j]) * min(1.0, float(scale[i] / scale[j]) if scale[j] else 1.0) for j in range(3)
    )
    stretched = 4.0 * UNIT_ROUNDOFF * float(scale[i] * scale[i])
    return total + stretched


def require_closed(found: Measured, *, allowed: bool) -> None:
    """Refuse surfaces that enclose nothing definite, or enclose it from the wrong side."""
    places = ""
    if found.faults is not None:
        kept = found.faults
        places = (
            f": {kept.open_edges} open edges, {kept.clashing_edges} clashing edges, {kept.flipped} flipped, "
            f"{kept.duplicated} duplicated and {kept.degenerate} degenerate triangles"
            + "".join("; " + place for place in kept.places)
        )
    require(
        found.closed or allowed,
        "the surface of {0} triangles is not closed: not every edge is met by one the other way{1}",
        found.sums.count,
        places,
        code="open",
        hint="mend the surface, or give --allow-open"
        if found.faults is not None
        else "--diagnose names the faulty edges; --allow-open answers all the same",
    )
    require(
        found.moments.measure >= 0.0 or not found.closed,
        "the surface is inside out: it encloses {0:.6g} cubed units of length",
        found.moments.measure,
        code="inverted",
        hint="turn all triangles round (swap two corners of each)",
    )


def _checks(found: Measured, shell: bool) -> tuple[Check, ...]:
    if shell:
        return ()
    return (Check("every directed edge is met by one the other way", found.closed),)


def _closure(sums: "Sums") -> float:
    """The length of the closure vector over the area."""
    x, y, z = (float(part) for part in sums.closure)
    return (x * x + y * y + z * z) ** 0.5 / sums.area if sums.area else 0.0


def quanta(sums: "Sums") -> "Any":
    """Spacing of single precision at the greatest coordinate along each axis."""
    import numpy as np

    return np.spacing(np.maximum(abs(sums.low), abs(sums.high)).astype(np.float32)).astype(float)


def _quantisation(found: Measured) -> "float | None":
    """Standard deviation of the volume when every corner was rounded to single precision, in the file's unit.

    With A_v the area vector around a corner, Σ_v (A_v q)²/12 is twice that sum over triangles, as corners are shared.
    """
    if not found.single or found.moments.shell:
        return None
    q = quanta(found.sums)
    return float((found.sums.squares @ (q * q)) / 6.0) ** 0.5


def _advice(found: Measured, shell: bool) -> tuple[Advice, ...]:
    out = []
    sums = found.sums
    if not shell and not found.closed:
        out.append(
            Advice(
                "open-surface",
                f"the surface is open: its closure vector is {_closure(sums):.3g} of its area, which indicates how much "
                "is missing but bounds nothing; other reference points give other answers",
                "serious",
                "mend the surface; --diagnose names the faulty edges",
            )
        )
    edge = (sums.area / sums.count * 2.3094) ** 0.5
    if found.single and edge > 0.0:
        coarse = float(max(quanta(sums))) / edge
        if coarse > COARSE:
            out.append(
                Advice(
                    "coarse-coordinates",
                    f"single precision is {coarse:.2g} of the mean edge this far from the origin: the file has lost shape",
                    "serious" if coarse > 0.1 else "caution",
                    "export the part nearer its origin",
                )
            )
    return tuple(out)


def _surface(found: Measured, lift: _Lift) -> Surface:
    sums = found.sums
    quantisation = _quantisation(found)
    zero = (0.0, 0.0, 0.0)
    return Surface(
        form=found.form,
        triangles=sums.count,
        area=lift.number(sums.area, 8.0 * UNIT_ROUNDOFF * sums.area, 2),
        closed="yes" if found.closed else "no",
        closure=_closure(sums),
        low=lift.point(sums.low, zero),
        high=lift.point(sums.high, zero),
        quantisation=None if quantisation is None else lift.number(quantisation, quantisation, 3).value,  # type: ignore[attr-defined]
        faults=found.faults,
    )


def _tracked(thing: "Any") -> "Iterator[Any]":
    """Every tracked number within arguments."""
    if hasattr(thing, "slopes"):
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
            bounds.append(ErrorBound(address, thing.error / (abs(thing.value) - thing.error)))
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


def _rows(matrix: "Any") -> "Any":
    return tuple(tuple(row) for row in matrix.tolist())


def _array(rows: "Any") -> "Any":
    import numpy as np

    return np.array(rows)
