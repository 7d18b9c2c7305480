"""What a user should know about the forces on a cam: leaving it, being near to, impacts and surge."""

from math import pi

from dynamics_cli.cam.force_records import ArmOnSpring, Train
from dynamics_cli.records import Advice

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.cam.certified import Found
    from dynamics_cli.cam.loads import Load
    from dynamics_cli.cam.motion import Motion

SURGE_ORDER = 12.0


def impacts(motion: "Motion") -> "tuple[Advice, ...]":
    """Warn of joints at which the velocity jumps: no extreme of a force includes the impact there."""
    from dynamics_cli.cam.pieces import joint_jumps

    jumps = joint_jumps(motion)[0]
    if not jumps:
        return ()
    return (
        Advice(
            "velocity-jump",
            f"the velocity jumps at {jumps} {'joint' if jumps == 1 else 'joints'}: the force there is an impact, which "
            "no extreme told here includes",
            "serious",
            "choose laws whose velocities join; `dynamics cam motion` tells where they do not",
        ),
    )


def advice_of(
    load: "Load", train: Train, omega: float, low: "Found", leaves: "Found | None", order: float | None
) -> "tuple[Advice, ...]":
    """Say when the follower leaves its cam or nearly does, that nothing makes it jump, and that its spring surges.

    Parameters
    ----------
    load : Load
        Inertia, spring and load.
    train : Train
        What they came from.
    omega : float
        Speed of the cam shaft [rad/s].
    low : Found
        Least force, or an arm's torque.
    leaves : Found
        The speed of the jump; None where there is none.
    order : float
        The harmonic of the cam at which the spring surges; None without its mass.

    Returns
    -------
    tuple of Advice
        What a user should know.
    """
    found = []
    unit = "N·m" if load.arm else "N"
    if low.value < 0.0:
        needed = (load.preload - low.value) / load.spring_radius
        what = f"preload to {needed:.6g} {'N' if isinstance(train, ArmOnSpring) else unit}"
        found.append(
            Advice(
                "follower-leaves",
                f"the {'torque' if load.arm else 'force'} falls to {low.value:.6g} {unit} at "
                f"{low.at * 180.0 / pi:.6g} deg: the follower leaves the cam",
                "serious",
                f"raise the {what}"
                + (f", or stay below {leaves.value * 30.0 / pi:.6g} rpm" if leaves and leaves.value else ""),
            )
        )
    elif leaves is not None and 0.0 < leaves.value < 1.2 * omega:
        found.append(
            Advice(
                "near-jump",
                f"the follower jumps at {leaves.value * 30.0 / pi:.6g} rpm, "
                f"{leaves.value / omega - 1.0:.1%} above this speed",
                "caution",
                "raise the preload or the spring rate",
            )
        )
    if leaves is None:
        found.append(Advice("no-jump", "no speed makes the follower jump", "note", result="jump_speed"))
    if order is not None and order < SURGE_ORDER:
        found.append(
            Advice(
                "spring-surge",
                f"the spring surges at {order:.4g} times the shaft's speed: "
                "harmonics of the cam up to the twelfth excite it",
                "caution" if order > 0.7 * SURGE_ORDER else "serious",
                "take a lighter or a stiffer spring",
            )
        )
    return tuple(found)
