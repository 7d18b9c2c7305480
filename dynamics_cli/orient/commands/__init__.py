"""The tasks of `dynamics orient`."""

from dynamics_cli.core.answering.task import Family
from dynamics_cli.orient.commands import motion, turns

FAMILIES = {
    "orient": Family(
        "orient",
        "Orientation in every notation, angular velocity and acceleration, rolling.",
        *turns.TASKS,
        *motion.TASKS,
    )
}
