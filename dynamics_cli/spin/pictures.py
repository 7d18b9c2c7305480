"""Polhodes of free bodies, tops on the sphere, gyroscopic torque, disks that roll and turn."""

import math

from dynamics_cli.numerics.elliptic import functions
from dynamics_cli.numerics.number import plain
from dynamics_cli.pictures import Arrow, Axis, Band, Curve, Label, Mark, Panel, Picture
from dynamics_cli.quantities import STANDARD_GRAVITY, Angle, GrowthRate, Length, ShaftSpeed, Time, Torque, TurnRate
from dynamics_cli.spin.disk import DISK, growth_factor
from dynamics_cli.spin.free import NAMES, NUMBERS, extremes, moduli
from dynamics_cli.spin.gyro import moments_of
from dynamics_cli.spin.principal import along_axes

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.pictures import Style

POINTS = 480
QUARTER = 0.5 * math.pi
# The sphere is seen from this height.
VIEW = math.radians(22.0)
# A path on it is followed for at most so many nutations, in so many steps each.
NUTATIONS, STEPS = 10, 120
GREY = 6
# Cones whose half angles differ by less look like one.
SAME = 1e-3


def free(
    made: "Any",
    *,
    moments: "tuple[float, float, float] | None" = None,
    tensor: "Any" = None,
    angular_velocity: "tuple[float, float, float]",
    **_: "Any",
) -> Picture:
    """Components over a period, and the polhode seen along the axis it goes round."""
    labels = NAMES if tensor is None else NUMBERS
    if tensor is not None:
        moments, angular_velocity, _axes = along_axes(tensor, angular_velocity)
    assert moments is not None
    order = sorted(range(3), key=lambda k: plain(moments[k]))
    body: Any = tuple(plain(moments[k]) for k in order)
    rates: Any = tuple(abs(plain(angular_velocity[k])) for k in order)
    most, _least, split = extremes(body, rates)
    period = plain(made.period) if made.period is not None else None
    if period is None:
        times = [0.0, 1.0]
        paths = [[rate, rate] for rate in rates]
        about = 2
    else:
        about = 2 if split[1] > 0.0 else 0
        outer, inner = moduli(body, rates, split)
        complement = min(inner / outer, 1.0)
        modulus = ((1.0 - complement) * (1.0 + complement)) ** 0.5
        times = [period * k / POINTS for k in range(POINTS + 1)]
        states = [functions(outer * t, modulus, complement) for t in times]
        paths = [[], [most[1] * sn for sn, _cn, _dn in states], []]
        paths[about] = [most[about] * dn for _sn, _cn, dn in states]
        paths[2 - about] = [most[2 - about] * cn for _sn, cn, _dn in states]
    names = [labels[k] for k in order]
    curves = tuple(Curve(times, paths[k], f"about {names[k]}", role=k) for k in range(3))
    history = Panel(Axis("time", Time), Axis("angular velocity", TurnRate), curves)
    across = 2 - about
    turns = [2.0 * math.pi * k / POINTS for k in range(POINTS + 1)]
    x, y = ([size * shape(t) for t in turns] for size, shape in ((most[across], math.cos), (most[1], math.sin)))
    now = Mark(plain(angular_velocity[order[across]]), plain(angular_velocity[order[1]]), "as given", role=3)
    polhode = Panel(
        Axis(f"about {names[across]}", TurnRate),
        Axis(f"about {names[1]}", TurnRate),
        (Curve(x, y, "", role=about), now) if period is not None else (now,),
        equal=True,
    )
    about_text = f" about {names[about]}" if period is not None else ""
    panels = (history, polhode, *_cone(made, f"{names[about]} axis"))
    return Picture(panels, f"polhode{about_text}", subtitle="over one period, begun at an extreme")


def _cone(made: "Any", axis: str) -> "list[Panel]":
    """The cones between which the axis goes round the angular momentum, seen a little from above."""
    if made.least_nutation is None or made.greatest_nutation is None:
        return []
    ends = [plain(made.greatest_nutation), plain(made.least_nutation)]
    items: list[Any] = [Arrow(0.0, 0.0, 0.0, 1.2, "angular momentum", role=1)]
    turns = [2.0 * math.pi * k / POINTS for k in range(POINTS + 1)]
    for nth, angle in enumerate(ends if ends[0] - ends[1] > SAME else ends[:1]):
        wide, high = math.sin(angle), math.cos(angle)
        style: Style = "dashed" if nth else "solid"
        rim = [high + wide * math.sin(VIEW) * math.sin(turn) for turn in turns]
        items.append(Curve([-wide, 0.0, wide], [high, 0.0, high], "", style, 0))
        items.append(Curve([wide * math.cos(turn) for turn in turns], rim, "", style, 0))
    items.append(Label(math.sin(ends[0]) + 0.08, math.cos(ends[0]), axis, 0, left=True))
    low = min(0.0, *(math.cos(angle) for angle in ends)) - 0.3
    title = "the axis goes round the angular momentum" + (" between two cones" if len(items) > 4 else " on a cone")
    return [Panel(Axis("", ends=(-1.6, 1.6)), Axis("", ends=(low, 1.4)), tuple(items), title, equal=True, bare=True)]


def top(
    made: "Any",
    *,
    mass: float,
    distance: float,
    axial: float,
    transverse: float,
    spin: float,
    gravity: float = STANDARD_GRAVITY,
    tilt: "float | None" = None,
    **_: "Any",
) -> Picture:
    """The path of the axis on the sphere, let go at rest, and steady precession over the spin."""
    pull = mass * gravity * distance
    panels = []
    if tilt is not None:
        path = let_go(transverse, axial * spin, pull, tilt, made.nutation, made.slow)
        circles = [(tilt, "dotted"), (made.lowest_tilt, "dotted")]
        panels.append(_sphere(path, circles))
    cosine = 1.0 if tilt is None else math.cos(tilt)
    least = 2.0 * math.sqrt(transverse * pull * cosine) / axial if cosine > 0.0 else 0.02 * abs(spin)
    spins = [least + (2.5 * max(least, abs(spin)) - least) * (k / POINTS) ** 2 for k in range(POINTS + 1)]
    roots = [math.sqrt(max((axial * n) ** 2 - 4.0 * transverse * pull * cosine, 0.0)) for n in spins]
    slow = [2.0 * pull / (axial * n + root) for n, root in zip(spins, roots, strict=True)]
    items: list[Any] = [Curve(spins, slow, "slow", role=0)]
    if cosine > 1e-3:
        fast = [(axial * n + root) / (2.0 * transverse * cosine) for n, root in zip(spins, roots, strict=True)]
        items.append(Curve(spins, fast, "fast", "dashed", role=1))
    items.append(Band(abs(spin), abs(spin), "its spin"))
    if tilt is None:
        items.append(Band(plain(made.sleeping_spin), plain(made.sleeping_spin), "sleeps from"))
    title = "steady precession, nearly upright" if tilt is None else "steady precession at the tilt"
    panels.append(Panel(Axis("spin", ShaftSpeed), Axis(title, TurnRate), tuple(items)))
    return Picture(tuple(panels), "a heavy top", subtitle=f"upright it {made.upright}")


def let_go(
    transverse: float, momentum: float, pull: float, tilt: float, nutation: float, slow: float
) -> "list[tuple[float, float]]":
    """Tilt and turn of an axis that is let go at rest, until it is round or has nutated often enough."""
    start = momentum * math.cos(tilt)

    def rates(angle: float, rate: float) -> "tuple[float, float, float]":
        sine, cosine = math.sin(angle), math.cos(angle)
        turn = (start - momentum * cosine) / (transverse * sine * sine)
        return rate, (turn * sine * (transverse * turn * cosine - momentum) + pull * sine) / transverse, turn

    time = min(2.0 * math.pi / abs(slow), NUTATIONS / nutation)
    count = math.ceil(time * nutation * STEPS)
    step = time / count
    state = (tilt, 0.0, 0.0)
    path = [(tilt, 0.0)]
    for _ in range(count):
        slopes: list[tuple[float, float, float]] = []
        for share in (0.0, 0.5, 0.5, 1.0):
            last = slopes[-1] if slopes else (0.0, 0.0, 0.0)
            slopes.append(rates(state[0] + share * step * last[0], state[1] + share * step * last[1]))
        a, b, c, d = slopes
        state = tuple(state[i] + step / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]) for i in range(3))  # type: ignore[assignment]
        path.append((state[0], state[2]))
    return path


def _seen(tilt: float, turn: float) -> "tuple[float, float, bool]":
    """A point of the unit sphere on the sheet, and whether it is on the near side."""
    x, y, z = math.sin(tilt) * math.sin(turn), -math.sin(tilt) * math.cos(turn), math.cos(tilt)
    return x, z * math.cos(VIEW) + y * math.sin(VIEW), z * math.sin(VIEW) - y * math.cos(VIEW) >= 0.0


def _drawn(path: "list[tuple[float, float]]", near: "Any", far: "Any", role: int) -> "list[Curve]":
    """The path, broken where it goes behind."""
    points = [_seen(*one) for one in path]
    x = [point[0] for point in points]
    return [
        Curve(x, [y if front is side else math.nan for _, y, front in points], "", style, role)
        for side, style in ((True, near), (False, far))
        if any(front is side for _, _, front in points)
    ]


def _sphere(path: "list[tuple[float, float]]", circles: "list[tuple[float, Any]]") -> Panel:
    turns = [2.0 * math.pi * k / POINTS for k in range(POINTS + 1)]
    items: list[Any] = [Curve([math.cos(t) for t in turns], [math.sin(t) for t in turns], "", "outline", GREY)]
    for tilt, style in [(QUARTER, "dots"), *circles]:
        items += _drawn([(tilt, t) for t in turns], style, "dots", GREY)
    items.append(Curve([0.0, 0.0], [0.0, 1.25 * math.cos(VIEW)], "", "centre", GREY))
    items += _drawn(path, "solid", "thin", 0)
    x, y, _front = _seen(*path[0])
    items += [Arrow(0.0, 0.0, x, y, "", role=1), Label(0.0, -1.12, "path of the axis, let go at rest at the tilt", 0)]
    ends = (-1.3, 1.3)
    return Panel(Axis("", ends=ends), Axis("", ends=ends), tuple(items), "", equal=True, bare=True)


def gyro(
    made: "Any",
    *,
    axial: "float | None" = None,
    transverse: "float | None" = None,
    mass: "float | None" = None,
    gyration: "float | None" = None,
    radius: "float | None" = None,
    spin: float,
    precession: float,
    angle: float = QUARTER,
    **_: "Any",
) -> Picture:
    """The angular momentum beside the axes, and the torque over the angle between them."""
    sine, cosine = math.sin(angle), math.cos(angle)
    axial, transverse = moments_of(axial, transverse, mass, gyration, radius)
    along = axial * (spin + precession * cosine)
    across = (transverse or 0.0) * precession * sine
    size = math.hypot(along, across) or 1.0
    # across the axis lies the part of the precession, at right angles in the plane of both axes
    momentum = ((along * sine - across * cosine) / size, (along * cosine + across * sine) / size)
    rim = 0.35
    items = (
        Curve([0.0, 0.0], [-0.3, 1.25], "", "centre", GREY),
        Curve([0.0, 1.2 * sine], [0.0, 1.2 * cosine], "", "centre", GREY),
        Curve([0.45 * sine - rim * cosine, 0.45 * sine + rim * cosine],
              [0.45 * cosine + rim * sine, 0.45 * cosine - rim * sine], "", "thick", GREY),
        Arrow(0.0, 0.0, *momentum, "angular momentum" + (" of the spin" if transverse is None else ""), role=0),
        Arrow(0.0, 0.0, 0.0, math.copysign(0.7, precession or 1.0), "precession", role=1),
        Label(1.3 * sine, 1.3 * cosine, "spin axis", GREY),
    )  # fmt: skip
    axes = Panel(Axis("", ends=(-0.7, 1.7)), Axis("", ends=(-0.6, 1.5)), items, "", equal=True, bare=True)
    angles = [math.pi * k / POINTS for k in range(POINTS + 1)]
    simple = [axial * spin * precession * math.sin(a) for a in angles]
    exact = (
        []
        if transverse is None
        else [
            one + precession * math.sin(a) * (axial - transverse) * precession * math.cos(a)
            for one, a in zip(simple, angles, strict=True)
        ]
    )
    torques = Panel(
        Axis("angle between spin and precession", Angle, step=math.pi / 6.0),
        Axis("gyroscopic torque", Torque),
        (
            *([Curve(angles, exact, "exact", role=0)] if exact else []),
            Curve(angles, simple, "spin times precession", "dashed", role=1),
            Mark(angle, plain(made.torque), "as given", role=3),
        ),
    )
    return Picture((axes, torques), "gyroscopic torque", subtitle=made.sense)


def disk(
    made: "Any",
    *,
    radius: float,
    wheel: "Any" = DISK,
    roll: "float | None" = None,
    lean: "float | None" = None,
    turn: "float | None" = None,
    **_: "Any",
) -> Picture:
    """How fast it falls at which roll, and the circles of a steady turn."""
    limit = plain(made.rolling_limit)
    shape = growth_factor(wheel)
    rates = [limit * k / POINTS for k in range(POINTS + 1)]
    falls = [math.sqrt(max(shape * (limit - rate) * (limit + rate), 0.0)) for rate in rates]
    items: list[Any] = [
        Curve([*rates, 1.6 * limit], [*falls, 0.0], "upright rolling", role=0),
        Band(limit, limit, "stable above"),
    ]
    if roll is not None:
        items.append(Mark(abs(roll), plain(made.growth or 0.0), "as given", role=3))
    panels = [Panel(Axis("roll", TurnRate), Axis("falls at", GrowthRate), tuple(items))]
    if lean is not None and turn is not None:
        path = plain(made.path_radius)
        contact = path + radius * math.sin(lean)
        turns = [2.0 * math.pi * k / POINTS for k in range(POINTS + 1)]
        circles: list[Any] = [
            Curve([path * math.cos(t) for t in turns], [path * math.sin(t) for t in turns], "centre", "dashed", 1),
            Curve(
                [contact * math.cos(t) for t in turns], [contact * math.sin(t) for t in turns], "on the floor", role=0
            ),
        ]
        # the disk from above: an ellipse along the path, its lean as width
        circles.append(
            Curve(
                [path + radius * math.sin(lean) * math.cos(t) for t in turns],
                [radius * math.sin(t) for t in turns],
                "",
                "filled",
                2,
            )
        )
        panels.append(Panel(Axis("x", Length), Axis("y", Length), tuple(circles), "steady turn from above", equal=True))
    return Picture(tuple(panels), f"a rolling {wheel}")
