"""Mesh moments: the program's two passes by edges, and what textbooks and libraries do, on the same corners."""

from functools import cache

from dynamics_cli.accuracy.cases import load
from dynamics_cli.accuracy.rivals.inertia_solids import triangles
from dynamics_cli.accuracy.rivals.inertia_table import Way, rows_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    import numpy as np

    from dynamics_cli.accuracy.cases import Case
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
    from dynamics_cli.inertia.lump import tensor_of
    from dynamics_cli.inertia.mesh.lift import Lift
    from dynamics_cli.inertia.mesh.measured import Measured
    from dynamics_cli.inertia.mesh.stl import Corners
    from dynamics_cli.inertia.mesh.surface import LengthUnit

    found, shell = corners(case), case.inputs["shell"]

    def answer() -> "dict[str, Any]":
        import numpy as np

        source = Corners("", "", found.reshape(-1, 3), np.arange(3 * len(found)).reshape(-1, 3))
        lift = Lift(Measured(source, shell=shell), LengthUnit("m"), 0)
        tensor = tensor_of(lift.second(1.0))
        return named(lift.measure(), lift.centroid(), tensor, lift.spread(1.0).moments, shell=shell)

    return answer


def once(case: "Case") -> "Callable[[], dict[str, Any]]":
    """One pass by edges and centroids in the axes of the file, Jacobi on the second moments."""
    from dynamics_cli.inertia.mesh.integrals import first_pass
    from dynamics_cli.inertia.mesh.stl import Corners
    from dynamics_cli.inertia.principal import principal

    found, shell = corners(case), case.inputs["shell"]

    def answer() -> "dict[str, Any]":
        import numpy as np

        source = Corners("", "", found.reshape(-1, 3), np.arange(3 * len(found)).reshape(-1, 3))
        _, moments = first_pass(source, shell=shell, prove=False)
        second = moments.second
        made = principal(tuple(map(tuple, second.tolist())))  # type: ignore[arg-type]
        tensor = np.trace(second) * np.eye(3) - second
        return named(moments.measure, moments.centroid, tensor, made.moments, shell=shell)

    return answer


def about_origin(case: "Case") -> "Callable[[], dict[str, Any]]":
    """The textbook: signed tetrahedra on the origin of the file, parallel axes at the end."""
    import numpy as np

    found = corners(case)
    sums = areas if case.inputs["shell"] else tetrahedra
    return lambda: moved(*sums(found, np.zeros(3)), np.zeros(3), shell=case.inputs["shell"])


def about_middle(case: "Case") -> "Callable[[], dict[str, Any]]":
    """The same on the middle of the box about the corners."""
    found = corners(case)
    sums = areas if case.inputs["shell"] else tetrahedra

    def answer() -> "dict[str, Any]":
        middle = 0.5 * (found.min(axis=(0, 1)) + found.max(axis=(0, 1)))
        return moved(*sums(found, middle), middle, shell=case.inputs["shell"])

    return answer


def by_faces(case: "Case") -> "Callable[[], dict[str, Any]]":
    """Surface integrals of cubic polynomials over the faces, about the mean of the corners, as Eberly has them."""
    found = corners(case)

    def answer() -> "dict[str, Any]":
        mean = found.mean(axis=(0, 1))
        return moved(*faces(found, mean), mean, shell=False)

    return answer


def _seen(found: "Array", point: "Array") -> "tuple[Array, Array, Array]":
    """The three corners from a point, coordinates by triangles."""
    import numpy as np

    a, b, c = np.ascontiguousarray(found.transpose(1, 2, 0)) - point[:, None]
    return a, b, c


def _cross(a: "Array", b: "Array") -> "Array":
    import numpy as np

    return np.stack([a[k - 2] * b[k - 1] - a[k - 1] * b[k - 2] for k in range(3)])


def tetrahedra(found: "Array", point: "Array") -> "tuple[float, Array, Array]":
    """Volume, first and second moments about a point: of a tetrahedron Σ d·(s sᵀ + a aᵀ + b bᵀ + c cᵀ)/120."""
    a, b, c = _seen(found, point)
    d = (a * _cross(b, c)).sum(axis=0)
    s = a + b + c
    second = sum((d * v) @ v.T for v in (s, a, b, c))
    return float(d.sum()) / 6.0, s @ d / 24.0, second / 120.0


def areas(found: "Array", point: "Array") -> "tuple[float, Array, Array]":
    """Area, first and second moments of the triangles about a point."""
    import numpy as np

    a, b, c = _seen(found, point)
    d = np.linalg.norm(_cross(b - a, c - a), axis=0)
    s = a + b + c
    second = sum((d * v) @ v.T for v in (s, a, b, c))
    return float(d.sum()) / 2.0, s @ d / 6.0, second / 24.0


def faces(found: "Array", point: "Array") -> "tuple[float, Array, Array]":
    """Volume, first and second moments: ∮ x nₓ, ∮ x² nₓ/2, ∮ x³ nₓ/3 and ∮ x² y nₓ/2 over the surface."""
    import numpy as np

    x = _seen(found, point)
    n, s = _cross(x[1] - x[0], x[2] - x[0]), x[0] + x[1] + x[2]
    squares = [[sum(v[i] * v[j] for v in x) for j in range(3)] for i in range(3)]
    first = np.array([n[i] @ (s[i] * s[i] + squares[i][i]) for i in range(3)]) / 48.0
    second = np.empty((3, 3))
    for i in range(3):
        for j in range(3):
            # ∫ f² h over a triangle, of linear functions given at its corners
            f, h = s[i], s[j]
            triple = sum(v[i] * v[i] * v[j] for v in x)
            cubic = f * f * h + 2.0 * f * squares[i][j] + h * squares[i][i] + 2.0 * triple
            second[i, j] = n[i] @ cubic / (360.0 if i == j else 240.0)
    return float(n[0] @ s[0]) / 6.0, first, 0.5 * (second + second.T)


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
    found = {"area" if shell else "volume": measure}
    found |= {f"centroid[{k}]": centre[k] for k in range(3)}
    found |= {f"moments.{name}": tensor[k][k] for k, name in enumerate(("xx", "yy", "zz"))}
    found |= {f"products.{name}": tensor[i][j] for name, i, j in PAIRS}
    return found | {f"principal_moments.{name}": moments[k] for k, name in enumerate(NAMES)}


def by_trimesh(case: "Case") -> "Callable[[], dict[str, Any]]":
    """Trimesh, from arrays."""
    import numpy as np
    import trimesh  # type: ignore[import-not-found, unused-ignore]

    found = corners(case)

    def answer() -> "dict[str, Any]":
        faces = np.arange(3 * len(found)).reshape(-1, 3)
        made = trimesh.Trimesh(found.reshape(-1, 3), faces, process=False).mass_properties
        tensor = np.asarray(made["inertia"])
        return named(made["volume"], made["center_mass"], tensor, np.linalg.eigvalsh(tensor), shell=False)

    return answer


def by_mujoco(case: "Case") -> "Callable[[], dict[str, Any]]":
    """MuJoCo's compiler, which keeps corners in single precision; it refuses what is small or thin for it."""
    import mujoco  # type: ignore[import-not-found, unused-ignore]
    import numpy as np

    vertices, places = np.unique(corners(case).reshape(-1, 3), axis=0, return_inverse=True)

    def answer() -> "dict[str, Any]":
        spec = mujoco.MjSpec()
        mesh = spec.add_mesh(name="case", inertia=mujoco.mjtMeshInertia.mjMESH_INERTIA_EXACT)
        mesh.uservert, mesh.userface = vertices.ravel(), places.ravel()
        body = spec.worldbody.add_body()
        body.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname="case", density=1.0)
        model = spec.compile()
        turn = np.empty(9)
        mujoco.mju_quat2Mat(turn, model.body_iquat[1])
        axes = turn.reshape(3, 3)
        moments = model.body_inertia[1]
        return named(
            model.body_mass[1], model.body_ipos[1], axes @ np.diag(moments) @ axes.T, sorted(moments), shell=False
        )

    return answer


OWN = Way("two passes by edges (chosen)", twice)
SHELLS = (
    OWN,
    Way("one pass by edges, Jacobi", once),
    Way("about the middle of the box, LAPACK", about_middle),
    Way("about the origin of the file, LAPACK", about_origin),
)
METHODS = (*SHELLS[:2], Way("integrals over faces about the mean, LAPACK", by_faces), *SHELLS[2:])
PEERS = {
    "trimesh": Way("trimesh, from arrays", by_trimesh),
    "mujoco": Way("MuJoCo, corners in single precision", by_mujoco),
}


def _cases(task: str, *, hard: bool, shell: bool = False) -> "list[Case]":
    found = [case for case in load(FILE) if case.task == task and case.inputs["shell"] == shell]
    return [case for case in found if case.hard or not hard]


def compare(name: str, *, hard: bool, full: bool, timed: bool, peers: "tuple[str, ...]" = ()) -> "list[Row]":
    """Solids of up to some hundred triangles."""
    methods = (*METHODS, *(PEERS[peer] for peer in peers))
    return rows_of(name, _cases("mesh", hard=hard), methods, full=full, timed=timed)


def compare_large(name: str, *, hard: bool, full: bool, timed: bool, peers: "tuple[str, ...]" = ()) -> "list[Row]":
    """Solids of many triangles, where time is that of the sums."""
    methods = (*METHODS, *(PEERS[peer] for peer in peers))
    return rows_of(name, _cases("large mesh", hard=hard), methods, full=full, timed=timed)


def compare_overlapping(name: str, *, hard: bool, full: bool, timed: bool) -> "list[Row]":
    """Solids that single precision has left with faces through one another, and little between them."""
    return rows_of(name, _cases("overlapping mesh", hard=hard), METHODS, full=full, timed=timed)


def compare_shells(name: str, *, hard: bool, full: bool, timed: bool) -> "list[Row]":
    """Thin shells along the triangles."""
    return rows_of(name, _cases("mesh", hard=hard, shell=True), SHELLS, full=full, timed=timed)
