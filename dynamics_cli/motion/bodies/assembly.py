"""How a scene is put together at its start, where it says so by `sides` and `near` as linkages do."""

from dynamics_cli.motion.bodies.laws import prescribed
from dynamics_cli.numerics.linkages.records import GROUND, Driver, Link, Slide
from dynamics_cli.numerics.linkages.records import Scene as Linkage

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.motion.bodies.records import Scene


def places_of(scene: "Scene", size: float) -> "dict[str, complex]":
    """Where pins are, in units of `size`: roughly as `near` says, or as the sides have it."""
    if not scene.sides:
        return {near.pin: complex(*near.at) / size for near in scene.near}
    from dynamics_cli.numerics.linkages.assemblies import assembled, chosen, require_driven
    from dynamics_cli.numerics.linkages.system import System

    links = tuple(Link(link.name, link.points) for link in scene.links if link.name == GROUND or len(link.points) > 1)
    slides = tuple(Slide(one.point, one.link, one.start, one.end) for one in scene.slides)
    drivers = _drivers(scene)
    # angles that the scene gives count as drivers, as far as it takes them
    driven = {driver.link for driver in drivers}
    turned = [Driver(one.name, angle=one.angle) for one in scene.links if one.angle and one.name not in driven]
    system = System(Linkage(links, tuple(drivers), slides, scene.sides, scene.near))
    while turned and len(system.rows) < system.size:
        drivers.append(turned.pop(0))
        system = System(Linkage(links, tuple(drivers), slides, scene.sides, scene.near))
    require_driven(system)
    at = chosen(system, assembled(system)[0], False).at
    return {pin: place * (system.scale / size) for pin, place in at.items()}


def _drivers(scene: "Scene") -> "list[Driver]":
    """Positions of drivers at the start."""
    drivers = []
    angles = {link.name: link.angle for link in scene.links}
    for driver in scene.drivers:
        start = angles.get(driver.link)
        known = driver.angle_law or driver.table or driver.position_law or driver.position is not None
        if not known and driver.angle is None and start is None:
            continue
        motion = prescribed(driver, start or 0.0, 1.0)
        first = motion.law(0.0)[0] if not motion.of_rate else driver.angle or start or 0.0
        place = {"point": driver.point, "position": first} if driver.point else {
            "link": driver.link, "against": driver.against, "angle": first}  # fmt: skip
        drivers.append(Driver(**place))  # type: ignore[arg-type]
    return drivers
