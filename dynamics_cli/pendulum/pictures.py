"""The phase portrait of a pendulum with its motion, and the history of one that runs down."""

import math

from dynamics_cli.pendulum.simple import BottomSpeed, State
from dynamics_cli.pendulum.simple import simple as pendulum
from dynamics_cli.pictures import Axis, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import STANDARD_GRAVITY, Angle, Time, TurnRate

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

POINTS = 240
GREY = 6
OTHERS = (0.25, 0.5, 0.75)


def simple(
    made: "Any", *, length: float, start: "Any", time: "float | None" = None, gravity: float = STANDARD_GRAVITY,
    **_: "Any",
) -> Picture:  # fmt: skip
    """Rate over angle, with the motions beside it and the one that just reaches the top; the angle over time."""
    own = math.sqrt(gravity / length)
    bottom = made.bottom_speed / length
    items: list[Any] = []
    for share in OTHERS:
        items += _orbit(2.0 * own * share, own, "", "thin", GREY)
    items += _orbit(2.0 * own, own, "separatrix", "dashed", 1)
    items += _orbit(bottom, own, "this motion", "thick", 0)
    if made.angle_then is not None:
        angle = math.remainder(made.angle_then, 2.0 * math.pi)
        items.append(Mark(angle, made.rate_then, "then", role=2))
    panel = Panel(Axis("angle", Angle, ends=(-math.pi, math.pi)), Axis("angular velocity", TurnRate), tuple(items))
    if isinstance(start, State):
        return Picture((panel,), f"phase portrait: {made.motion}")
    until = max(2.0 * (made.period or 2.0 * made.small_period), time or 0.0)
    times = [until * k / POINTS for k in range(POINTS + 1)]
    angles = [pendulum(length=length, start=start, time=at, gravity=gravity).angle_then or 0.0 for at in times]
    history = [Curve(times, angles, "this motion", "thick", role=0)]
    if made.amplitude is not None:
        turn = 2.0 * math.pi / made.small_period
        # from the bottom or from rest, as it is started
        wave = math.sin if isinstance(start, BottomSpeed) else math.cos
        small = [made.amplitude * wave(turn * at) for at in times]
        history.append(Curve(times, small, "by the period of small swings", "dashed", role=GREY))
    return Picture(
        (panel, Panel(Axis("time", Time), Axis("angle", Angle), tuple(history))), f"phase portrait: {made.motion}"
    )


def _orbit(bottom: float, own: float, label: str, style: "Any", role: int) -> "list[Curve]":
    """Rate over angle of one energy: closed, or above and below."""
    modulus = bottom / (2.0 * own)
    if modulus < 1.0:
        end = 2.0 * math.asin(modulus)
        angles = [end * math.sin(math.pi * (k / POINTS - 0.5)) for k in range(POINTS + 1)]
    else:
        angles = [math.pi * (2.0 * k / POINTS - 1.0) for k in range(POINTS + 1)]
    rates = [2.0 * own * math.sqrt(max(modulus**2 - math.sin(0.5 * angle) ** 2, 0.0)) for angle in angles]
    below = [-rate for rate in rates]
    if modulus < 1.0:
        return [Curve([*angles, *angles[::-1]], [*rates, *below[::-1]], label, style, role=role)]
    return [Curve(angles, rates, label, style, role=role), Curve(angles, below, "", style, role=role)]


def damped(made: "Any", *, amplitude: float, until: "float | None" = None, **_: "Any") -> Picture:
    """Turning points over time, with the envelope through them."""
    times = [0.0, *[peak.time for peak in made.peaks]]
    sizes = [abs(amplitude), *[peak.amplitude for peak in made.peaks]]
    x: list[float] = []
    y: list[float] = []
    for k in range(len(times) - 1):
        for j in range(24):
            share = j / 24.0
            size = sizes[k] ** (1.0 - share) * sizes[k + 1] ** share
            x.append(times[k] + share * (times[k + 1] - times[k]))
            y.append(math.copysign(1.0, amplitude) * (-1.0) ** k * size * math.cos(math.pi * share))
    items: list[Any] = [
        Curve(x, y, "angle"),
        Curve(times, sizes, "amplitude", "dashed", role=1),
        Curve(times, [-size for size in sizes], "", "dashed", role=1),
    ]
    if until is not None:
        items += [
            Curve([times[0], times[-1]], [side * abs(until)] * 2, "", "dotted", role=GREY) for side in (1.0, -1.0)
        ]
    return Picture((Panel(Axis("time", Time), Axis("angle", Angle), tuple(items)),), "a pendulum runs down")
