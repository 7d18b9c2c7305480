"""Tasks of `dynamics impact`: approach motion from the motion after, a recorder, or the turn of a heavy vehicle."""

from dynamics_cli.core.answering.task import Model, Task

BRACH = "R. M. Brach, R. M. Brach, Vehicle Accident Analysis and Reconstruction Methods, SAE 2011"
SHORT = "the impact is short: forces other than that of the contact have no impulse, and nothing moves meanwhile"
POINT = "one resultant impulse acts at the contact"
RECORDED = "the recorded ΔV is within its tolerance, and the pulse had ended"
EXITS = "the motion after is that of the mass centres just after the impact"

INVERSE = Task(
    "inverse",
    "Approach speeds from the motion after the impact, including spins.",
    Model(
        "least squares to rest positions",
        "dynamics_cli.impact.inverse.task:by_rest",
        source=BRACH + ": planar impact mechanics",
        formula="Σ ((rest(v₁, v₂, …) − measured)/σ)² = {chi_squared|χ²} → minimum",
        assumptions=(SHORT, POINT, "errors of the measurements are independent and normal"),
        method="Gauss–Newton by QR of the scaled matrix, impact and slides driven forward",
        suffices="dynamics_cli.impact.inverse.task:rests_given",
    ),
    Model(
        "momentum alone",
        "dynamics_cli.impact.inverse.task:by_momentum",
        source="Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 9.5",
        formula="m₁·{first.approach_speed|v₁}·d₁ + m₂·{second.approach_speed|v₂}·d₂ = m₁·u₁ + m₂·u₂",
        assumptions=(SHORT, EXITS),
        method="QR of the scaled equations",
        suffices="dynamics_cli.impact.inverse.task:momentum_suffices",
    ),
    Model(
        "momentum and spins",
        "dynamics_cli.impact.inverse.task:by_spins",
        source=BRACH + ": planar impact mechanics",
        formula="p = (J₁·Δω₁·r₂ + J₂·Δω₂·r₁)/(r₁ × r₂); {first.approach_speed|v₁} = |u₁ − p/m₁|, "
        "{second.approach_speed|v₂} = |u₂ + p/m₂|",
        assumptions=(SHORT, POINT, EXITS),
        method="QR of the scaled equations",
        suffices="dynamics_cli.impact.inverse.task:spins_suffice",
    ),
    Model(
        "least squares, headings and spins together",
        "dynamics_cli.impact.inverse.task:least_squares",
        source=BRACH + ": planar impact mechanics",
        formula="Σ ((fitted − measured)/σ)² = {chi_squared|χ²} → minimum over v₁, v₂, p, α₁, α₂",
        assumptions=(SHORT, POINT, EXITS, "errors of the measurements are independent and normal"),
        method="Gauss–Newton by QR of the scaled matrix",
    ),
    plot="dynamics_cli.impact.inverse.pictures:inverse",
    digits=4,
    examples=(
        'dynamics impact inverse --first-mass "1500 kg" --first-exit-velocity "11.2, 0.2 m/s" '
        '--first-approach-heading "0 deg" --second-mass "1200 kg" --second-exit-velocity "4.9, 9.9 m/s" '
        '--second-approach-heading "90 deg"',
        "dynamics impact inverse --input examples/exit_motion/cars.toml",
    ),
    arrays=False,
    tracked=False,
    findings=(
        "first.approach_speed: {first}'s speed before the impact was {} with a standard deviation of "
        "{first.speed_sigma}",
        "second.approach_speed: {second}'s speed before the impact was {} with a standard deviation of "
        "{second.speed_sigma}",
        "first.delta_v.magnitude: {first}'s ΔV",
        "second.delta_v.magnitude: {second}'s ΔV",
    ),
    headline=(
        "first.approach_speed: first speed before v₁",
        "first.speed_sigma: its standard deviation σ₁",
        "second.approach_speed: second speed before v₂",
        "second.speed_sigma: its standard deviation σ₂",
        "first.delta_v.magnitude: first Δv₁",
        "second.delta_v.magnitude: second Δv₂",
        "probability: agreement P(χ²)",
        "restitution: implied restitution e",
        "impulse_ratio: implied ratio p_t/p_n",
        "least_certain: least certain",
    ),
    notes="Restitution is small, so the motion after the impact says little about the closing speed: give approach "
    "headings, or the spins before the impact, which are zero for vehicles that drove straight.",
)

RECORD = Task(
    "record",
    "A crash from the ΔV that one vehicle's recorder gives.",
    Model(
        "in line, with a range of restitution",
        "dynamics_cli.impact.recorded.task:head_on",
        source="CRASH3 (NHTSA), effective mass with a lever arm; 49 CFR 563.8",
        formula="{closing_speed|u} = m₁·ΔV₁·(1/(γ₁·m₁) + 1/(γ₂·m₂))/(1 + {restitution|e})",
        assumptions=(SHORT, "the vehicles met along the line of the force", RECORDED),
        suffices="dynamics_cli.impact.recorded.task:in_line",
    ),
    Model(
        "in the plane, with a range of restitution",
        "dynamics_cli.impact.recorded.task:by_restitution",
        source=BRACH + ": planar impact mechanics; 49 CFR 563.8",
        formula="u_n = −n·K·p/(1 + {restitution|e}); {second.approach_speed|v₂} = (V₁·n − u_n)/(d₂·n)",
        assumptions=(SHORT, POINT, RECORDED),
        suffices="dynamics_cli.impact.recorded.task:restitution_decides",
    ),
    Model(
        "in the plane, with headings before and after",
        "dynamics_cli.impact.recorded.task:by_headings",
        source="conservation of momentum; 49 CFR 563.8",
        formula="{second.approach_speed|v₂} = −(ΔV₂ × d_β)/(d₂ × d_β)",
        assumptions=(SHORT, RECORDED, "the heading after is that of the mass centre just after the impact"),
    ),
    plot="dynamics_cli.impact.recorded.pictures:record",
    examples=(
        'dynamics impact record --first-mass "1500 kg" --first-delta-v-longitudinal "-27 km/h" --second-mass '
        '"1200 kg" --least-restitution 0 --greatest-restitution 0.2',
        'dynamics impact record --first-mass "1500 kg" --first-inertia "2600 kg*m^2" --first-lever "1.9, 0.15 m" '
        '--first-nose "12 deg" --first-approach-speed "13.2 m/s" --first-delta-v-longitudinal "-44.6 km/h" '
        '--first-delta-v-lateral "7.2 km/h" --first-spin-change "1.9 rad/s" --first-module "-0.4, 0.1 m" '
        '--second-mass "1200 kg" --second-inertia "1900 kg*m^2" --second-lever "-1.8, -0.3 m" '
        '--second-approach-heading "140 deg" --normal "12 deg" --least-restitution 0 --greatest-restitution 0.2',
    ),
    findings=(
        "first.delta_v.magnitude: {first}'s ΔV at its mass centre",
        "second.delta_v.magnitude: {second}'s ΔV",
        "closing_speed: the closing speed was {}, between {closing_speed_low} and {closing_speed_high}",
        "second.approach_speed: {second}'s speed before the impact was {}, between {second.approach_speed_low} and "
        "{second.approach_speed_high}",
    ),
    headline=(
        "first.delta_v.magnitude: first Δv₁ at the mass centre",
        "second.delta_v.magnitude: second Δv₂",
        "closing_speed: closing speed u",
        "closing_speed_low: closing speed at least",
        "closing_speed_high: closing speed at most",
        "second.approach_speed: second speed before v₂",
        "second.approach_speed_low: second speed at least",
        "second.approach_speed_high: second speed at most",
        "energy_lost: energy lost E",
    ),
)

PULSE = Task(
    "pulse",
    "A recorded crash pulse: greatest ΔV, whether it had ended, the car's turn taken out.",
    Model(
        "samples of a recorder",
        "dynamics_cli.impact.recorded.pulse:pulse",
        source="49 CFR 563.7 and 563.8",
        formula="ψ = ∫ ω dt; ΔV = Σ R(ψ)·dv in the axes of the start",
        assumptions=("ΔV changes uniformly between samples", "the recorder is at the mass centre"),
        method="sums over the samples",
    ),
    arrays=False,
    cost=8e-5,
    tracked=False,
    plot="dynamics_cli.impact.recorded.pictures:pulse",
    table="rows",
    examples=(
        'dynamics impact pulse --longitudinal "0, -1, -4, -9, -16, -22, -29, -35, -40, -43, -44, -45, -45, -45 km/h" '
        '--lateral "0, 0, 1, 1, 3, 4, 5, 6, 6, 7, 7, 7, 7, 7 km/h"',
        'dynamics impact pulse --longitudinal "0, -1, -4, -9, -16, -22, -29, -35, -40, -43, -44, -45, -45, -45 km/h" '
        '--yaw-rate "0, 1, 4, 17, 33, 49, 64, 80, 93, 103, 107, 109, 109, 109 deg/s" --friction 0.7 -q',
    ),
    findings=(
        "delta_v: the greatest ΔV was {}, between {delta_v_low} and {delta_v_high}",
        "delta_v_longitudinal: along the nose as it was at the start it was {}, and {delta_v_lateral} across it",
    ),
    headline=(
        "delta_v: greatest ΔV",
        "delta_v_low: at least",
        "delta_v_high: at most",
        "time: reached after",
        "delta_v_longitudinal: along the nose at the start",
        "delta_v_lateral: across it",
        "duration: duration of the pulse",
        "mean_acceleration: mean acceleration",
        "greatest_acceleration: greatest over one interval",
        "turned: turned meanwhile",
        "tyres: tyres can have added",
    ),
)

ROTATION = Task(
    "rotation",
    "Speed of a light vehicle from how it turned the heavy one it struck.",
    Model(
        "momentum of rotation",
        "dynamics_cli.impact.reconstruction.rotation:rotation",
        source="Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 9.4",
        formula="{impulse|p} = {heavy_inertia|J₁}·{heavy_spin|Δω₁}/{lever|h}, "
        "{speed|v₂} = {impulse|p}/{light_mass|m₂} + {exit_speed|u₂}",
        assumptions=(
            "one impulse, along the approach of the light vehicle",
            "the tyres of the heavy vehicle do not hold it against the turn",
            "it did not turn before",
        ),
    ),
    findings=(
        "speed: the light vehicle's speed",
        "light_change: its ΔV",
        "heavy_change: the heavy vehicle's ΔV",
    ),
    headline=(
        "speed: speed of the light vehicle",
        "impulse",
        "light_change: its ΔV",
        "heavy_change: ΔV of the heavy vehicle",
    ),
    examples=(
        'dynamics impact rotation --heavy-inertia "1800 kg*m^2" --heavy-spin "1.15 rad/s" --lever "1.6 m" '
        '--light-mass "250 kg" --exit-speed "2 m/s" --heavy-mass "1450 kg"',
    ),
    plot="dynamics_cli.impact.reconstruction.rotation_picture:rotation",
)

TASKS = (INVERSE, RECORD, PULSE, ROTATION)
