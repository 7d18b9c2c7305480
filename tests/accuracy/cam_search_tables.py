"""Answers of `cam motion` and `cam profile` beside exact ones, for the search."""

from collections.abc import Iterator
from typing import Any

from cam_search_compared import UNIT_ROUNDOFF, Compared, Stated, nearest, placed, table_angles
from cam_search_contact import Carried, Looking, extreme, nodes
from cam_search_motion import Turn
from precise import FUNCTIONS, Exact, exact_pi

from dynamics_cli.cam.geometry import followers
from dynamics_cli.cam.geometry.followers import Flank, Rotation
from dynamics_cli.cam.geometry.profile import profile
from dynamics_cli.cam.program.reading import Program
from dynamics_cli.cam.program.revolution import motion

NOTHING = Program()
RANGES = ("lift", "velocity", "acceleration", "jerk")
# What `Motion.at` says of its rows, in shares of the peaks, besides what rounding the angle moves.
ROWS = (1e-15, 1e-15, 5e-15, 5e-14)
# Extremes and sizes that an answer states no bound of are held to this share of the size: a turning place that is
# missed shows, rounding does not.
MISSED = 1e-9
_NODES: list[tuple[Any, Any]] = []


def doubles(tree: dict[str, str]) -> dict[str, float]:
    """The numbers of a record's tree."""
    return {key: float(value) for key, value in tree.items() if key != "record"}


def follower_of(tree: dict[str, str], module: Any = followers) -> Any:
    """The program's own record of a follower."""
    return getattr(module, tree["record"])(**doubles(tree))


def quadrature(turn: Turn, function: Any, most: float, order: int = 2) -> Any:
    """∮ function(zone's state, angle) dθ by Gauss's rule of 40 nodes on steps of at most so many radians."""
    if not _NODES:
        _NODES.extend(nodes())
    total: Any = None
    for zone in turn.zones:
        width = zone.end - zone.start
        # a short zone is steep: its integrand may turn many times faster than the cam
        steps = (int(float(width) / most) + (1 if zone.branch is None else 3)) * Looking.steps
        half = width / (2 * steps)
        for step in range(steps):
            middle = zone.start + half * (2 * step + 1)
            for node, weight in _NODES:
                theta = middle + half * node
                part = [half * weight * value for value in function(zone.at(theta, order), theta)]
                total = part if total is None else [a + b for a, b in zip(total, part, strict=True)]
    return total


def _ends(turn: Turn, order: int) -> tuple[Any, Any]:
    """Least and greatest value of a derivative of the lift."""
    shift = max(order - 2, 0)
    which = order - shift
    return tuple(extreme(turn, lambda *state: state[which], sign, shift=shift) for sign in (-1, 1))  # type: ignore[return-value]


def moving(case: dict[str, Any]) -> Iterator[Compared]:
    """`cam motion`: extremes, root mean square, values in time, and the table."""
    speed = float(case["shaft_speed"]) if "shaft_speed" in case else None
    count = int(case.get("count", 9))
    answer = motion(NOTHING, program=case["program"], count=count, shaft_speed=speed)
    turn, stated = Turn(case["program"]), Stated(answer)
    ends = [_ends(turn, order) for order in range(4)]
    peaks = [max(float(abs(low)), float(abs(high))) for low, high in ends]
    for order, name in enumerate(RANGES):
        for which, exact in zip(("least", "greatest"), ends[order], strict=True):
            if turn.swing:
                address = f"swing.{which}" + (f"_{name}" if order else "")
                value = getattr(answer.swing, address[6:])
            else:
                address, value = f"{name}.{which}", getattr(getattr(answer, name), which)
            yield from stated.compare(address, value, exact, 2e-14 * peaks[order], size=peaks[order])
    square = quadrature(turn, lambda state, _: [state[2] * state[2]], 7.0)[0]
    rms = FUNCTIONS["sqrt"](square / (2 * exact_pi()))
    name = "rms_swing_acceleration" if turn.swing else "rms_acceleration"
    yield from stated.compare(name, getattr(answer, name), rms, 2e-14 * float(rms))
    if speed is not None:
        yield from _in_time(answer, stated, ends, rms, Exact(abs(speed)))
    yield from _moved_rows(answer, turn, stated, peaks)


def _in_time(answer: Any, stated: Stated, ends: list[Any], rms: Any, speed: Any) -> Iterator[Compared]:
    words = "swing_in_time" if answer.swing_in_time is not None else "in_time"
    timed = getattr(answer, words)
    for order, name in enumerate(("speed", "acceleration", "jerk"), 1):
        exact = max(abs(ends[order][0]), abs(ends[order][1])) * speed**order
        yield from stated.compare(f"{words}.{name}", getattr(timed, name, None), exact, 3e-14 * float(exact))
    exact = rms * speed * speed
    yield from stated.compare(f"{words}.rms_acceleration", timed.rms_acceleration, exact, 3e-14 * float(exact))


def _moved_rows(answer: Any, turn: Turn, stated: Stated, peaks: list[float]) -> Iterator[Compared]:
    """Rows of the table; where a derivative jumps within a rounding of the angle either side is right."""
    words = "swing_table" if turn.swing else "table"
    arrays = getattr(answer, words).arrays
    names = ("swing" if turn.swing else "lift", *RANGES[1:])
    for index, theta in enumerate(arrays["angle"].tolist()):
        sides = [zone.at(at, 4) for zone, at in turn.zones_at(theta)]
        for order, name in enumerate(names):
            value = float(arrays[name][index])
            exact = nearest([side[order] for side in sides], value)
            # an angle is a double: what it moves by its rounding is not the motion's
            slope = max(float(abs(side[order + 1])) for side in sides)
            promised = ROWS[order] * peaks[order] + 4.0 * UNIT_ROUNDOFF * theta * slope
            address = f"{words}[{index}].{name}"
            yield from stated.compare(
                address, value, exact, promised, size=peaks[order], row=f"{words}[{index}]"
            )  # fmt: skip


def outlining(case: dict[str, Any]) -> Iterator[Compared]:
    """`cam profile`: extremes, plate and table."""
    points, start = int(case.get("points", 8)), float(case.get("start_angle", 0.0))
    tool = float(case.get("cutter_radius", 0.0))
    plate = {name: float(case[name]) for name in ("thickness", "density") if name in case}
    answer = profile(
        NOTHING, program=case["program"], follower=follower_of(case["follower"]), points=points, start_angle=start,
        rotation=Rotation(case.get("rotation", "ccw")), flank=Flank(case.get("flank", "inner")),
        cutter_radius=tool or None, **plate,
    )  # fmt: skip
    turn, stated = Turn(case["program"]), Stated(answer)
    carried = Carried(case["follower"], case.get("rotation", ""), case.get("flank", "inner"))
    yield from shape(answer, turn, carried, stated)
    if points % 5 == 0:
        yield from _plate(answer, turn, carried, stated, Exact(start), plate)
    yield from _outlined_rows(answer, turn, carried, stated, (points, Exact(start), Exact(tool)))


def shape(answer: Any, turn: Turn, carried: Carried, stated: Stated, words: str = "") -> Iterator[Compared]:
    """Extremes of pressure angle, curvature and place along a flat face, and whether they are where they are said."""
    for name, sign in (("largest_pressure_angle", 1), ("least_pressure_angle", -1)):
        exact = Exact(0)
        if carried.kind != "FlatFace":
            exact = extreme(turn, carried.leaning, sign)
        # past a right angle a follower is pulled, and at two of them the angle jumps to its other sign
        if abs(exact) < 3 and abs(getattr(answer, name)) < 3.0:
            yield from stated.compare(words + name, getattr(answer, name), exact, MISSED)
            yield from placed(name, getattr(answer, f"{name}_at", None), turn, carried.leaning, exact, MISSED)
    travel = 0.0 if turn.swing else max(map(abs, turn.levels))
    size = float(carried.roller) + carried.sizes["base_radius"] + travel
    if carried.flat:
        yield from _flat_shape(answer, turn, carried, stated, size)
        return
    for name, sign in (("least_convex_radius", 1), ("least_concave_radius", -1)):
        bend = extreme(turn, carried.bend, sign)
        if sign * bend > 1e-9 / size:
            exact = sign * (1 / bend - carried.side * carried.roller)
            whole = abs(float(exact)) + size
            value = getattr(answer, name, None)
            yield from stated.compare(words + name, value, exact, MISSED * whole, size=whole)
            room = MISSED * abs(float(bend))
            yield from placed(name, getattr(answer, f"{name}_at", None), turn, carried.bend, bend, room)


def _flat_shape(answer: Any, turn: Turn, carried: Carried, stated: Stated, size: float) -> Iterator[Compared]:
    radius = extreme(turn, carried.rounding, -1)
    whole, name = abs(float(radius)) + size, "least_convex_radius"
    yield from stated.compare(name, getattr(answer, name), radius, MISSED * whole, size=whole)
    yield from placed(name, getattr(answer, f"{name}_at", None), turn, carried.rounding, radius, MISSED * whole)
    if hasattr(answer, "base_radius"):
        return
    low, high = (extreme(turn, lambda *state: carried.face(*state)["along"], sign) for sign in (-1, 1))
    wide = max(abs(float(low)), abs(float(high)), size)
    for name, exact in (("face_low", low), ("face_high", high), ("face_width", high - low)):
        yield from stated.compare(name, getattr(answer, name, None), exact, MISSED * wide, size=wide)


def _plate(
    answer: Any, turn: Turn, carried: Carried, stated: Stated, start: Any, plate: dict[str, float]
) -> Iterator[Compared]:
    """Area, length, centroid and moments of inertia by Gauss's rule in 240 bits: A = ½∮ x dy − y dx, and so on."""

    def swept(state: list[Any], theta: Any) -> list[Any]:
        # jets by hand: the point's own derivative along the turn, z′ = dz/dθ of the fixed frame − iτz
        touch = carried.touch(*state)
        (x, y), (nx, ny) = touch["point"], touch["normal"]
        if carried.flat:
            bend = touch["radius"] * (carried.turn if carried.kind == "FlatFace" else carried.turn + state[1])
        else:
            bend = carried.turn * touch["speed"] * (1 - carried.side * carried.roller * touch["curvature"])
        run = carried.turn * bend
        over = (x * nx + y * ny) * run
        zx, zy = carried.turned((x, y), theta, start)
        return [over / 2, abs(run), zx * over / 3, zy * over / 3, (x * x + y * y) * over / 4]

    area, length, mx, my, polar = quadrature(turn, swept, 0.15)
    # the whole envelope is integrated here: it is the plate's edge where it neither breaks nor cuts itself
    if area <= 0 or any(one.code in ("undercut", "velocity-jump") for one in answer.advice):
        return
    size = float(length)
    yield from stated.compare("area", answer.area, area)
    yield from stated.compare("perimeter", answer.perimeter, length)
    for name, exact in (("centroid_x", mx / area), ("centroid_y", my / area)):
        yield from stated.compare(name, getattr(answer, name), exact, MISSED * size, size=size)
    if plate:
        weight = Exact(plate["thickness"]) * Exact(plate["density"])
        about = polar - (mx * mx + my * my) / area
        for name, exact in (("mass", area), ("inertia", polar), ("inertia_about_centroid", about)):
            room = MISSED * float(weight * (area if name == "mass" else polar))
            yield from stated.compare(name, getattr(answer, name), weight * exact, room)


def _outlined_rows(answer: Any, turn: Turn, carried: Carried, stated: Stated, given: Any) -> Iterator[Compared]:
    count, start, tool = given
    arrays = answer.points.arrays
    lengths = sum(carried.sizes[key] for key in carried.sizes if key not in ("arm_angle", "offset"))
    size = max(lengths, float(arrays["radius"].max()))
    side = carried.side
    for index, theta in enumerate(arrays["cam_angle"].tolist()):
        rows = []
        for zone, at, angle in table_angles(turn, index, count, theta):
            touch = carried.touch(*zone.at(at, 2))
            point, normal = touch["point"], touch["normal"]
            centre = touch.get("centre", point)
            cutter = tuple(a + side * tool * b for a, b in zip(point, normal, strict=True))
            x, y = carried.turned(point, angle, start)
            (px, py), (cx, cy) = (carried.turned(one, angle, start) for one in (centre, cutter))
            rows.append({
                "x": x, "y": y, "radius": FUNCTIONS["sqrt"](x * x + y * y), "pitch_x": px, "pitch_y": py,
                "cutter_x": cx, "cutter_y": cy, "pressure_angle": touch["pressure"], "contact_x": point[0],
                "contact_y": point[1],
            })  # fmt: skip
        for name in rows[0]:
            value = float(arrays[name][index])
            exact = nearest([row[name] for row in rows], value)
            angle = name == "pressure_angle"
            yield from stated.compare(
                f"points[{index}].{name}", value, exact, 2e-13 if angle else 1e-14 * size,
                size=None if angle else size, row=f"points[{index}]",
            )  # fmt: skip
