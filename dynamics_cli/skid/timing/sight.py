"""Sight past an obstruction or at night: when two parties on crossing paths could first see each other."""

from dynamics_cli.errors import require, require_given
from dynamics_cli.numerics.elementary import cos, hypot, sin
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    Annotated,
    Coordinate,
    Distance,
    Gravity,
    Length,
    RoadSpeed,
    Text,
    Time,
)
from dynamics_cli.records import Advice, record
from dynamics_cli.skid.timing.courses import Course, changes
from dynamics_cli.skid.timing.hidden import Obstruction, Wall, both, openings, past_corner, within
from dynamics_cli.skid.timing.meet import Party, course_to_impact, motion_of
from dynamics_cli.skid.timing.timeline import summed

RIGHT_ANGLE = 1.5707963267948966
AT_IMPACT = 1e-9


@record
class SightChange:
    """The sight opens or closes."""

    change: Annotated[str, "Whether the sight opens or closes."]
    time_left: Annotated[Time, "Time left to the impact [s]."]
    first_distance: Annotated[Distance, "How far the first is from the impact [m]."]
    first_speed: Annotated[RoadSpeed, "Speed of the first [m/s]."]
    second_distance: Annotated[Distance, "How far the second is from the impact [m]."]
    second_speed: Annotated[RoadSpeed, "Speed of the second [m/s]."]


@record
class Sight:
    """When the second came into the first's sight for the last time before the impact."""

    time_left: Annotated[Time, "Time left to the impact when the sight opens, or as far back as the phases go [s]."]
    first_distance: Annotated[Distance, "How far the first then is from the impact [m]."]
    first_speed: Annotated[RoadSpeed, "Speed of the first then [m/s]."]
    second_distance: Annotated[Distance, "How far the second then is from the impact [m]."]
    second_speed: Annotated[RoadSpeed, "Speed of the second then [m/s]."]
    sight_line: Annotated[Length, "Distance between eye and target then [m]."]
    by: Annotated[Text | None, "What opened it: the corner or the distance of recognition; none where it was open."]
    changes: Annotated[tuple[SightChange, ...], "Every opening and closing, in order of time."]
    advice: tuple[Advice, ...] = ()


def sight(
    *,
    first: Annotated[Party, "The party that looks; its phases up to the impact."],
    second: Annotated[Party, "The party looked for; its phases up to the impact."],
    corner_before: Annotated[
        Coordinate | None,
        "How far before the impact the corner of the obstruction is, along the way of the first, e.g. 6 m [m].",
    ] = None,
    corner_aside: Annotated[
        Length | None, "How far it stands aside from the way of the first, on the second's side, e.g. 1.8 m [m]."
    ] = None,
    recognition_distance: Annotated[
        Distance | None,
        "At night: distance from the eye at which the second is recognized, as a test at the scene showed, e.g. 35 m "
        "[m].",
    ] = None,
    eye_behind: Annotated[Length, "How far the eye is behind the front that meets the second, e.g. 2 m [m]."] = 0.0,
    crossing: Annotated[
        Angle, "Angle between the directions of travel: 90 deg for a crossing, 180 deg head on, e.g. 70 deg [rad]."
    ] = RIGHT_ANGLE,
    obstruction: Annotated[
        Obstruction | None, "How the obstruction moves; its corner is then where it is at the moment of the impact."
    ] = None,
    obstruction_length: Annotated[
        Distance | None, "Length of the obstruction back from its corner; without end unless given, e.g. 12 m [m]."
    ] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Sight:
    """When two parties on crossing paths could see each other past the corner of an obstruction, or at night.

    Equation
    --------
    (C − E) × (Q − E) = 0 with eye E, target Q and corner C: quadratic in the time for steady speeds, a polynomial for
    every pair of phases otherwise. All its roots are examined; the answer is the last opening before the impact. At
    night |Q − E| must be no more than the distance of recognition besides.

    Returns
    -------
    Sight
        Time, distances and speeds when the sight opens for the last time, and every change before.

    Raises
    ------
    InadmissibleError
        When neither a corner nor a distance of recognition is given, the corner is not aside, or the angle is not
        within 0 and 180 degrees; when the second would not be recognized before the impact.

    Notes
    -----
    A plan view: points, and an obstruction that fills everything behind its corner, or a line of some length back from
    it, along its own direction of travel. All are looked at as far back as the longer of the two timelines; before its
    first phase each keeps its speed.

    References
    ----------
    Plane geometry of lines of sight, derived; Josephs & Huston, Dynamics of Mechanical Systems, chapter 3.

    Examples
    --------
    >>> from dynamics_cli.numerics.road.phases import Kind, Phase
    >>> from dynamics_cli.skid.timing.timeline import EndSpeed
    >>> car = Party(Phase(Kind("constant"), duration=5.0), EndSpeed(13.0))
    >>> walker = Party(Phase(Kind("constant"), duration=5.0), EndSpeed(1.5))
    >>> result = sight(first=car, second=walker, corner_before=6.0, corner_aside=1.8, eye_behind=2.0)
    >>> round(result.time_left, 6)
    1.621544
    """
    corner = _corner(corner_before, corner_aside, recognition_distance)
    require(
        (crossing > 0.0) & (crossing < 2.0 * RIGHT_ANGLE), "ways at an angle of {crossing} do not cross",
        code="no-crossing", crossing=(crossing, Angle),
    )  # fmt: skip
    across, along = sin(crossing), cos(crossing)
    mover = None if obstruction is None else course_to_impact(motion_of(obstruction, gravity, "the obstruction"))
    motions = [motion_of(one, gravity, whose) for one, whose in ((first, "the first"), (second, "the second"))]
    first_course, second_course = (course_to_impact(motion) for motion in motions)

    start = max((summed(motion)[0].begins for motion in motions), key=plain)
    if corner is None:
        past: list[tuple[float, bool]] = []
    elif obstruction is None and obstruction_length is None:
        past = changes(first_course, second_course, past_corner(*corner, eye_behind, crossing), -plain(start), 0.0)
    else:
        heading = 0.0 if obstruction is None else obstruction.heading
        wall = Wall(*corner, heading, obstruction_length, crossing)
        past = openings(wall, first_course, second_course, mover, eye_behind, -plain(start))
    near: list[tuple[float, bool]] = []
    if recognition_distance is not None:
        _require_recognition(recognition_distance, eye_behind)
        near = changes(
            first_course, second_course, within(recognition_distance, eye_behind, crossing), -plain(start), 0.0
        )
    # the meeting of eye and target at the impact is not an opening
    times, opened_by = both([one for one in past if plain(one[0]) < -AT_IMPACT], near)
    rows = tuple(_change(time, opens, first_course, second_course) for time, opens in times)
    opening = next((time for time, opens in reversed(times) if opens), None)
    advice: tuple[Advice, ...] = ()
    if opening is None:
        advice = _unhidden(rows)
        opening = -start
    row = _change(opening, True, first_course, second_course)
    eye, target_place = row.first_distance + eye_behind, row.second_distance
    return Sight(
        time_left=row.time_left,
        first_distance=row.first_distance,
        first_speed=row.first_speed,
        second_distance=row.second_distance,
        second_speed=row.second_speed,
        sight_line=hypot(eye - along * target_place, across * target_place),
        by=opened_by,
        changes=rows,
        advice=advice,
    )


def _corner(before: "float | None", aside: "float | None", recognition: "float | None") -> "tuple[float, float] | None":
    """The place of the corner, if there is one."""
    require_given(
        before is not None or aside is not None or recognition is not None,
        "neither a corner that hides nor a distance of recognition is given", ("corner_before", "corner_aside"),
        ("recognition_distance",),
    )  # fmt: skip
    require_given((before is None) == (aside is None), "the corner needs both its places",
                  ("corner_before",) if before is None else ("corner_aside",))  # fmt: skip
    if before is None or aside is None:
        return None
    require(
        aside > 0.0, "a corner {aside} beside the way of the first hides nothing of the other way", code="no-corner",
        hint="measure corner-aside from the way of the first towards the second; it is positive", aside=(aside, Length),
    )  # fmt: skip
    return before, aside


def _require_recognition(distance: float, eye_behind: float) -> None:
    require(
        distance > eye_behind, "the second would be recognized within {distance}, less than the eye's {behind} behind "
        "the front: only after the impact", code="never-shows", distance=(distance, Distance),
        behind=(eye_behind, Length), hint="check the distance of recognition and its unit",
    )  # fmt: skip


def _unhidden(rows: "tuple[SightChange, ...]") -> "tuple[Advice, ...]":
    """No opening within the phases: nothing hid the second as far back as they go."""
    require(
        not rows, "the corner hides the second at the impact itself", code="never-shows",
        hint="look at the corner's place: it lies on the way between the two",
    )  # fmt: skip
    message = "the second is in sight from the start of the phases"
    remedy = "give longer phases to look farther back"
    return (Advice(code="always-in-sight", message=message, severity="note", remedy=remedy),)


def _change(time: float, opens: bool, first_course: Course, second_course: Course) -> SightChange:
    (first_place, fast, _), (second_place, swift, _) = first_course.at(time), second_course.at(time)
    return SightChange("opens" if opens else "closes", -time, -first_place, fast, -second_place, swift)
