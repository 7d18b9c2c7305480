"""Tasks of `dynamics skid` about time and distance: phases, two parties, sight."""

from dynamics_cli.core.answering.task import Model, Task
from dynamics_cli.skid.commands.marks import POINT


def _stopping(body: str, speed: str) -> "dict[str, str]":
    """Template values of a driver who reacts and brakes to a stop."""
    return {
        f"{body}start_speed": speed,
        f"{body}phases[0].kind": "reaction",
        f"{body}phases[0].duration": "1.2 s",
        f"{body}phases[1].kind": "braking",
        f"{body}phases[1].speed": "0 m/s",
        f"{body}phases[1].friction": "0.7",
    }


def _steady(body: str, speed: str) -> "dict[str, str]":
    """Template values of one who continues at constant speed."""
    return {f"{body}start_speed": speed, f"{body}phases[0].kind": "constant", f"{body}phases[0].duration": "5 s"}


TIMELINE = Task(
    "timeline",
    "Time, distance and speed through reaction, braking and other phases, forward or back.",
    Model(
        "phases of uniform acceleration",
        "dynamics_cli.skid.timing.timeline:timeline",
        source="Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, chapter 3 and section 10.10",
        formula="{start_speed|v₁}² = {end_speed|v₂}² + 2·a·d, t = 2·d/(v₁ + v₂) in every phase",
        assumptions=(POINT, "the deceleration rises linearly during a build-up"),
    ),
    headline=(
        "start_speed: speed at the start",
        "end_speed: speed at the end",
        "duration",
        "distance",
        "phases: phases, counted back from the end | phase, begins, from_distance=distance left, start_speed, "
        "end_speed",
    ),
    scene=_stopping("", "50 km/h"),
    examples=(
        'dynamics skid timeline --end-speed "8 m/s" --phase "reaction, duration=1.2 s" '
        '--phase "build-up, duration=0.2 s" --phase "braking, distance=14 m, friction=0.7"',
        'dynamics skid timeline --start-speed 0km/h --kind accelerating --acceleration "2 m/s^2" --distance "11 m"',
    ),
    table="moments",
    plot="dynamics_cli.skid.timing.pictures:timeline",
)

KINEMATICS = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, chapter 3"

MEET = Task(
    "meet",
    "Two parties before they met: where each was, and what speed would have avoided it.",
    Model(
        "time and distance of two parties",
        "dynamics_cli.skid.timing.meet:meet",
        source=KINEMATICS + "; avoidance by stopping and by arriving later derived",
        formula="{stopping_speed|v_s} = 2·D′/(T + √(T² + 2·D′/a)), D′ = {first_distance|D} + a·t_b²/24, "
        "T = t_r + t_b/2; "
        "{late_speed|v_l} = ({first_distance|D} + ½·a·({clear_time|t_c} − T)² + a·t_b²/24)/{clear_time|t_c}",
        assumptions=(POINT, "before its first phase each party keeps its speed", "the second does not change its path"),
    ),
    headline=(
        "avoidable",
        "hazard_time: hazard began, before the impact",
        "first_distance: first at a distance of",
        "first_speed: first travelling at",
        "sufficient_speed: speed that suffices",
        "stopping_speed: to stop short",
        "late_speed: to arrive when the way is clear",
        "sufficient_deceleration",
        "earlier: reaction too late by",
        "moments: both, counted back from the impact | time_left, first_distance=first, first_speed=speed, "
        "first_phase, second_distance=second",
    ),
    findings=(
        "hazard_time: {second} set out {} before the impact, with {first} {first_distance} away at {first_speed}",
        "avoidable: {first} {could|could not} have avoided the impact",
        "sufficient_speed: it would have been avoided from {} or less",
    ),
    chances={"avoidable": "speed_margin"},
    scene={**_stopping("first.", "50 km/h"), **_steady("second.", "1.4 m/s")},
    examples=(
        'dynamics skid meet --first-end-speed "8 m/s" --first-phase "reaction, duration=1.2 s" '
        '--first-phase "build-up, duration=0.2 s" --first-phase "braking, distance=14 m, friction=0.7" '
        '--second-kind constant --second-distance "4.6 m" --second-end-speed "1.4 m/s" --clear-distance "1.9 m"',
    ),
    table="moments",
    arrays=False,
    branches=True,
    plot="dynamics_cli.skid.timing.pictures:meet",
)

FOLLOW = Task(
    "follow",
    "When and how fast a vehicle runs into the one before it, or how near it comes.",
    Model(
        "time and distance in one lane",
        "dynamics_cli.skid.timing.follow:follow",
        source=KINEMATICS,
        formula="gap + s_leader({contact_time|t}) = s_follower({contact_time|t})",
        assumptions=(POINT, "both in one lane", "after its last phase each vehicle keeps its speed"),
        method="roots of polynomials, all found between those of their derivatives",
    ),
    headline=(
        "contact",
        "contact_time: contact after",
        "closing_speed",
        "leader_speed: leader travelling at",
        "follower_speed: follower travelling at",
        "follower_distance: follower has travelled",
        "least_gap",
        "least_gap_time: nearest after",
        "sufficient_gap: gap that suffices",
        "moments: moments | time, gap, leader_speed, follower_speed",
    ),
    findings=(
        "contact: {the follower ran|the follower did not run} into the leader",
        "contact_time: the contact came after {}, at a closing speed of {closing_speed}",
        "least_gap: the smallest gap was {}, after {least_gap_time}",
    ),
    chances={"contact": "missing_gap"},
    scene={**_stopping("leader.", "70 km/h"), **_stopping("follower.", "72 km/h"), "gap": "25 m"},
    examples=(
        'dynamics skid follow --gap "25 m" --leader-start-speed "20 m/s" --leader-kind braking --leader-speed 0m/s '
        '--leader-acceleration "7 m/s^2" --follower-start-speed "20.5 m/s" '
        '--follower-phase "reaction, duration=1.1 s" '
        '--follower-phase "braking, speed=0 m/s, acceleration=6.5 m/s^2"',
    ),
    table="moments",
    arrays=False,
    cost=3e-4,
    plot="dynamics_cli.skid.timing.pictures:follow",
)

SIGHT = Task(
    "sight",
    "When two parties on crossing paths could see each other past an obstruction, or at night.",
    Model(
        "line of sight past a corner",
        "dynamics_cli.skid.timing.sight:sight",
        source=KINEMATICS + "; plane geometry of the line of sight",
        formula="(C − E) × (Q − E) = 0 or |Q − E| = {recognition_distance|R} at {time_left|t} before the impact",
        assumptions=(
            "eye E, target Q and corner C are points in a plan view",
            "the obstruction fills everything behind its corner",
        ),
        method="roots of polynomials, all found between those of their derivatives",
    ),
    headline=(
        "time_left: in sight, before the impact",
        "first_distance: first at a distance of",
        "first_speed: first then at",
        "second_distance: second then away",
        "second_speed: second then at",
        "sight_line: line of sight",
        "by: opened by",
        "changes: openings and closings",
    ),
    findings=(
        "time_left: {second} came into sight {} before the impact, with {first} {first_distance} from it at "
        "{first_speed}",
    ),
    scene={
        **_steady("first.", "13 m/s"),
        **_steady("second.", "1.5 m/s"),
        "corner_before": "6 m",
        "corner_aside": "1.8 m",
    },
    examples=(
        'dynamics skid sight --first-kind constant --first-duration "5 s" --first-end-speed "13 m/s" '
        '--second-kind constant --second-duration "5 s" --second-end-speed "1.5 m/s" --corner-before "6 m" '
        '--corner-aside "1.8 m" --eye-behind "2 m"',
        'dynamics skid sight --first-kind constant --first-duration "5 s" --first-end-speed "80 km/h" '
        '--second-kind constant --second-duration "5 s" --second-end-speed "1.5 m/s" --eye-behind "2 m" '
        '--recognition-distance "35 m"',
    ),
    table="changes",
    arrays=False,
    plot="dynamics_cli.skid.timing.pictures:sight",
)

RECORD = Task(
    "record",
    "What the speeds of an event data recorder say of the way, the braking and the event.",
    Model(
        "trapezoids between samples",
        "dynamics_cli.skid.timing.recorder:record_of",
        source="49 CFR 563.8, table III (tolerances); Josephs & Huston, chapter 3",
        formula="{distance|s} = Σ (vᵢ + vᵢ₊₁)·Δt/2, {least_event_speed|v} = vₙ − d·δ",
        assumptions=(
            "wheel speeds are the vehicle's, but for the slip given",
            "tolerance and resolution are limits: uniform, the first common to all samples",
        ),
    ),
    headline=(
        "least_event_speed: speed at the event, from",
        "greatest_event_speed: speed at the event, to",
        "distance: distance of the record",
        "distance_deviation: its standard deviation",
        "least_distance",
        "greatest_distance",
        "greatest_deceleration",
        "greatest_drag_factor: as a drag factor",
        "brake_earliest: earliest braking, before the event",
        "brake_latest: latest braking, before the event",
        "speed_before_braking",
        "intervals: samples | time_left, speed, distance_left, acceleration, drag_factor",
    ),
    findings=(
        "least_event_speed: the speed at the event lay between {} and {greatest_event_speed}",
        "brake_latest: braking began between {} and {brake_earliest} before the event",
        "speed_before_braking: the speed before braking",
    ),
    examples=(
        'dynamics skid record --speeds "78,78,78,78,77,76,74,66,54,41,29 km/h" --interval "0.5 s" --brake-on 8',
        'dynamics skid record --speeds "78,78,78,78,77,76,74,66,54,41,29 km/h" --greatest-acceleration "9 m/s^2" '
        '--least-slip "8 %" --greatest-slip "18 %"',
    ),
    table="intervals",
    arrays=False,
    plot="dynamics_cli.skid.timing.pictures:record",
)

TASKS = (TIMELINE, MEET, FOLLOW, SIGHT, RECORD)
