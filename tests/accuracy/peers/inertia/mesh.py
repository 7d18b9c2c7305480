"""Further ways beside those of `alternatives/inertia/mesh`."""

from dynamics_cli.accuracy.alternatives.inertia.bodies import named
from dynamics_cli.accuracy.alternatives.inertia.mesh import corners, cross, moved

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    import numpy as np

    from dynamics_cli.accuracy.cases import Case

    Array = np.ndarray[Any, np.dtype[Any]]


def once(case: "Case") -> "Callable[[], dict[str, Any]]":
    """One pass by edges and centroids in the axes of the file, Jacobi on the second moments."""
    from dynamics_cli.inertia.bodies.principal import principal
    from dynamics_cli.inertia.mesh.passes import first_pass
    from dynamics_cli.inertia.mesh.stl import Corners

    found, shell = corners(case), case.inputs["shell"]

    def answer() -> "dict[str, Any]":
        import numpy as np

        source = Corners("", "", found.reshape(-1, 3), np.arange(3 * len(found)).reshape(-1, 3))
        _, moments = first_pass(source, shell=shell, prove=False)
        second = moments.second
        made = principal(tuple(map(tuple, second.tolist())))  # type: ignore[arg-type]
        tensor = np.trace(second) * np.eye(3) - second
        size = {"area" if shell else "volume": moments.measure}
        return size | named(moments.centroid, tensor, made.moments)

    return answer


def by_faces(case: "Case") -> "Callable[[], dict[str, Any]]":
    """Surface integrals of cubic polynomials over the faces, about the mean of the corners, as Eberly has them."""
    found = corners(case)

    def answer() -> "dict[str, Any]":
        mean = found.mean(axis=(0, 1))
        return moved(case, *faces(found, mean), mean)

    return answer


def faces(found: "Array", point: "Array") -> "tuple[float, Array, Array]":
    """Volume, first and second moments: ∮ x nₓ, ∮ x² nₓ/2, ∮ x³ nₓ/3 and ∮ x² y nₓ/2 over the surface."""
    import numpy as np

    x = np.ascontiguousarray(found.transpose(1, 2, 0)) - point[:, None]
    n, s = cross(x[1] - x[0], x[2] - x[0]), x[0] + x[1] + x[2]
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


def by_trimesh(case: "Case") -> "Callable[[], dict[str, Any]]":
    """Trimesh, from arrays."""
    import numpy as np
    import trimesh  # type: ignore[import-not-found, unused-ignore]

    found = corners(case)

    def answer() -> "dict[str, Any]":
        faces = np.arange(3 * len(found)).reshape(-1, 3)
        made = trimesh.Trimesh(found.reshape(-1, 3), faces, process=False).mass_properties
        tensor = np.asarray(made["inertia"])
        return {"volume": made["volume"], **named(made["center_mass"], tensor, np.linalg.eigvalsh(tensor))}

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
        tensor = axes @ np.diag(moments) @ axes.T
        return {"volume": model.body_mass[1], **named(model.body_ipos[1], tensor, sorted(moments))}

    return answer
