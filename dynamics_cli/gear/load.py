"""The torque of a drive, from a torque or from a power and a speed."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import absolute


def torque_of(torque: float | None, power: float | None, speed: float | None) -> float | None:
    """The torque as given, or power over speed; None if neither is given."""
    require(torque is None or power is None, "both torque and power are given", code="load", hint="give one of them")
    if power is None:
        return torque
    require(
        speed is not None and absolute(speed) > 0.0,
        "a power gives a torque only with a speed",
        code="speed",
        hint="give --speed",
    )
    return power / absolute(speed)  # type: ignore[arg-type]
