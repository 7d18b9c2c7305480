"""The tasks of `dynamics force`."""

from dynamics_cli.core.answering.task import Family, Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, "
TYPED = "numbers are exact as typed; directions by an angle to 15 digits"
METHOD = "exact sums"
PICTURES = "dynamics_cli.force.pictures"

RESULTANT = Task(
    "resultant",
    "Resultant of forces and couples: class, line of action, wrench.",
    Model(
        "central axis",
        "dynamics_cli.force.resultant:resultant",
        source=BOOK + "sections 6.2 to 6.6",
        formula="R = Σ F, M = Σ (r − Q)×F + Σ C, {pitch|p} = R·M/R², axis through Q + R×M/R²",
        assumptions=("forces act on one rigid body", TYPED),
        method=METHOD,
    ),
    headline=(
        "system", "arrangement: forces are", "force: resultant R", "magnitude: magnitude |R|", "angle: angle from x",
        "moment: moment M", "axis_point: axis through", "direction: along", "crosses_x: crosses the x-axis at",
        "crosses_y: crosses the y-axis at", "pitch: pitch p", "wrench_moment: moment of the wrench",
    ),
    examples=(
        'dynamics force resultant --load "force=0, -500 N, at=2, 0 m" --load "force=300 N @ 30 deg, at=4, 1 m"',
        'dynamics force resultant --load "force=10, -4, 3 N, at=1, 2, -1 m" '
        '--load "force=-6, 8, 2 N, at=-2, 0.5, 3 m" --couple "moment=2, -3, 0.5 N*m"',
    ),
    arrays=False,
    tracked=False,
    plot=f"{PICTURES}:resultant",
)  # fmt: skip

MOMENT = Task(
    "moment",
    "Moment of a force about a point and about a line, with its lever.",
    Model(
        "vector product",
        "dynamics_cli.force.moment:moment",
        source=BOOK + "section 6.3",
        formula="M = (r − Q)×F, {lever|h} = |M|/|F|, {about_line|M_n} = M·n/|n|",
        assumptions=(TYPED,),
        method=METHOD,
    ),
    headline=(
        "moment: moment M", "magnitude: magnitude |M|", "lever", "foot: foot on the line of action",
        "about_line: moment about the line", "line_lever: distance of the lines",
    ),
    examples=(
        'dynamics force moment --force "200 N @ -60 deg" --at "0.3, 0.1 m"',
        'dynamics force moment --force "10, -4, 30 lbf" --at "6, 2, 0 in" --axis "0, 1, 0" --units us',
    ),
    arrays=False,
    tracked=False,
    plot=f"{PICTURES}:moment",
)  # fmt: skip

EQUIVALENT = Task(
    "equivalent",
    "The same system as force and couple elsewhere, wrench, or two forces.",
    Model(
        "equivalent systems",
        "dynamics_cli.force.equivalent:equivalent",
        source=BOOK + "sections 6.5 and 6.6",
        formula="R = Σ F, M_Q = M_O − Q×R",
        assumptions=("forces act on one rigid body", TYPED),
        method=METHOD,
    ),
    headline=(
        "form: equivalent to", "force: force", "at", "couple", "second_force: second force", "second_at: at",
        "pitch: pitch p", "wrench_moment: moment of the wrench",
    ),
    examples=(
        'dynamics force equivalent --load "force=0, -500 N, at=2, 0 m" --about "0.5, 0 m"',
        'dynamics force equivalent --load "force=10, -4, 3 N, at=1, 2, -1 m" --couple "moment=2, -3, 0.5 N*m" '
        "--form two-forces",
    ),
    arrays=False,
    tracked=False,
)  # fmt: skip

EQUILIBRIUM = Task(
    "equilibrium",
    "Reactions of pins, rollers, cables and other supports of a rigid body.",
    Model(
        "equations of equilibrium",
        "dynamics_cli.force.equilibrium:equilibrium",
        source=BOOK + "section 6.5",
        formula="Σ F = 0, Σ M = 0",
        assumptions=("one rigid body at rest", "supports without friction, rigid", TYPED),
        method="exact elimination",
    ),
    headline=("verdict", "reactions: reactions on the body | name, type, force, size, angle, moment, sense"),
    examples=(
        'dynamics force equilibrium --load "force=0, -1000 N, at=2, 0 m" --load "force=300, 0 N, at=4, 1 m" '
        '--support "type=pin, at=0, 0 m" --support "type=roller, at=5, 0 m, direction=1 @ 120 deg"',
        'dynamics force equilibrium --force "0, -500 lbf" --at "8, 0 ft" --support "type=fixed, at=0, 0 ft" --units us',
    ),
    table="reactions",
    arrays=False,
    tracked=False,
    plot=f"{PICTURES}:equilibrium",
)  # fmt: skip

FAMILIES = {
    "force": Family(
        "force", "Forces: resultants, moments, reactions of supports, springs.", RESULTANT, MOMENT, EQUIVALENT, EQUILIBRIUM
    )
}
