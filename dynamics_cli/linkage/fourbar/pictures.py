"""Pictures of a four-bar: poses with the curve of a coupler point, speeds, transmission angle, and a moving SVG."""

from cmath import exp
from math import atan2, nan, pi, sin

from dynamics_cli.animation import animated
from dynamics_cli.errors import worded
from dynamics_cli.linkage.drawing import BELOW, LEFT, ZERO, circle, pin, plan
from dynamics_cli.linkage.fourbar.closure import OPEN, Branch, frame
from dynamics_cli.linkage.fourbar.grashof import kind_of
from dynamics_cli.pictures import Axis, Band, Curve, Panel, Picture, complex_curve
from dynamics_cli.quantities import Angle, AngularAcceleration, Size, TurnRate

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

FRAMES = 120
GHOSTS = 8
SAMPLES = 361
# The default pose drawn in full: an eighth of the motion from the start.
SHOWN = 45
# Beyond this a speed ratio near a toggle only squeezes the rest of its curve.
STEEP = 8.0
ENDS = (0.001, 0.999)


def _title(lengths: "tuple[float, ...]", words: str) -> str:
    a, b, c, d = lengths
    return worded(
        "{words}\ncrank {a}, coupler {b}, rocker {c}, ground {d}",
        words=words, a=(a, Size), b=(b, Size), c=(c, Size), d=(d, Size),
    )  # fmt: skip


def _frames(lengths: "tuple[float, ...]", side: float, point: "complex | None", count: int) -> "list[Any]":
    """Pins A, B and the coupler point over the whole motion, evenly in its parameter."""
    import numpy as np

    from dynamics_cli.linkage.fourbar.circuit import FULL, Circuit

    circuit = Circuit(frame(*lengths), side)
    u = np.arange(count) * (FULL / count)
    tracks = []
    for place in (0j, complex(lengths[1]), 0.5 * lengths[1] + 0j if point is None else point):
        x, y = circuit.place(u, place)
        tracks.append((x.parts[0] + 1j * y.parts[0]).tolist())
    return list(zip(*tracks, strict=True))


def linkage_items(
    lengths: "tuple[float, ...]", side: float, point: "complex | None", shown: "tuple[complex, complex] | None"
) -> "list[Any]":
    """Ghosts, the path of B and of the coupler point, and one pose drawn out."""
    d = lengths[3]
    every = _frames(lengths, side, point, SAMPLES - 1)
    items: list[Any] = []
    for index in range(0, SAMPLES - 1, (SAMPLES - 1) // GHOSTS):
        a, b, _ = every[index]
        items.append(complex_curve((0j, a, b, complex(d)), "", "dots", 6))
    items.append(complex_curve([frame_[1] for frame_ in every], "", "thin", 2))
    if point is not None:
        items.append(complex_curve([*(frame_[2] for frame_ in every), every[0][2]], "path of P", "solid", 3))
    pins = shown or every[SHOWN][:2]
    turn = (pins[1] - pins[0]) / lengths[1]
    items += [
        complex_curve((0j, pins[0]), "crank", "thick", 0),
        complex_curve((pins[0], pins[1]), "coupler", "thick", 1),
        complex_curve((complex(d), pins[1]), "rocker", "thick", 2),
    ]
    if point is not None:
        tip = pins[0] + turn * point
        items.append(complex_curve((pins[0], tip, pins[1]), "", "solid", 1))
        items.append(pin(tip, "P"))
    return [*items, *_pivots(complex(d)), pin(pins[0], "A", BELOW), pin(pins[1], "B")]


def _pivots(rocker_pivot: complex) -> "list[Any]":
    return [pin(0j, "O₂", LEFT), pin(rocker_pivot, "O₄", BELOW)]


def four_bar_picture(
    result: "Any", *, crank: float, coupler: float, rocker: float, ground: float, crank_angle: "float | None" = None,
    branch: Branch = OPEN, point: "tuple[float, float] | None" = None, speed: "float | None" = None, **_: "Any",
) -> Picture:  # fmt: skip
    """The linkage in several poses, and speed, acceleration and transmission angle over the crank angle."""
    lengths = (crank, coupler, rocker, ground)
    side = 1.0 if branch == OPEN else -1.0
    place = None if point is None else complex(*point)
    now = None
    if result.crank_pin is not None:
        now = complex(*result.crank_pin), complex(*result.rocker_pin)
    items = linkage_items(lengths, _circuit_side(lengths, side, crank_angle), place, now)
    return Picture((plan(items), *_curves(lengths, side, crank_angle, speed)), _title(lengths, kind_of(lengths)))


def _circuit_side(lengths: "tuple[float, ...]", side: float, crank_angle: "float | None") -> float:
    """The side that names the circuit: of the crank where that swings on either side of the ground link."""
    links = frame(*lengths)
    if links.outer < 0.0 and links.inner < 0.0 and crank_angle is not None:
        return 1.0 if sin(crank_angle) >= 0.0 else -1.0
    return side


def _curves(
    lengths: "tuple[float, ...]", side: float, crank_angle: "float | None", speed: "float | None"
) -> "tuple[Panel, ...]":
    """Speeds, accelerations and transmission angle; over those of the crank where it has no speed."""
    from dynamics_cli.linkage.fourbar.table import posed, reachable, spread

    links = frame(*lengths)
    ranges = reachable(links)
    low, high = next(
        (ends for ends in ranges if crank_angle is not None and ends[0] <= crank_angle <= ends[1]), ranges[-1]
    )
    inset = (0.0, 1.0) if links.outer >= 0.0 and links.inner >= 0.0 else ENDS
    angles = spread(low + (high - low) * inset[0], low + (high - low) * inset[1], SAMPLES - 1)
    poses = [posed(links, angle, side) for angle in angles]
    tracks = zip(*(there or (nan,) * 4 for _, there in poses), strict=True)
    rate = 1.0 if speed is None else speed
    scales = (rate, rate, rate * rate, rate * rate)
    clipped = [
        [part * scale if abs(part) <= STEEP else nan for part in track]
        for track, scale in zip(tracks, scales, strict=True)
    ]
    angle_axis = Axis("crank angle θ₂", Angle, ends=(low, high), step=pi / 6.0 if high - low > 2.0 else pi / 18.0)
    marks = () if crank_angle is None or not low <= crank_angle <= high else (Band(crank_angle, crank_angle),)
    mu = [2.0 * atan2(abs(loop.second), abs(loop.first)) if loop else nan for loop, _ in poses]
    words = "speeds of rocker and coupler", "accelerations, crank at uniform speed"
    if speed is None:
        over = "speeds of rocker and coupler over that of the crank"
        ratios = (
            (Axis("speed ratio"), ("ω₄/ω₂", "ω₃/ω₂"), clipped[:2], over),
            (Axis("α/ω₂²"), ("α₄/ω₂²", "α₃/ω₂²"), clipped[2:], words[1]),
        )
    else:
        ratios = (
            (Axis("ω", TurnRate), ("ω₄", "ω₃"), clipped[:2], words[0]),
            (Axis("α", AngularAcceleration), ("α₄", "α₃"), clipped[2:], words[1]),
        )
    return (
        *(
            Panel(
                angle_axis, axis,
                (Curve(angles, rocker, names[0], role=2), Curve(angles, coupler, names[1], "dashed", 1), ZERO, *marks),
                title,
            )
            for axis, names, (coupler, rocker), title in ratios
        ),
        Panel(
            angle_axis, Axis("transmission angle μ", Angle, ends=(0.0, pi), step=pi / 4.0),
            (Curve(angles, mu, role=0), Band(2.0 * pi / 9.0, 7.0 * pi / 9.0, "good", vertical=False), *marks),
            "transmission angle; force is transmitted well between 40 and 140 deg",
        ),
    )  # fmt: skip


def coupler_picture(
    result: "Any", *, crank: float, coupler: float, rocker: float, ground: float, point: "tuple[float, float]",
    branch: Branch = OPEN, **_: "Any",
) -> Picture:  # fmt: skip
    """The coupler curve with its linkage, and its cognates."""
    lengths = (crank, coupler, rocker, ground)
    side, place = (1.0 if branch == OPEN else -1.0), complex(*point)
    items = linkage_items(lengths, side, place, None)
    for name, group in (("cusp", result.cusps), ("crossing", result.crossings)):
        items += [pin(complex(pose.x, pose.y), name) for pose in group or ()]
    for part in result.straight or ():
        ends = (complex(*part.start), complex(*part.end))
        items.append(complex_curve(ends, "straight part", "thick", 4))
    every = _frames(lengths, side, place, SAMPLES - 1)
    a, b, tip = every[SHOWN]
    scale = place / coupler
    third = scale * ground
    first_leg, second_leg = tip - a, complex(ground) + tip - b
    second_left, second_right = first_leg + scale * a, second_leg + (1.0 - scale) * (b - ground)
    o4 = complex(ground)
    cognates: list[Any] = [complex_curve([*(pose[2] for pose in every), every[0][2]], "one curve", "solid", 3)]
    for role, (name, style, (one, other), pivots) in enumerate((
        ("linkage", "thick", (a, b), (0j, o4)),
        ("left cognate", "solid", (first_leg, second_left), (0j, third)),
        ("right cognate", "dashed", (second_leg, second_right), (o4, third)),
    )):  # fmt: skip
        cognates.append(complex_curve((pivots[0], one, other, pivots[1]), name, style, role))
        cognates.append(complex_curve((one, tip, other), "", "thin", role))
    cognates += [*_pivots(o4), pin(third, "C₀"), pin(tip, "P")]
    second = plan(cognates, "three linkages that trace the same curve")
    return Picture((plan(items), second), _title(lengths, "coupler curve"), columns=2)


def class_picture(result: "Any", *, crank: float, coupler: float, rocker: float, ground: float, **_: "Any") -> Picture:
    """The linkage in several poses with its limits."""
    lengths = (crank, coupler, rocker, ground)
    items = linkage_items(lengths, 1.0, None, None)
    for limit, word in ((result.outer_limit, "outer limit"), (result.inner_limit, "inner limit")):
        if limit is not None:
            for sign in (1.0, -1.0):
                tip = 1.25 * crank * exp(1j * sign * limit)
                items.append(complex_curve((0j, tip), word if sign > 0.0 else "", "centre", 5))
    for angle in (result.rocker_least, result.rocker_greatest):
        if angle is not None:
            tip = ground + 1.15 * rocker * exp(1j * angle)
            items.append(complex_curve((complex(ground), tip), "", "centre", 6))
    return Picture((plan(items),), _title(lengths, str(result.kind)))


def synthesis_picture(result: "Any", *, task: "Any", **_: "Any") -> Picture:
    """The linkage at every pair or pose that it reaches, or over its motion."""
    lengths = (result.crank, result.coupler, result.rocker, result.ground)
    if not result.met:
        return Picture((plan(linkage_items(lengths, 1.0, None, None)),), _title(lengths, str(result.kind)))
    poses = getattr(task, "poses", ())
    o2, o4 = 0j, complex(result.ground)
    if poses:
        o2, o4 = complex(*result.crank_pivot), complex(*result.rocker_pivot)
    along = (o4 - o2) / abs(o4 - o2)
    items: list[Any] = [
        complex_curve(circle(*each), "", "thin", 6) for each in ((o2, result.crank), (o4, result.rocker))
    ]
    for index, target in enumerate(result.met):
        a = o2 + along * result.crank * exp(1j * target.crank_angle)
        b = o4 + along * result.rocker * exp(1j * target.rocker_angle)
        label = f"{'pose' if poses else 'pair'} {index + 1}, {target.branch}"
        items.append(complex_curve((o2, a, b, o4), label, "thick", index))
        if poses:
            origin = complex(poses[index].x, poses[index].y)
            items += [complex_curve((a, origin, b), "", "solid", index), pin(origin, str(index + 1))]
        items += [pin(a, "A" if index == 0 else ""), pin(b, "B" if index == 0 else "")]
    items += [pin(o2, "O₂", LEFT), pin(o4, "O₄", BELOW)]
    return Picture((plan(items),), _title(lengths, str(result.kind)))


def moving_four_bar(
    result: "Any", crank: float = 0.0, coupler: float = 0.0, rocker: float = 0.0, ground: float = 0.0,
    crank_angle: "float | None" = None, branch: Branch = OPEN, point: "tuple[float, float] | None" = None, **_: "Any",
) -> str:  # fmt: skip
    """One complete motion of the linkage as an animated SVG."""
    del result
    lengths = (crank, coupler, rocker, ground)
    place = None if point is None else complex(*point)
    side = _circuit_side(lengths, 1.0 if branch == OPEN else -1.0, crank_angle)
    every = _frames(lengths, side, place, FRAMES)
    o4 = complex(ground)
    frames = [((0j, a), (a, b) if place is None else (a, p, b, a), (o4, b)) for a, b, p in every]
    tips = [pose[2] for pose in every] if place is not None else [pose[1] for pose in every]
    pins = [(a, b, p) if place is not None else (a, b) for a, b, p in every]
    return animated("One motion of a four-bar", frames, [[*tips, tips[0]]], (0j, o4), pins)
