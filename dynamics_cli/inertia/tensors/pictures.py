"""Pictures of inertia tensors: Mohr's circles, the parts of a torque, two bodies compared."""

from math import cos, pi, sin

from dynamics_cli.numerics.number import over_plain
from dynamics_cli.pictures import Axis, Band, Bars, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import Inertia, ProductOfInertia, Ratio, Torque

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

STEPS = 96


def mohr(result: "Any", **_: "Any") -> Picture:
    """Mohr's three circles: every direction's moment and product lies between them."""
    answer = over_plain(result)
    main = [float(moment) for moment in (answer.principal_moments.first, answer.principal_moments.second,
                                   answer.principal_moments.third)]  # fmt: skip
    items: list[Any] = []
    for role, (i, j) in enumerate(((0, 2), (0, 1), (1, 2))):
        centre, radius = 0.5 * (main[i] + main[j]), 0.5 * abs(main[j] - main[i])
        turns = [pi * k / STEPS for k in range(STEPS + 1)]
        x, y = [centre + radius * cos(t) for t in turns], [radius * sin(t) for t in turns]
        items.append(Curve(x, y, f"axes {i + 1} and {j + 1}", "dashed" if role else "solid", role))
    tensor = answer.tensor
    for k, name in enumerate("xyz"):
        products = [tensor[k][other] for other in range(3) if other != k]
        items.append(Mark(float(tensor[k][k]), float(sum(product * product for product in products) ** 0.5), name))
    items += [Mark(value, 0.0, name, (4.0, -12.0)) for value, name in zip(main, ("I₁", "I₂", "I₃"), strict=True)]
    axes = Axis("moment of inertia", Inertia), Axis("magnitude of the product of inertia", ProductOfInertia)
    return Picture((Panel(*axes, tuple(items), equal=True),), "Mohr's circles")


def torque(result: "Any", **_: "Any") -> Picture:
    """The inertia torque by components, each split into angular acceleration and gyroscopic parts."""
    answer = over_plain(result)
    names, values = [], []
    for title, vector in (
        ("acceleration", answer.acceleration_part),
        ("gyroscopic", answer.gyroscopic_part),
        ("inertia torque", answer.inertia_torque),
    ):
        for name, part in zip("xyz", vector, strict=True):
            names.append(f"{title}, {name}")
            values.append(float(part))
    bars = Bars(tuple(names), [min(value, 0.0) for value in values], [max(value, 0.0) for value in values])
    items = (bars, Band(0.0, 0.0))
    return Picture((Panel(Axis("torque", Torque), Axis(""), items),), "inertia torque and its parts")


def compared(result: "Any", *_: "Any", **__: "Any") -> Picture:
    """Each moment of the second body against the first's."""
    answer = over_plain(result)
    rows = [(row.moment, float(row.ratio) - 1.0) for row in answer.moments if row.ratio is not None]
    rows.insert(0, ("mass", float(answer.mass_ratio) - 1.0))
    ends = [value for _, value in rows]
    bars = Bars(
        tuple(name for name, _ in rows), [min(value, 0.0) for value in ends], [max(value, 0.0) for value in ends]
    )
    panel = Panel(Axis("second over first, less one", Ratio), Axis(""), (bars, Band(0.0, 0.0)))
    return Picture((panel,), "two bodies compared")
