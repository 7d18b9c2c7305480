"""Answers of `cam size` and `cam check` beside exact ones, for the search."""

from collections.abc import Iterator
from typing import Any

from cam_search_compared import Compared, Stated
from cam_search_contact import Carried, extreme
from cam_search_forces import Pressed, jumping
from cam_search_motion import Turn
from cam_search_tables import MISSED, NOTHING, doubles, follower_of, shape
from cam_search_undercut import lost
from precise import FUNCTIONS, Exact

from dynamics_cli.cam.forces.check import check
from dynamics_cli.cam.geometry.followers import Flank, Rotation
from dynamics_cli.cam.sizing import records as wanted
from dynamics_cli.cam.sizing.size import size

DEGREE = 3.141592653589793 / 180.0
ASKED = ("rise_limit", "return_limit", "least_radius", "shaft_speed")
SPRINGS = ("mass", "spring_rate", "preload", "inertia", "torsion_rate", "preload_torque")


def _cotangent(angle: float) -> Any:
    return 1 / FUNCTIONS["tan"](Exact(angle))


def nearest_start(a: Any, b: Any, floor: Any, c1: Any, c2: Any) -> tuple[Any, Any]:
    """The (e, d) nearest to the axis with d + e c₁ ≥ a, d − e c₂ ≥ b and d ≥ floor, of all feet and corners."""
    lines = [(c1, a), (-c2, b), (Exact(0), floor)]
    places = [(slope * level / (1 + slope * slope), level / (1 + slope * slope)) for slope, level in lines]
    places.append((Exact(0), Exact(0)))
    for i, (m, p) in enumerate(lines):
        for n, q in lines[i + 1 :]:
            e = (p - q) / (m - n)
            places.append((e, p - e * m))
    small = Exact(2) ** -180 * (abs(a) + abs(b) + abs(floor))
    kept = [(e, d) for e, d in places if all(d + e * slope >= level - small for slope, level in lines)]
    return min(kept, key=lambda place: place[0] ** 2 + place[1] ** 2)


class Limits:
    """Heights that the limits of pressure angle ask of a slide."""

    def __init__(self, turn: Turn, rise: float, back: float) -> None:
        self.turn = turn
        self.c1, self.c2 = _cotangent(rise), _cotangent(back)
        self.f1, self.f2 = float(self.c1), float(self.c2)

    def _weighed(self, s: Any, first: Any, second: Any) -> Any:
        return second if hasattr(s, "shape") else first

    def steepest(self, way: int, sign: int) -> Any:
        """max(s′ cot φ₁ − s) for +1, max(−s′ cot φ₂ − s) for −1; of the lift upside down with a sign of −1."""
        exact, rough = (self.c1, self.f1) if way > 0 else (self.c2, self.f2)

        def level(s: Any, s1: Any, s2: Any) -> Any:
            return (s1 * (way * (rough if hasattr(s, "shape") else exact)) - s) * sign

        return extreme(self.turn, level, 1)

    def floor(self) -> Any:
        """The least height that keeps the follower above the axis."""
        return -extreme(self.turn, lambda *state: state[0], -1)


def sizing(case: dict[str, Any]) -> Iterator[Compared]:
    """`cam size`: the size by its conditions, and the extremes of the cam that it makes."""
    tree = case["follower"]
    given = {key: float(case[key]) for key in ("rise_limit", "return_limit", "least_radius") if key in case}
    answer = size(
        NOTHING, program=case["program"], follower=follower_of(tree, wanted),
        rotation=Rotation(case.get("rotation", "ccw")), **given,
    )  # fmt: skip
    turn, stated = Turn(case["program"]), Stated(answer)
    rise, back = (given.get(name, 30.0 * DEGREE) for name in ("rise_limit", "return_limit"))
    values = {key: Exact(value) for key, value in doubles(tree).items()}
    kind = tree["record"]
    if kind == "FlatFace":
        yield from _flat(answer, turn, stated, values, Exact(given.get("least_radius", 0.0)))
    elif kind in ("Roller", "KnifeEdge") and "least_radius" not in given:
        yield from _slide(answer, stated, values, Limits(turn, rise, back), case.get("rotation", ""))
    elif kind == "ConjugateRoller" and "roller_distance" not in values:
        yield from _pair(answer, stated, values, Limits(turn, rise, back), case.get("rotation", ""))
    elif kind in ("OscillatingRoller", "OscillatingFlat") or (kind == "Roller" and "offset" in values):
        yield from _limited(answer, turn, stated, case, (rise, back), given.get("least_radius"))
    for words, owner, made in _made(answer, tree, kind):
        found = list(shape(owner, turn, Carried(made, case.get("rotation", "")), stated, words))
        yield from found
        yield from _kept({one.name.removeprefix(words): one.exact for one in found}, words, (rise, back))


def _made(answer: Any, tree: dict[str, str], kind: str) -> Iterator[tuple[str, Any, dict[str, str]]]:
    """The followers on the cams that were found, and where their extremes are in the answer."""
    made = {key: value for key, value in tree.items() if key != "face_margin"}
    made["base_radius"] = repr(answer.base_radius)
    if kind in ("Roller", "KnifeEdge"):
        yield "", answer, {"roller_radius": "0", **made, "record": "Roller", "offset": repr(answer.offset)}
    elif kind == "ConjugateRoller":
        apart = made.pop("roller_distance", repr(answer.roller_distance))
        yield "", answer, {"offset": "0", **made, "record": "Roller"}
        yield "second.", answer.second, {"offset": "0", **made, "roller_distance": apart}
    elif kind != "OscillatingFlat":
        yield "", answer, made


def _kept(exact: dict[str, Any], words: str, limits: tuple[float, float]) -> Iterator[Compared]:
    """The limits of pressure angle are kept on the cam that was found, beyond what its size in doubles can hold."""
    for name, way, limit in (("largest_pressure_angle", 1, limits[0]), ("least_pressure_angle", -1, limits[1])):
        if name in exact:
            over = max(way * exact[name] - Exact(limit), Exact(0))
            yield Compared(f"{words}{name} kept", 0.0, MISSED, over, 1.0, False, f"{words}{name} kept")


def _flat(answer: Any, turn: Turn, stated: Stated, values: dict[str, Any], least: Any) -> Iterator[Compared]:
    low = extreme(turn, lambda *state: state[0] + state[2], -1)
    floor = -extreme(turn, lambda *state: state[0], -1)
    exact = max(least - low, floor, Exact(0))
    # s + s″ may be nothing at all
    room = max(map(abs, turn.levels)) + float(least)
    yield from stated.compare("base_radius", answer.base_radius, exact, MISSED * room, size=room)
    slow, fast = (extreme(turn, lambda *state: state[1], sign) for sign in (-1, 1))
    width = fast - slow + 2 * values.get("face_margin", 0)
    yield from stated.compare("face_width", answer.face_width, width, MISSED * float(width))


def _slide(answer: Any, stated: Stated, values: dict[str, Any], limits: Limits, rotation: str) -> Iterator[Compared]:
    roller = values.get("roller_radius", Exact(0))
    a, b, floor = limits.steepest(1, 1), limits.steepest(-1, 1), limits.floor()
    way = -1 if rotation == "clockwise" else 1
    if "offset" in values:
        e = way * values["offset"]
        d = max(a - e * limits.c1, b + e * limits.c2, floor)
    else:
        e, d = nearest_start(a, b, floor, limits.c1, limits.c2)
    radius = FUNCTIONS["sqrt"](e * e + d * d)
    size = float(max(radius, roller))
    binds = radius >= roller
    yield from stated.compare("base_radius", answer.base_radius, max(radius - roller, Exact(0)), MISSED * size)
    yield from stated.compare("start_radius", answer.start_radius, max(radius, roller), MISSED * size)
    if binds:
        yield from stated.compare("offset", answer.offset, way * e, MISSED * size, size=size)
    in_line = max(a, b, floor) - roller
    yield from stated.compare("in_line_base_radius", answer.in_line_base_radius, in_line, MISSED * size)


def _pair(answer: Any, stated: Stated, values: dict[str, Any], limits: Limits, rotation: str) -> Iterator[Compared]:
    """Two rollers on a slide: tan φ = (s′ − e)/(d + s) above the axis, (e − s′)/(d₂ − s) below it."""
    e, roller = values.get("offset", Exact(0)), values["roller_radius"]
    e = -e if rotation == "clockwise" else e
    a, b = limits.steepest(1, 1), limits.steepest(-1, 1)
    first = max(a - e * limits.c1, b + e * limits.c2, limits.floor())
    # the motion upside down in the mirror: its rise is this one's return
    top = extreme(limits.turn, lambda *state: state[0], 1)
    under = [_falling(limits, way) for way in (1, -1)]
    second = max(under[0] + e * limits.c1, under[1] - e * limits.c2, top)
    floor = FUNCTIONS["sqrt"](max(roller * roller - e * e, Exact(0)))
    first, second = max(first, floor), max(second, floor)
    base = FUNCTIONS["sqrt"](e * e + first * first) - roller
    size = float(base + roller)
    yield from stated.compare("base_radius", answer.base_radius, base, MISSED * size)
    yield from stated.compare("roller_distance", answer.roller_distance, first + second, MISSED * float(first + second))


def _falling(limits: Limits, way: int) -> Any:
    """max(−s′ cot φ₁ + s) for +1, max(s′ cot φ₂ + s) for −1."""
    exact, rough = (limits.c1, limits.f1) if way > 0 else (limits.c2, limits.f2)
    return extreme(
        limits.turn, lambda s, s1, s2: s - s1 * (way * (rough if hasattr(s, "shape") else exact)), 1
    )  # fmt: skip


def _limited(
    answer: Any, turn: Turn, stated: Stated, case: dict[str, Any], limits: tuple[float, float], least: float | None
) -> Iterator[Compared]:  # fmt: skip
    """The base radius at which an exact pressure angle or curvature is at its limit: a secant from the one found."""
    base = Exact(answer.base_radius)
    tree = {**case["follower"], "base_radius": repr(answer.base_radius)}
    if answer.offset is not None:
        tree["offset"] = repr(answer.offset)
    carried = Carried(tree, case.get("rotation", ""))

    def excess(radius: Any) -> Any:
        carried.f["base_radius"] = radius
        carried.restart()
        over = []
        if not carried.flat:
            high, low = (extreme(turn, carried.leaning, sign) for sign in (1, -1))
            over += [high - Exact(limits[0]), -low - Exact(limits[1])]
        if least is not None:
            wanted = Exact(least)
            if carried.flat:
                over.append((wanted - extreme(turn, carried.rounding, -1)) / radius)
            else:
                over.append(extreme(turn, carried.bend, 1) * (wanted + carried.roller) - 1)
        return max(over)

    if answer.base_radius <= 0.0 or abs(at := excess(base)) > 1e-9:
        # something else binds: the limits are kept with room
        return
    step = base * Exact(2) ** -60
    for _ in range(3):
        slope = (excess(base + step) - at) / step
        base -= at / slope
        at = excess(base)
    yield from stated.compare("base_radius", answer.base_radius, base, MISSED * float(base))


def checking(case: dict[str, Any]) -> Iterator[Compared]:
    """`cam check`: extremes, verdicts, what an undercut costs, and the jump."""
    tree = case["follower"]
    given = {key: float(case[key]) for key in (*SPRINGS, *ASKED) if key in case}
    answer = check(
        NOTHING, program=case["program"], follower=follower_of(tree), rotation=Rotation(case.get("rotation", "ccw")),
        flank=Flank(case.get("flank", "inner")), **given,
    )  # fmt: skip
    turn, stated = Turn(case["program"]), Stated(answer)
    carried = Carried(tree, case.get("rotation", ""), case.get("flank", "inner"))
    found = list(shape(answer, turn, carried, stated))
    found += lost(answer, turn, carried, stated)
    if "shaft_speed" in given:
        record = "ArmOnTorsionSpring" if turn.swing else "Slide"
        springs = {key: repr(given[key]) for key in SPRINGS if key in given}
        pressed = Pressed({"record": record, **springs}, 0.0, carried)
        found += jumping(answer, turn, stated, pressed)
    yield from found
    yield from _verdicts(answer, turn, given, {one.name: one.exact for one in found})


def _verdicts(answer: Any, turn: Turn, given: dict[str, float], exact: dict[str, Any]) -> Iterator[Compared]:
    """Yes or no of every limit that the exact value does not meet to rounding, and the joints that jump."""
    limits = {
        "largest_pressure_angle": Exact(given.get("rise_limit", 30.0 * DEGREE)),
        "least_pressure_angle": -Exact(given.get("return_limit", 30.0 * DEGREE)),
        "least_radius": Exact(given.get("least_radius", 0.0)),
        "shaft_speed": Exact(given.get("shaft_speed", 0.0)),
    }
    radii = [exact[name] for name in ("least_convex_radius", "least_concave_radius") if name in exact]
    pairs = [(limits[name] - exact[name]) * sign for name, sign in (("largest_pressure_angle", 1),
             ("least_pressure_angle", -1)) if name in exact]  # fmt: skip
    asked = [
        ("pressure_angle_kept", min(pairs) if len(pairs) == 2 else None),
        ("curvature_kept", min(radii) - limits["least_radius"] if radii else None),
        ("jump_kept", exact["jump_speed"] - limits["shaft_speed"] if "jump_speed" in exact else None),
    ]
    for name, margin in asked:
        value = getattr(answer, name)
        if value is not None and margin is not None and abs(margin) > 1e-9:
            yield Compared(name, float(value), 0.5, Exact(int(margin > 0)), 1.0, False, name)
    for order, name in ((1, "velocity_jumps"), (2, "acceleration_jumps")):
        count = _jumps(turn, order)
        if count is not None:
            yield Compared(name, float(getattr(answer, name)), 0.5, Exact(count), 1.0, False, name)


def _jumps(turn: Turn, order: int) -> int | None:
    """Joints at which a derivative jumps; None where one jumps by so little that it may be rounding."""
    ends = [(zone.at(zone.start, 2)[order], zone.at(zone.end, 2)[order]) for zone in turn.zones]
    peak = max(extreme(turn, lambda *state: state[order], 1), -extreme(turn, lambda *state: state[order], -1))
    steps = [abs(ends[i][0] - ends[i - 1][1]) / peak for i in range(len(ends))]
    if any(1e-14 < step < 1e-6 for step in steps):
        return None
    return sum(step > 1e-7 for step in steps)
