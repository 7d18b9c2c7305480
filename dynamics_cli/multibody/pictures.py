"""Pictures: bodies as sticks from the front and from the side, and a motion over time."""

from itertools import accumulate

from dynamics_cli.multibody.bodies.records import Scene, Upward
from dynamics_cli.multibody.bodies.system import System
from dynamics_cli.multibody.motions.runs import Run, parted
from dynamics_cli.multibody.motions.simulate import runs_of, scales_of
from dynamics_cli.numerics.vectors import add, times
from dynamics_cli.pictures import Axis, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import STANDARD_GRAVITY, Angle, Length, Ratio, Time

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.numerics.vectors import Vector

GREY, GHOSTS, LINES = 6, 6, 5
# Errors below the last digit are not drawn.
DUST = 1e-16
# Bodies this much out of one plane [m, rad] are seen from the side too.
FLAT = 1e-9
# What is seen from the front and from the side: across and up, by the axis that points up.
VIEWS = {"z": ((0, 2), (1, 2)), "y": ((0, 1), (2, 1)), "x": ((1, 0), (2, 0)), "none": ((0, 2), (1, 2))}


def sticks(system: System) -> "list[list[Vector]]":
    """Every body as lines from its own origin to what it carries, or to its mass centre and as far again for a rod."""
    lines: list[list[Vector]] = []
    for body in system.bodies:
        k = system.link[body.name]
        turn, origin = system.ground[k]
        ends = [
            add(origin, times(turn, link.position))
            for link in system.tree.links
            if link.parent == k and any(link.position)
        ]
        for loop in system.scene.loops:
            for name, point in ((loop.first, loop.first_at), (loop.second, loop.second_at)):
                if name == body.name and any(point):
                    ends.append(add(origin, times(turn, point)))
        if body.rod is not None:
            ends.append(add(origin, times(turn, body.rod)))
        elif not ends and body.centroid is not None:
            ends.append(system.centre(k))
        lines += [[origin, end] for end in ends] or [[origin]]
    return lines


def _drawn(system: System, view: "tuple[int, int]", label: str, role: int, style: "Any" = "thick") -> "list[Any]":
    items: list[Any] = []
    for line in sticks(system):
        x, y = ([point[axis] for point in line] for axis in view)
        if len(line) == 1:
            items.append(Mark(x[0], y[0], role=role))
        else:
            items.append(Curve(x, y, label, style, role=role))
            label = ""
    for spring in system.between if style == "thick" else ():
        ends = [spring.end(system.ground, side) for side in (0, 1)]
        items.append(Curve([end[view[0]] for end in ends], [end[view[1]] for end in ends], "", "dots", role=role))
    return items


def _centres(system: System, view: "tuple[int, int]") -> "list[Any]":
    marks = []
    for body in system.bodies:
        k = system.link[body.name]
        if system.tree.links[k].mass:
            centre = system.centre(k)
            marks.append(Mark(centre[view[0]], centre[view[1]], body.name, role=2))
    return marks


def scene_picture(
    _: "Any",
    scene: Scene,
    up: Upward = Upward("z"),  # noqa: B008
    gravity: float = STANDARD_GRAVITY,
    **__: "Any",
) -> Picture:
    """The bodies from the front and from the side, with their mass centres."""
    system = System(scene, up, gravity)
    if scene.loops:
        from dynamics_cli.multibody.bodies.loops import Loops

        Loops(system).close()
    panels = []
    for title, view in _views([system.ground], up):
        items = (*_drawn(system, view, "", 0), *_centres(system, view))
        panels.append(_panel(title, view, items))
    return Picture(tuple(panels), "bodies at this instant", columns=len(panels))


def _panel(title: str, view: "tuple[int, int]", items: "tuple[Any, ...]") -> Panel:
    return Panel(Axis("xyz"[view[0]], Length), Axis("xyz"[view[1]], Length), items, equal=True, title=title)


def _views(grounds: "list[Any]", up: Upward) -> "list[tuple[str, tuple[int, int]]]":
    """From the front, from above where all turns in a level plane, and from the side where it is in no plane."""
    front, side = VIEWS[str(up)]
    heights = [origin[front[1]] for ground in grounds for _, origin in ground]
    tilted = max(
        (abs(turn[front[1]][k]) for ground in grounds for turn, _ in ground for k in range(3) if k != front[1])
    )
    if max(heights) - min(heights) < FLAT and tilted < FLAT and front[1] == "xyz".find(str(up)):
        return [("from above", (front[0], side[0]))]
    depths = [origin[side[0]] for ground in grounds for _, origin in ground]
    turned = max(
        (abs(turn[side[0]][k]) for ground in grounds for turn, _ in ground for k in range(3) if k != side[0]),
        default=0.0,
    )
    flat = max(depths) - min(depths) < FLAT and turned < FLAT
    return [("front", front)] if flat else [("front", front), ("side", side)]


def motion_picture(
    _: "Any", scene: Scene, *, duration: float, steps: int = 4, follow: str | None = None, tolerance: float = 1e-10,
    up: Upward = Upward("z"), gravity: float = STANDARD_GRAVITY, **__: "Any",  # noqa: B008
) -> Picture:  # fmt: skip
    """Poses with the path of the body followed, from the front and the side, coordinates and errors over time."""
    fine, coarse, loops = runs_of(scene, duration, steps, tolerance, up, gravity)
    system = fine.system
    k = system.body_link(follow) if follow is not None else len(system.tree.links) - 1
    last = len(fine.states) - 1
    paths, grounds = [], []
    for state in fine.states:
        fine.put(state)
        paths.append(system.centre(k))
        grounds.append(system.ground)
    panels = []
    for title, view in _views(grounds, up):
        items: list[Any] = []
        for n in range(GHOSTS + 1):
            fine.put(fine.states[last * n // GHOSTS])
            if n in (0, GHOSTS):
                items += _drawn(system, view, "at the start" if n == 0 else "at the end", 0 if n == 0 else 1)
            else:
                items += _drawn(system, view, "", GREY, "thin")
        items.append(Curve([p[view[0]] for p in paths], [p[view[1]] for p in paths], "mass centre", "dots", role=2))
        panels.append(_panel(title, view, tuple(items)))
    panels += _history(fine, duration)
    apart = list(accumulate((max(off, DUST) for off in parted(fine, coarse, scales_of(system, loops))), max))
    first, exchanged = fine.energies[0], max(*fine.kinetics, 1e-300)
    energy = list(accumulate((max(abs(one - first) / exchanged, DUST) for one in fine.energies), max))
    panels.append(Panel(
        Axis("time", Time, ends=(0.0, duration)), Axis("error", Ratio, logarithmic=True),
        (Curve(fine.times, apart, "two tolerances, rad"), Curve(fine.times, energy, "energy, share", role=1)),
    ))  # fmt: skip
    return Picture(tuple(panels), "motion of bodies in space", columns=2)


def _history(run: Run, duration: float) -> "list[Panel]":
    """Angles, and ways of slides, over time."""
    out = []
    for kind, word, turns in ((Angle, "angle", True), (Length, "way", False)):
        curves: list[Curve] = []
        for name, turning, spring in zip(run.system.names, run.system.turning, run.system.springs, strict=True):
            place = spring.place
            if place is not None and turning is turns and len(curves) < LINES:
                curves.append(Curve(run.times, [state[place] for state in run.states], name, role=len(curves)))
        if curves:
            out.append(Panel(Axis("time", Time, ends=(0.0, duration)), Axis(word, kind), tuple(curves)))
    return out
