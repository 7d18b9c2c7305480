"""Published arms, each with its source."""

from math import pi, radians

from dynamics_cli.robot.arms.records import STANDARD, Arm, Joint

RIGHT = pi / 2.0


def _joint(name: str, a: float, alpha: float, d: float, low: float, high: float) -> Joint:
    return Joint(name=name, a=a, alpha=alpha, d=d, lower=radians(low), upper=radians(high))


# Lengths, twists and limits as in P. Corke's roboticstoolbox for Python, models/DH/Puma560, after Corke and
# Armstrong-Hélouvry; the shoulder is 0.67183 m above the floor.
PUMA_560 = Arm(
    convention=STANDARD,
    joints=(
        _joint("waist", 0.0, RIGHT, 0.67183, -160.0, 160.0),
        _joint("shoulder", 0.4318, 0.0, 0.0, -45.0, 225.0),
        _joint("elbow", 0.0203, -RIGHT, 0.15005, -225.0, 45.0),
        _joint("wrist 1", 0.0, RIGHT, 0.4318, -110.0, 170.0),
        _joint("wrist 2", 0.0, -RIGHT, 0.0, -100.0, 100.0),
        _joint("wrist 3", 0.0, 0.0, 0.0, -266.0, 266.0),
    ),
)
PRESETS = {"puma-560": PUMA_560}
ALSO = {"puma560": "puma-560", "puma": "puma-560"}
NAMES = tuple(PRESETS)


def preset(name: str) -> Arm | None:
    """The published arm of a name in any spelling, or None."""
    key = name.strip().lower().replace("_", "-").replace(" ", "-")
    return PRESETS.get(ALSO.get(key, key))
