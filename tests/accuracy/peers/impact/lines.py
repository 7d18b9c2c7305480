"""Further ways beside those of `alternatives/impact/lines`."""

from math import cos, sin, sqrt

from dynamics_cli.accuracy.alternatives.impact.lines import _central, _restitution, _rise, _shot, _speeds
from dynamics_cli.accuracy.alternatives.impact.plane import mass_of
from dynamics_cli.accuracy.alternatives.solvers import dormand_prince

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


# A body that bounces more often than this before it rests is not followed to its end.
MOST_BOUNCES = 20_000


def central_by_matrix(
    *, first: "Any", second: "Any", contact: "Any", gravity: float, closing_speed: "float | None" = None,
    force: "Any" = None,
) -> "dict[str, float]":  # fmt: skip
    """Momentum and restitution as one system of two equations, by `numpy.linalg.solve`."""
    import numpy as np

    m1, m2, e = mass_of(first.bulk, gravity), mass_of(second.bulk, gravity), contact.restitution
    assert m1 is not None
    v1, v2 = _speeds(first, second, closing_speed)
    rows, right = ([m1, m2], m1 * v1 + m2 * v2) if m2 is not None else ([0.0, 1.0], v2)
    w1, w2 = np.linalg.solve(np.array([rows, [-1.0, 1.0]]), np.array([right, e * (v1 - v2)])).tolist()
    return _central((m1, m2), (v1, v2), (w1, w2))


def drop_by_bounces(
    *, evidence: "Any", height: "float | None" = None, bounces: int, gravity: float, mass: "float | None" = None
) -> "dict[str, float]":
    """From bounce to bounce: fall, rebound, rise v²/2g, until one adds nothing to the time, or too many."""
    e, h = _restitution(evidence, height, gravity)
    fall = sqrt(2.0 * h / gravity)
    found = {"restitution": e, "drop_height": h, "fall_time": fall}
    time, way, top = fall, h, h
    for n in range(MOST_BOUNCES):
        down = sqrt(2.0 * gravity * top)
        up = e * down
        flight, top = 2.0 * up / gravity, up * up / (2.0 * gravity)
        if n == 0:
            found |= {"impact_speed": down, "share_lost": (down * down - up * up) / (down * down)}
            if mass is not None:
                found["energy_lost"] = 0.5 * mass * down * down - 0.5 * mass * up * up
        if n < bounces:
            found |= {
                f"bounces[{n}].number": n + 1.0, f"bounces[{n}].time": time, f"bounces[{n}].impact_speed": down,
                f"bounces[{n}].rebound_speed": up, f"bounces[{n}].height": top, f"bounces[{n}].flight_time": flight,
            }  # fmt: skip
        if n >= bounces and time + flight == time:
            return found | {"time_to_rest": time, "way_to_rest": way}
        time, way = time + flight, way + 2.0 * top
    # it bounces on: what has been seen of it is all there is
    return found


def pendulum_by_swing(
    *, shot_mass: float, block: "Any", swing: "Any", restitution: float, gravity: float
) -> "dict[str, float]":
    """θ'' = −k·sin θ let go at the greatest angle and integrated to the lowest point; the impact as a 2×2 system."""
    import numpy as np

    mass = mass_of(block.bulk, gravity)
    assert mass is not None
    if hasattr(swing, "inertia"):
        arm, along = swing.impact_distance, shot_mass if restitution == 0.0 else 0.0
        lift, inertia = mass * swing.centre_distance + along * arm, swing.inertia + along * arm**2
        effective, spin = swing.inertia / arm**2, _fallen(swing.swing, gravity * lift / inertia)
        u, more, rise = arm * spin, {"angular_velocity": spin}, lift / (mass + along) * (1.0 - cos(swing.swing))
    elif hasattr(swing, "swing"):
        effective, rise, more = mass, _rise(swing), {}
        u = swing.length * _fallen(swing.swing, gravity / swing.length)
    else:
        effective, rise, more = mass, _rise(swing), {}
        u = sqrt(2.0 * gravity * rise)
    # m·v − m·w = M·u and e·v + w = u
    rows = np.array([[shot_mass, -shot_mass], [restitution, 1.0]])
    v, w = np.linalg.solve(rows, np.array([effective * u, u])).tolist()
    return _shot(shot_mass, effective, v, w, u, rise) | more


def _fallen(angle: float, stiffness: float) -> float:
    """Angular speed at the lowest point of a pendulum let go at an angle, by Dormand–Prince steps to 1e-12."""
    start = abs(angle)
    # in radians of small swings, and shares of the angle
    _, (_, speed), _ = dormand_prince(
        lambda _, y: (y[1], -sin(start * y[0]) / start), [1.0, 0.0], [lambda _, y: -y[0]], 1e-12, 1e-14, first=0.01
    )
    return -speed * start * sqrt(stiffness)
