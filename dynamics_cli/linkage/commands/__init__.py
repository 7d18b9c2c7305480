"""The tasks of `dynamics linkage`."""

from dynamics_cli.core.answering.task import Family
from dynamics_cli.linkage.commands import mechanisms, scenes

FAMILIES = {
    "linkage": Family(
        "linkage",
        "Four-bars, slider-cranks, coupler curves, bodies in plane motion, and linkages from scenes.",
        *scenes.BODIES,
        *mechanisms.TASKS,
        *scenes.SCENES,
    )
}
