"""The tasks of `dynamics gear`."""

from dynamics_cli.core.answering.task import Family
from dynamics_cli.gear.commands import crossing, cylindrical, trains

FAMILIES = {
    "gear": Family(
        "gear",
        "Gear geometry, measurement, pairs, trains and ratios.",
        cylindrical.SPUR,
        cylindrical.HELICAL,
        cylindrical.INVOLUTE,
        cylindrical.PAIR,
        cylindrical.RACK_TASK,
        crossing.BEVEL,
        crossing.CROSSED,
        crossing.WORM,
        crossing.HYPOID,
        crossing.WHEELS,
        cylindrical.GLOSSARY,
        cylindrical.DATA_BLOCK,
        trains.TRAIN,
        trains.RATIO,
        trains.MEASURE,
        trains.IDENTIFY,
        trains.PROFILE,
        trains.MESH,
    )
}
