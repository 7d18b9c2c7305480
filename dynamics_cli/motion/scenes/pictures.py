"""Pictures of a scene: poses with the paths of its points, what happens over time, and a moving SVG; equilibria."""

import math
from itertools import accumulate

from dynamics_cli.motion.bodies.joints import NONE
from dynamics_cli.motion.bodies.records import Scene
from dynamics_cli.numerics.linkages.records import GROUND
from dynamics_cli.pictures import Axis, Band, Curve, Mark, Panel, Picture, complex_curve
from dynamics_cli.quantities import STANDARD_GRAVITY, Angle, Coordinate, Force, Ratio, Time, Torque, TurnRate

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.motion.bodies.system import System
    from dynamics_cli.motion.scenes.runs import Runs

GREY, GHOSTS, SAMPLES = 6, 8, 400
# Of the animation: frames a second, seconds at least and at most, and how long its end stands.
FRAMES, SHORTEST, LONGEST, HELD = 25, 3.0, 20.0, 1.0
MOST_CURVES = 5
# A link that turns less than this has no curve of its angle.
TURNS = 1e-6
COILS, WIDE = 6, 0.025
# Errors below the last digit are not drawn.
DUST = 1e-16


class Shapes:
    """Links and springs of a scene as lines, in SI."""

    def __init__(self, system: "System") -> None:
        self.system = system
        spots = system.spots
        points: dict[str, list[int]] = {}
        for (link, _), spot in system.where.items():
            points.setdefault(link, []).append(spot)
        self.links = {body.name: points.get(body.name, []) for body in system.bodies}
        self.fixed = [spot for spot in points.get(GROUND, []) if spots[spot][0] == NONE]
        self.springs = [(force.a, force.b, bool(force.k)) for force in system.forces if hasattr(force, "tension")]

    def of(self, y: "Any") -> "dict[str, list[complex]]":
        """Every link as a line, a polygon, or its mass centre alone."""
        f, size, out = self.system.frame_of(y), self.system.size, {}
        for k, (name, spots) in enumerate(self.links.items()):
            line = [complex(f.x[spot], f.y[spot]) * size for spot in spots]
            line = list(dict.fromkeys(line)) or [complex(f.q[3 * k], f.q[3 * k + 1]) * size]
            if len(line) == 1 and abs(line[0] / size - complex(f.q[3 * k], f.q[3 * k + 1])) > 1e-9:
                line.append(complex(f.q[3 * k], f.q[3 * k + 1]) * size)
            out[name] = [*line, line[0]] if len(line) > 2 else line
        return out

    def coils(self, y: "Any") -> "list[list[complex]]":
        """Springs as zigzags, dampers alone as lines."""
        f, size, out = self.system.frame_of(y), self.system.size, []
        for a, b, wound in self.springs:
            ends = complex(f.x[a], f.y[a]) * size, complex(f.x[b], f.y[b]) * size
            way = ends[1] - ends[0]
            side = 1j * way / abs(way) * WIDE * size if way else 0j
            turns = [ends[0] + way * (0.2 + 0.6 * k / COILS) + side * (-1) ** k for k in range(COILS + 1)]
            out.append([ends[0], *(turns if wound else ()), ends[1]])
        return out

    def paths(self, states: "list[Any]") -> "list[list[complex]]":
        """Paths of the points that move, or of the mass centres of links without any."""
        seen = []
        frames = [self.system.frame_of(y) for y in states]
        size, names = self.system.size, self.system.holders
        for name, links in names.items():
            spot = self.system.where[links[0], name]
            if self.system.spots[spot][0] != NONE:
                seen.append([complex(f.x[spot], f.y[spot]) * size for f in frames])
        for k, spots in enumerate(self.links.values()):
            if not spots:
                seen.append([complex(f.q[3 * k], f.q[3 * k + 1]) * size for f in frames])
        return seen


def _posed(shapes: Shapes, y: "Any", label: str, role: int) -> "list[Any]":
    items: list[Any] = []
    for line in shapes.of(y).values():
        if len(line) == 1:
            items.append(Mark(line[0].real, line[0].imag, role=role))
        else:
            items.append(complex_curve(line, label, "thick", role))
            label = ""
    return items + [complex_curve(line, "", "solid", role) for line in shapes.coils(y)]


def _thin(shapes: Shapes, y: "Any") -> "list[Any]":
    return [complex_curve(line, "", "thin", GREY) for line in shapes.of(y).values() if len(line) > 1]


def _ground(shapes: Shapes, y: "Any", scene: Scene) -> "list[Any]":
    f, size, system = shapes.system.frame_of(y), shapes.system.size, shapes.system
    items: list[Any] = []
    for slide in scene.slides:
        if slide.link == GROUND:
            ends = [system.where[GROUND, end] for end in (slide.start, slide.end)]
            items.append(complex_curve([complex(f.x[k], f.y[k]) * size for k in ends], "", "centre", GREY))
    names = {spot: name for (link, name), spot in system.where.items() if link == GROUND}
    return items + [Mark(f.x[spot] * size, f.y[spot] * size, names[spot]) for spot in shapes.fixed]


def _poses(shapes: Shapes, states: "list[Any]", scene: Scene, last: str) -> Panel:
    items: list[Any] = []
    for k in range(1, GHOSTS):
        items += _thin(shapes, states[k * (len(states) - 1) // GHOSTS])
    items += [complex_curve(path, "", "dots", 2) for path in shapes.paths(states)]
    items += _posed(shapes, states[0], "at the start", 0) + _posed(shapes, states[-1], last, 1)
    items += _ground(shapes, states[0], scene)
    return Panel(Axis("x", Coordinate), Axis("y", Coordinate), tuple(items), equal=True)


def scene_picture(
    made: "Any", scene: Scene, *, duration: float, follow: str = "", gravity: float = STANDARD_GRAVITY, **_: "Any"
) -> Picture:
    """Poses with the paths of points, angles over time or what is followed, forces in the joints, and errors."""
    from dynamics_cli.motion.scenes.runs import runs_of
    from dynamics_cli.motion.scenes.states import followed

    runs = runs_of(scene, gravity, duration)
    times = [runs.end * k / SAMPLES for k in range(SAMPLES + 1)]
    states = [runs.fine.at(t) for t in times]
    last = "at the horizon" if runs.reached else "at the end"
    ends = Axis("time", Time, ends=(0.0, duration))
    beyond = [Band(runs.end, duration, "not known")] if runs.end < duration else []
    over = (
        _followed(followed(runs, follow, SAMPLES), ends)
        if follow
        else _angles(runs.system, times, states, ends, beyond)
    )
    forces = () if follow else _forces(runs.system, times, states, ends, beyond)
    errors = () if follow else (Panel(ends, Axis("error", Ratio, logarithmic=True), _errors(runs)),)
    count = runs.system.n
    return Picture((_poses(Shapes(runs.system), states, scene, last), *over, *forces, *errors),
                   f"motion of {count} bodies" if count > 1 else "motion of a body")  # fmt: skip


def _angles(
    system: "System", times: "list[float]", states: "list[Any]", ends: Axis, beyond: "list[Any]"
) -> "list[Panel]":
    turned = [k for k in range(system.n) if abs(max(y[3 * k + 2] for y in states) - min(y[3 * k + 2] for y in states))
              > TURNS][:MOST_CURVES]  # fmt: skip
    if turned:
        curves = [Curve(times, [float(y[3 * k + 2]) for y in states], system.bodies[k].name, role=k) for k in turned]
        return [Panel(ends, Axis("angle", Angle), (*curves, *beyond))]
    curves = []
    for k in range(min(system.n, MOST_CURVES)):
        for j, name in enumerate("xy"):
            values = [float(y[3 * k + j]) * system.size for y in states]
            if max(values) - min(values) > TURNS * system.size:
                curves.append(Curve(times, values, f"{name} of {system.bodies[k].name}", role=len(curves)))
    return [Panel(ends, Axis("mass centre", Coordinate), (*curves, *beyond))]


def _forces(
    system: "System", times: "list[float]", states: "list[Any]", ends: Axis, beyond: "list[Any]"
) -> "list[Panel]":
    from dynamics_cli.motion.scenes.states import bears_a_couple, bears_a_force, forces_of

    table = [forces_of(system, t, y) for t, y in zip(times, states, strict=True)]
    known = [k for k, joint in enumerate(system.joints) if not system.left & set(joint.rows())]
    panels = []
    pushed = [k for k in known if bears_a_force(system.joints[k])]
    pushed.sort(key=lambda k: -max(math.hypot(*row[k][:2]) for row in table))
    curves = [Curve(times, [math.hypot(*row[k][:2]) for row in table], _label(system.joints[k]), role=role)
              for role, k in enumerate(pushed[:MOST_CURVES])]  # fmt: skip
    if curves:
        panels.append(Panel(ends, Axis("joint force", Force), (*curves, *beyond)))
    turned = [k for k in known if bears_a_couple(system.joints[k]) and not bears_a_force(system.joints[k])]
    curves = [Curve(times, [row[k][2] for row in table], system.joints[k].name, role=role)
              for role, k in enumerate(turned[:MOST_CURVES])]  # fmt: skip
    if curves:
        panels.append(Panel(ends, Axis("torque", Torque), (*curves, *beyond)))
    return panels


def _errors(runs: "Runs") -> "tuple[Curve, ...]":
    """The largest errors so far: what two tolerances differ by, and energy less work."""
    curves: list[Curve] = []
    for values, label in ((runs.parted, "two tolerances, share of its size"), (runs.energy_errors(), "energy, share")):
        largest = list(accumulate((max(value, DUST) for _, value in values), max))
        curves.append(Curve([t for t, _ in values], largest, label, role=len(curves)))
    return tuple(curve for curve in curves if len(curve.x) > 1)


def _label(joint: "Any") -> str:
    return f"{joint.name} on {joint.link}" if joint.kind == "pin" else str(joint.name)


def _followed(rows: "Any", ends: Axis) -> "list[Panel]":
    times, panels = [row.time for row in rows], []
    first = rows[0]
    if first.angle is not None:
        panels.append(Panel(ends, Axis("angle", Angle), (Curve(times, [row.angle for row in rows], role=0),)))
        panels.append(Panel(ends, Axis("angular velocity", TurnRate), (Curve(times, [r.speed for r in rows], role=1),)))
    elif first.position is not None:
        both = [Curve(times, [r.position[k] for r in rows], name, role=k) for k, name in enumerate("xy")]
        panels.append(Panel(ends, Axis("position", Coordinate), tuple(both)))
    if first.force_x is not None:
        both = [Curve(times, [getattr(r, f"force_{name}") for r in rows], f"along {name}", role=k + 2)
                for k, name in enumerate("xy")]  # fmt: skip
        panels.append(Panel(ends, Axis("force", Force), tuple(both)))
    if first.moment is not None:
        panels.append(Panel(ends, Axis("moment", Torque), (Curve(times, [r.moment for r in rows], role=4),)))
    return panels


def moving_scene(
    made: "Any", scene: Scene, *, duration: float, gravity: float = STANDARD_GRAVITY, **_: "Any"
) -> str:  # fmt: skip
    """The scene over time as an animated SVG, in real time where that is neither very short nor very long."""
    from dynamics_cli.animation import animated
    from dynamics_cli.motion.scenes.runs import runs_of

    runs = runs_of(scene, gravity, duration)
    seconds = min(max(runs.end, SHORTEST), LONGEST)
    count = round(FRAMES * seconds)
    states = [runs.fine.at(runs.end * k / count) for k in range(count + 1)]
    shapes = Shapes(runs.system)
    f, size = runs.system.frame_of(states[0]), runs.system.size
    pivots = [complex(f.x[spot], f.y[spot]) * size for spot in shapes.fixed]
    moved = shapes.paths(states)
    # the end stands still for a while before all begins again
    shown = [*range(count + 1), *[count] * round(FRAMES * HELD)]
    lines = [[line if len(line) > 1 else line * 2 for line in [*shapes.of(y).values(), *shapes.coils(y)]]
             for y in states]  # fmt: skip
    pins = [[path[k] for path in moved] for k in range(len(states))]
    return animated("Bodies in motion", [lines[k] for k in shown], moved, pivots, [pins[k] for k in shown],
                    seconds + HELD)  # fmt: skip


def equilibrium_picture(
    made: "Any", scene: Scene, *, place: int = 1, gravity: float = STANDARD_GRAVITY, **_: "Any"
) -> Picture:  # fmt: skip
    """The places found, that shown standing out, beside the start."""
    from dynamics_cli.motion.bodies.start import Start
    from dynamics_cli.motion.scenes.rest import rests

    start = Start(scene, gravity, static=True)
    found, shapes = rests(start), Shapes(start.system)
    items = _thin(shapes, start.state)
    for number, one in enumerate(found, 1):
        label, role = f"{number}: {one.stability}", 0 if number == place else number if number > 1 else 1
        if number == place:
            items += _posed(shapes, one.state, label, role)
        else:
            for line in shapes.of(one.state).values():
                items.append(complex_curve(line, label, "dashed", role))
                label = ""
    items += _ground(shapes, start.state, scene)
    panel = Panel(Axis("x", Coordinate), Axis("y", Coordinate), tuple(items), equal=True)
    return Picture((panel,), "equilibrium positions", subtitle="thin: the scene as given")
