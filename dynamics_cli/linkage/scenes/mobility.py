"""Degrees of freedom of a linkage: counted (Grübler), and true at a pose, with redundant conditions."""

from dynamics_cli.numerics.linkages.records import Scene
from dynamics_cli.quantities import Annotated, Count, Text
from dynamics_cli.records import Advice, Check, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# Singular values below this share of the largest are zero within rounding.
ZERO = 1e-9
# A condition is involved in a dependency with at least this share of it.
PART = 1e-3


@record
class Mobility:
    """The degrees of freedom of a linkage."""

    freedom: Annotated[Count, "Degrees of freedom at this pose, from the rank of its conditions."]
    counted: Annotated[int, "3(n − 1) − 2 j₁ − j₂."]
    links: Annotated[Count, "Links n, ground among them."]
    pins: Annotated[Count, "Pins j₁: a pin of three links counts twice."]
    slides: Annotated[Count, "Pins in slots j₂."]
    repeated: Annotated[Count, "Redundant conditions: the linkage is over-constrained by this number."]
    named: Annotated[Text | None, "The conditions involved."] = None
    gap: Annotated[float | None, "Ratio of the smallest singular value counted to the largest left out."] = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def mobility(
    scene: Annotated[Scene, "The linkage, from a file."],
    /,
) -> Mobility:
    """Degrees of freedom of a linkage: by counting, and true at the pose that its drivers give.

    Equation
    --------
    M = 3(n − 1) − 2j₁ − j₂; true: unknowns less the rank of the Jacobian of all conditions without drivers.

    Raises
    ------
    InadmissibleError
        As of `solve`.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 5.2.
    """
    import numpy as np

    from dynamics_cli.numerics.linkages.assemblies import assembled, chosen
    from dynamics_cli.numerics.linkages.system import System

    system = System(scene)
    possible, _ = assembled(system)
    q = system.vector(chosen(system, possible, True).at)
    free = [index for index, name in enumerate(system.names) if not name.startswith("driver")]
    jacobian = _undriven(system, q, free)
    left_vectors, values, _ = np.linalg.svd(jacobian)
    top = float(values.max(initial=0.0))
    rank = int((values > ZERO * top).sum())
    repeated = jacobian.shape[0] - rank
    names = _names(system, free, left_vectors[:, rank:]) if repeated else None
    joints = sum(
        sum(pin in shape.points for shape in system.shapes.values()) - 1
        for pin in (*system.known, *system.unknown)
        if any(pin in shape.points for shape in system.shapes.values())
    )
    count = 3 * (len(scene.links) - 1) - 2 * joints - len(scene.slides)
    freedom = system.size - rank
    return Mobility(
        freedom=freedom,
        counted=count,
        links=len(scene.links),
        pins=joints,
        slides=len(scene.slides),
        repeated=repeated,
        named=names,
        gap=float(values[rank - 1] / values[rank]) if 0 < rank < len(values) and values[rank] > 0.0 else None,
        advice=(
            Advice(
                "over-constrained",
                "the linkage moves only because its lengths fit exactly: manufacturing errors make it bind",
                remedy="give a pin play, or leave a link out",
            ),
        )
        if repeated and freedom > max(count, 0)
        else (),
    )


def _undriven(system: "Any", q: "Any", free: "list[int]") -> "Any":
    """Conditions without drivers; a driven link gets back the length condition that its driver replaced."""
    import numpy as np

    rows = [system.jacobian(q)[index] for index in free]
    places, half = system.positions(q), len(system.unknown)
    for driver in system.scene.drivers:
        if driver.point or driver.against != "ground":
            continue
        shape = system.shapes[driver.link]
        link_vector = places[shape.last] - places[shape.first]
        row = np.zeros(system.size)
        for pin, sign in ((shape.last, 1.0), (shape.first, -1.0)):
            if pin in system.place:
                row[system.place[pin]] = sign * link_vector.real
                row[half + system.place[pin]] = sign * link_vector.imag
        rows.append(row)
    return np.array(rows).reshape(len(rows), system.size)


def _names(system: "Any", free: "list[int]", null: "Any") -> str:
    import numpy as np

    weights = np.abs(null).max(axis=1)
    names = [system.names[index] for index in free]
    names += [f"length of {driver.link}" for driver in system.scene.drivers]
    chosen = [name for name, weight in zip(names, weights, strict=False) if weight > PART]
    return ", ".join(dict.fromkeys(chosen))
