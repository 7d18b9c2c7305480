"""Mass properties of bodies at any precision: quadrature of patches, sums about the origin, parallel axes."""

from typing import Any

import inertia_patches
from mpmath import cos, eigsy, matrix, mp, mpf, sin, sqrt


def exact(tree: Any) -> Any:
    """Doubles as exact numbers."""
    if isinstance(tree, float):
        return mpf(tree)
    if isinstance(tree, dict):
        return {name: exact(part) for name, part in tree.items()}
    return [exact(part) for part in tree] if isinstance(tree, list) else tree


def rotation(spec: dict[str, Any]) -> Any:
    """A part's rotation matrix, each way of writing it by its definition."""
    one = matrix([[1, 0, 0], [0, 1, 0], [0, 0, 1]])
    if "rotation_axis" in spec:
        x = spec["rotation_axis"]
        n = sqrt(sum(part * part for part in x))
        x = [part / n for part in x]
        c, s = cos(spec["rotation_angle"]), sin(spec["rotation_angle"])
        cross = matrix([[0, -x[2], x[1]], [x[2], 0, -x[0]], [-x[1], x[0], 0]])
        return one + s * cross + (1 - c) * cross * cross
    if "euler_angles" in spec:
        made = one
        for letter, angle in zip(spec["euler_order"].lower(), spec["euler_angles"], strict=True):
            axis = [mpf(letter == k) for k in "xyz"]
            turn = rotation({"rotation_axis": axis, "rotation_angle": angle})
            made = made * turn if spec["euler_order"].islower() else turn * made
        return made
    if "quaternion" in spec:
        w, x, y, z = spec["quaternion"]
        n = sqrt(w * w + x * x + y * y + z * z)
        half = 2 * mp.atan2(sqrt(x * x + y * y + z * z), w)
        return rotation({"rotation_axis": [x / n, y / n, z / n], "rotation_angle": half})
    return one


def symmetric(six: Any) -> Any:
    xx, yy, zz, xy, yz, zx = six
    return matrix([[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]])


def added(parts: list[dict[str, Any]], origin: Any, frame: Any, sign: int, sums: list[Any]) -> None:
    """Mass, first and second moments about the origin, summed over the leaves."""
    for part in parts:
        place = origin + frame * matrix(part.get("position", [0, 0, 0]))
        turn = frame * rotation(part)
        own = -sign if part.get("subtract") else sign
        if "shape" in part or "mass" in part:
            if "shape" in part:
                unit = inertia_patches.integrate(inertia_patches.patches(part["shape"], part))
                mass = part["mass"] if "mass" in part else part["density"] * unit["measure"]
                middle, second = matrix(unit["centroid"]), symmetric(unit["second"])
            else:
                mass = part["mass"]
                middle, second = matrix(part.get("centroid", [0, 0, 0])), matrix(3, 3)
                if "tensor" in part:
                    tensor = matrix(part["tensor"])
                    trace = tensor[0, 0] + tensor[1, 1] + tensor[2, 2]
                    second = (trace / 2 * mp.eye(3) - tensor) / mass
            r = place + turn * middle
            sums[0] += own * mass
            sums[1] += own * mass * r
            sums[2] += own * mass * (turn * second * turn.T + r * r.T)
        added(part.get("parts", []), place, turn, own, sums)


def results(mass: Any, centroid: Any, second: Any) -> dict[str, Any]:
    """The results by address, from mass, centroid and central second moments."""
    trace = second[0, 0] + second[1, 1] + second[2, 2]
    found = {"mass": mass, **{f"centroid[{k}]": centroid[k] for k in range(3)}}
    for k, name in enumerate(("xx", "yy", "zz")):
        found[f"moments.{name}"] = trace - second[k, k]
    for (i, j), name in (((0, 1), "xy"), ((1, 2), "yz"), ((2, 0), "zx")):
        found[f"products.{name}"] = -second[i, j]
    values = sorted(eigsy(second, eigvals_only=True), reverse=True)
    for k, name in enumerate(("first", "second", "third")):
        found[f"principal_moments.{name}"] = sum(values) - values[k]
    return found


def answer(task: str, inputs: dict[str, Any]) -> dict[str, Any]:
    own = exact(inputs)
    if task == "shape":
        patches = inertia_patches.patches(own["shape"], own)
        unit = inertia_patches.integrate(patches)
        second = symmetric(unit["second"]) * own["mass"]
        measure = ("length", "area", "volume")[len(patches[0][0]) - 1]
        return {measure: unit["measure"], **results(own["mass"], unit["centroid"], second)}
    if task == "tensor":
        tensor = matrix(own["tensor"])
        values = sorted(eigsy(tensor, eigvals_only=True))
        names = ("first", "second", "third")
        return {
            **{f"principal_moments.{name}": value for name, value in zip(names, values, strict=True)},
            "greatest_product": (values[2] - values[0]) / 2,
            "slack": (values[0] + values[1] - values[2]) / values[2],
        }
    if task == "torque":
        tensor, w, alpha = matrix(own["tensor"]), matrix(own["angular_velocity"]), matrix(own["angular_acceleration"])
        h, t = tensor * w, tensor * alpha
        cross = matrix([w[1] * h[2] - w[2] * h[1], w[2] * h[0] - w[0] * h[2], w[0] * h[1] - w[1] * h[0]])
        found = {f"inertia_torque[{k}]": -t[k] - cross[k] for k in range(3)}
        return {**found, "rotational_energy": (w.T * h)[0] / 2}
    if task == "compare":
        return compared(composed(own["first"]["parts"]), composed(own["second"]["parts"]))
    return results(*composed(own["parts"]))


def composed(parts: list[dict[str, Any]]) -> tuple[Any, Any, Any]:
    """Mass, centroid and central second moments of an assembly."""
    sums = [mpf(0), matrix([0, 0, 0]), matrix(3, 3)]
    added(parts, matrix([0, 0, 0]), mp.eye(3), 1, sums)
    mass, centroid = sums[0], sums[1] / sums[0]
    return mass, centroid, sums[2] - mass * centroid * centroid.T


def compared(first: tuple[Any, Any, Any], second: tuple[Any, Any, Any]) -> dict[str, Any]:
    """Two bodies: masses, the way between the centroids, the turn between the axes, the distance of the tensors."""
    shift = second[1] - first[1]
    tensors = [sum(s[k, k] for k in range(3)) * mp.eye(3) - s for _, _, s in (first, second)]
    found = {"first_mass": first[0], "second_mass": second[0]}
    found |= {"mass_difference": second[0] - first[0], "mass_ratio": second[0] / first[0]}
    found |= {f"centroid_shift[{k}]": shift[k] for k in range(3)}
    found["centroid_distance"] = mp.norm(shift)
    found["tensor_distance"] = mp.mnorm(tensors[1] - tensors[0], "f") / mp.mnorm(tensors[0], "f")
    frames = [eigsy(tensor)[1] for tensor in tensors]
    turn = frames[0].T * frames[1]
    # the smallest of the turns by senses of the axes: of right-handed frames with the greatest trace
    turn *= mp.sign(mp.det(turn))
    signs = ((1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1))
    changed = [turn * mp.diag(sign) for sign in signs]
    best = max(changed, key=lambda r: r[0, 0] + r[1, 1] + r[2, 2])
    odd = (best - best.T) / 2
    sine = sqrt(odd[0, 1] ** 2 + odd[1, 2] ** 2 + odd[2, 0] ** 2)
    found["axes_angle"] = mp.atan2(sine, (best[0, 0] + best[1, 1] + best[2, 2] - 1) / 2)
    names = [*(f"moments.{n}" for n in ("xx", "yy", "zz")), *(f"products.{n}" for n in ("xy", "yz", "zx"))]
    names += [f"principal_moments.{n}" for n in ("first", "second", "third")]
    for row, name in enumerate(names):
        one, two = (results(*body)[name] for body in (first, second))
        found |= {f"moments[{row}].first": one, f"moments[{row}].second": two, f"moments[{row}].difference": two - one}
    return found
