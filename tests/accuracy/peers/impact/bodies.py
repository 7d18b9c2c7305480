"""Whole planar impacts by pycrash, and what is lost where all but velocities is taken as differences."""

from math import hypot

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


FOOT, POUND_FORCE, MILE_PER_HOUR = 0.3048, 4.4482216152605, 0.44704
# The acceleration of gravity that pycrash divides weights by [ft/s²].
GRAVITY = 32.2


DEGREE = 0.017453292519943295


def planar(**given: "Any") -> "dict[str, float]":
    """The program's velocities after, and ΔV, impulse and energies as the differences that they are often taken as."""
    from dynamics_cli.impact.planar.impact import planar as own

    found = own(**given)
    made = {"energy_lost": 0.0}
    for name in ("first", "second"):
        body, after = given[name], getattr(found, name)
        if hasattr(body.bulk, "fixed"):
            continue
        mass, before = body.bulk.mass, body.motion.velocity
        x, y = after.velocity[0] - before[0], after.velocity[1] - before[1]
        turning = body.turning
        inertia = turning.inertia if hasattr(turning, "inertia") else mass * turning.radius_of_gyration**2
        energies = [
            0.5 * mass * (v[0] * v[0] + v[1] * v[1]) + 0.5 * inertia * w * w
            for v, w in ((before, body.spin), (after.velocity, after.spin))
        ]
        made |= {
            f"{name}.delta_v.magnitude": hypot(x, y),
            f"{name}.spin_change": after.spin - body.spin,
            f"{name}.energy_change": energies[1] - energies[0],
        }
        made["energy_lost"] += energies[0] - energies[1]
        made["impulse_magnitude"] = mass * hypot(x, y)
    if any(hasattr(given[name].bulk, "fixed") for name in ("first", "second")):
        del made["energy_lost"]
    return made


def planar_by_pycrash(
    *, first: "Any", second: "Any", normal: float, friction: float, contact: "Any", law: str, **more: "Any"
) -> "dict[str, float]":
    """Static impact of PyPI's `pycrash`, whose law is Kudlich's and Slibar's: feet, pounds, degrees, axes of vehicle 1.

    Its masses are weights over 32.2 ft/s²; they are given so that they come out right. Spins before are left to those
    that it is given none of, since it adds degrees to radians.
    """
    import contextlib
    import io
    from types import SimpleNamespace

    if law != "kudlich-slibar" or more or any(hasattr(one.bulk, "fixed") or one.spin for one in (first, second)):
        raise ArithmeticError
    with contextlib.redirect_stdout(io.StringIO()):
        from pycrash.impc import impc_calcs  # type: ignore[import-not-found]
    bodies = []
    for one in (first, second):
        mass = one.bulk.mass / (POUND_FORCE / FOOT)
        lever, velocity = one.arm.lever, one.motion.velocity
        bodies.append(
            SimpleNamespace(
                weight=mass * GRAVITY, izz=one.turning.inertia / (POUND_FORCE * FOOT), omega_z=0.0, head_angle=0.0,
                vx_initial=velocity[0] / FOOT, vy_initial=velocity[1] / FOOT, pimpact_x=lever[0] / FOOT,
                pimpact_y=lever[1] / FOOT, impc_result=None,
            )
        )  # fmt: skip
    inputs = {"cor": contact.restitution, "cof": friction, "impact_norm_deg": normal / DEGREE + 180.0}
    with contextlib.redirect_stdout(io.StringIO()):
        made = impc_calcs(*bodies, bodies[1].pimpact_x, bodies[1].pimpact_y, inputs)
    found: dict[str, float] = {}
    for name, one in zip(("first", "second"), made, strict=True):
        x, y, spin = (float(_last(one[key])) for key in ("dvx", "dvy", "oz_deg"))
        found |= {f"{name}.delta_v.magnitude": hypot(x, y) * MILE_PER_HOUR, f"{name}.spin_change": spin * DEGREE}
    return found


def _last(value: "Any") -> float:
    import numpy as np

    return float(np.ravel(value)[-1])
