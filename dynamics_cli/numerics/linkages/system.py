"""A linkage's equations in the coordinates of its pins: all quadratic, so that Newton's method can be proved.

Unknowns are the coordinates of the pins that are not on ground, in units of the scene's size. A link gives the length
of its base (two of its points) and every further point as an affine function of these; a slide a vanishing cross
product; a driver the direction of a base, or a position along a line.
"""

from copy import copy

import numpy as np

from dynamics_cli.errors import require
from dynamics_cli.numerics.linkages.records import GROUND, Driver, Link, Scene

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Row = tuple[Any, ...]

MOST_PINS = 40
UNIT = 2.0**-53


class Shape:
    """A link: its points in its own axes, and the base from its first point to the one farthest from it."""

    def __init__(self, link: Link, scale: float) -> None:
        self.name = link.name
        self.points = {pin.name: complex(*pin.at) / scale for pin in link.points}
        names = list(self.points)
        self.first = names[0]
        start = self.points[self.first]
        self.last = max(names, key=lambda name: abs(self.points[name] - start))
        self.base = self.points[self.last] - start

    def others(self) -> "list[tuple[str, complex]]":
        """Further points as shares of the base."""
        start = self.points[self.first]
        return [
            (name, (z - start) / self.base) for name, z in self.points.items() if name not in (self.first, self.last)
        ]


def checked(scene: Scene) -> None:
    """Refuse scenes with inconsistent names, and links of zero size."""
    names = [link.name for link in scene.links]
    require(GROUND in names, "no link is called ground: one link must be fixed", code="no-ground",
            hint=f"there are {', '.join(names)}: rename the fixed one")  # fmt: skip
    for name in names:
        require(names.count(name) == 1, "two links are called {name}", name=repr(name), code="same-name",
                hint="give every link its own name")  # fmt: skip
    for link in scene.links:
        pin_names = [pin.name for pin in link.points]
        require(
            len(set(pin_names)) == len(pin_names),
            "link {link} has a pin twice",
            link=repr(link.name),
            code="same-pin",
        )
        ends = [complex(*pin.at) for pin in link.points]
        require(
            link.name == GROUND or (len(ends) >= 2 and max(abs(end - ends[0]) for end in ends) > 0.0),
            "link {link} needs two points apart: a link needs a length above zero",
            link=repr(link.name),
            code="no-length",
        )
    pins = {pin.name for link in scene.links for pin in link.points}
    require(len(pins) <= MOST_PINS, "{count} pins; a scene has at most {most}", count=len(pins), most=MOST_PINS)
    shapes = {link.name: {pin.name: complex(*pin.at) for pin in link.points} for link in scene.links}
    for slide in scene.slides:
        line = shapes.get(slide.link, {})
        require(
            slide.point in pins and slide.start in line and slide.end in line,
            "the slide of {point} needs a pin of that name and two points of link {link}",
            hint="its start and end are points of that link",
            point=repr(slide.point),
            link=repr(slide.link),
            code="slide",
        )
        require(line[slide.start] != line[slide.end], "a slide along a line of length zero", code="no-length")
    _drivers_checked(scene, names)


def _drivers_checked(scene: Scene, names: "list[str]") -> None:
    for driver in scene.drivers:
        sliding = any(slide.point == driver.point for slide in scene.slides)
        require(
            sliding if driver.point else driver.link in names and driver.against in names,
            "the driver of {what} names no link of the scene, or no pin that slides",
            hint="the links are {known}; a pin that is pushed needs a slide",
            known=", ".join(names),
            what=repr(driver.point or driver.link),
            code="driver",
        )
        require(
            driver.point != "" or driver.link not in (GROUND, driver.against),
            "a driver cannot turn {link} against {against}",
            link=repr(driver.link),
            against=repr(driver.against),
            code="driver",
        )


class System:
    """The equations of a scene and the proof of their solutions."""

    def __init__(self, scene: Scene) -> None:
        checked(scene)
        self.scene = scene
        spans = [abs(complex(*p.at) - complex(*link.points[0].at)) for link in scene.links for p in link.points]
        self.scale = max(spans)
        self.shapes = {link.name: Shape(link, self.scale) for link in scene.links}
        ground = self.shapes[GROUND]
        every = list(dict.fromkeys(pin for shape in self.shapes.values() for pin in shape.points))
        self.known = dict(ground.points)
        self.unknown = [pin for pin in every if pin not in self.known]
        self.place = {pin: index for index, pin in enumerate(self.unknown)}
        self.rows: list[Row] = []
        self.names: list[str] = []
        self._build()
        self.size = 2 * len(self.unknown)
        self.linear, self.curved = self._quadratic()

    def moved(self, shift: float) -> "System":
        """The same with its first driver moved on by an angle, or along its slide."""
        first = self.scene.drivers[0]
        fields = {name: getattr(first, name) for name in Driver.fields}  # type: ignore[attr-defined]
        fields["position" if first.point else "angle"] += shift
        scene, other = self.scene, copy(self)
        other.scene = Scene(scene.links, (Driver(**fields), *scene.drivers[1:]), scene.slides, scene.sides, scene.near)
        other.rows, other.names = [], []
        other._build()
        if not first.point and first.against != GROUND:
            other.linear, other.curved = other._quadratic()
        return other

    def turned_against(self, driver: Driver) -> "tuple[Shape, Shape, float]":
        """The driven link, the link that its angle is measured from, and the angle between their bases."""
        driven, base_link = self.shapes[driver.link], self.shapes[driver.against]
        base = base_link.base if driver.against != GROUND else 1.0 + 0j
        return driven, base_link, driver.angle + float(np.angle(driven.base)) - float(np.angle(base))

    def _build(self) -> None:
        fixed = {driver.link for driver in self.scene.drivers if not driver.point and driver.against == GROUND}
        for shape in self.shapes.values():
            if shape.name == GROUND:
                continue
            if shape.name not in fixed:
                self._add(f"length of {shape.name}", ("length", shape.first, shape.last, abs(shape.base)))
            for name, ratio in shape.others():
                self._add(f"{name} on {shape.name}, along", ("point", name, shape.first, shape.last, ratio, 0))
                self._add(f"{name} on {shape.name}, across", ("point", name, shape.first, shape.last, ratio, 1))
        for slide in self.scene.slides:
            self._add(f"slide of {slide.point}", ("slide", slide.point, slide.start, slide.end))
        for driver in self.scene.drivers:
            if driver.point:
                slide = next(slide_ for slide_ in self.scene.slides if slide_.point == driver.point)
                points = self.shapes[slide.link].points
                span = abs(points[slide.end] - points[slide.start])
                self._add(
                    f"driver of {driver.point}", ("push", slide.point, slide.start, slide.end, span, driver, self.scale)
                )
                continue
            own_shape, other, angle = self.turned_against(driver)
            ends = (own_shape.first, own_shape.last)
            if driver.against == GROUND:
                target = abs(own_shape.base) * np.exp(1j * angle)
                for part in (0, 1):
                    self._add(f"driver of {driver.link}", ("turn", *ends, target, part, driver))
            else:
                self._add(f"driver of {driver.link}", ("angle", *ends, other.first, other.last, angle, driver))

    def _add(self, name: str, row: "Row") -> None:
        # conditions on fixed points only do not involve the unknowns
        if any(part in self.place for part in row if isinstance(part, str)):
            self.names.append(name)
            self.rows.append(row)

    def positions(self, q: "Any") -> "dict[str, complex]":
        """Every pin, in units of the scene's size."""
        half = len(self.unknown)
        return self.known | {pin: complex(q[i], q[half + i]) for pin, i in self.place.items()}

    def vector(self, at: "dict[str, complex]") -> "Any":
        """Unknown pins as one vector."""
        values = np.array([at[pin] for pin in self.unknown])
        return np.concatenate((values.real, values.imag))

    def residuals(self, q: "Any") -> "Any":
        """All equations at q."""
        places = self.positions(q)
        return np.array([_residual(row, places) for row in self.rows])

    def _quadratic(self) -> "tuple[Any, Any]":
        """The linear part and the constant second derivatives, by polarisation, exact to rounding."""
        n = self.size
        unit = np.eye(n)
        zero = self.residuals(np.zeros(n))
        plus = [self.residuals(unit[j]) for j in range(n)]
        minus = [self.residuals(-unit[j]) for j in range(n)]
        linear = np.array([0.5 * (p - m) for p, m in zip(plus, minus, strict=True)]).T.reshape(len(self.rows), n)
        curved = np.zeros((len(self.rows), n, n))
        for j in range(n):
            for k in range(j, n):
                mixed = self.residuals(unit[j] + unit[k]) - plus[j] - plus[k] + zero
                curved[:, j, k] = curved[:, k, j] = np.where(np.abs(mixed) > 1e-12, mixed, 0.0)
        return linear, curved

    def jacobian(self, q: "Any") -> "Any":
        """Derivatives of the equations."""
        return self.linear + self.curved @ q

    def rates(self, q: "Any", jacobian: "Any") -> "tuple[Any, Any]":
        """Velocities and accelerations of the unknowns for the drivers' rates."""
        places = self.positions(q)
        velocity = np.linalg.lstsq(jacobian, -np.array([_drift(row, places, self.scale) for row in self.rows]))[0]
        half = len(self.unknown)
        moving = dict.fromkeys(self.known, 0j) | {
            pin: complex(velocity[i], velocity[half + i]) for pin, i in self.place.items()
        }
        bend = np.einsum("j,ijk,k->i", velocity, self.curved, velocity)
        bend = bend + np.array([_second_drift(row, places, moving, self.scale) for row in self.rows])
        return velocity, np.linalg.lstsq(jacobian, -bend)[0]


def _residual(row: "Row", at: "dict[str, complex]") -> float:
    kind = row[0]
    if kind == "length":
        apart = at[row[2]] - at[row[1]]
        return 0.5 * (apart.real * apart.real + apart.imag * apart.imag - row[3] * row[3])  # type: ignore[no-any-return]
    if kind == "point":
        gap = at[row[1]] - at[row[2]] - row[4] * (at[row[3]] - at[row[2]])
        return float(gap.imag if row[5] else gap.real)
    if kind == "turn":
        gap = at[row[2]] - at[row[1]] - row[3]
        return gap.imag if row[4] else gap.real  # type: ignore[no-any-return]
    if kind == "angle":
        turned = (at[row[2]] - at[row[1]]) * (at[row[4]] - at[row[3]]).conjugate() * np.exp(-1j * row[5])
        return turned.imag  # type: ignore[no-any-return]
    offset, line = at[row[1]] - at[row[2]], at[row[3]] - at[row[2]]
    if kind == "slide":
        return float((line.conjugate() * offset).imag)
    return (line.conjugate() * offset).real - row[4] * row[5].position / row[6]  # type: ignore[no-any-return]


def _drift(row: "Row", at: "dict[str, complex]", scale: float) -> float:
    """Explicit change of an equation with time."""
    if row[0] == "turn":
        change = -1j * row[5].speed * row[3]
        return change.imag if row[4] else change.real  # type: ignore[no-any-return]
    if row[0] == "angle":
        turned = (at[row[2]] - at[row[1]]) * (at[row[4]] - at[row[3]]).conjugate() * np.exp(-1j * row[5])
        return (-1j * row[6].speed * turned).imag  # type: ignore[no-any-return]
    if row[0] == "push":
        return -row[4] * row[5].velocity / scale  # type: ignore[no-any-return]
    return 0.0


def _second_drift(row: "Row", at: "dict[str, complex]", moving: "dict[str, complex]", scale: float) -> float:
    """Terms of an equation's second time derivative besides J·q̈ and q̇·H·q̇."""
    if row[0] == "turn":
        driver = row[5]
        change = -(1j * driver.angular_acceleration - driver.speed * driver.speed) * row[3]
        return change.imag if row[4] else change.real  # type: ignore[no-any-return]
    if row[0] == "angle":
        driver, turn = row[6], np.exp(-1j * row[5])
        driven, base = at[row[2]] - at[row[1]], at[row[4]] - at[row[3]]
        driven_rate, base_rate = moving[row[2]] - moving[row[1]], moving[row[4]] - moving[row[3]]
        change = driven_rate * base.conjugate() + driven * base_rate.conjugate()
        square = driver.speed * driver.speed
        second = -2j * driver.speed * change - (1j * driver.angular_acceleration + square) * driven * base.conjugate()
        return (second * turn).imag  # type: ignore[no-any-return]
    if row[0] == "push":
        return -row[4] * row[5].acceleration / scale  # type: ignore[no-any-return]
    return 0.0


class Certificate:
    """Kantorovich's theorem at a solution: maximum distance of the true one, and minimum distance of any other."""

    def __init__(self, system: System, q: "Any", jacobian: "Any") -> None:
        inverse = np.linalg.pinv(jacobian)
        beta = float(np.linalg.norm(inverse, 2))
        # residuals are sums of a few products of coordinates of order one
        rounding = 16.0 * UNIT * (1.0 + float(np.abs(q).max(initial=0.0)) ** 2) * beta * len(q) ** 0.5
        step = float(np.linalg.norm(inverse @ system.residuals(q))) + rounding
        curve = float(np.sqrt(sum(np.linalg.norm(curvature, 2) ** 2 for curvature in system.curved)))
        self.step, self.curve = step, curve
        self.share = beta * curve * step
        root = max(0.0, 1.0 - 2.0 * self.share) ** 0.5
        self.proved = self.share <= 0.5
        self.error = 2.0 * step / (1.0 + root) * system.scale
        self.apart = (1.0 + root) / (beta * curve) * system.scale if curve else None
