"""Tasks of `dynamics skid` beside marks and timing: rollovers, swerves, published ranges."""

from dynamics_cli.core.answering.task import Model, Task

ROLLOVER = Task(
    "rollover",
    "Where a vehicle tips, what speed trips it, and its speed from the rolling.",
    Model(
        "rigid vehicle, tripped at its outer wheels",
        "dynamics_cli.skid.rollover.task:rollover",
        source="static stability factor: NHTSA; trips derived from moment of momentum and energy; Josephs & Huston, "
        "Dynamics of Mechanical Systems, CRC Press 2002, chapters 9 and 10",
        formula="{stability|S} = {track_width|T}/(2·{cm_height|h}); "
        "{tip_drag|a/g} = ({stability|S} + {superelevation|e})/(1 − {stability|S}·{superelevation|e})",
        assumptions=(
            "a rigid vehicle: no suspension, no tyre travel; real ones tip earlier",
            "the road is level while it trips",
            "a steady deceleration in soil, and while rolling",
        ),
    ),
    headline=(
        "speed: speed before the trip",
        "roll_speed: speed as it began to roll",
        "trip_speed: least trip speed in soil",
        "kerb_speed: least trip speed at a kerb",
        "curve_speed: speed that tips in the curve",
        "stability: static stability factor",
        "tip_drag: lateral drag factor that tips",
        "roll_rate: mean roll rate",
        "roll_time: time of the rolling",
    ),
    examples=(
        'dynamics skid rollover --track-width "1.54 m" --cm-height "0.7 m" --roll-gyration "0.74 m" '
        '--trip-deceleration "1.4 g"',
        'dynamics skid rollover --track-width "61 in" --cm-height "27 in" --roll-distance "144 ft" --roll-drag 0.53 '
        '--turns 3 --trip-distance "12 ft" --trip-deceleration "1.4 g" --units us',
    ),
    plot="dynamics_cli.skid.rollover.pictures:rollover",
    notes="Published ranges with their sources: dynamics skid values roll",
)

VALUES = Task(
    "values",
    "Published ranges of friction, drag, reaction and more, with their sources.",
    Model(
        "ranges as printed",
        "dynamics_cli.skid.values.task:values",
        source="as each row says; no calculation takes its numbers from here",
        method="a table",
    ),
    examples=(
        "dynamics skid values friction --surface asphalt",
        "dynamics skid values reaction",
    ),
    table="values",
    listing=True,
    arrays=False,
    tracked=False,
    names={"surface": "dynamics_cli.skid.values.task:SURFACES"},
    headline=("values: ranges",),
    layout="dynamics_cli.skid.values.layout:lines",
)

SWERVE = Task(
    "swerve",
    "Distance and time of a swerve, and the speed at which braking needs as much.",
    Model(
        "two equal arcs at constant speed",
        "dynamics_cli.skid.curved.swerve:swerve",
        source="motion on a circle, Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, chapter 3; "
        "derived",
        formula="{distance|d} = √({lateral_shift|y}·(4·{arc_radius|R} − {lateral_shift|y})), "
        "{arc_radius|R} = {speed|v}²/{lateral_acceleration|a}",
        assumptions=(
            "the speed does not change",
            "the lateral acceleration comes and goes at once: give the steering's time as lag",
            "the tyres have the grip for it",
        ),
    ),
    headline=(
        "total_distance: distance with reaction and lag",
        "total_time: time with reaction and lag",
        "distance: distance of two arcs",
        "time: time of two arcs",
        "one_arc_distance: distance of one arc",
        "sine_time: time as a sine",
        "braking_distance: stopping distance instead",
        "equal_speed: swerving is shorter above",
    ),
    examples=(
        'dynamics skid swerve --speed "90 km/h" --lateral-shift "3.5 m" --lateral-acceleration "0.35 g" '
        '--drag-factor 0.7 --reaction-time "1.2 s" --steering-lag "0.2 s"',
    ),
    plot="dynamics_cli.skid.curved.pictures:swerve",
)

TASKS = (ROLLOVER, SWERVE, VALUES)
