"""Pictures of a crash: the scene to scale and the figures of a report beside it; the scene alone as a plan."""

from dynamics_cli.errors import worded
from dynamics_cli.impact.conventions import mass_of
from dynamics_cli.impact.crash.drawn import Drawn
from dynamics_cli.impact.crash.figures import approach, energy, links, speeds
from dynamics_cli.impact.scene_pictures import LANE, finished, to_scale
from dynamics_cli.impact.vector_pictures import polygon, triangles
from dynamics_cli.impact.verdict_pictures import worst_headings
from dynamics_cli.pictures import Picture, Plan
from dynamics_cli.quantities import STANDARD_GRAVITY, Length

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.pictures import Spreads

# Inches of the scene.
WIDE, HIGH = 7.2, 3.9
SUBTITLE = "start, impact and rest; velocities before dashed, after solid, one scale for all"


def crash(
    result: "Any", scene: "Any", *, gravity: float = STANDARD_GRAVITY, spreads: "Spreads | None" = None, **_: "Any"
) -> Picture:
    """Both vehicles through the crash seen from above, their momenta, and what the answer rests on."""
    drawn = Drawn(result, scene, gravity, spreads)
    masses = [mass_of(one.bulk, gravity) for one in drawn.given]
    before, after = drawn.velocities()
    courses = (result.first, result.second)
    moving = any(course.start is not None for course in courses)
    # a half of the page is free beside the speeds or beside the way before, where only one of them is shown
    free = moving == (spreads is None)
    bulks = [one.bulk for one in drawn.given]
    errors = worst_headings(courses, bulks, drawn.names, drawn.axes, gravity, wide=False) if free else []
    panels = [
        finished(drawn.items(), drawn.words, (WIDE, HIGH), (drawn.scale, drawn.fastest), _north(drawn), _note(drawn)),
        None
        if spreads is None
        else speeds(result, drawn.names, spreads, scene.speed_limit, wide=not moving and not errors),
        approach(result, scene, drawn.names, gravity, spreads, wide=spreads is None and not errors),
        *errors,
        polygon(drawn.names, masses, before, after),
        triangles(drawn.names, before, after),
        links(result, drawn.names, spreads),
        energy(result),
    ]
    title = f"{drawn.names[0]} and {drawn.names[1]}: the crash to scale"
    shown = tuple(panel for panel in panels if panel is not None)
    return Picture(shown, title, 2, width=WIDE, scene=True, spread=True, subtitle=SUBTITLE)


def plan(
    result: "Any", scene: "Any", *, gravity: float = STANDARD_GRAVITY, spreads: "Spreads | None" = None, **_: "Any"
) -> Plan:
    """The scene as a drawing, in the coordinates of the scene."""
    drawn = Drawn(result, scene, gravity, spreads)
    x, y = scene.impact.point
    title = f"{drawn.names[0]} and {drawn.names[1]}"
    return to_scale(
        drawn.items(), drawn.words, (drawn.scale, drawn.fastest), _north(drawn), (SUBTITLE, *_note(drawn)), title,
        (x, drawn.flip * y),
    )  # fmt: skip


def _north(drawn: Drawn) -> "tuple[float, float] | None":
    return (0.0, 1.0) if drawn.axes == "compass" else None


def _note(drawn: Drawn) -> "tuple[str, ...]":
    """What was not measured, and what the shaded shapes hold."""
    size = "outlines of common size where none is given" if drawn.neutral else "outlines as given"
    lanes = worded("{size}; lanes {width:3} wide along the approach headings", size=size, width=(2.0 * LANE, Length))
    if drawn.spreads is None:
        return (lanes,)
    return lanes, f"ellipses of positions and fans of headings hold {100.0 * drawn.spreads.coverage:.4g} %"
