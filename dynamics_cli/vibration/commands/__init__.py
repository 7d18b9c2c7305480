"""The tasks of `dynamics vibration`."""

from dynamics_cli.core.answering.task import Family
from dynamics_cli.vibration.commands import single

FAMILIES = {
    "vibration": Family(
        "vibration", "Vibration of machines, rotors, shafts and beams; shocks and isolation.", *single.TASKS
    )
}
