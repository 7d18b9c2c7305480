"""The tasks of `dynamics linkage`."""

from dynamics_cli.core.answering.task import Family
from dynamics_cli.linkage.commands import bodies, fourbar, scenes, sliders

FAMILIES = {
    "linkage": Family(
        "linkage",
        "Four-bars, slider-cranks, coupler curves, bodies in plane motion, and linkages from scenes.",
        *bodies.TASKS,
        *fourbar.TASKS,
        *sliders.TASKS,
        *scenes.TASKS,
    )
}
