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
        "trip_speed: least speed that trips it, soil",
        "kerb_speed: least speed that trips it, kerb",
        "curve_speed: tips in the curve at",
        "stability: static stability factor",
        "tip_drag: tips at a lateral drag factor of",
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
    names={"surface": "dynamics_cli.skid.values.task:surfaces"},
    headline=("values: ranges",),
    layout="dynamics_cli.skid.values.layout:lines",
)

TASKS = (ROLLOVER, VALUES)
