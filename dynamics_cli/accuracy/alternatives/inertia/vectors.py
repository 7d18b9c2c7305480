"""Tensors, torques and bodies side by side: LAPACK and the trigonometric formula, Euler's equations, differences."""

from dynamics_cli.accuracy.alternatives.inertia.bodies import (
    FILE,
    both,
    both_stated,
    from_centre,
    from_origin,
    groups,
    own,
    tensor,
)
from dynamics_cli.accuracy.alternatives.inertia.eigen import textbook_axes, trigonometric
from dynamics_cli.accuracy.alternatives.inertia.table import Way, rows_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    import numpy as np

    from dynamics_cli.accuracy.cases import Case
    from dynamics_cli.accuracy.comparing import Comparing
    from dynamics_cli.accuracy.rows import Row

    Array = np.ndarray[Any, np.dtype[Any]]

NAMES = ("first", "second", "third")
PLACES = ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0))


def _tensor(moments: "list[float]") -> "dict[str, float]":
    """What follows from principal moments, by differences: the greatest product, and how far I₁ + I₂ is above I₃."""
    one, two, three = moments
    results = {f"principal_moments.{name}": moment for name, moment in zip(NAMES, moments, strict=True)}
    return results | {"greatest_product": 0.5 * (three - one), "slack": (one + two - three) / three}


def _matrix(case: "Case") -> "tuple[tuple[float, ...], ...]":
    inertia = case.inputs["inertia"]
    if "tensor" not in inertia:
        raise ArithmeticError
    return tuple(tuple(map(float, row)) for row in inertia["tensor"])


def tensor_by_lapack(case: "Case") -> "Callable[[], dict[str, float]]":
    """Eigenvalues by `numpy.linalg.eigvalsh`."""
    import numpy as np

    rows = np.array(_matrix(case))
    return lambda: _tensor(np.linalg.eigvalsh(rows).tolist())


def tensor_by_cardano(case: "Case") -> "Callable[[], dict[str, float]]":
    """The roots of det(I − λ·1) = 0 by an arc cosine, as taught."""
    rows = _matrix(case)
    return lambda: _tensor(trigonometric(rows)[0][::-1])  # type: ignore[arg-type]


def _torque(own: "Array", gyroscopic: "Array", momentum: "Array", spin: "Array") -> "dict[str, float]":
    import numpy as np

    total = own + gyroscopic
    results = {"magnitude": float(np.linalg.norm(total)), "rotational_energy": float(0.5 * spin @ momentum)}
    vectors = {"inertia_torque": total, "acceleration_part": own, "gyroscopic_part": gyroscopic}
    vectors["angular_momentum"] = momentum
    return results | {f"{name}[{k}]": float(x) for name, vector in vectors.items() for k, x in enumerate(vector)}


def torque_by_cross(*, tensor: "Any", angular_velocity: "Any", angular_acceleration: "Any") -> "dict[str, float]":
    """T* = −I·α − ω × (I·ω), the cross product as it stands: equal moments no longer cancel to nothing."""
    import numpy as np

    inertia, spin = np.array(tensor), np.array(angular_velocity)
    momentum = inertia @ spin
    return _torque(-(inertia @ np.array(angular_acceleration)), -np.cross(spin, momentum), momentum, spin)


def torque_along_axes(*, tensor: "Any", angular_velocity: "Any", angular_acceleration: "Any") -> "dict[str, float]":
    """Euler's equations, T₁* = −I₁·α₁ + (I₂ − I₃)·ω₂·ω₃ and so on, in principal axes of LAPACK, and turned back."""
    import numpy as np

    moments, axes = np.linalg.eigh(np.array(tensor))
    # right-handed, as the products of the components ask
    axes = axes * np.linalg.det(axes)
    spin, rise = np.array(angular_velocity) @ axes, np.array(angular_acceleration) @ axes
    (a, b, c), (x, y, z) = moments, spin
    turning = np.array([(b - c) * y * z, (c - a) * z * x, (a - b) * x * y])
    results = _torque(axes @ -(moments * rise), axes @ turning, axes @ (moments * spin), np.array(angular_velocity))
    return results | {"rotational_energy": float(0.5 * moments @ (spin * spin))}


def _whole(results: "dict[str, Any]") -> "tuple[float, Array, Array, list[float]]":
    """Mass, mass centre, tensor and principal moments from results by address."""
    import numpy as np

    centre = np.array([results[f"centroid[{k}]"] for k in range(3)])
    tensor = np.diag([results[f"moments.{name}"] for name in ("xx", "yy", "zz")])
    for name, i, j in (("xy", 0, 1), ("yz", 1, 2), ("zx", 2, 0)):
        tensor[i, j] = tensor[j, i] = results[f"products.{name}"]
    return results["mass"], centre, tensor, [results[f"principal_moments.{name}"] for name in NAMES]


def _lapack_axes(tensor: "Array") -> "Array":
    import numpy as np

    return np.linalg.eigh(tensor)[1].T


def _book_axes(tensor: "Array") -> "Array":
    import numpy as np

    return np.array(textbook_axes(tuple(map(tuple, tensor.tolist()))))[::-1]


def compared(
    one: "Callable[[Any], Callable[[], dict[str, Any]]]", axes: "Callable[[Array], Array]"
) -> "Callable[[Case], Callable[[], dict[str, float]]]":
    """Two bodies, each by `one`, and their numbers subtracted; the turn between their axes by an arc cosine."""

    def prepare(case: "Case") -> "Callable[[], dict[str, float]]":
        from types import SimpleNamespace

        pair = groups(case)["scene"]
        sides = [one(SimpleNamespace(scene=side)) for side in (pair.first, pair.second)]
        return lambda: _differences(_whole(sides[0]()), _whole(sides[1]()), axes)

    return prepare


def _differences(
    first: "tuple[float, Array, Array, list[float]]", second: "tuple[float, Array, Array, list[float]]",
    axes: "Callable[[Array], Array]",
) -> "dict[str, float]":  # fmt: skip
    import numpy as np

    (m, c, a, moments), (n, d, b, others) = first, second
    shift = d - c
    results = {
        "first_mass": m, "second_mass": n, "mass_difference": n - m, "mass_ratio": n / m,
        "centroid_distance": float(np.linalg.norm(shift)),
        "tensor_distance": float(np.linalg.norm(b - a) / np.linalg.norm(a)),
    }  # fmt: skip
    results |= {f"centroid_shift[{k}]": float(x) for k, x in enumerate(shift)}
    rows = [(float(a[i, j]), float(b[i, j])) for i, j in PLACES] + list(zip(moments, others, strict=True))
    for k, (one, other) in enumerate(rows):
        results |= {f"moments[{k}].first": one, f"moments[{k}].second": other, f"moments[{k}].difference": other - one}
    # of the four senses that leave right-handed axes right-handed the smallest turn: cos φ = (tr R − 1)/2
    shares = np.diag(axes(a) @ axes(b).T)
    if np.linalg.det(axes(a)) * np.linalg.det(axes(b)) < 0.0:
        shares = -shares
    traces = [float(np.array(signs) @ shares) for signs in ((1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1))]
    return results | {"axes_angle": float(np.arccos(np.clip(0.5 * (max(traces) - 1.0), -1.0, 1.0)))}


compare_by_centre = compared(from_centre, _lapack_axes)
compare_by_origin = compared(from_origin, _book_axes)


def compare_pairs(comparing: "Comparing") -> "list[Row]":
    """Two bodies side by side."""
    ways = (
        own("composed each about its mass centre", both, both_stated),
        Way("textbook: about the origin, arc cosines", compare_by_origin),
        Way("tensors about the mass centre, LAPACK", compare_by_centre),
    )
    return rows_of(comparing, comparing.cases(FILE, task="compare"), ways)


def compare_tensors(comparing: "Comparing") -> "list[Row]":
    """Given tensors."""
    ways = (
        own("Jacobi on the tensor", tensor),
        Way("textbook: roots by an arc cosine", tensor_by_cardano),
        Way("LAPACK eigvalsh", tensor_by_lapack),
    )
    return rows_of(comparing, comparing.cases(FILE, task="tensor"), ways)
