"""The tasks of `dynamics impact`."""

from dynamics_cli.core.answering.task import Family
from dynamics_cli.impact.commands import crash, evidence, particles, rigid

FAMILIES = {
    "impact": Family(
        "impact",
        "Impacts, from two balls to a two-car crash with friction, with a certificate.",
        *particles.TASKS,
        *rigid.TASKS,
        *crash.TASKS,
        *evidence.TASKS,
    )
}
