"""The task of a whole crash."""

from dynamics_cli.core.answering.task import Model, Task
from dynamics_cli.impact.commands.rigid import SHORT

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 9.5 and 10.10"
POINTS = "point masses slowed uniformly on every surface; slides are straight"
ONE_ROAD = "one surface is one friction, for every vehicle and phase that refers to it"

CRASH = Task(
    "crash",
    "A complete two-car crash from one scene: before, impact and after, as one model.",
    Model(
        "slides, then momentum and energy on one line, then the approach phases",
        "dynamics_cli.impact.crash.solve:crash_with_energy",
        source=BOOK,
        formula="after: u² = u_e² + 2·g·Σ f·d; impact: u² = w² + 2·E/m_r; before: v₀² = v² + 2·g·f·d",
        assumptions=(POINTS, SHORT, ONE_ROAD),
        suffices="dynamics_cli.impact.crash.solve:energy_suffices",
    ),
    Model(
        "slides, then momentum, then the approach phases",
        "dynamics_cli.impact.crash.solve:crash",
        source=BOOK,
        formula="after: u² = u_e² + 2·g·Σ f·d; impact: m₁·v₁ + m₂·v₂ = m₁·u₁ + m₂·u₂; before: v₀² = v² + 2·g·f·d",
        assumptions=(POINTS, SHORT, ONE_ROAD),
    ),
    scene={
        "axes": "compass",
        "first.mass": "1500 kg",
        "first.approach_heading": "90 deg",
        "first.exit_heading": "48 deg",
        "first.name": "Ford",
        "first.before[0].distance": "12.4 m",
        "first.before[0].surface": "road",
        "first.after[0].distance": "10.7 m",
        "first.after[0].surface": "road",
        "second.mass": "1150 kg",
        "second.approach_heading": "0 deg",
        "second.exit_heading": "53 deg",
        "second.name": "Opel",
        "second.after[0].distance": "11.6 m",
        "second.after[0].surface": "road",
        "surfaces[0].name": "road",
        "surfaces[0].friction": "0.72",
    },
    examples=("dynamics impact crash examples/crash_scene/crash.toml",),
    table="courses links agreements",
    plot="dynamics_cli.impact.crash.pictures:crash",
    writers=dict.fromkeys(("dxf", "svg", "pdf"), "dynamics_cli.impact.crash.pictures:plan"),
    unspread=("first.per_degree", "second.per_degree"),
    findings=(
        "first.start.speed: {first}'s speed at its start",
        "first.approach_speed: {first}'s speed into the impact",
        "first.delta_v.magnitude: {first}'s ΔV",
        "second.start.speed: {second}'s speed at its start",
        "second.approach_speed: {second}'s speed into the impact",
        "second.delta_v.magnitude: {second}'s ΔV",
    ),
    headline=(
        "first.start.speed: first speed at its start v₀",
        "first.approach_speed: first speed into the impact v",
        "first.per_degree: first v per degree of heading",
        "first.delta_v.magnitude: first ΔV",
        "second.start.speed: second speed at its start v₀",
        "second.approach_speed: second speed into the impact v",
        "second.per_degree: second v per degree of heading",
        "second.delta_v.magnitude: second ΔV",
        "weakest: weakest link",
    ),
)

TASKS: "tuple[Task, ...]" = (CRASH,)
