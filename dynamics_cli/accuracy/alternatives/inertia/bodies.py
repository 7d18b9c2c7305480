"""Assemblies, pairs of bodies, tensors and torques as textbooks and LAPACK have them, and what errors are shares of.

A coordinate, a product of inertia or a difference may pass through zero; what its error costs is shown by the largest
coordinate, by the moments, or by what the difference is of.
"""

from decimal import Decimal

from dynamics_cli.accuracy.alternatives.inertia.eigen import trigonometric
from dynamics_cli.accuracy.measure import DIGITS

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    import numpy as np

    Array = np.ndarray[Any, np.dtype[Any]]

NAMES = ("first", "second", "third")
PAIRS = (("xy", 0, 1), ("yz", 1, 2), ("zx", 2, 0))
UNIT_ROUNDOFF = Decimal(2.0**-53)
MOMENTS = ("moments.", "principal_moments.")
# Whose largest number an error is a share of, by the beginning of the address.
KIN: "dict[str, tuple[str, ...]]" = {
    "products": MOMENTS, "greatest_product": MOMENTS, "centroid": ("centroid",), "mass_difference": ("first_mass",),
    "x": ("x", "y", "gyration.polar"), "y": ("x", "y", "gyration.polar"), "centroidal.ixy": ("centroidal.",),
    "about_origin.ixy": ("about_origin.",), "inertia_torque": ("inertia_torque",),
}  # fmt: skip
# Numbers that are shares or angles, and differences of those: of one and more.
SHARES = ("slack", "axes_angle", "tensor_distance", "principal.angle")


def scale(address: str, sizes: "dict[str, Decimal]") -> Decimal:
    """What the error of a result is a share of."""
    size = sizes[address]
    if address in SHARES:
        return size + 1
    for start, kin in KIN.items():
        if address.startswith(start):
            size = max(other for name, other in sizes.items() if name.startswith(kin))
    if address.startswith(("centroid[", "centroid_")):
        # the radius of gyration about the principal axis of the greatest moment; unit density where no mass is told
        mass = next(sizes[name] for name in ("mass", "volume", "area", "first_mass") if name in sizes)
        moment = next(sizes[name] for name in ("principal_moments.third", "moments[8].first") if name in sizes)
        size = max(size, DIGITS.sqrt(DIGITS.divide(moment, mass)))
    if address.startswith(MOMENTS):
        # below a rounding of the largest moment there is nothing but rounding
        size = max(size, UNIT_ROUNDOFF * max(other for name, other in sizes.items() if name.startswith(MOMENTS)))
    if address.startswith("moments["):
        # a row of two bodies and their difference; products beside the moments
        row, _, which = address.partition(".")
        rows = (row,) if int(row[8:-1]) > 5 else tuple(f"moments[{k}]" for k in range(6))
        both = [max(sizes[f"{one}.{body}"] for one in rows) for body in ("first", "second")]
        size = sum(both, Decimal(0)) if which == "difference" else max(both)
    return size or Decimal(1)


def named(centre: "Any", tensor: "Any", moments: "Any") -> "dict[str, Any]":
    """Results by address."""
    results = {f"centroid[{k}]": centre[k] for k in range(3)}
    results |= {f"moments.{name}": tensor[k][k] for k, name in enumerate(("xx", "yy", "zz"))}
    results |= {f"products.{name}": tensor[i][j] for name, i, j in PAIRS}
    return results | {f"principal_moments.{name}": moments[k] for k, name in enumerate(NAMES)}


def _composed(scene: "Any") -> "tuple[float, Array, Array]":
    """Mass, mass centre and tensor about it, by parallel axes from the origin."""
    import numpy as np

    from dynamics_cli.inertia.assembly.parts import Walk
    from dynamics_cli.numerics.orientation.rotations import IDENTITY

    walk, parts = Walk(), []
    walk.into(scene.parts, "", (0.0, 0.0, 0.0), IDENTITY, 1.0)
    for leaf in walk.leaves:
        turn, second = np.array(leaf.rotation), np.array(leaf.lump.second)
        inner = np.trace(second) * np.eye(3) - second
        place = np.array(leaf.origin) + turn @ np.array(leaf.lump.centroid)
        parts.append((leaf.sign * leaf.lump.mass, place, leaf.sign * (turn @ inner @ turn.T)))
    mass = sum(part[0] for part in parts)
    centre = np.sum([m * place for m, place, _ in parts], axis=0) / mass

    def moved(m: float, d: "Array") -> "Array":
        return m * (d @ d * np.eye(3) - np.outer(d, d))  # type: ignore[no-any-return]

    tensor = np.sum([inner + moved(m, place) for m, place, inner in parts], axis=0)
    return mass, centre, tensor - moved(mass, centre)


def body_from_origin(scene: "Any") -> "dict[str, Any]":
    """The textbook: tensors summed about the origin, I = I₀ − m (c²·1 − c cᵀ) at the end, LAPACK."""
    import numpy as np

    mass, centre, tensor = _composed(scene)
    return {"mass": mass, **named(centre.tolist(), tensor.tolist(), np.linalg.eigvalsh(tensor).tolist())}


def _tensor(moments: "list[float]") -> "dict[str, float]":
    """What follows from principal moments, by differences: the greatest product, and how far I₁ + I₂ is above I₃."""
    one, two, three = moments
    results = {f"principal_moments.{name}": moment for name, moment in zip(NAMES, moments, strict=True)}
    return results | {"greatest_product": 0.5 * (three - one), "slack": (one + two - three) / three}


def tensor_by_cardano(*, inertia: "Any") -> "dict[str, float]":
    """The roots of det(I − λ·1) = 0 by an arc cosine, as taught."""
    return _tensor(trigonometric(inertia.matrix())[::-1])


def torque_by_cross(*, tensor: "Any", angular_velocity: "Any", angular_acceleration: "Any") -> "dict[str, float]":
    """T* = −I·α − ω × (I·ω), the cross product as it stands: equal moments no longer cancel to nothing."""
    import numpy as np

    inertia, spin = np.array(tensor), np.array(angular_velocity)
    momentum = inertia @ spin
    parts = {
        "acceleration_part": -(inertia @ np.array(angular_acceleration)), "gyroscopic_part": -np.cross(spin, momentum),
        "angular_momentum": momentum,
    }  # fmt: skip
    parts["inertia_torque"] = parts["acceleration_part"] + parts["gyroscopic_part"]
    results = {"magnitude": float(np.linalg.norm(parts["inertia_torque"])), "rotational_energy": 0.5 * spin @ momentum}
    return results | {f"{name}[{k}]": float(x) for name, vector in parts.items() for k, x in enumerate(vector)}
