"""The speeds that a recorder kept: listed, or in a CSV file with their times."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.fitting.records_file import interval_of, read_columns
from dynamics_cli.quantities import Annotated, InputFile, RoadSpeed, Time
from dynamics_cli.records import record

# Columns of a file and their units: speed, and the brake switch as on and off or 1 and 0.
COLUMNS = {
    "speed": {"km/h": 1.0 / 3.6, "mph": 0.44704, "m/s": 1.0, "ft/s": 0.3048},
    "brake": {"": 1.0},
}


@record
class ListedSpeeds:
    """Recorded speeds one after the other."""

    speeds: Annotated[
        tuple[RoadSpeed, ...], "Recorded speeds in order of time, equally spaced, e.g. 78, 77, 66, 41, 29 km/h [m/s]."
    ]
    interval: Annotated[Time, "Time between samples, e.g. 0.5 s [s]."] = 0.5


@record
class SpeedFile:
    """Recorded speeds in a file."""

    file: Annotated[
        InputFile,
        "CSV with time[s],speed[km/h] and, if recorded, brake (on or off); times before the event are negative, e.g. "
        "edr.csv.",
    ]


class Samples:
    """Speeds with their interval; of a file, what it says of the brake and the age of the last sample too."""

    def __init__(self, recorded: ListedSpeeds | SpeedFile) -> None:
        self.brake_on: int | None = None
        self.ended = 0.0
        if isinstance(recorded, ListedSpeeds):
            self.speeds, self.interval = recorded.speeds, recorded.interval
            return
        times, columns = read_columns(recorded.file, COLUMNS)
        require("speed" in columns, "the file has no column of speeds", code="header", hint="name it speed[km/h]")
        self.speeds = tuple(columns["speed"])
        self.interval = interval_of(times)
        require(times[-1] <= 0.0, "the last sample is {late} after the event", late=(times[-1], Time), code="times",
                hint="times before the event are negative, the event is at 0")  # fmt: skip
        self.ended = -times[-1]
        switched = [number for number, on in enumerate(columns.get("brake", ()), 1) if on]
        self.brake_on = switched[0] if switched else None
