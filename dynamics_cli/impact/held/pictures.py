"""Pictures of one body that is struck or stopped: pendulums, seized bodies, wheels at a step."""

from math import asin, cos, pi, sin, sqrt

from dynamics_cli.pictures import Arrow, Axis, Band, Bars, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import AngularSpeed, Energy, Length, Speed

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Vector = tuple[float, float, float]

VIEWS = ((0, 1), (0, 2), (1, 2))
STEPS = 48
HALF_ROOT = sqrt(0.5)


def pendulum(result: "Any", *, swing: "Any", **_: "Any") -> Picture:
    """Distribution of the shot's energy; the swing, if its length is known."""
    before, lost = float(result.energy_before), float(result.energy_lost)
    bars = Bars(
        ("in the shot", "lost in the impact", "in the moving body after"),
        [0.0, 0.0, 0.0],
        [before, lost, before - lost],
    )
    panels = [Panel(Axis("kinetic energy", Energy), Axis(""), (bars,))]
    length = getattr(swing, "length", None) or getattr(swing, "centre_distance", None)
    if length is not None:
        panels.append(_swing(float(length), float(result.rise)))
    return Picture(tuple(panels), "ballistic pendulum")


def _swing(length: float, rise: float) -> Panel:
    """The mass centre's path up from rest."""
    least = 1.0 - rise / length
    # From the half angle: a small rise keeps its angle.
    angle = 2.0 * asin(min(1.0, sqrt(max(0.0, 0.5 * (1.0 - least)))))
    turns = [angle * k / STEPS for k in range(STEPS + 1)]
    path = Curve([length * sin(t) for t in turns], [-length * cos(t) for t in turns], "mass centre", role=0)
    top = length * sin(angle), -length * cos(angle)
    items = (
        path,
        Curve([0.0, 0.0], [0.0, -length], "hanging", "dashed", 6),
        Curve([0.0, top[0]], [0.0, top[1]], "greatest swing", "thin", 6),
        Mark(0.0, 0.0, "hinge"),
    )
    return Panel(Axis("x", Length), Axis("height", Length), items, "the swing", equal=True)


def seize(result: "Any", *, body: "Any", **_: "Any") -> Picture:
    """Angular velocities before and after in three views, and the point that is held."""
    before = _spin(body)
    after = tuple(float(part) for part in result.angular_velocity)
    reach = 1.1 * max(max(abs(part) for part in (*before, *after)), 1e-300)
    panels = []
    for i, j in VIEWS:
        zero, ends = [0.0, 0.0], [-reach, reach]
        items: tuple[Any, ...] = (
            Curve(ends, zero, style="thin", role=6),
            Curve(zero, ends, style="thin", role=6),
            *(
                Arrow(0.0, 0.0, spin[i], spin[j], name, role)
                for role, (name, spin) in enumerate((("before", before), ("after", after)))
                if max(abs(spin[i]), abs(spin[j])) > 1e-3 * reach
            ),
        )
        across, up = (Axis(f"about {'xyz'[k]}", AngularSpeed) for k in (i, j))
        panels.append(Panel(across, up, items, f"plane of {'xyz'[i]} and {'xyz'[j]}", equal=True))
    return Picture(tuple(panels), "angular velocity before and after", columns=3)


def _spin(body: "Any") -> "Vector":
    """The angular velocity before: a plate turns about its diagonal."""
    spin = getattr(body, "spin", None)
    if spin is not None:
        return HALF_ROOT * spin, HALF_ROOT * spin, 0.0
    x, y, z = body.angular_velocity
    return x, y, z


def step(result: "Any", *, radius: float, height: float, speed: "float | None" = None, **_: "Any") -> Picture:
    """The wheel at the step and on it, and the speeds that limit its behaviour."""
    back = sqrt(height * (2.0 * radius - height))
    turns = [2.0 * pi * k / STEPS for k in range(STEPS + 1)]
    start = asin(min(1.0, back / radius))
    angles = [start * (1.0 - k / STEPS) for k in range(STEPS + 1)]

    def wheel(x: float, y: float, label: str, style: "Any", role: int) -> Curve:
        return Curve([x + radius * cos(t) for t in turns], [y + radius * sin(t) for t in turns], label, style, role)

    scene = (
        Curve([-back - 1.3 * radius, 0.0, 0.0, 1.3 * radius], [0.0, 0.0, height, height], "road", role=6),
        wheel(-back, radius, "meets the edge", "solid", 0),
        wheel(0.0, radius + height, "on the step", "dashed", 1),
        Curve([-radius * sin(t) for t in angles], [height + radius * cos(t) for t in angles], "centre", "dotted", 2),
        Mark(0.0, height, "edge"),
    )
    names, speeds = ["least speed over the step", "jumps off the edge above"], [
        float(result.least_speed), float(result.leaves_edge_speed)
    ]  # fmt: skip
    bars: list[Any] = [Bars(tuple(names), [0.0] * len(names), speeds)]
    if speed is not None:
        bars.append(Band(speed, speed, "rolling speed"))
    panels = (
        Panel(Axis("x", Length), Axis("y", Length), scene, equal=True),
        Panel(Axis("speed before the step", Speed), Axis(""), tuple(bars)),
    )
    return Picture(panels, "a wheel at a step")
