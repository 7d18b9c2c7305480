"""The tasks of `dynamics gear`."""

from dynamics_cli.core.task import Family
from dynamics_cli.gear.commands import geometry, trains

FAMILIES = {
    "gear": Family("gear", "Gear geometry, measurement, pairs, trains and ratios.", *geometry.TASKS, *trains.TASKS)
}
