"""The tasks of `dynamics skid`."""

from dynamics_cli.core.answering.task import Family
from dynamics_cli.skid.commands import evidence, marks, timing

FAMILIES = {
    "skid": Family(
        "skid",
        "Speeds and distances from skids, yaw marks, vaults and braking.",
        *marks.TASKS,
        *evidence.TASKS,
        *timing.TASKS,
    )
}
