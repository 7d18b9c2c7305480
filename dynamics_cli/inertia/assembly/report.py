"""Report of an assembly: a row for each part, cancellation, standard uncertainties, and bounds."""

from dynamics_cli.errors import worded
from dynamics_cli.inertia.assembly.holes import hole_advice
from dynamics_cli.inertia.assembly.uncertainty_rollup import deviation
from dynamics_cli.inertia.bodies.mass_moments import Lump, about, tensor_of, turned
from dynamics_cli.inertia.bodies.principal_tracked import SHOWN
from dynamics_cli.inertia.bodies.properties import MassProperties, View, properties
from dynamics_cli.inertia.bodies.records import Cancellation, PartShare
from dynamics_cli.numerics.number import over_plain, plain
from dynamics_cli.quantities import Inertia
from dynamics_cli.records import Advice, ErrorBound, Numerics

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.inertia.bodies.compose import Composed
    from dynamics_cli.inertia.bodies.mass_moments import Matrix, Vector
    from dynamics_cli.inertia.bodies.records import Deviation

# Above this a sum of material and holes loses more digits than a reader expects.
MUCH_CANCELS = 1e6


def reported(assembly: "Composed", view: View) -> MassProperties:
    """The report of a composed assembly, with plain numbers and their bounds stated separately."""
    measures, spread = measures_of(assembly), deviation(assembly)
    answer = properties(assembly.lump, view, spread=assembly.spread, **measures)
    rows, cancels = _shares(assembly, view, answer)
    bounds: list[ErrorBound] = []
    values = dict(answer.__dict__)
    if not assembly.sloped and not assembly.bare:
        values = {name: stated(name, value, bounds) for name, value in values.items()}
    values |= {
        "parts": rows,
        "cancellation": cancels,
        "standard_uncertainty": spread,
        "advice": _advice(cancels, assembly)
        + hole_advice(assembly.leaves)
        + _mesh_advice(assembly)
        + _close_moments(assembly, spread),
        "numerics": Numerics(
            "composition about the mass centre; Jacobi rotations in two passes",
            (*bounds, *assembly.spread.axes_bound()),
        ),
    }
    return MassProperties(**values)


def stated(name: str, value: "Any", bounds: "list[ErrorBound]") -> "Any":
    """A plain scalar with a relative bound; a vector with a bound for each component."""
    if hasattr(value, "fields"):
        return type(value)(**{part: stated(f"{name}.{part}", getattr(value, part), bounds) for part in value.fields})
    error = getattr(value, "error", None)
    if error is None:
        return value
    size = abs(value.value)
    if size == 0.0 and error > 0.0:
        return value
    relative = (error / (size - error) if size > 2.0 * error else error / size) if error else 0.0
    bounds.append(ErrorBound(name, relative + SHOWN if size else 0.0))
    return value.value


def measures_of(assembly: "Composed") -> "dict[str, Any]":
    """Volume, area or length of an assembly whose bodies are all solids, all laminae or all rods; else nothing."""
    kinds = {leaf.measures[0] if leaf.measures else 0 for leaf in assembly.leaves}
    if len(kinds) != 1 or kinds == {0}:
        return {}
    total = 0.0
    for leaf in assembly.leaves:
        total = total + leaf.sign * leaf.measures[1]
    return {("length", "area", "volume")[kinds.pop() - 1]: total} if plain(total) > 0.0 else {}


def _shares(
    assembly: "Composed", view: View, answer: MassProperties
) -> "tuple[tuple[PartShare, ...], Cancellation | None]":
    off: Callable[[Any], Any] = (lambda value: value) if assembly.bare else over_plain
    rotation: Matrix = off(_rotation(view, assembly))
    point: Vector = off(answer.reference_point)
    rows = []
    for leaf, tracked in zip(assembly.leaves, assembly.pieces, strict=True):
        piece: Lump = off(tracked)
        tensor = tensor_of(turned(about(piece, point), rotation))
        rows.append(PartShare(leaf.name, piece.mass, piece.centroid, (tensor[0][0], tensor[1][1], tensor[2][2])))
    if all(leaf.sign > 0.0 for leaf in assembly.leaves):
        return tuple(rows), None
    sums = [sum(row.moments[k] for row in rows) for k in range(3)]
    sizes = [sum(abs(row.moments[k]) for row in rows) for k in range(3)]
    mass = sum(abs(row.mass) for row in rows) / plain(assembly.lump.mass)
    cancelled = [size / abs(total) if total else 0.0 for size, total in zip(sizes, sums, strict=True)]
    return tuple(rows), Cancellation(mass, (cancelled[0], cancelled[1], cancelled[2]))


def _close_moments(assembly: "Composed", spread: "Deviation | None") -> tuple[Advice, ...]:
    """A warning where principal moments differ by less than their uncertainty, so that their axes are undetermined."""
    if spread is None:
        return ()
    moments, deviations = over_plain(assembly.spread.moments), spread.principal_moments
    return tuple(
        Advice(
            "axes-uncertain",
            worded(
                f"principal moments {i + 1} and {j + 1} differ by {{difference:3}}, less than their uncertainty "
                "{uncertainty:3}: the axes in that plane are not determined",
                difference=(moments[j] - moments[i], Inertia),
                uncertainty=((deviations[i] * deviations[i] + deviations[j] * deviations[j]) ** 0.5, Inertia),
            ),
            remedy="measure the moments better, or use any two axes in the plane",
        )
        for i, j in ((0, 1), (1, 2))
        if moments[j] - moments[i] < (deviations[i] * deviations[i] + deviations[j] * deviations[j]) ** 0.5
    )


def _mesh_advice(assembly: "Composed") -> tuple[Advice, ...]:
    """Faults from the diagnosis of mesh parts, each with the name of its part."""
    advice: list[Advice] = []
    for leaf in assembly.leaves:
        if leaf.part.mesh:
            from dynamics_cli.inertia.mesh.measurement import measured
            from dynamics_cli.inertia.mesh.report import fault_advice

            faults = fault_advice(measured(leaf.part.mesh, shell=False), shell=False)
            advice += [Advice(f.code, f"{leaf.name}: {f.message}", f.severity, f.remedy) for f in faults]
    return tuple(advice)


def _rotation(view: View, assembly: "Composed") -> "Matrix":
    from dynamics_cli.numerics.orientation.rotations import IDENTITY

    if view.axes == "principal":
        return assembly.spread.axes
    return view.rotation if view.rotation is not None else IDENTITY


def _advice(cancels: Cancellation | None, assembly: "Composed") -> tuple[Advice, ...]:
    advice = []
    if cancels is not None and max(cancels.mass, *cancels.moments) > MUCH_CANCELS:
        largest = max(cancels.mass, *cancels.moments)
        message = f"material and holes cancel to 1/{largest:.3g} of their size: the result loses as many digits"
        remedy = "use a hollow shape with its wall thickness instead of a solid less a solid"
        advice.append(Advice("cancellation", message, severity="caution", remedy=remedy))
    if assembly.unbounded:
        advice.append(Advice("no-bound", "with this many parts no rounding bound is calculated", severity="note"))
    return tuple(advice)
