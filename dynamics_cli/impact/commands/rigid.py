"""Tasks of `dynamics impact`: rigid bodies with friction."""

from dynamics_cli.core.answering.task import Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section "
PICTURES = "dynamics_cli.impact.rigid_pictures:"
SHORT = "the impact is short: forces other than that of the contact have no impulse, and nothing moves meanwhile"
POINT = "the bodies are rigid and touch at one point with Coulomb friction"
KELLER = "Keller, J. Appl. Mech. 53 (1986); Stronge, Impact Mechanics (2000)"
IN_SPACE = (
    "first.speed: first speed after v₁′",
    "second.speed: second speed after v₂′",
    "first.delta_v_magnitude: first Δv₁",
    "second.delta_v_magnitude: second Δv₂",
    "first.spin: first spin after ω₁′",
    "second.spin: second spin after ω₂′",
    "energy_lost: energy lost E",
    "slip_history: slip history",
)

PLANAR = Task(
    "planar",
    "Two rigid bodies, or one and a barrier, with friction and restitution, by five laws.",
    Model(
        "planar impact with friction",
        "dynamics_cli.impact.planar.impact:planar",
        source=KELLER + "; Brach & Brach, Vehicle Accident Analysis and Reconstruction Methods (2011)",
        formula="u' = u + K·p; dp_t = −{friction|μ}·sgn(u_t)·dp_n while it slips, −(k_x/k_t)·dp_n while it sticks; "
        "{normal_impulse|p_n}, {tangential_impulse|p_t} where the law with {restitution|e} ends",
        assumptions=(SHORT, POINT),
        method="closed-form Routh–Keller path",
    ),
    plot=PICTURES + "planar",
    examples=(
        'dynamics impact planar --first-mass "1500 kg" --first-inertia "2500 kg*m^2" --first-velocity "15, 0 m/s" '
        '--first-lever "2, -0.4 m" --second-mass "1200 kg" --second-inertia "1800 kg*m^2" --second-velocity '
        '"0, 10 m/s" --second-lever "-0.8, 0.5 m" --normal "10 deg" --friction 0.5 --restitution 0.1',
        'dynamics impact planar --first-mass "1500 kg" --first-inertia "2500 kg*m^2" --first-speed "60 km/h" '
        '--first-heading "-15 deg" --first-contact-on-body "2.2, -0.8 m" --first-name Ford --second-fixed --normal '
        '"-90 deg" --friction 0.4 --restitution 0.1',
        'dynamics impact planar --first-mass "1 kg" --first-radius-of-gyration "0.2 m" --first-velocity "3, -4 m/s" '
        '--first-lever "0.3, -0.4 m" --second-fixed --normal "-90 deg" --friction 0.3 --restitution 0.6 --law all',
        'dynamics impact planar --first-mass "0.5 kg" --first-inertia "2e-4 kg*m^2" --first-velocity "1, -2 m/s" '
        '--first-lever "0, -20 mm" --first-spin "300 rpm" --second-fixed --normal "-90 deg" --friction 0.2 '
        '--restitution 0.8 --contact-radius "20 mm" --contact-modulus "2 GPa" --json',
    ),
    headline=(
        "first.speed: first speed after v₁′",
        "second.speed: second speed after v₂′",
        "first.delta_v.magnitude: first Δv₁",
        "second.delta_v.magnitude: second Δv₂",
        "first.delta_v.pdof: first PDOF",
        "second.delta_v.pdof: second PDOF",
        "first.spin: first spin after ω₁′",
        "second.spin: second spin after ω₂′",
        "energy_lost: energy lost E",
        "equivalent_barrier_speed: EBS",
        "slip_history: slip history",
        "newton.first_delta_v: first Δv₁ by Newton",
        "poisson.first_delta_v: by Poisson",
        "brach.first_delta_v: by Brach",
        "kudlich_slibar.first_delta_v: by Kudlich–Slibar",
    ),
)

ENVELOPE = Task(
    "envelope",
    "ΔV of a planar impact over a region of restitution and friction.",
    Model(
        "planar impact with friction, over a region",
        "dynamics_cli.impact.planar.envelope:envelope",
        source=KELLER,
        formula="ΔV = |p|/m at every point of {least_restitution|e₁} to {greatest_restitution|e₂}, "
        "{least_friction|μ₁} to {greatest_friction|μ₂}",
        assumptions=(SHORT, POINT),
        method="closed-form Routh–Keller path on a grid, extremes in many digits",
    ),
    plot=PICTURES + "envelope",
    examples=(
        'dynamics impact envelope --first-mass "1500 kg" --first-inertia "2500 kg*m^2" --first-velocity "15, 0 m/s" '
        '--first-lever "2, -0.4 m" --second-mass "1200 kg" --second-inertia "1800 kg*m^2" --second-velocity '
        '"0, 10 m/s" --second-lever "-0.8, 0.5 m" --normal "10 deg" --greatest-restitution 0.3 --least-friction 0.2 '
        "--greatest-friction 0.8",
    ),
    table="map",
    arrays=False,
    cost=4e-3,
    unspread=("refused",),
    tracked=False,
    findings=(
        "first_delta_v.least: {first}'s ΔV lay between {} and {first_delta_v.greatest}",
        "second_delta_v.least: {second}'s ΔV lay between {} and {second_delta_v.greatest}",
    ),
    headline=(
        "first_delta_v.least: first Δv₁ at least",
        "first_delta_v.greatest: first Δv₁ at most",
        "second_delta_v.least: second Δv₂ at least",
        "second_delta_v.greatest: second Δv₂ at most",
        "least_energy_lost: energy lost at least",
        "greatest_energy_lost: energy lost at most",
        "slip_share: share that slips",
    ),
)

SPATIAL = Task(
    "spatial",
    "Two rigid bodies in space, or one and a barrier, with friction: Keller's equations.",
    Model(
        "impact in space with friction",
        "dynamics_cli.impact.spatial.impact:spatial",
        source=KELLER,
        formula="du = K·(−{friction|μ}·u_t/|u_t|, 1)·dp_n while it slips; p_t = −K_tt⁻¹·k_tn·p_n while it sticks; "
        "{normal_impulse|p_n} where the law with {restitution|e} ends",
        assumptions=(SHORT, POINT),
        method="Taylor series, in doubles and again in decimals",
    ),
    plot=PICTURES + "spatial",
    examples=(
        'dynamics impact spatial --first-mass "2 kg" --first-inertia "[[0.02,0,0],[0,0.03,0.004],[0,0.004,'
        '0.04]] kg*m^2" --first-lever "0.1, 0.05, -0.2 m" --first-velocity "3, 1, -4 m/s" --first-spin "0, 5, 2 rad/s" '
        '--second-fixed --normal "0, 0, -1" --friction 0.4 --restitution 0.6',
        'dynamics impact spatial --first-mass "1500 kg" --first-inertia "[[500, 0, 0], [0, 2400, 0], [0, 0, 2500]] '
        'kg*m^2" --first-lever "2, -0.4, 0.1 m" --first-velocity "15, 0, 0 m/s" --second-mass "1200 kg" '
        '--second-inertia "[[400, 0, 0], [0, 1700, 0], [0, 0, 1800]] kg*m^2" --second-lever "-0.8, 0.5, 0.05 m" '
        '--second-velocity "0, 10, 0 m/s" --normal "0.98, 0.17, 0" --friction 0.5 --restitution 0.1 --json',
    ),
    arrays=False,
    cost=1e-3,
    tracked=False,
    headline=IN_SPACE,
)

SOLVE = Task(
    "solve",
    "A scene of two bodies and one contact, by the simplest model that fits it.",
    Model(
        "central, bodies that meet on one line",
        "dynamics_cli.impact.spatial.scene:solve_central",
        source=BOOK + "9.10",
        formula="{normal_impulse|p} = (1 + e)·m_r·{closing_speed|u}",
        assumptions=(SHORT,),
        suffices="dynamics_cli.impact.spatial.scene:central_suffices",
    ),
    Model(
        "oblique, smooth bodies without spin",
        "dynamics_cli.impact.spatial.scene:solve_oblique",
        source=BOOK + "9.11",
        formula="{normal_impulse|p} = (1 + e)·m_r·{closing_speed|u}",
        assumptions=(SHORT, "nothing acts across the normal"),
        suffices="dynamics_cli.impact.spatial.scene:oblique_suffices",
    ),
    Model(
        "planar, rigid bodies with friction in one plane",
        "dynamics_cli.impact.spatial.scene:solve_planar",
        source=KELLER,
        formula="u' = u + K·p in the plane of normal and slip, {slip_history|history}",
        assumptions=(SHORT, POINT, "the slip stays on one line"),
        method="closed-form Routh–Keller path",
        suffices="dynamics_cli.impact.spatial.scene:planar_suffices",
    ),
    Model(
        "spatial, rigid bodies with friction in space",
        "dynamics_cli.impact.spatial.scene:solve",
        source=KELLER,
        formula="du = K·(−μ·u_t/|u_t|, 1)·dp_n, {slip_history|history}",
        assumptions=(SHORT, POINT),
        method="Taylor series, in doubles and again in decimals",
    ),
    plot=PICTURES + "scene",
    scene={
        "first.name": "Ford",
        "first.mass": "1500 kg",
        "first.speed": "50 km/h",
        "first.heading": "0 deg",
        "second.name": "Seat",
        "second.mass": "1200 kg",
        "contact.normal": "1, 0, 0",
        "contact.restitution": "0.3",
    },
    examples=(
        "dynamics impact solve examples/corner_strike.toml",
        "dynamics impact solve examples/thrown_block.toml --explain",
    ),
    arrays=False,
    tracked=False,
    headline=IN_SPACE,
)

TASKS: "tuple[Task, ...]" = (PLANAR, SPATIAL, ENVELOPE, SOLVE)
