"""The task `mass-matrix`: the matrix of Kane's equations and the forces beside it."""

from dynamics_cli.multibody.bodies.records import Scene, Upward
from dynamics_cli.multibody.bodies.results import MassRow, effort, mass_rows
from dynamics_cli.multibody.bodies.system import System
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.trees.matrix import mass_matrix, partial
from dynamics_cli.numerics.trees.newton_euler import inverse
from dynamics_cli.numerics.vectors import dot, times
from dynamics_cli.quantities import STANDARD_GRAVITY, Annotated, FreeNumber, Gravity, Ratio, Text
from dynamics_cli.records import Advice, Check, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

# Composite bodies and partial velocities agree within this share of √(a_ll·a_pp).
SAME = 1e-11


@record
class ForceRow:
    """The forces of one of Kane's equations: Σ a_lp·ẏ_p = motor + springs + loads − weight − velocity."""

    name: Annotated[Text, "The speed."]
    inertia: Annotated[FreeNumber, "a_ll, the inertia that this speed alone sets in motion."]
    weight: Annotated[FreeNumber, "What weights take."]
    velocity: Annotated[FreeNumber, "What the speeds alone take: centrifugal, Coriolis, gyroscopic."]
    springs: Annotated[FreeNumber, "What springs and dampers in the joint give."]
    loads: Annotated[FreeNumber, "What loads give."]
    motor: Annotated[FreeNumber, "What the joint's motor gives."]


@record
class Coupling:
    """An element of the mass matrix beside its diagonal."""

    name: Annotated[Text, "The speed of its row."]
    other: Annotated[Text, "That of its column."]
    value: Annotated[FreeNumber, "a_lp."]


@record
class MassMatrix:
    """Kane's equations of a tree at an instant."""

    matrix: Annotated[tuple[MassRow, ...], "The mass matrix a_lp, rows and columns in the order of the speeds."]
    forces: Annotated[tuple[ForceRow, ...], "The forces beside it."]
    couplings: Annotated[tuple[Coupling, ...], "Elements below the diagonal that are not zero."]
    eigenvalues: Annotated[
        tuple[Ratio, ...], "Eigenvalues of the matrix scaled to ones on its diagonal, largest first [-]."
    ]
    condition: Annotated[Ratio | None, "The largest of them over the smallest; null where the matrix is singular [-]."]
    numerics: Numerics
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def matrix(
    scene: Annotated[Scene, "The bodies, from a file."],
    /,
    *,
    up: Annotated[Upward, "The axis that points up: x, y, z, or none without gravity."] = Upward("z"),  # noqa: B008
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> MassMatrix:
    """Mass matrix of a tree of bodies, and weight, velocity, spring and load forces, for every generalized speed.

    Equation
    --------
    a_lp = Σ_K m_K·v_Kl·v_Kp + ω_Kl·I_K·ω_Kp; h_l = Σ_K m_K·v_Kl·a_K + ω_Kl·(I_K·α_K + ω_K × I_K·ω_K) at ẏ = 0.

    Raises
    ------
    InadmissibleError
        When a joint has too many numbers, or no body has the tensor given.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 18.16 and 18.17.

    Examples
    --------
    >>> from dynamics_cli.multibody.bodies.records import Body
    >>> arm = Body("arm", axis=(0.0, 1.0, 0.0), mass=3.0, rod=(1.0, 0.0, 0.0))
    >>> matrix(Scene((arm,))).matrix[0].values[0].value
    1.0
    """
    system = System(scene, up, gravity)
    system.require_open()
    tree, frames = system.tree, system.frames
    still = [0.0] * tree.speeds
    rows = mass_matrix(tree, frames)
    weight, _ = inverse(tree, frames, still, ground=system.base)
    velocity, _ = inverse(tree, frames, system.speeds)
    loads, _ = inverse(tree, frames, still, loads=system.loads)
    springs = system.spring_efforts()
    named = mass_rows(system, rows)
    columns = zip(weight, velocity, springs, (0.0 - load for load in loads), system.efforts, strict=True)
    forces = (
        ForceRow(row.name, row.values[k], *(effort(system.turning[k], part) for part in parts))
        for k, (row, parts) in enumerate(zip(named, columns, strict=True))
    )
    couplings = (
        Coupling(row.name, named[j].name, row.values[j])
        for k, row in enumerate(named) for j in range(k) if plain(rows[k][j]) != 0.0
    )  # fmt: skip
    eigenvalues = _eigenvalues(rows)
    singular = not eigenvalues or eigenvalues[-1] < 1e-14 * eigenvalues[0]
    apart = _apart(system, rows)
    return MassMatrix(
        matrix=named,
        forces=tuple(forces),
        couplings=tuple(couplings),
        eigenvalues=eigenvalues,
        condition=None if singular else eigenvalues[0] / eigenvalues[-1],
        numerics=Numerics("composite bodies"),
        checks=(Check("partial velocities give the same matrix", apart <= SAME, apart, SAME),),
        advice=tuple(system.advice),
    )


def _eigenvalues(rows: "Sequence[Sequence[float]]") -> "tuple[float, ...]":
    """Of the matrix scaled by its diagonal, which makes them free of units; a speed without inertia counts zero."""
    import numpy as np

    doubles = np.array([[plain(x) for x in row] for row in rows])
    size = np.sqrt(np.where(doubles.diagonal() > 0.0, doubles.diagonal(), 1.0))
    return tuple(max(float(x), 0.0) for x in np.linalg.eigvalsh(doubles / np.outer(size, size))[::-1])


def _apart(system: System, rows: "Sequence[Sequence[float]]") -> float:
    """The largest difference from the sum over partial velocities, on the scale of the diagonal."""
    count = system.tree.speeds
    total = [[0.0] * count for _ in range(count)]
    for k, link in enumerate(system.tree.links):
        for column in range(len(link.columns)):
            total[link.first + column][link.first + column] += plain(link.rotor)
        ways = partial(system.tree, system.ground, k, system.centre(k))
        # turning ways in the axes of the link, where its tensor is known
        rotation = tuple(zip(*system.ground[k][0], strict=True))
        local = [times(rotation, turning) for turning, _ in ways]  # type: ignore[arg-type]
        spun = [times(link.tensor, turning) for turning in local]
        for i in range(count):
            for j in range(i + 1):
                term = plain(link.mass * dot(ways[i][1], ways[j][1]) + dot(local[i], spun[j]))
                total[i][j] += term
                total[j][i] += term if i != j else 0.0
    sizes = [abs(total[k][k]) ** 0.5 for k in range(count)]
    # what has no inertia is measured against what has
    least = 1e-6 * max(sizes, default=0.0) or 1.0
    sizes = [max(size, least) for size in sizes]
    pairs = ((i, j) for i in range(count) for j in range(count))
    return max((abs(total[i][j] - plain(rows[i][j])) / (sizes[i] * sizes[j]) for i, j in pairs), default=0.0)
