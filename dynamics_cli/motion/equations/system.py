"""A scene as functions: places, turns and loads for numbers or jets in place of the coordinates."""

import math

from dynamics_cli.errors import require
from dynamics_cli.motion.equations.records import ORIGIN, Turning
from dynamics_cli.numerics.elementary import cos, sin
from dynamics_cli.numerics.expressions import FUNCTIONS
from dynamics_cli.numerics.expressions.dimensions import LENGTH, NONE, RATE, SPEED, TIME
from dynamics_cli.numerics.expressions.jets import Jet
from dynamics_cli.numerics.expressions.laws import law_of, parsed
from dynamics_cli.numerics.number import plain

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping
    from typing import Any

    from dynamics_cli.motion.equations.records import Body, Point, Scene
    from dynamics_cli.records import Formula, Let

    Law = Callable[..., Any]
    Numbers = Mapping[str, Any]

MOST_COORDINATES, MOST_BODIES = 20, 60
TAKEN = (*FUNCTIONS, "pi", "t")
NOWHERE = (0.0, 0.0, 0.0)


class System:
    """The laws of a scene; `numbers` gives what stands for each coordinate, for t and, of loads, for NAME_dot."""

    def __init__(self, scene: "Scene", let: "tuple[Let, ...]", upward: str) -> None:
        self.scene = scene
        self.let = let
        self.up = {"x": 0, "y": 1, "z": 2}.get(upward)
        self.names = [one.name for one in scene.coordinates]
        self.angular = [isinstance(one, Turning) for one in scene.coordinates]
        self.dimensions: dict[str, tuple[int, ...]] = {"t": TIME}
        for name, turns in zip(self.names, self.angular, strict=True):
            self.dimensions |= {name: NONE, f"{name}_dot": RATE} if turns else {name: LENGTH, f"{name}_dot": SPEED}
        self.timed = False
        self._check_names()
        self.bodies = {body.name: body for body in scene.bodies}
        places: list[Body | Point] = [*scene.bodies, *scene.points]
        self.flat = upward != "z" and not any(
            getattr(one, "z", None) or getattr(one, "turns", ()) for one in (*places, *scene.forces)
        )
        # a place in space has a third coordinate
        self.places = {one.name: tuple(self._law(one, axis) for axis in ("x", "y", "z")) for one in places}
        self.turns = {body.name: self._turns_of(body) for body in scene.bodies}
        self.moments = {body.name: _moments(body) for body in scene.bodies}
        speeds = tuple(f"{name}_dot" for name in self.names)
        self.forces = {
            one.name: tuple(self._law(one, axis, speeds) for axis in ("x", "y", "z")) for one in scene.forces
        }
        self.torques = {one.name: self._law(one, "torque", speeds) for one in scene.torques}
        self.conditions = {one.name: self._law(one, "zero", speeds) for one in scene.conditions}
        self.speeds = {one.name: self._law(one, "rate" if one.angular else "velocity", speeds) for one in scene.speeds}
        self.twists = {one.name: self._law(one, "angle") for one in scene.torsion_springs}
        self._check_places()

    def place(self, name: str, numbers: "Numbers") -> "Any":
        """Where a point or a body's centre is."""
        return NOWHERE if name == ORIGIN else self.three(name, self.places[name], numbers)

    def three(self, name: str, laws: "Iterable[Law | None]", numbers: "Numbers") -> "Any":
        """Three components by their laws."""
        return tuple(0.0 if law is None else self.value(name, law, numbers) for law in laws)

    def value(self, name: str, law: "Law", numbers: "Numbers") -> "Any":
        """The value of a law; refuses one that has none, or no slope, at this instant."""
        try:
            value = law(**numbers)
            good = all(map(math.isfinite, _numbers(value)))
        except (ArithmeticError, ValueError):
            good = False
        require(good, "a formula of {name} has no value or no slope at this instant", name=name, code="no-value",
                hint="look for a root or a logarithm of what is not above zero, or a division by zero")  # fmt: skip
        clock = numbers["t"]
        if isinstance(clock, Jet) and not isinstance(value, Jet):
            # a number that carries more than a double cannot operate on jets
            return Jet([value, *[0.0] * (len(clock.parts) - 1)])
        return value

    def turned(self, name: str, vector: "Any", numbers: "Numbers") -> "Any":
        """A vector of the body's axes in space."""
        for axis, law in reversed(self.turns[name]):
            vector = spun(axis, self.value(name, law, numbers), vector)
        return vector

    def axes(self, name: str, numbers: "Numbers") -> "list[tuple[Any, Any]]":
        """The body's turns in order: the angle and the axis in space of each."""
        made: list[tuple[Any, Any]] = []
        earlier: list[tuple[int, Any]] = []
        for axis, law in self.turns[name]:
            vector: Any = tuple(1.0 if k == axis else 0.0 for k in range(3))
            for other, angle in reversed(earlier):
                vector = spun(other, angle, vector)
            angle = self.value(name, law, numbers)
            made.append((angle, vector))
            earlier.append((axis, angle))
        return made

    def heights(self, numbers: "Numbers") -> "list[Any]":
        """The height of each body's centre."""
        up = self.up
        return [0.0 if up is None else self.place(body.name, numbers)[up] for body in self.scene.bodies]

    def _turns_of(self, body: "Body") -> "list[tuple[int, Law]]":
        require(body.angle is None or not body.turns, "{name} has an angle and turns too", name=body.name, code="turns",
                hint="in space, give turns alone")  # fmt: skip
        require(body.moments is None or body.inertia == 0.0, "{name} has an inertia and moments too", name=body.name,
                code="inertia", hint="inertia is for the plane, moments are for space")  # fmt: skip
        inert = body.inertia != 0.0 or body.moments is not None
        require(not inert or body.angle is not None or bool(body.turns), "{name} has an inertia, but no angle",
                name=body.name, code="turns", hint="give its angle; 0 rad where it does not turn")  # fmt: skip
        if body.angle is not None:
            return [(2, self._law(body, "angle"))]  # type: ignore[list-item]
        return [("xyz".index(turn.axis), self._read(turn.angle, (), angular=True)) for turn in body.turns]

    def _law(self, of: "Any", field: str, speeds: "tuple[str, ...]" = ()) -> "Law | None":
        formula = getattr(of, field)
        return None if formula is None else self._read(formula, speeds, angular=field == "angle")

    def _read(self, formula: "Formula", speeds: "tuple[str, ...]", *, angular: bool) -> "Law":
        used = parsed(formula, {*self.dimensions, *(one.name for one in self.let)}).names
        # a coordinate is in metres or radians, which another unit at the end would count once more
        mixed = [
            name for name, turns in zip(self.names, self.angular, strict=True)
            if {name, f"{name}_dot"} & used and (angular or not turns or f"{name}_dot" in used)
        ]  # fmt: skip
        require(formula.factor == 1.0 or not mixed,
                "the formula {text} ends in {unit}, but {names} in it has a unit too", text=repr(formula.text),
                unit=formula.unit, names=", ".join(mixed), code="mixed-units",
                hint="coordinates are in m and rad: end the formula in m, rad, N or N*m")  # fmt: skip
        if not speeds:
            self.timed |= "t" in used
        known = {name: self.dimensions[name] for name in (*self.names, *speeds, "t")}
        return law_of(formula, self.let, known)

    def _check_names(self) -> None:
        scene = self.scene
        require(0 < len(self.names) <= MOST_COORDINATES, "{n} coordinates are none or too many", n=str(len(self.names)),
                code="count", hint="give 1 to {most}", most=str(MOST_COORDINATES))  # fmt: skip
        require(0 < len(scene.bodies) <= MOST_BODIES, "{n} bodies are none or too many", n=str(len(scene.bodies)),
                code="count", hint="give 1 to {most}", most=str(MOST_BODIES))  # fmt: skip
        taken = {*TAKEN, *(one.name for one in self.let)}
        for name in self.names:
            require(name.isidentifier() and name not in taken, "a coordinate cannot be called {name}",
                    name=repr(name), code="name",
                    hint="a word of its own: no function, no variable, not t")  # fmt: skip
            taken |= {name, f"{name}_dot"}
        loads: tuple[Any, ...] = (*scene.forces, *scene.torques, *scene.springs, *scene.torsion_springs)
        places: tuple[Any, ...] = (*scene.bodies, *scene.points)
        for one in scene.speeds:
            require((one.velocity is None) != (one.rate is None), "{name} needs a velocity or a rate", name=one.name,
                    code="speeds", hint="one of the two")  # fmt: skip
        for group in (places, loads, scene.conditions, scene.speeds):
            names = [one.name for one in group]
            double = [name for name in names if names.count(name) > 1 or name == ORIGIN]
            require(not double, "the name {name} is given twice", name=repr(double[0] if double else ""), code="name",
                    hint="call them apart; origin is the fixed point 0, 0")  # fmt: skip

    def _check_places(self) -> None:
        scene = self.scene
        known = {ORIGIN, *self.places}
        ends = [(one.name, at) for one in scene.springs for at in (one.start, one.end)]
        for name, at in (*((one.name, one.at) for one in scene.forces), *ends):
            require(at in known, "{name}: there is no point or body {at}", name=name, at=repr(at), code="unknown-name",
                    hint="there are {known}", known=", ".join(sorted(known)))  # fmt: skip
        for one in scene.torques:
            for at in (one.body, *([one.against] if one.against else [])):
                require(at in self.bodies, "{name}: there is no body {at}", name=one.name, at=repr(at),
                        code="unknown-name", hint="there are {known}", known=", ".join(self.bodies))  # fmt: skip


def spun(axis: int, angle: "Any", vector: "Any") -> "Any":
    """A vector turned about a coordinate axis."""
    c, s = cos(angle), sin(angle)
    j, k = (axis + 1) % 3, (axis + 2) % 3
    out = list(vector)
    out[j], out[k] = c * vector[j] - s * vector[k], s * vector[j] + c * vector[k]
    return tuple(out)


def _moments(body: "Body") -> "tuple[float, float, float]":
    if body.moments is None:
        return (0.0, 0.0, body.inertia)
    a, b, c = body.moments
    largest = max(a, b, c)
    good = min(a, b, c) >= 0.0 and a + b + c - largest >= largest * (1.0 - 1e-12)
    require(good, "{name}: no body has these moments of inertia", name=body.name, code="inertia",
            hint="none is negative, and none exceeds the sum of the other two")  # fmt: skip
    return body.moments


def _numbers(value: "Any") -> "list[float]":
    """The numbers of a jet, or of a jet of jets."""
    if not hasattr(value, "parts"):
        return [plain(value)]
    return [number for part in value.parts for number in _numbers(part)]
