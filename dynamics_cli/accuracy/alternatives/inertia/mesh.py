"""Mesh moments: the program's two passes by edges, and what textbooks and libraries do, on the same corners."""

from functools import cache

from dynamics_cli.accuracy.alternatives.inertia.bodies import named, scale
from dynamics_cli.accuracy.alternatives.inertia.solids import triangles
from dynamics_cli.accuracy.cases import load
from dynamics_cli.accuracy.measure import Errors, count

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    import numpy as np

    from dynamics_cli.accuracy.cases import Case
    from dynamics_cli.accuracy.comparing import Comparing
    from dynamics_cli.accuracy.rows import Row

    Array = np.ndarray[Any, np.dtype[Any]]
    Call = Callable[[], dict[str, Any]]

FILE = "inertia_mesh.json"
# The cases of each question, and whether they are shells.
ASKED = {
    "mesh moments": ("mesh", False),
    "mesh moments, 32,768 triangles": ("large mesh", False),
    "mesh moments, faces that overlap": ("overlapping mesh", False),
    "shell moments": ("mesh", True),
}


@cache
def _corners(name: str) -> "Array":
    import numpy as np

    inputs = next(case.inputs for case in load(FILE) if case.name == name)
    numbers = {key: [float(x) for x in inputs[key]] for key in ("stretch", "quaternion", "offset")}
    return np.array(triangles({**inputs, **numbers}))


def corners(case: "Case") -> "Array":
    """The corners of a case's triangles: triangles by corners by coordinates."""
    return _corners(case.name)


def twice(case: "Case") -> "Call":
    """The program's own: edges and centroids of triangles, a second pass in the principal axes, Jacobi, its bounds."""
    from dynamics_cli.inertia.bodies.mass_moments import tensor_of
    from dynamics_cli.inertia.mesh.measurement import Measured
    from dynamics_cli.inertia.mesh.stl import Corners
    from dynamics_cli.inertia.mesh.surface import LengthUnit
    from dynamics_cli.inertia.mesh.tracked_integrals import Lift

    triangles, shell = corners(case), case.inputs["shell"]

    def answer() -> "dict[str, Any]":
        import numpy as np

        source = Corners("", "", triangles.reshape(-1, 3), np.arange(3 * len(triangles)).reshape(-1, 3))
        lift = Lift(Measured(source, shell=shell), LengthUnit("m"), 0)
        size = {"area" if shell else "volume": lift.measure()}
        return size | named(lift.centroid(), tensor_of(lift.second(1.0)), lift.spread(1.0).moments)

    return answer


def _summed(case: "Case", point: "Callable[[Array], Array]") -> "Call":
    """Sums about a point of the corners, parallel axes, LAPACK."""
    triangles = corners(case)
    return lambda: moved(case, *sums(triangles, point(triangles), shell=case.inputs["shell"]), point(triangles))


def about_origin(case: "Case") -> "Call":
    """The textbook: signed tetrahedra on the origin of the file, parallel axes at the end."""
    import numpy as np

    return _summed(case, lambda _: np.zeros(3))


def sums(triangles: "Array", point: "Array", *, shell: bool) -> "tuple[float, Array, Array]":
    """Measure, first and second moments about a point: of a tetrahedron Σ d·(s sᵀ + a aᵀ + b bᵀ + c cᵀ)/120."""
    import numpy as np

    a, b, c = np.ascontiguousarray(triangles.transpose(1, 2, 0)) - point[:, None]
    if shell:
        d, parts = np.linalg.norm(cross(b - a, c - a), axis=0), (2.0, 6.0, 24.0)
    else:
        d, parts = (a * cross(b, c)).sum(axis=0), (6.0, 24.0, 120.0)
    s = a + b + c
    second = sum((d * v) @ v.T for v in (s, a, b, c))
    return float(d.sum()) / parts[0], s @ d / parts[1], second / parts[2]


def cross(a: "Array", b: "Array") -> "Array":
    """The vector product of columns."""
    import numpy as np

    return np.stack([a[k - 2] * b[k - 1] - a[k - 1] * b[k - 2] for k in range(3)])


def moved(case: "Case", measure: float, first: "Array", second: "Array", point: "Array") -> "dict[str, Any]":
    """Results from sums about a point: the parallel axis theorem, and LAPACK on the tensor."""
    import numpy as np

    if measure == 0.0:
        raise ArithmeticError
    centre = first / measure
    central = second - measure * np.outer(centre, centre)
    tensor = np.trace(central) * np.eye(3) - central
    size = {"area" if case.inputs["shell"] else "volume": measure}
    return size | named(centre + point, tensor, np.linalg.eigvalsh(tensor))


METHODS = (
    ("two passes by edges (chosen)", twice),
    ("about the origin of the file, LAPACK", about_origin),
)


def compare(comparing: "Comparing") -> "list[Row]":
    """Solids of few triangles and of many, with faces that overlap, and thin shells."""
    task, shell = ASKED[comparing.name]
    cases = [case for case in comparing.cases(FILE, task=task) if case.inputs["shell"] == shell]

    def answer(errors: Errors, case: "Case", prepare: "Any", index: int) -> "Call":
        call: Call = prepare(case)
        count(errors, case, index, call(), scale)
        return call

    return comparing.rows(METHODS, cases, answer, most=20, shared=True)
