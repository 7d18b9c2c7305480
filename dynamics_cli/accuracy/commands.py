"""The command `dynamics accuracy`."""

from dynamics_cli.core.answering.task import Family, Model, Task

TASK = Task(
    "",
    "Speed against error of every method, measured here and now.",
    Model(
        "work–precision measurement",
        "dynamics_cli.accuracy.report:accuracy",
        source="references of 40 digits by other formulas, in multiple precision or exact rationals",
        method="errors in 60-digit decimals, times as medians of repeats",
    ),
    examples=(
        "dynamics accuracy coords --untimed",
        "dynamics accuracy skid yaw --hard --untimed",
        "dynamics accuracy gear ratio --full --untimed",
        "dynamics accuracy gear pair --peers --untimed",
        "dynamics accuracy cam size --hard --cases",
    ),
    table="cases methods",
    arrays=False,
    tracked=False,
    digits=3,
    plot="dynamics_cli.accuracy.pictures:work_precision",
    layout="dynamics_cli.accuracy.layout:lines",
    verdict=True,
)
FAMILIES = {"accuracy": Family("accuracy", "Speed against error of every method, measured here and now.", TASK)}
