"""Mesh moments: the program's two passes by edges, and what textbooks and libraries do, on the same corners."""

from functools import cache

from dynamics_cli.accuracy.alternatives.inertia.solids import triangles
from dynamics_cli.accuracy.alternatives.inertia.table import Way, rows_of
from dynamics_cli.accuracy.cases import load

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    import numpy as np

    from dynamics_cli.accuracy.cases import Case
    from dynamics_cli.accuracy.comparing import Comparing
    from dynamics_cli.accuracy.rows import Row

    Array = np.ndarray[Any, np.dtype[Any]]

FILE = "inertia_mesh.json"
PAIRS = (("xy", 0, 1), ("yz", 1, 2), ("zx", 2, 0))
NAMES = ("first", "second", "third")


@cache
def _corners(file: str, name: str) -> "Array":
    """The corners of a case's triangles: triangles by corners by coordinates."""
    import numpy as np

    inputs = next(case.inputs for case in load(file) if case.name == name)
    numbers = {key: [float(x) for x in inputs[key]] for key in ("stretch", "quaternion", "offset")}
    return np.array(triangles({**inputs, **numbers}))


def corners(case: "Case") -> "Array":
    """The corners of a case's triangles."""
    return _corners(FILE, case.name)


def twice(case: "Case") -> "Callable[[], dict[str, Any]]":
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
        tensor = tensor_of(lift.second(1.0))
        return named(lift.measure(), lift.centroid(), tensor, lift.spread(1.0).moments, shell=shell)

    return answer


def about_origin(case: "Case") -> "Callable[[], dict[str, Any]]":
    """The textbook: signed tetrahedra on the origin of the file, parallel axes at the end."""
    import numpy as np

    triangles = corners(case)
    sums = areas if case.inputs["shell"] else tetrahedra
    return lambda: moved(*sums(triangles, np.zeros(3)), np.zeros(3), shell=case.inputs["shell"])


def about_middle(case: "Case") -> "Callable[[], dict[str, Any]]":
    """The same on the middle of the box about the corners."""
    triangles = corners(case)
    sums = areas if case.inputs["shell"] else tetrahedra

    def answer() -> "dict[str, Any]":
        middle = 0.5 * (triangles.min(axis=(0, 1)) + triangles.max(axis=(0, 1)))
        return moved(*sums(triangles, middle), middle, shell=case.inputs["shell"])

    return answer


def _seen(triangles: "Array", point: "Array") -> "tuple[Array, Array, Array]":
    """The three corners from a point, coordinates by triangles."""
    import numpy as np

    a, b, c = np.ascontiguousarray(triangles.transpose(1, 2, 0)) - point[:, None]
    return a, b, c


def _cross(a: "Array", b: "Array") -> "Array":
    import numpy as np

    return np.stack([a[k - 2] * b[k - 1] - a[k - 1] * b[k - 2] for k in range(3)])


def tetrahedra(triangles: "Array", point: "Array") -> "tuple[float, Array, Array]":
    """Volume, first and second moments about a point: of a tetrahedron Σ d·(s sᵀ + a aᵀ + b bᵀ + c cᵀ)/120."""
    a, b, c = _seen(triangles, point)
    d = (a * _cross(b, c)).sum(axis=0)
    s = a + b + c
    second = sum((d * v) @ v.T for v in (s, a, b, c))
    return float(d.sum()) / 6.0, s @ d / 24.0, second / 120.0


def areas(triangles: "Array", point: "Array") -> "tuple[float, Array, Array]":
    """Area, first and second moments of the triangles about a point."""
    import numpy as np

    a, b, c = _seen(triangles, point)
    d = np.linalg.norm(_cross(b - a, c - a), axis=0)
    s = a + b + c
    second = sum((d * v) @ v.T for v in (s, a, b, c))
    return float(d.sum()) / 2.0, s @ d / 6.0, second / 24.0


def moved(measure: float, first: "Array", second: "Array", point: "Array", *, shell: bool) -> "dict[str, Any]":
    """Results from sums about a point: the parallel axis theorem, and LAPACK on the tensor."""
    import numpy as np

    if measure == 0.0:
        raise ArithmeticError
    centre = first / measure
    central = second - measure * np.outer(centre, centre)
    tensor = np.trace(central) * np.eye(3) - central
    return named(measure, centre + point, tensor, np.linalg.eigvalsh(tensor), shell=shell)


def named(measure: "Any", centre: "Any", tensor: "Any", moments: "Any", *, shell: bool) -> "dict[str, Any]":
    """Results by address, for unit density."""
    results = {"area" if shell else "volume": measure}
    results |= {f"centroid[{k}]": centre[k] for k in range(3)}
    results |= {f"moments.{name}": tensor[k][k] for k, name in enumerate(("xx", "yy", "zz"))}
    results |= {f"products.{name}": tensor[i][j] for name, i, j in PAIRS}
    return results | {f"principal_moments.{name}": moments[k] for k, name in enumerate(NAMES)}


METHODS = (
    Way("two passes by edges (chosen)", twice),
    Way("about the middle of the box, LAPACK", about_middle),
    Way("about the origin of the file, LAPACK", about_origin),
)


def _cases(comparing: "Comparing", task: str, *, shell: bool = False) -> "list[Case]":
    return [case for case in comparing.cases(FILE, task=task) if case.inputs["shell"] == shell]


def compare(comparing: "Comparing") -> "list[Row]":
    """Solids of up to some hundred triangles."""
    return rows_of(comparing, _cases(comparing, "mesh"), METHODS)


def compare_large(comparing: "Comparing") -> "list[Row]":
    """Solids of many triangles, where time is that of the sums."""
    return rows_of(comparing, _cases(comparing, "large mesh"), METHODS)


def compare_overlapping(comparing: "Comparing") -> "list[Row]":
    """Solids that single precision has left with faces through one another, and little between them."""
    return rows_of(comparing, _cases(comparing, "overlapping mesh"), METHODS)


def compare_shells(comparing: "Comparing") -> "list[Row]":
    """Thin shells along the triangles."""
    return rows_of(comparing, _cases(comparing, "mesh", shell=True), METHODS)
