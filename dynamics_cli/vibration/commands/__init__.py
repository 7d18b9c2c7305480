"""The tasks of `dynamics vibration`."""

from dynamics_cli.core.answering.task import Family
from dynamics_cli.vibration.commands import nonlinear, shafts, shocks, single, systems

SUMMARY = "Vibration of machines, rotors, shafts, beams; shocks, isolation."

FAMILIES = {
    "vibration": Family(
        "vibration", SUMMARY, *single.TASKS, *shocks.TASKS, *systems.TASKS, *shafts.TASKS, *nonlinear.TASKS
    )
}
