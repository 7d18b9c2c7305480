"""Published arms, each with its source."""

from math import pi, radians

from dynamics_cli.robot.arms.records import STANDARD, Arm, Joint

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.numerics.vectors import Vector

RIGHT = pi / 2.0


def _joint(
    name: str, sizes: "tuple[float, float, float]", limits: "tuple[float, float]", mass: float,
    centroid: "Vector", moments: "Vector", motor: "tuple[float, float, float, float, float]",
) -> Joint:  # fmt: skip
    """A joint; of its motor rotor inertia, gear ratio, viscous friction and dry friction both ways, at the motor."""
    a, alpha, d = sizes
    rotor, ratio, viscous, forward, back = motor
    gear = abs(ratio)
    return Joint(
        name=name, a=a, alpha=alpha, d=d, lower=radians(limits[0]), upper=radians(limits[1]),
        mass=mass, centroid=centroid,
        tensor=((moments[0], 0.0, 0.0), (0.0, moments[1], 0.0), (0.0, 0.0, moments[2])),
        rotor_inertia=rotor, gear_ratio=gear, viscous=viscous * gear * gear, coulomb=forward * gear,
        coulomb_back=back * gear,
    )  # fmt: skip


# Sizes, limits, masses and motors as in P. Corke's roboticstoolbox for Python, models/DH/Puma560, which cites Corke and
# Armstrong-Hélouvry 1994; the shoulder is 0.67183 m above the floor (0.672 m in some versions of that file). The waist
# has no mass there, and its moment is about the first axis alone.
PUMA_560 = Arm(
    convention=STANDARD,
    joints=(
        _joint("waist", (0.0, RIGHT, 0.67183), (-160.0, 160.0), 0.0, (0.0, 0.0, 0.0), (0.0, 0.35, 0.0),
               (200e-6, -62.6111, 1.48e-3, 0.395, 0.435)),
        _joint("shoulder", (0.4318, 0.0, 0.0), (-45.0, 225.0), 17.4, (-0.3638, 0.006, 0.2275), (0.13, 0.524, 0.539),
               (200e-6, 107.815, 0.817e-3, 0.126, 0.071)),
        _joint("elbow", (0.0203, -RIGHT, 0.15005), (-225.0, 45.0), 4.8, (-0.0203, -0.0141, 0.07),
               (0.066, 0.086, 0.0125), (200e-6, -53.7063, 1.38e-3, 0.132, 0.105)),
        _joint("wrist 1", (0.0, RIGHT, 0.4318), (-110.0, 170.0), 0.82, (0.0, 0.019, 0.0), (1.8e-3, 1.3e-3, 1.8e-3),
               (33e-6, 76.0364, 71.2e-6, 11.2e-3, 16.9e-3)),
        _joint("wrist 2", (0.0, -RIGHT, 0.0), (-100.0, 100.0), 0.34, (0.0, 0.0, 0.0), (0.3e-3, 0.4e-3, 0.3e-3),
               (33e-6, 71.923, 82.6e-6, 9.26e-3, 14.5e-3)),
        _joint("wrist 3", (0.0, 0.0, 0.0), (-266.0, 266.0), 0.09, (0.0, 0.0, 0.032), (0.15e-3, 0.15e-3, 0.04e-3),
               (33e-6, 76.686, 36.7e-6, 3.96e-3, 10.5e-3)),
    ),
)  # fmt: skip
PRESETS = {"puma-560": PUMA_560}
ALSO = {"puma560": "puma-560", "puma": "puma-560"}
NAMES = tuple(PRESETS)


def preset(name: str) -> Arm | None:
    """The published arm of a name in any spelling, or None."""
    key = name.strip().lower().replace("_", "-").replace(" ", "-")
    return PRESETS.get(ALSO.get(key, key))
