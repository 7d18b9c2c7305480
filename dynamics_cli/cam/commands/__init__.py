"""The tasks of `dynamics cam`."""

from dynamics_cli.cam.commands import geometry, motion
from dynamics_cli.core.answering.task import Family

FAMILIES = {
    "cam": Family(
        "cam", "Cam motions, profiles, sizes and forces, with proved deviations.", *motion.TASKS, *geometry.TASKS
    )
}
