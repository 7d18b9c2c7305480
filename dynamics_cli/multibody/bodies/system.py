"""A scene as a tree of links with its state, loads and springs."""

from dynamics_cli.errors import UsageError, require, worded
from dynamics_cli.multibody.bodies.ordering import ordered
from dynamics_cli.multibody.bodies.records import GROUND, ORIGIN, Body, Scene, Upward
from dynamics_cli.multibody.bodies.springs import PointSpring, spring_wrenches
from dynamics_cli.numerics.eigen3.jacobi import eigen
from dynamics_cli.numerics.elementary import sqrt
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.orientation.rotations import IDENTITY, matrix_of
from dynamics_cli.numerics.trees.newton_euler import back
from dynamics_cli.numerics.trees.tree import BALL, FIXED, PRISMATIC, REVOLUTE, UNITS, Link, Tree, placed, poses
from dynamics_cli.numerics.vectors import add, cross, times
from dynamics_cli.quantities import Angle, Inertia, Length, Ratio
from dynamics_cli.records import Advice

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from dynamics_cli.numerics.trees.newton_euler import Wrench
    from dynamics_cli.numerics.trees.tree import Pose
    from dynamics_cli.numerics.vectors import Tensor, Vector

# How many turning and sliding speeds each joint has.
COUNTS = {"revolute": (1, 0), "prismatic": (0, 1), "cylindrical": (1, 1), "universal": (2, 0), "ball": (3, 0),
          "planar": (1, 2), "free": (3, 3), "fixed": (0, 0)}  # fmt: skip
# Euler parameters and tensors are typed with few digits; one farther off is a mistake, or worth a word.
ROUNDED, TYPED = 1e-6, 1e-3


class System:
    """Links of a scene in order, with what belongs to each speed: its name, and whether it turns."""

    def __init__(self, scene: Scene, up: Upward = Upward("z"), gravity: float = 9.80665) -> None:  # noqa: B008
        require(scene.bodies, "the scene has no bodies", code="no-bodies", hint="give at least one under [[bodies]]")
        self.scene = scene
        self.order = ordered([body.name for body in scene.bodies], [body.parent for body in scene.bodies])
        self.bodies = [scene.bodies[k] for k in self.order]
        self.advice: list[Advice] = []
        # the link of each body; the joints of some need links without mass before it
        self.link: dict[str, int] = {GROUND: -1}
        self.names: list[str] = []
        self.turning: list[bool] = []
        self.coordinates: list[float] = []
        self.speeds: list[float] = []
        self.accelerations: list[float] = []
        self.efforts: list[float] = []
        self.springs: list[Spring] = []
        # whether the scene gives them, or leaves them zero
        self.placed: list[bool] = []
        self.moving: list[bool] = []
        links: list[Link] = []
        for body in self.bodies:
            self._add(body, links)
        self.tree = Tree(links)
        self.at(self.coordinates, self.speeds)
        self.gravity = pull = gravity if up != "none" else 0.0
        # the weight of things, as an upward acceleration of the ground
        self.base: Vector = tuple(pull * x for x in UNITS["xyz".index(up)]) if up != "none" else ORIGIN  # type: ignore[assignment]
        self.between = [
            PointSpring(spring, n, (self.body_link(spring.first), self.body_link(spring.second)))
            for n, spring in enumerate(scene.springs, 1)
        ]
        self.begin()
        self._say_passed()
        if scene.drives:
            self.advice.append(Advice("drives", "drives count in simulate alone: here joints move as their bodies say"))

    def at(self, coordinates: "list[float]", speeds: "list[float]") -> None:
        """Put the bodies into another state."""
        self.coordinates, self.speeds = coordinates, speeds
        self.frames: list[Pose] = poses(self.tree, coordinates)
        self.ground: list[Pose] = placed(self.tree, self.frames)

    def begin(self) -> None:
        """Take the place where the bodies stand as that of the scene: loads and free lengths of springs follow."""
        for spring in self.between:
            spring.begin(self.ground)
        self.loads = loads_of(self)

    def body_link(self, name: str) -> int:
        """The link of a body; refuses an unknown name."""
        require(name in self.link, "there is no body {name}", name=repr(name), code="unknown-body",
                hint="bodies are {known}", known=", ".join(body.name for body in self.bodies))  # fmt: skip
        return self.link[name]

    def speed(self, name: str) -> int:
        """The place of a speed; refuses an unknown name."""
        require(name in self.names, "there is no speed {name}", name=repr(name), code="unknown-speed",
                hint="speeds are {known}", known=", ".join(self.names))  # fmt: skip
        return self.names.index(name)

    def centre(self, k: int) -> "Vector":
        """The mass centre of a link, in the ground's frame."""
        rotation, origin = self.ground[k]
        return add(origin, times(rotation, self.tree.links[k].centroid))

    def require_open(self) -> None:
        """Refuse loops, where only trees are answered."""
        require(not self.scene.loops, "the scene closes loops, which this task does not take", code="loops",
                hint="dynamics multibody accelerations takes them")  # fmt: skip

    def _say_passed(self) -> None:
        """A word on every joint that starts beyond a stop."""
        for name, turning, spring in zip(self.names, self.turning, self.springs, strict=True):
            far = 0.0 if spring.place is None else abs(plain(spring.beyond(self.coordinates[spring.place])))
            if far:
                way = far, Angle if turning else Length
                self.advice.append(Advice("stop", worded("{name} is {far:4} beyond its stop", name=name, far=way)))

    def spring_efforts(self) -> "list[float]":
        """Efforts of springs and dampers in the joints."""
        return [spring.effort(self.coordinates, y) for spring, y in zip(self.springs, self.speeds, strict=True)]

    def _add(self, body: Body, links: "list[Link]") -> None:
        turns, slides = COUNTS[body.joint]
        _refuse_what_the_joint_lacks(body, turns, slides)
        state = _state(body, turns, slides)
        mass, centroid, tensor = _inertia(body)
        parts = _parts(body, str(body.joint))
        parent, rotation, position = (
            self.link[body.parent],
            matrix_of(body.turn) if body.turn else IDENTITY,
            body.position,
        )
        for n, (joint, axis, label) in enumerate(parts):
            last = n == len(parts) - 1
            links.append(Link(
                body.name, parent, joint, axis=axis, position=position, rotation=rotation,
                mass=mass if last else 0.0, centroid=centroid if last else ORIGIN,
                tensor=tensor if last else (ORIGIN, ORIGIN, ORIGIN),
                rotor=body.rotor_inertia if joint == REVOLUTE else 0.0,
            ))  # fmt: skip
            parent, rotation, position = len(links) - 1, IDENTITY, ORIGIN
            self._speeds(body, joint, label, state)
        self.link[body.name] = len(links) - 1

    def _speeds(self, body: Body, joint: str, label: str, state: "dict[str, list[float]]") -> None:
        """Names and values of the speeds of one link."""
        if joint == FIXED:
            return
        turning = joint != PRISMATIC
        count = 3 if joint == BALL else 1
        for n in range(count):
            self.names.append(body.name + (f" {label}{'xyz'[n]}" if joint == BALL else label and f" {label}"))
            self.turning.append(turning)
            self.placed.append(bool(body.orientation if joint == BALL else body.angle if turning else body.slide))
            self.moving.append(bool(body.speed if turning else body.velocity))
            self.springs.append(_spring(body, turning, None if joint == BALL else len(self.coordinates)))
            for numbers, address in ((self.speeds, "speed velocity"), (self.efforts, "torque force"),
                                     (self.accelerations, "angular_acceleration acceleration")):  # fmt: skip
                numbers.append(state[address.split()[not turning]].pop(0))
        if joint == BALL:
            self.coordinates += self._orientation(body)
        else:
            self.coordinates.append(state["angle" if turning else "slide"].pop(0))

    def _orientation(self, body: Body) -> "list[float]":
        """The Euler parameters of a ball joint, of length one."""
        q = body.orientation or (1.0, 0.0, 0.0, 0.0)
        size = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3])
        if not plain(size) > 0.0:
            raise UsageError(f"the orientation of {body.name} has no length", code="rotation",
                             hint="1, 0, 0, 0 leaves the axes as they are")  # fmt: skip
        if abs(plain(size) - 1.0) > ROUNDED:
            message = worded("the Euler parameters of {body} have the length {size:6}; they are scaled to 1",
                             body=body.name, size=(plain(size), Ratio))  # fmt: skip
            self.advice.append(Advice("orientation", message))
        return [x / size for x in q]


class Spring:
    """The spring and the damper that act on one speed; `place` is that of the coordinate, None in a ball joint."""

    def __init__(self, place: "int | None", stiffness: float, free: float, damping: float) -> None:
        self.place, self.stiffness, self.free, self.damping = place, stiffness, free, damping
        # stops: the smallest and the largest coordinate, and their stiffness
        self.lower: float | None = None
        self.upper: float | None = None
        self.stop = 0.0

    def effort(self, coordinates: "Sequence[float]", speed: float) -> float:
        """What they add to the effort of the joint's motor."""
        damped = -(self.damping * speed)
        if self.place is None:
            return damped
        at = coordinates[self.place]
        effort = damped - self.stiffness * (at - self.free)
        return effort - self.stop * self.beyond(at) if self.lower is not None or self.upper is not None else effort

    def beyond(self, coordinate: float) -> float:
        """How far a coordinate is above its upper stop, or below the lower one, negative then; 0 between."""
        if self.upper is not None and plain(coordinate) > plain(self.upper):
            return coordinate - self.upper
        if self.lower is not None and plain(coordinate) < plain(self.lower):
            return coordinate - self.lower
        return 0.0

    def energy(self, coordinates: "Sequence[float]") -> float:
        """What the spring and the stops store."""
        if self.place is None:
            return 0.0
        at = coordinates[self.place]
        stretch, pressed = at - self.free, self.beyond(at)
        return 0.5 * (self.stiffness * stretch * stretch + self.stop * pressed * pressed)


def _spring(body: Body, turning: bool, place: "int | None") -> Spring:
    stiffness = body.torsion_stiffness if turning else body.stiffness
    single = COUNTS[body.joint][not turning] == 1
    require(
        single or not plain(stiffness), "{body} has a spring in its {joint} joint, which can move in several ways",
        body=body.name, joint=str(body.joint), code="state", hint="give springs in joints with one angle or one slide",
    )  # fmt: skip
    spring = Spring(place, stiffness, body.free_angle if turning else body.free_slide,
                    body.torsion_damping if turning else body.damping)  # fmt: skip
    lower, upper = (body.lower_angle, body.upper_angle) if turning else (body.lower_slide, body.upper_slide)
    if lower is not None or upper is not None:
        require(
            single, "{body} has stops in its {joint} joint, which can move in several ways", body=body.name,
            joint=str(body.joint), code="state", hint="give stops in joints with one angle or one slide",
        )  # fmt: skip
        require(lower is None or upper is None or upper > lower, "the upper stop of {body} is not above its lower one",
                body=body.name, code="state")  # fmt: skip
    spring.lower, spring.upper = lower, upper
    spring.stop = body.stop_torsion_stiffness if turning else body.stop_stiffness
    return spring


def _refuse_what_the_joint_lacks(body: Body, turns: int, slides: int) -> None:
    """Refuse springs, dampers, rotors and axes that the joint has no use for, instead of leaving them out."""
    for address, fits, instead in (
        ("torsion_stiffness", turns, "stiffness"), ("torsion_damping", turns, "damping"),
        ("stiffness", slides, "torsion_stiffness"), ("damping", slides, "torsion_damping"),
        ("rotor_inertia", turns in (1, 2), ""), ("second_axis", body.joint == "universal", ""),
    ):  # fmt: skip
        value = getattr(body, address)
        require(
            fits or value is None or (address != "second_axis" and not plain(value)),
            "{body} gives {address}, which its {joint} joint does not take", body=body.name, address=address,
            joint=str(body.joint), code="state",
            hint=f"give {instead}" if instead and turns + slides else f"leave out {address}",
        )  # fmt: skip


def _parts(body: Body, kind: str) -> "list[tuple[str, Vector, str]]":
    """The single joints that a joint is a row of: sort, axis, and the name of its speed beside the body's."""
    axis = body.axis
    if not any(map(plain, axis)):
        raise UsageError(f"the joint axis of {body.name} is the zero vector", code="direction",
                         hint="for example 0, 0, 1")  # fmt: skip
    if kind == "cylindrical":
        return [(PRISMATIC, axis, "slide"), (REVOLUTE, axis, "turn")]
    if kind == "universal":
        second = body.second_axis or (0.0, 1.0, 0.0)
        require(any(map(plain, cross(axis, second))), "the axes of the universal joint of {body} are parallel",
                body=body.name, code="direction",
                hint="give second_axis, usually at a right angle to axis")  # fmt: skip
        return [(REVOLUTE, axis, "turn 1"), (REVOLUTE, second, "turn 2")]
    if kind == "planar":
        along = [k for k in range(3) if plain(axis[k])]
        require(len(along) == 1, "the normal of the planar joint of {body} is along none of its axes", body=body.name,
                code="direction", hint="turn the joint by rotation_axis and rotation_angle instead")  # fmt: skip
        one, other = (along[0] + 1) % 3, (along[0] + 2) % 3
        return [(PRISMATIC, UNITS[one], f"slide {'xyz'[one]}"), (PRISMATIC, UNITS[other], f"slide {'xyz'[other]}"),
                (REVOLUTE, axis, "turn")]  # fmt: skip
    if kind == "free":
        return [
            *((PRISMATIC, unit, f"v{letter}") for unit, letter in zip(UNITS, "xyz", strict=True)),
            (BALL, axis, "ω"),
        ]
    return [
        (
            {"ball": BALL, "fixed": FIXED, "prismatic": PRISMATIC}.get(kind, REVOLUTE),
            axis,
            "ω" if kind == "ball" else "",
        )
    ]


def _state(body: Body, turns: int, slides: int) -> "dict[str, list[float]]":
    """The numbers of a joint's state, zeros where none are given; refuses too many or too few."""
    state = {}
    angles = turns if turns < 3 else 0
    for address, wanted in (("angle", angles), ("slide", slides), ("speed", turns), ("velocity", slides),
                            ("torque", turns), ("force", slides), ("angular_acceleration", turns),
                            ("acceleration", slides)):  # fmt: skip
        numbers = list(getattr(body, address))
        hint = "orientation gives it, by Euler parameters" if address == "angle" and turns == 3 else None
        require(len(numbers) in (0, wanted), "{body} has {given} of {address}; its {joint} joint takes {wanted}",
                body=body.name, given=len(numbers), address=address.replace("_", " "), joint=str(body.joint),
                wanted=wanted or "none", code="state", hint=hint)  # fmt: skip
        state[address] = numbers or [0.0] * wanted
    require(body.orientation is None or turns == 3, "{body} has an orientation; its {joint} joint takes none",
            body=body.name, joint=str(body.joint), code="state", hint="give angle or slide")  # fmt: skip
    return state


def _inertia(body: Body) -> "tuple[float, Vector, Tensor]":
    """Mass, mass centre and central tensor of a body."""
    mass = body.mass
    if body.rod is not None:
        require(body.tensor is None and body.moments is None and body.centroid is None,
                "{body} is a rod and gives a centroid, a tensor or moments besides", body=body.name,
                code="contradiction", hint="leave out rod, or the others")  # fmt: skip
        x, y, z = (0.5 * part for part in body.rod)
        third = mass / 3.0
        xx, yy, zz = third * x * x, third * y * y, third * z * z
        a, b, c = -third * x * y, -third * y * z, -third * z * x
        return mass, (x, y, z), ((yy + zz, a, c), (a, zz + xx, b), (c, b, xx + yy))
    require(body.tensor is None or body.moments is None, "{body} gives a tensor and moments together", body=body.name,
            code="exclusive", hint="give one of them")  # fmt: skip
    tensor: Tensor = body.tensor or (ORIGIN, ORIGIN, ORIGIN)
    if body.moments is not None:
        p, q, r = body.moments
        tensor = (p, 0.0, 0.0), (0.0, q, 0.0), (0.0, 0.0, r)
    if any(plain(x) for row in tensor for x in row):
        _require_tensor(body.name, tensor)
    return mass, body.centroid or ORIGIN, tensor


def _require_tensor(name: str, tensor: "Tensor") -> None:
    """Refuse a tensor that no body can have."""
    doubles = tuple(tuple(plain(x) for x in row) for row in tensor)
    least, middle, most = sorted(map(float, eigen(doubles).values))  # type: ignore[arg-type]
    require(
        least >= -TYPED * most and least + middle - most >= -TYPED * most,
        "no body has the tensor of {body}: its principal moments are {least:6}, {middle:6} and {most:6}",
        code="tensor", hint="each is at least zero, and at most the sum of the other two", body=name,
        least=(least, Inertia), middle=(middle, Inertia), most=(most, Inertia),
    )  # fmt: skip


def loads_of(system: System) -> "list[Wrench | None]":
    """Of each link the force and the moment about its origin of loads and springs between points, in its own axes."""
    out: list[Wrench | None] = [None] * len(system.tree.links)
    acting = spring_wrenches(system.between, system.tree, system.frames, system.ground, system.speeds)
    for load in system.scene.loads:
        k = system.body_link(load.body)
        force, moment = load.force, load.moment
        if load.axes == "ground":
            rotation = system.ground[k][0]
            force, moment = back(rotation, force), back(rotation, moment)
        acting.append((k, (force, add(moment, cross(load.at, force)))))
    for k, (force, moment) in acting:
        before = out[k]
        out[k] = (force, moment) if before is None else (add(before[0], force), add(before[1], moment))
    return out
