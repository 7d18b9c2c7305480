"""Instant centres of every two links of a linkage, including those at infinity."""

from itertools import combinations

from dynamics_cli.numerics.linkages.records import GROUND, Scene
from dynamics_cli.quantities import Angle, Annotated, Count, PartPoint, Ratio, Text
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.linkage.scenes.solve import Solution

# A difference of angular velocities below this share of the largest is zero: the centre is at infinity.
PARALLEL = 1e-12


@record
class Centre:
    """The instant centre of two links."""

    first: Annotated[Text, "One link."]
    second: Annotated[Text, "The other."]
    position: Annotated[PartPoint | None, "The point that moves alike on both; none at infinity [m]."]
    direction: Annotated[Angle | None, "Direction in which it lies at infinity [rad]."]
    ratio: Annotated[Ratio | None, "Angular velocity of the second over that of the first; absent for ground."]


@record
class Centres:
    """All instant centres."""

    count: Annotated[Count, "Their number, n(n − 1)/2."]
    centres: Annotated[tuple[Centre, ...], "The centres."]


def centres(
    scene: Annotated[Scene, "The linkage, from a file."],
    /,
) -> Centres:
    """Instant centres of every pair of links; any three of three links lie on one line (Kennedy).

    Equation
    --------
    v_i + ω_i k×(p − r_i) = v_j + ω_j k×(p − r_j); homogeneous, so that equal angular velocities give a direction.

    Raises
    ------
    InadmissibleError
        As of `solve`, and at a pose where velocities are not determined or no driver moves.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 5.4 and 5.7.
    """
    from dynamics_cli.errors import require
    from dynamics_cli.linkage.scenes.solve import solve

    solved = solve(_moving(scene))
    require(
        solved.links is not None and solved.links[0].speed is not None,
        "velocities are not determined at this pose: it has no instant centres",
        code="singular",
        hint="move the driver a little",
    )
    motions = _motions(scene, solved)
    fastest = max(abs(speed) for speed, _ in motions.values())
    rows = []
    for a, b in combinations(motions, 2):
        (first, start), (second, end) = motions[a], motions[b]
        apart, drift = second - first, end - start
        ratio = second / first if abs(first) > PARALLEL * fastest and abs(second) > PARALLEL * fastest else None
        if abs(apart) > PARALLEL * fastest:
            place = 1j * drift / apart
            rows.append(Centre(a, b, (place.real, place.imag), None, ratio))
        else:
            from cmath import phase

            # square to the common translation
            rows.append(Centre(a, b, None, phase(1j * drift) if drift else None, ratio))
    return Centres(len(rows), tuple(rows))


def _moving(scene: Scene) -> Scene:
    """The scene with its first driver moving if none does: centres do not depend on the speed."""
    from dynamics_cli.numerics.linkages.records import Driver

    if any(driver.speed or driver.velocity for driver in scene.drivers):
        return scene
    drivers = list(scene.drivers)
    fields = {name: getattr(drivers[0], name) for name in Driver.fields}  # type: ignore[attr-defined]
    fields |= {"velocity": 1.0} if drivers[0].point else {"speed": 1.0}
    drivers[0] = Driver(**fields)
    return Scene(scene.links, tuple(drivers), scene.slides, scene.sides, scene.near)


def _motions(scene: Scene, solved: "Solution") -> "dict[str, tuple[float, complex]]":
    """Every link's angular velocity, and the velocity of its point at the origin."""
    pins = {pin.name: pin for pin in solved.pins or ()}
    motions: dict[str, tuple[float, complex]] = {GROUND: (0.0, 0j)}
    names = {link.name: link.points[0].name for link in scene.links}
    for link in solved.links or ():
        pin = pins[names[link.name]]
        speed = link.speed or 0.0
        motions[link.name] = (speed, complex(*(pin.velocity or (0.0, 0.0))) - 1j * speed * complex(*pin.position))
    return motions
