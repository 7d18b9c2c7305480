"""What is drawn of a crash seen from above: lanes, marks, vehicles, velocities, and what is uncertain of them."""

import math

from dynamics_cli.impact.conventions import direction_of
from dynamics_cli.impact.crash.scene import LENGTH, WIDTH, named
from dynamics_cli.impact.crash.spinning import swept
from dynamics_cli.impact.scene_labels import Words
from dynamics_cli.impact.scene_pictures import about, apart, lane
from dynamics_cli.impact.uncertain_shapes import at_place, at_tip, fan
from dynamics_cli.impact.vehicle_outlines import NARROW, outline
from dynamics_cli.pictures import Arrow, Curve

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.pictures import Spreads

    Pair = tuple[float, float]

SIDES = ("first", "second")
# What the fastest arrow takes beside the longest way of the scene.
ARROW_SHARE = 0.25
# Half the width between the tracks of a car, beside its width.
TRACK = 0.4
# How far an arrow stands beside a vehicle, in its widths.
ABEAM = 0.8
# Half the size of the cross at the point of impact, in metres.
CROSS = 0.6
BLACK = 6


class Drawn:
    """Items and words of both vehicles; the page's zero is where they touch, or the point of impact in the scene."""

    def __init__(self, result: "Any", scene: "Any", gravity: float, spreads: "Spreads | None") -> None:
        self.scene = scene
        self.spreads = spreads
        self.given = (scene.first, scene.second)
        self.axes = scene.axes
        self.flip = -1.0 if scene.axes == "sae" else 1.0
        self.courses = (result.first, result.second)
        self.names = [named(one, side) for one, side in zip(self.given, SIDES, strict=True)]
        self.ways = [self.way(course.approach_heading) for course in self.courses]
        self.noses = [
            way if one.nose is None else self.way(one.nose) for way, one in zip(self.ways, self.given, strict=True)
        ]
        sizes = [(one.length, one.width) for one in self.given]
        self.centres = apart(self.noses[0], self.noses[1], (sizes[0], sizes[1]))
        reach = [(0.0 if c.start is None else c.start.distance) + (c.slide_distance or 0.0) for c in self.courses]
        self.fastest = max(speed for c in self.courses for speed in (c.approach_speed, c.exit_speed)) or 1.0
        self.scale = max(ARROW_SHARE * max(reach), 1.3 * LENGTH) / self.fastest
        self.words: list[Words] = []
        self.swept = [
            self._swept(role, gravity) if one.slide is not None else None for role, one in enumerate(self.given)
        ]
        self.neutral = any(one.length == LENGTH and one.width == WIDTH for one in self.given)

    def way(self, heading: float) -> "Pair":
        """A direction as seen from above on the page; the y axis of sae points down."""
        x, y = direction_of(heading, self.axes)
        return x, self.flip * y

    def velocities(self) -> "tuple[list[Pair], list[Pair]]":
        """Velocities of both before and after, on the page."""
        before = [_times(c.approach_speed, way) for c, way in zip(self.courses, self.ways, strict=True)]
        return before, [_times(c.exit_speed, self.way(c.exit_heading)) for c in self.courses]

    def items(self) -> "list[Any]":
        """Ground and what is uncertain beneath, then marks, outlines, arrows."""
        roles = (0, 1)
        parts = (self._lane, self._uncertain, self._marks, self._outlines, self._arrows)
        return [*(item for part in parts for role in roles for item in part(role)), *self._impact()]

    def _swept(self, role: int, gravity: float) -> "tuple[list[tuple[float, float, Pair]], list[Any]]":
        """Places and directions of the nose along a slide with spin, and the marks of its wheels.

        The slide begins at the mass centre and ends at the rest position, which counts from the point of impact: what
        lies between them is spread along it.
        """
        way, marks = swept(self.scene, SIDES[role], self.courses[role], gravity)
        centre, last = self.centres[role], way[-1]
        length = math.hypot(last[0], last[1]) or 1.0

        def place(x: float, y: float) -> "Pair":
            left = max(0.0, 1.0 - math.hypot(x, y) / length)
            return x + left * centre[0], self.flip * y + left * centre[1]

        path = [(*place(x, y), (math.cos(nose), self.flip * math.sin(nose))) for x, y, nose in way]
        lines = [[place(x, y) for x, y in mark] for mark in marks]
        return path, [Curve([x for x, _ in line], [y for _, y in line], "", "track", BLACK) for line in lines]

    def ended(self, role: int) -> "tuple[Pair, Pair]":
        """Where a vehicle ends on the page, and where its nose points: a measured rest where it was measured."""
        way, given, facing = self.swept[role], self.given[role], self._after(role)
        if way is not None:
            return (way[0][-1][0], way[0][-1][1]), way[0][-1][2]
        if given.rest is not None:
            point = self.scene.impact.point
            return (given.rest[0] - point[0], self.flip * (given.rest[1] - point[1])), facing
        return self._shifted(role, facing, self.courses[role].slide_distance), facing

    def _lane(self, role: int) -> "list[Any]":
        course = self.courses[role]
        start = 0.0 if course.start is None else course.start.distance
        ahead = max((c.slide_distance or 0.0) for c in self.courses)
        reach = max(start, self.scale * course.approach_speed) + LENGTH, 0.7 * ahead + LENGTH
        return [lane(self.centres[role], self.ways[role], reach)]

    def _uncertain(self, role: int) -> "list[Any]":
        """Fans of headings before and after, the ellipse of the rest position, or of the velocity without one."""
        spreads, side, course, centre = self.spreads, SIDES[role], self.courses[role], self.centres[role]
        if spreads is None:
            return []
        reach = self.scale * course.approach_speed + self.given[role].length
        back = fan(spreads, f"{side}.approach_heading", centre, -reach, self.way, role)
        arrow = _times(self.scale * course.exit_speed, self._after(role))
        length = math.hypot(*arrow)
        if course.slide_distance:
            end, _ = self.ended(role)
            rest = at_place(spreads, f"{side}.rest_position", end, self.flip, role)
            if self.given[role].rest is not None and self.swept[role] is None:
                # the heading follows from where it came to rest
                return [*back, *rest]
            if self.swept[role] is None:
                length = math.dist(centre, end)
        else:
            tip = centre[0] + arrow[0], centre[1] + arrow[1]
            sense = -1.0 if self.axes in ("compass", "sae") else 1.0
            rest = at_tip(spreads, side, tip, arrow, self.scale, sense, role)
        return [*back, *fan(spreads, f"{side}.exit_heading", centre, length, self.way, role), *rest]

    def _after(self, role: int) -> "Pair":
        return self.way(self.courses[role].exit_heading)

    def _shifted(self, role: int, way: "Pair", distance: float) -> "Pair":
        centre = self.centres[role]
        return centre[0] + distance * way[0], centre[1] + distance * way[1]

    def _marks(self, role: int) -> "list[Any]":
        """The wheel tracks of the braking before; marks of the wheels and the path of the mass centre after."""
        course, way = self.courses[role], self.ways[role]
        items: list[Any] = []
        if course.start is not None and course.start.braking_distance:
            aside = TRACK * self.given[role].width
            begin = self._shifted(role, way, -course.start.braking_distance)
            end = self.centres[role]
            for side in (aside, -aside) if self.given[role].width >= NARROW else (0.0,):
                x = [point[0] - side * way[1] for point in (begin, end)]
                y = [point[1] + side * way[0] for point in (begin, end)]
                items.append(Curve(x, y, "", "track", BLACK))
        if course.slide_distance:
            begin, (end, _) = self.centres[role], self.ended(role)
            path, marks = self.swept[role] or ([(*begin, begin), (*end, end)], [])
            items += [*marks, Curve([one[0] for one in path], [one[1] for one in path], "", "dotted", role)]
        return items

    def _outlines(self, role: int) -> "list[Any]":
        course, given, nose = self.courses[role], self.given[role], self.noses[role]
        size = {"length": given.length, "width": given.width}
        items = outline(self.centres[role], nose, role, **size)
        if course.start is not None:
            at = self._shifted(role, self.ways[role], -course.start.distance)
            items += outline(at, self.ways[role], role, **size)
            back = at[0] - 0.5 * given.length * self.ways[role][0], at[1] - 0.5 * given.length * self.ways[role][1]
            away = -self.ways[role][0], -self.ways[role][1]
            self.words.append(Words(back, away, about(f"{self.names[role]} at its start", course.start.speed), role))
        if course.slide_distance:
            at, facing = self.ended(role)
            items += outline(at, facing, role, **size)
            for x, y, nose in (self.swept[role] or ((), ()))[0][15:-1:15]:
                body = outline((x, y), nose, role, **size)
                items += [Curve(one.x, one.y, "", "outline", role) for one in (body[0], body[2])]
            ahead = self._after(role)
            front = at[0] + 0.5 * given.length * ahead[0], at[1] + 0.5 * given.length * ahead[1]
            self.words.append(Words(front, ahead, f"{self.names[role]} at rest", role))
        return items

    def _arrows(self, role: int) -> "list[Any]":
        """Velocities before, dashed, and after, from the mass centre, on one scale."""
        course, given = self.courses[role], self.given[role]
        way, after, centre = self.ways[role], self._after(role), self.centres[role]
        items: list[Any] = []
        before, gone = _times(self.scale * course.approach_speed, way), _times(self.scale * course.exit_speed, after)
        if course.approach_speed > 0.0:
            # beside the vehicle, clear of its marks and of where it began, on the side that it does not turn to
            turn = way[0] * after[1] - way[1] * after[0]
            side = -math.copysign(ABEAM * given.width, turn)
            tail = centre[0] - before[0] - side * way[1], centre[1] - before[1] + side * way[0]
            items.append(Arrow(*tail, *before, "", role, dashed=True))
            middle = tail[0] + 0.5 * before[0], tail[1] + 0.5 * before[1]
            text = about(f"{self.names[role]} before", course.approach_speed)
            self.words.append(Words(middle, (-side * way[1], side * way[0]), text, role))
        if course.exit_speed > 0.0:
            items.append(Arrow(*centre, *gone, "", role))
            tip = centre[0] + gone[0], centre[1] + gone[1]
            text = about(f"{self.names[role]} after", course.exit_speed)
            self.words.append(Words(tip, (after[1], -after[0]), text, role))
        return items

    def _impact(self) -> "list[Any]":
        """A cross where they touch, with the ellipse of the point of impact."""
        spreads = self.spreads
        items = [] if spreads is None else at_place(spreads, "impact.point", (0.0, 0.0), self.flip, BLACK)
        ends = [-CROSS, CROSS]
        self.words.append(Words((0.0, 0.0), (1.0, 0.3), "impact", BLACK))
        return [*items, Curve(ends, ends, "", "solid", BLACK), Curve(ends, ends[::-1], "", "solid", BLACK)]


def _times(length: float, way: "Pair") -> "Pair":
    return length * way[0], length * way[1]
