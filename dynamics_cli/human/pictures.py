"""Stick figures with mass centres, ground forces and joint moments as arcs; falls as a strip of poses."""

import math

from dynamics_cli.errors import worded
from dynamics_cli.human.bodies.figure import SPANS, Flexions, side_view
from dynamics_cli.human.fall import forces_at
from dynamics_cli.human.joints.moments import TURNS
from dynamics_cli.numerics.number import plain
from dynamics_cli.pictures import Arrow, Axis, Curve, Label, Mark, Panel, Picture
from dynamics_cli.quantities import STANDARD_GRAVITY, Angle, Force, Length, Mass, MusclePower, Time, Torque

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from typing import Any

    Place = Sequence[float]

BODY, CENTRES, GROUND, WEIGHT, MOMENT = 6, 6, 2, 1, 0
ARC = 1.5 * math.pi
ARC_POINTS = 48
POSES = 7
# Above it the picture of the friction needed ends: a floor gives no more.
MOST_FRICTION = 1.0


def posture(answer: "Any", **_: "Any") -> Picture:
    """The figure from the side, and of joint centres from the front too."""
    joints = {joint.name: [float(plain(x)) for x in joint.at] for joint in answer.joints}
    centres = [([float(plain(x)) for x in segment.centre], float(plain(segment.mass))) for segment in answer.segments]
    whole = [float(plain(x)) for x in answer.centre]
    panels = [_view(joints, centres, whole, (0, 2), answer)]
    if any(name.startswith("left ") for name in joints):
        panels.append(_view(joints, centres, whole, (1, 2), answer))
    return Picture(tuple(panels), f"posture: {answer.balance or 'in the air'}", columns=len(panels))


def _view(
    joints: "Mapping[str, Place]", centres: "Sequence[tuple[Place, float]]", whole: "Place", axes: "tuple[int, int]",
    answer: "Any",
) -> Panel:  # fmt: skip
    i, j = axes
    items: list[Any] = [*_body(joints, axes)]
    heaviest = max(mass for _, mass in centres)
    for at, mass in centres:
        items.append(Curve(*_circle(at[i], at[j], 0.012 + 0.025 * math.sqrt(mass / heaviest)), "", "filled", CENTRES))
    words = worded("mass centre, {height} up", height=(whole[2], Length))
    items.append(Curve([whole[i]] * 2, [0.0, whole[j]], "", "dashed", WEIGHT))
    items.append(Mark(whole[i], whole[j], "", role=WEIGHT))
    if i == 0:
        items.append(Label(whole[i] + 0.03, 0.25 * whole[j], words, WEIGHT, left=True))
    if i == 0 and answer.toe_margin is not None:
        front = whole[0] + float(plain(answer.toe_margin))
        back = whole[0] - float(plain(answer.heel_margin))
        items.append(Curve([back, front], [0.0, 0.0], "", "thick", GROUND))
    items += _room(items)
    return Panel(
        Axis("forward" if i == 0 else "left", Length), Axis("up", Length), tuple(items),
        "" if i == 0 else "from the front", equal=True,
    )  # fmt: skip


def _body(joints: "Mapping[str, Place]", axes: "tuple[int, int]") -> "list[Any]":
    """Limbs as lines, the head as a circle, the floor below."""
    i, j = axes
    lines: list[Any] = []
    for name, (first, second) in SPANS.items():
        for side in ("", "left ", "right "):
            ends = [joints.get(side + end, joints.get(end)) for end in (first, second)]
            if ends[0] is None or ends[1] is None or (side and side + first not in joints):
                continue
            (x0, y0), (x1, y1) = ((end[i], end[j]) for end in ends)  # type: ignore[index]
            if name == "head":
                size = math.hypot(x1 - x0, y1 - y0)
                radius = max(0.4 * size, 0.06)
                x, y = x0 + 0.4 * (x1 - x0), y0 + 0.4 * (y1 - y0)
                lines.append(Curve(*_circle(x, y, radius), "", "outline", BODY))
                edge = min(radius / max(0.6 * size, 1e-9), 1.0)
                x0, y0 = x + edge * (x1 - x), y + edge * (y1 - y)
            lines.append(Curve([x0, x1], [y0, y1], "", "thick", BODY))
    corners = [[side + name for name in ("heel", "ankle", "toe")] for side in ("", "left ", "right ")]
    corners += [["left shoulder", "neck", "right shoulder"], ["left hip", "hip", "right hip"]]
    for names in corners:
        if set(names) <= joints.keys():
            places = [joints[name] for name in names]
            lines.append(Curve([at[i] for at in places], [at[j] for at in places], "", "solid", BODY))
    lines += [
        Mark(at[i], at[j], "", role=BODY) for name, at in joints.items()
        if name.split()[-1] in ("ankle", "knee", "hip", "shoulder", "elbow", "wrist", "neck")
    ]  # fmt: skip
    return lines


def _circle(x: float, y: float, radius: float) -> "tuple[list[float], list[float]]":
    turns = [2.0 * math.pi * k / ARC_POINTS for k in range(ARC_POINTS + 1)]
    return [x + radius * math.cos(t) for t in turns], [y + radius * math.sin(t) for t in turns]


def _room(items: "Sequence[Any]") -> "list[Curve]":
    """Air around a figure, for words beside it, and the floor."""
    xs = [x for item in items if isinstance(item, Curve) for x in item.x]
    ys = [y for item in items if isinstance(item, Curve) for y in item.y]
    left, right = min(xs) - 0.25, max(xs) + 0.45
    return [
        Curve([left, right], [min(*ys, 0.0) - 0.1, max(ys) + 0.12], "", "fill", BODY),
        Curve([left, right], [0.0, 0.0], "", "thin", BODY),
    ]


def moments(
    answer: "Any", *, mass: float, size: "Any", sex: "Any" = None, pose: "Any" = None, load: float = 0.0,
    hand_force: "Any" = None, ankle_height: float = 0.08, heel: float = 0.06, foot_inclination: float = 0.0,
    gravity: float = STANDARD_GRAVITY, **_: "Any",
) -> Picture:  # fmt: skip
    """The figure with its weight, the load, the force of the ground, and the moments of the joints as arcs."""
    numbers = [float(plain(number)) for number in (mass, ankle_height, heel, foot_inclination)]
    figure = side_view(numbers[0], sex, size, pose or Flexions(), *numbers[1:], any_posture=True)
    joints = {name: [float(plain(x)) for x in at] for name, at in figure.joints.items()}
    items: list[Any] = [*_body(joints, (0, 2))]
    up = [float(plain(x)) for x in answer.ground_force]
    scale = 0.45 / (math.hypot(*up) or 1.0)
    x, z = (float(plain(figure.centre[k])) for k in (0, 2))
    weight = numbers[0] * float(plain(gravity))
    items += [Mark(x, z, "", role=WEIGHT), Arrow(x, z, 0.0, -scale * weight, "", WEIGHT)]
    items.append(
        Label(x + 0.02, z - 0.3 * scale * weight, worded("{weight}", weight=(weight, Force)), WEIGHT, left=True)
    )
    hand = joints["knuckle"]
    held = float(plain(load)) * float(plain(gravity))
    push = [float(plain(part)) for part in hand_force or (0.0, 0.0)]
    if held or any(push):
        items.append(Arrow(hand[0], hand[2], scale * push[0], scale * (push[1] - held), "", WEIGHT))
        words = worded("{held}", held=(float(plain(load)), Mass) if held else (math.hypot(*push), Force))
        items.append(Label(hand[0] + 0.03, hand[2] + scale * (push[1] - held), words, WEIGHT, left=True))
    at = float(plain(answer.pressure_centre))
    items.append(Arrow(at - scale * up[0], -scale * up[1], scale * up[0], scale * up[1], "", GROUND))
    items.append(
        Label(at + 0.03, -0.6 * scale * up[1], worded("{force}", force=(math.hypot(*up), Force)), GROUND, left=True)
    )
    items += _moment_arcs(answer, joints)
    items += _room(items)
    title = worded("joint moments, both sides; the largest at the {joint}", joint=answer.largest_joint)
    return Picture((Panel(Axis("forward", Length), Axis("up", Length), tuple(items), equal=True),), title)


def _moment_arcs(answer: "Any", joints: "Mapping[str, Place]") -> "list[Any]":
    largest = max(abs(float(plain(joint.moment))) for joint in answer.joints) or 1.0
    items: list[Any] = []
    for joint in answer.joints:
        moment = float(plain(joint.moment))
        x, z = joints[joint.name][0], joints[joint.name][2]
        anticlockwise = moment * TURNS[joint.name][2] > 0.0
        radius = 0.03 + 0.07 * abs(moment) / largest
        if abs(moment) > 0.02 * largest:
            items += _arc(x, z, radius, anticlockwise=anticlockwise)
        words = worded("{name} {moment:3}", name=joint.name, moment=(abs(moment), Torque))
        if joint.name in ("hip", "knee", "ankle", "neck"):
            items.append(Mark(x, z, words, (-8.0 - 220.0 * radius, 4.0), dot=False, role=MOMENT))
        else:
            items.append(Label(x + radius + 0.03, z + 0.02, words, MOMENT, left=True))
    return items


def _arc(x: float, y: float, radius: float, *, anticlockwise: bool) -> "list[Any]":
    """Three quarters of a circle with an arrow at its end."""
    sense = 1.0 if anticlockwise else -1.0
    start = math.pi * (0.5 - 0.75 * sense)
    turns = [start + sense * ARC * k / ARC_POINTS for k in range(ARC_POINTS + 1)]
    end = turns[-1]
    tip = x + radius * math.cos(end), y + radius * math.sin(end)
    step = 0.4 * radius
    return [
        Curve(
            [x + radius * math.cos(t) for t in turns], [y + radius * math.sin(t) for t in turns], "", "solid", MOMENT
        ),
        Arrow(tip[0], tip[1], -sense * step * math.sin(end), sense * step * math.cos(end), "", MOMENT),
    ]


def fall(
    answer: "Any", *, centre_height: float, body: "Any", start: float = 0.0, speed: float = 0.0,
    end: float = 0.5 * math.pi, height: "float | None" = None, friction: "float | None" = None,
    gravity: float = STANDARD_GRAVITY, **_: "Any",
) -> Picture:  # fmt: skip
    """Poses on the way down, and the friction that the support needs over the inclination."""
    h, first, last = (float(plain(number)) for number in (centre_height, start, end))
    tall = float(plain(height)) if height is not None else 1.75 * h
    poses: list[Any] = []
    for k in range(POSES):
        angle = first + (last - first) * k / (POSES - 1)
        s, c = math.sin(angle), math.cos(angle)
        ends = k in (0, POSES - 1)
        poses.append(Curve([0.0, 0.88 * tall * s], [0.0, 0.88 * tall * c], "", "thick" if ends else "thin", BODY))
        poses.append(Curve(*_circle(0.94 * tall * s, 0.94 * tall * c, 0.06 * tall), "", "outline", BODY))
        poses.append(Mark(h * s, h * c, "", role=WEIGHT))
    poses += _room(poses)
    square = float(plain(body.squared(h)))
    share = h * h / square
    own = float(plain(gravity)) * h / square
    tripped = float(plain(speed)) * h * math.cos(first) / square
    boost = tripped * tripped / (4.0 * own)
    x, y = [], []
    for k in range(401):
        angle = first + (last - first) * k / 400
        along, normal = forces_at(share, first, boost, angle)
        if normal <= 0.0 or abs(along) > MOST_FRICTION * normal:
            break
        x.append(angle)
        y.append(along / normal)
    curves: list[Any] = [Curve(x, y, "needed", "thick", MOMENT)]
    if friction is not None:
        mu = float(plain(friction))
        curves += [
            Curve([first, last], [sign * mu] * 2, "floor" if sign > 0.0 else "", "dashed", GROUND)
            for sign in (1.0, -1.0)
        ]
    return Picture(
        (
            Panel(Axis("forward", Length), Axis("up", Length), tuple(poses), equal=True),
            Panel(Axis("inclination", Angle), Axis("friction force over normal force"), tuple(curves)),
        ),
        "a fall as one piece",
    )


def gait(answer: "Any", *_files: "Any", **_: "Any") -> Picture:
    """Moments and powers of the joints and the force of the ground, over time."""
    arrays = answer.history.arrays
    times = [float(t) for t in arrays["time"]]

    def curves(ending: str, names: "Sequence[str]", labels: "Sequence[str]") -> "tuple[Curve, ...]":
        return tuple(
            Curve(times, [float(y) for y in arrays[name + ending]], label, "thick", role=role)
            for role, (name, label) in enumerate(zip(names, labels, strict=True))
        )

    joints = ("ankle", "knee", "hip")
    moments = curves("_moment", joints, ("ankle: plantar flexors", "knee: extensors", "hip: extensors"))
    return Picture(
        (
            Panel(Axis("time", Time), Axis("moment", Torque), moments),
            Panel(Axis("time", Time), Axis("power", MusclePower), curves("_power", joints, joints)),
            Panel(
                Axis("time", Time), Axis("force of the ground", Force),
                curves("", ("ground_force_y", "ground_force_x"), ("up", "forward")),
            ),
        ),
        "joint moments and powers of a leg",
    )  # fmt: skip
