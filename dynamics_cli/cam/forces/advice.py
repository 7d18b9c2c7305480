"""Advice about the forces on a cam: follower jump, small margins, impacts and surge."""

from dynamics_cli.cam.forces.records import ArmOnSpring, Train
from dynamics_cli.errors import worded
from dynamics_cli.quantities import Angle, Force, Fraction, Ratio, ShaftSpeed, Torque
from dynamics_cli.records import Advice

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.cam.forces.loads import Load
    from dynamics_cli.cam.forces.survey import Found
    from dynamics_cli.cam.program.motion import Motion

SURGE_ORDER = 12.0


def impacts(motion: "Motion") -> "tuple[Advice, ...]":
    """Warn of joints with a velocity jump: no extreme of a force includes the impact there."""
    from dynamics_cli.cam.program.pieces import joint_jumps

    jumps = joint_jumps(motion)[0]
    if not jumps:
        return ()
    message = (
        f"the velocity jumps at {jumps} {'joint' if jumps == 1 else 'joints'}: the force there is an impact, which "
        "the extremes reported here do not include"
    )
    remedy = "choose laws whose velocities join; `dynamics cam motion` lists the jumps"
    return (Advice("velocity-jump", message, "serious", remedy),)


def advice_of(
    load: "Load", train: Train, omega: float, low: "Found", leaves: "Found | None", order: float | None
) -> "tuple[Advice, ...]":
    """Advice when the follower leaves its cam or nearly does, cannot jump at all, or its spring surges.

    `load`: inertia, spring and load; `train`: the record they were read from; `low`: minimum force, or torque of an
    arm; `leaves`: the speed at which it jumps, or None; `order`: the harmonic of the cam at which the spring
    surges, or None if the spring's mass is not given.
    """
    advice = []
    force: Any = Torque if load.arm else Force
    if low.value < 0.0:
        needed = (load.preload - low.value) / load.spring_radius
        stays = bool(leaves and leaves.value)
        advice.append(
            Advice(
                "follower-leaves",
                worded(
                    "the {what} falls to {low:6} at {at:6}: the follower leaves the cam",
                    what="torque" if load.arm else "force", low=(low.value, force), at=(low.at, Angle),
                ),
                "serious",
                worded(
                    "raise the preload to {needed:6}" + (", or stay below {speed:6}" if stays else ""),
                    needed=(needed, Force if isinstance(train, ArmOnSpring) else force),
                    speed=(leaves.value if leaves else 0.0, ShaftSpeed),
                ),
            )
        )  # fmt: skip
    elif leaves is not None and 0.0 < leaves.value < 1.2 * omega:
        advice.append(
            Advice(
                "near-jump",
                worded(
                    "the follower jumps at {speed:6}, {share:2} above this speed",
                    speed=(leaves.value, ShaftSpeed), share=(leaves.value / omega - 1.0, Fraction),
                ),
                "caution",
                "raise the preload or the spring rate",
            )
        )  # fmt: skip
    if leaves is None:
        advice.append(Advice("no-jump", "no speed makes the follower jump", "note", result="jump_speed"))
    if order is not None and order < SURGE_ORDER:
        message = worded(
            "the spring surges at {order} times the shaft's speed: harmonics of the cam up to the twelfth excite it",
            order=(order, Ratio),
        )
        remedy = "take a lighter or a stiffer spring"
        advice.append(Advice("spring-surge", message, "caution" if order > 0.7 * SURGE_ORDER else "serious", remedy))
    return tuple(advice)
