"""Degrees of freedom of a linkage: counted (Grübler), and true at a pose, with redundant conditions."""

from dynamics_cli.numerics.linkages.records import Scene
from dynamics_cli.quantities import Annotated, Count, Text
from dynamics_cli.records import Advice, Check, record

TYPE_CHECKING = False

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
    undriven = System(Scene(scene.links, (), scene.slides))
    jacobian = undriven.jacobian(q)
    left_vectors, values, _ = np.linalg.svd(jacobian)
    top = float(values.max(initial=0.0))
    rank = int((values > ZERO * top).sum())
    repeated = jacobian.shape[0] - rank
    weights = np.abs(left_vectors[:, rank:]).max(axis=1, initial=0.0)
    involved = dict.fromkeys(name for name, weight in zip(undriven.names, weights, strict=True) if weight > PART)
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
        named=", ".join(involved) if repeated else None,
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
