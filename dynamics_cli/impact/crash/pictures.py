"""The scene of a crash to scale: outlines at the start, at the impact and at rest, marks, velocities on one scale."""

import math

from dynamics_cli.impact.conventions import direction_of
from dynamics_cli.impact.crash.scene import LENGTH, WIDTH, named
from dynamics_cli.impact.crash.spinning import swept
from dynamics_cli.impact.scene_labels import Words
from dynamics_cli.impact.scene_pictures import about, apart, finished, lane, outline
from dynamics_cli.pictures import Arrow, Curve, Mark, Picture
from dynamics_cli.quantities import STANDARD_GRAVITY

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Pair = tuple[float, float]

# What the fastest arrow takes beside the longest way of the scene.
ARROW_SHARE = 0.25
# Half the width between the tracks of a car, beside its width.
TRACK = 0.4
# How far an arrow stands beside a vehicle, in its widths.
ABEAM = 0.8
# Inches of the picture.
WIDE, HIGH = 7.2, 4.6


def crash(result: "Any", scene: "Any", *, gravity: float = STANDARD_GRAVITY, **_: "Any") -> Picture:
    """Both vehicles through the crash, seen from above."""
    drawn = _Scene(result, scene, gravity)
    north = (0.0, 1.0) if scene.axes == "compass" else None
    size = "outlines of common size where none is given" if drawn.neutral else "outlines as given"
    note = f"{size}; lanes 3.5 m wide along the approach headings"
    items = drawn.items()
    panel = finished(items, drawn.words, (WIDE, HIGH), (drawn.scale, drawn.fastest), north, note)
    title = f"{drawn.names[0]} and {drawn.names[1]}: the crash to scale"
    subtitle = "start, impact and rest; velocities before dashed, after solid, one scale for all"
    return Picture((panel,), title, width=WIDE, scene=True, subtitle=subtitle)


class _Scene:
    """What is drawn of both vehicles."""

    def __init__(self, result: "Any", scene: "Any", gravity: float) -> None:
        self.given = (scene.first, scene.second)
        self.axes = scene.axes
        self.courses = (result.first, result.second)
        self.names = [named(one, side) for one, side in zip(self.given, ("first", "second"), strict=True)]
        self.ways = [self._way(course.approach_heading) for course in self.courses]
        self.noses = [
            way if one.nose is None else self._way(one.nose) for way, one in zip(self.ways, self.given, strict=True)
        ]
        self.centres = apart(self.noses[0], self.noses[1])
        reach = [(0.0 if c.start is None else c.start.distance) + (c.slide_distance or 0.0) for c in self.courses]
        speeds = [speed for c in self.courses for speed in (c.approach_speed, c.exit_speed)]
        self.fastest = max(speeds) or 1.0
        self.scale = max(ARROW_SHARE * max(reach), 1.3 * LENGTH) / self.fastest
        self.words: list[Words] = []
        self.swept = [
            self._swept(scene, role, gravity) if one.slide is not None else None for role, one in enumerate(self.given)
        ]
        self.neutral = any(one.length == LENGTH and one.width == WIDTH for one in self.given)

    def _way(self, heading: float) -> "Pair":
        """A direction as seen from above on the page; the y axis of sae points down."""
        x, y = direction_of(heading, self.axes)
        return (x, -y) if self.axes == "sae" else (x, y)

    def _swept(self, scene: "Any", role: int, gravity: float) -> "list[tuple[float, float, Pair]]":
        """Places on the page and directions of the nose along a slide with spin."""
        flip, centre = -1.0 if self.axes == "sae" else 1.0, self.centres[role]
        return [
            (centre[0] + x, centre[1] + flip * y, (math.cos(nose), flip * math.sin(nose)))
            for x, y, nose in swept(scene, ("first", "second")[role], self.courses[role], gravity)
        ]

    def _ended(self, role: int) -> "tuple[Pair, Pair]":
        """Where a vehicle ends on the page, and where its nose points."""
        way = self.swept[role]
        if way is not None:
            return (way[-1][0], way[-1][1]), way[-1][2]
        return self._shifted(role, self._after(role), self.courses[role].slide_distance), self._after(role)

    def items(self) -> "list[Any]":
        """Marks beneath, then outlines, then arrows."""
        roles = (0, 1)
        return [
            *(self._lane(role) for role in roles),
            *(item for role in roles for item in self._marks(role)),
            *(item for role in roles for item in self._outlines(role)),
            *(item for role in roles for item in self._arrows(role)),
            Mark(0.0, 0.0, "", role=6),
        ]

    def _lane(self, role: int) -> Curve:
        course = self.courses[role]
        start = 0.0 if course.start is None else course.start.distance
        ahead = max((c.slide_distance or 0.0) for c in self.courses)
        return lane(self.centres[role], self.ways[role], (max(start, self.scale * course.approach_speed) + LENGTH,
                                                          0.7 * ahead + LENGTH))  # fmt: skip

    def _after(self, role: int) -> "Pair":
        return self._way(self.courses[role].exit_heading)

    def _shifted(self, role: int, way: "Pair", distance: float) -> "Pair":
        centre = self.centres[role]
        return centre[0] + distance * way[0], centre[1] + distance * way[1]

    def _marks(self, role: int) -> "list[Any]":
        """Two wheel tracks of the braking before, and the path of the mass centre after."""
        course, way = self.courses[role], self.ways[role]
        items: list[Any] = []
        if course.start is not None and course.start.braking_distance:
            aside = TRACK * self.given[role].width
            begin = self._shifted(role, way, -course.start.braking_distance)
            end = self.centres[role]
            for side in (aside, -aside):
                x = [point[0] - side * way[1] for point in (begin, end)]
                y = [point[1] + side * way[0] for point in (begin, end)]
                items.append(Curve(x, y, "", "track", 6))
        if course.slide_distance:
            begin, (end, _) = self.centres[role], self._ended(role)
            path = self.swept[role] or [(*begin, begin), (*end, end)]
            items.append(Curve([one[0] for one in path], [one[1] for one in path], "", "dotted", role))
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
            self.words.append(Words(back, away, f"{self.names[role]} at its start\n{about(course.start.speed)}", role))
        if course.slide_distance:
            at, facing = self._ended(role)
            items += outline(at, facing, role, **size)
            for x, y, nose in (self.swept[role] or ())[15:-1:15]:
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
        arriving, leaving = self.scale * course.approach_speed, self.scale * course.exit_speed
        before = arriving * way[0], arriving * way[1]
        gone = leaving * after[0], leaving * after[1]
        if course.approach_speed > 0.0:
            # beside the vehicle, clear of its marks and of where it began, on the side that it does not turn to
            turn = way[0] * after[1] - way[1] * after[0]
            side = -math.copysign(ABEAM * given.width, turn)
            tail = centre[0] - before[0] - side * way[1], centre[1] - before[1] + side * way[0]
            items.append(Arrow(*tail, *before, "", role, dashed=True))
            middle = tail[0] + 0.5 * before[0], tail[1] + 0.5 * before[1]
            text = f"{self.names[role]} before\n{about(course.approach_speed)}"
            self.words.append(Words(middle, (-side * way[1], side * way[0]), text, role))
        if course.exit_speed > 0.0:
            items.append(Arrow(*centre, *gone, "", role))
            tip = centre[0] + gone[0], centre[1] + gone[1]
            text = f"{self.names[role]} after\n{about(course.exit_speed)}"
            self.words.append(Words(tip, (after[1], -after[0]), text, role))
        return items
