"""A scene's names as bodies, spots, joints and forces, in units of the scene's own size and mass; refusals of names."""

import math

from dynamics_cli.errors import require
from dynamics_cli.motion.bodies.forces import PointLoad, SpringForce, TorqueLoad, TorsionForce
from dynamics_cli.motion.bodies.joints import NONE, Along, Joint, Pin, Turn
from dynamics_cli.motion.bodies.laws import LOADED, Loading, linear, prescribed
from dynamics_cli.motion.bodies.records import Link, Scene
from dynamics_cli.numerics.fitting.records_file import read_columns
from dynamics_cli.numerics.linkages.records import GROUND
from dynamics_cli.quantities import Inertia, Mass

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.motion.bodies.records import Driver, Load, Slide

MOST_LINKS = 30
ON_A_POINT = ("t", "x", "y", "vx", "vy")
ON_A_LINK = ("t", "angle", "speed")


class Body:
    """A link that moves: its mass, its moment, and its points about the mass centre, in the scene's units."""

    def __init__(self, link: Link, size: float, mass: float) -> None:
        points = {one.name: complex(*one.at) for one in link.points}
        centre, moment = complex(*link.centroid), link.moment
        if link.rod:
            require(len(points) >= 2, "the rod {name} needs two points", name=repr(link.name), code="rod")
            first, second = list(points.values())[:2]
            centre, moment = 0.5 * (first + second), link.mass * abs(second - first) ** 2 / 12.0
        require(link.mass > 0.0 or moment == 0.0, "link {name} has a moment of inertia but no mass", code="massless",
                name=repr(link.name), hint="give its mass")  # fmt: skip
        self.name = link.name
        self.mass, self.moment = link.mass / mass, moment / (mass * size * size)
        self.centre = centre / size
        self.points = {name: (at - centre) / size for name, at in points.items()}
        self.reach = max([abs(at) for at in self.points.values()] + [math.sqrt(moment / link.mass) / size
                         if link.mass else 0.0])  # fmt: skip


class Built:
    """Bodies, spots, joints, forces; `size`, `mass` and what follows from them are the scene's units in SI."""

    def __init__(self, scene: Scene, gravity: float, *, static: bool = False) -> None:
        self.scene = scene
        require_names(scene)
        self.moving = [link for link in scene.links if link.name != GROUND]
        self.size, self.mass = _size(scene), max(link.mass for link in self.moving)
        if static and self.mass == 0.0:
            self.mass = 1.0
        require(self.mass > 0.0, "no link has a mass: {mass}", mass=(0.0, Mass), code="massless", hint="give masses")
        self.force, self.torque = self.mass * self.size, self.mass * self.size**2
        self.gravity = 0.0 if scene.horizontal else gravity / self.size
        self.bodies = [Body(link, self.size, self.mass) for link in self.moving]
        self.index = {body.name: k for k, body in enumerate(self.bodies)} | {GROUND: NONE}
        self.n = len(self.bodies)
        self.spots: list[tuple[int, float, float]] = []
        self.where: dict[tuple[str, str], int] = {}
        self.holders: dict[str, list[str]] = {}
        for link in sorted(scene.links, key=lambda link: link.name != GROUND):
            for point in link.points:
                self.holders.setdefault(point.name, []).append(link.name)
                self._spot(link.name, point.name, complex(*point.at))
        self.joints: list[Joint] = []
        self.rows = 0

    def _spot(self, link: str, name: str, at: complex) -> int:
        body = self.index[link]
        place = at / self.size if body == NONE else self.bodies[body].points.get(name, at / self.size)
        self.where[link, name] = len(self.spots)
        self.spots.append((body, place.real, place.imag))
        return self.where[link, name]

    def spot(self, name: str, link: str = "") -> "tuple[int, int]":
        """A spot and its body by the name of the point, on the link named or the first that has it."""
        place = self.where[link or self.holders[name][0], name]
        return place, self.spots[place][0]

    def connect(self, guess: "list[float]") -> None:
        """Make joints, drivers and forces; what the scene leaves out is as in the first guess of the pose."""
        for name, links in self.holders.items():
            for other in links[1:]:
                self._add(name, "pin", other, links[0], [Pin(self.rows, self.spot(name, other), self.spot(name))],
                          self.where[other, name])  # fmt: skip
        for slide in self.scene.slides:
            self._slide(slide, guess)
        for weld in self.scene.welds:
            self._weld(weld)
        for driver in self.scene.drivers:
            self._drive(driver, guess)
        self.forces: list[Any] = []
        self._springs(guess)
        for load in self.scene.loads:
            self._load(load)

    def _add(self, name: str, kind: str, link: str, by: str, parts: "list[Any]", spot: int = NONE) -> None:
        self.joints.append(Joint(name, kind, link, by, parts, spot))
        self.rows += sum(part.size for part in parts)

    def angle(self, guess: "list[float]", link: str, against: str) -> float:
        """The angle between two links in the guess."""
        i, j = self.index[link], self.index[against]
        return (guess[3 * i + 2] if i != NONE else 0.0) - (guess[3 * j + 2] if j != NONE else 0.0)

    def _line(self, slide: "Slide") -> "tuple[tuple[int, int], complex]":
        start, body = self.spot(slide.start, slide.link)
        end = self.spot(slide.end, slide.link)[0]
        way = complex(self.spots[end][1] - self.spots[start][1], self.spots[end][2] - self.spots[start][2])
        require(way != 0.0, "the slide of {point} has a line of length zero", point=repr(slide.point), code="no-length")
        return (start, body), way / abs(way)

    def _slide(self, slide: "Slide", guess: "list[float]") -> None:
        start, way = self._line(slide)
        holder = slide.slider or next(name for name in self.holders[slide.point] if name != slide.link)
        spot = self.spot(slide.point, holder)
        parts: list[Any] = [Along(self.rows, spot, start, 1j * way)]
        if slide.slider:
            angle = self.angle(guess, slide.slider, slide.link)
            parts.append(Turn(self.rows + 1, self.index[slide.slider], start[1], angle))
        self._add(f"slide of {slide.point}", "slide", holder, slide.link, parts, spot[0])

    def _weld(self, weld: "Any") -> None:
        at, own = complex(*weld.at), f"weld of {weld.link}"
        bodies = self.index[weld.link], self.index[weld.to]
        first, second = self._spot(weld.link, own, 0j), self._spot(weld.to, own, at)
        for spot, body, there in ((first, bodies[0], 0j), (second, bodies[1], at)):
            if body != NONE:
                place = there / self.size - self.bodies[body].centre
                self.spots[spot] = (body, place.real, place.imag)
        parts = [Pin(self.rows, (first, bodies[0]), (second, bodies[1])), Turn(self.rows + 2, *bodies, weld.angle)]
        self._add(own, "weld", weld.link, weld.to, parts, first)

    def _drive(self, driver: "Driver", guess: "list[float]") -> None:
        if not driver.point:
            start = self.angle(guess, driver.link, driver.against)
            motion = prescribed(driver, start, 1.0)
            first = driver.angle if driver.angle is not None else start
            part = Turn(self.rows, self.index[driver.link], self.index[driver.against], first, motion)
            self._add(f"driver of {driver.link}", "driver", driver.link, driver.against, [part])
            return
        slide = next(one for one in self.scene.slides if one.point == driver.point)
        line, way = self._line(slide)
        holder = slide.slider or next(name for name in self.holders[slide.point] if name != slide.link)
        spot = self.spot(slide.point, holder)
        here = Along(0, spot, line, way).gap(0.0, self.frame(guess))[0] * self.size
        push = Along(self.rows, spot, line, way, prescribed(driver, here, self.size))
        self._add(f"driver of {driver.point}", "driver", holder, slide.link, [push], spot[0])

    def frame(self, guess: "list[float]") -> "Any":
        """The bodies at rest in a pose."""
        from dynamics_cli.motion.bodies.frame import Frame

        return Frame(self.n, self.spots, [*guess[: 3 * self.n], *[0.0] * 3 * self.n])

    def _springs(self, guess: "list[float]") -> None:
        f = self.frame(guess)
        for spring in self.scene.springs:
            name = f"{spring.from_} to {spring.to}"
            free = None if spring.free_length is None else spring.free_length / self.size
            ends = self.spot(spring.from_), self.spot(spring.to)
            one = SpringForce(name, *ends, spring.stiffness / self.mass, 0.0, spring.damping / self.mass)
            one.free = one.length(f) if free is None else free
            self.forces.append(one)
        for torsion in self.scene.torsions:
            angle = self.angle(guess, torsion.link, torsion.against)
            self.forces.append(
                TorsionForce(
                    self.index[torsion.link], self.index[torsion.against], torsion.stiffness / self.torque,
                    angle if torsion.free_angle is None else torsion.free_angle, torsion.damping / self.torque,
                )
            )  # fmt: skip

    def _load(self, load: "Load") -> None:
        formulas = {name: getattr(load, name) for name in LOADED}
        given: dict[str, Any] = {
            name: formula and Loading(formula, ON_A_LINK if name == "torque" else ON_A_POINT)
            for name, formula in formulas.items()
        }
        if load.table:
            times, columns = read_columns(load.table, LOADED)
            self.knots += tuple(times)
            for name, values in columns.items():
                given[name] = _over(linear(times, values))
        if given["force_x"] or given["force_y"]:
            require(bool(load.point), "a force needs the point where it acts", code="load", hint="point = …")
            along = self.index[load.link] if load.link else NONE
            x, y = given["force_x"], given["force_y"]
            self.forces.append(PointLoad(self.spot(load.point), x, y, along, (self.size, self.force)))
        if given["torque"]:
            require(bool(load.link), "a torque needs the link that it turns", code="load", hint="link = …")
            self.forces.append(TorqueLoad(self.index[load.link], given["torque"], self.torque))

    knots: "tuple[float, ...]" = ()


def _over(value: "Any") -> "Any":
    return lambda given: value(given["t"])[0]


def _size(scene: Scene) -> float:
    spans = [abs(complex(*p.at) - complex(*link.points[0].at)) for link in scene.links for p in link.points]
    spans += [abs(complex(*link.centroid)) for link in scene.links]
    apart = [abs(complex(*link.position)) for link in scene.links if link.position]
    free = [spring.free_length or 0.0 for spring in scene.springs]
    return max(spans, default=0.0) or max([*apart, *free], default=0.0) or 1.0


def require_names(scene: Scene) -> None:
    """Refuse names that do not fit, and numbers that no body has."""
    names = [link.name for link in scene.links]
    require(any(name != GROUND for name in names), "no link moves: all there is is ground", code="no-links")
    require(len(names) <= MOST_LINKS, "{n} links; a scene has at most {most}", n=len(names), most=MOST_LINKS,
            code="count")  # fmt: skip
    for link in scene.links:
        require(names.count(link.name) == 1, "two links are called {name}", name=repr(link.name), code="same-name")
        own = [point.name for point in link.points]
        require(len(set(own)) == len(own), "a point stands twice in link {link}", link=repr(link.name), code="same-pin")
        require(link.moment >= 0.0, "link {link} has a moment of {moment}", link=repr(link.name), code="massless",
                moment=(link.moment, Inertia))  # fmt: skip
    links = {*names, GROUND}
    points = {point.name: link.name for link in scene.links for point in link.points}
    of = {link.name: {point.name for point in link.points} for link in scene.links}

    def known(name: str, those: "Any", what: str, where: str) -> None:
        require(name in those, "{where} names the {what} {name}, which the scene does not have", where=where, what=what,
                name=repr(name), code=f"unknown-{what}", hint="{what}s are {list}",
                list=", ".join(sorted(those)[:12]) or "none")  # fmt: skip

    for slide in scene.slides:
        where = f"the slide of {slide.point!r}"
        known(slide.point, points, "point", where)
        known(slide.link, links, "link", where)
        for end in (slide.start, slide.end):
            known(end, of.get(slide.link, ()), "point", f"{where} on {slide.link!r}")
        require(any(slide.point in own and name != slide.link for name, own in of.items()),
                "{where} needs a point of another link", where=where, code="slide")  # fmt: skip
        require(not slide.slider or slide.point in of.get(slide.slider, ()), "{where}: {slider} does not have it",
                where=where, slider=repr(slide.slider), code="slide")  # fmt: skip
    _require_others(scene, known, links, points)


def _require_others(scene: Scene, known: "Any", links: "set[str]", points: "dict[str, str]") -> None:
    for weld in scene.welds:
        known(weld.link, links - {GROUND}, "link", "a weld")
        known(weld.to, links - {weld.link}, "link", "a weld")
    for spring in scene.springs:
        for end in (spring.from_, spring.to):
            known(end, points, "point", "a spring")
        require(spring.from_ != spring.to, "a spring from {end} to itself", end=repr(spring.from_), code="spring")
    for torsion in scene.torsions:
        known(torsion.link, links, "link", "a torsion spring")
        known(torsion.against, links - {torsion.link}, "link", "a torsion spring")
    for near in scene.near:
        known(near.pin, points, "point", "near")
    sliding = {slide.point for slide in scene.slides}
    for driver in scene.drivers:
        if driver.point:
            known(driver.point, sliding, "point", "a driver along a slide")
        else:
            known(driver.link, links - {GROUND}, "link", "a driver")
            known(driver.against, links - {driver.link}, "link", f"the driver of {driver.link!r}")
    for load in scene.loads:
        if load.point:
            known(load.point, points, "point", "a load")
        if load.link:
            known(load.link, links - {GROUND}, "link", "a load")
        given = (load.force_x, load.force_y, load.torque, load.table or None)
        require(any(one is not None for one in given), "a load has no force, torque or table", code="load")
