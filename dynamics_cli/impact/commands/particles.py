"""Tasks of `dynamics impact`: particles, momentum and crush."""

from dynamics_cli.core.answering.task import Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section "
SWINGS = "dynamics_cli.impact.held.pictures:"
PICTURES = "dynamics_cli.impact.particles.pictures:"
SHORT = "the impact is short: forces other than that of contact have no impulse"

CENTRAL = Task(
    "central",
    "Two bodies that meet head on: velocities after, impulse, energy lost.",
    Model(
        "central impact",
        "dynamics_cli.impact.particles.central:central",
        source=BOOK + "9.10",
        formula="{impulse|p} = (1 + {restitution|e})·{reduced_mass|m_r}·{closing_speed|u}; "
        "{results.first.velocity|v₁'} = v₁ − p/{first.mass|m₁}; "
        "{results.second.velocity|v₂'} = v₂ + p/{second.mass|m₂}; "
        "{energy_lost|E} = ½·m_r·(1 − e²)·u²",
        assumptions=(SHORT, "mass centres and contact lie on one line, along which both bodies move"),
    ),
    examples=(
        'dynamics impact central --first-mass "2 kg" --first-velocity "3 m/s" --second-mass "1 kg" --restitution 0.5',
        'dynamics impact central --first-weight "3400 lbf" --first-velocity "30 mph" --second-weight "2600 lbf" '
        '--second-velocity "-25 mph" --restitution 0.15 --units us',
        'dynamics impact central --first-mass "0.058 kg" --first-velocity "20 m/s" --second-fixed --restitution 0.73 '
        '--contact-stiffness "60 kN/m"',
        'dynamics impact central --first-mass "0.2 kg" --first-velocity "3 m/s" --second-fixed --restitution 0.6 '
        '--contact-radius "20 mm" --contact-modulus "2 GPa" --hunt-crossley',
    ),
    plot=PICTURES + "central",
    headline=(
        "first.velocity: first velocity after v₁′",
        "second.velocity: second velocity after v₂′",
        "first.delta_v: first Δv₁",
        "second.delta_v: second Δv₂",
        "impulse: impulse p",
        "energy_lost: energy lost E",
        "push.duration: contact time",
        "push.peak_force: peak force",
    ),
)

OBLIQUE = Task(
    "oblique",
    "Two particles or smooth spheres that meet at an angle.",
    Model(
        "oblique impact of smooth bodies",
        "dynamics_cli.impact.particles.oblique:oblique",
        source=BOOK + "9.11",
        formula="{impulse|p} = (1 + {restitution|e})·m_r·{closing_speed|u}, u = (v₁ − v₂)·n; "
        "{energy_lost|E} = ½·m_r·(1 − e²)·u²",
        assumptions=(SHORT, "the surfaces are smooth: the impulse acts along the line of impact"),
    ),
    examples=(
        'dynamics impact oblique --first-mass "1 kg" --first-velocity "20 cm/s @ 45 deg" --second-mass "1 kg" '
        '--second-velocity "15 cm/s @ 150 deg" --normal "0 deg" --restitution 0.95',
        'dynamics impact oblique --first-mass "0.17 kg" --first-velocity "3, 0 m/s" --second-mass "0.17 kg" '
        '--offset "20 mm" --first-radius "28.6 mm" --second-radius "28.6 mm" --restitution 0.94 '
        '--contact-radius "14.3 mm" --contact-modulus "2.9 GPa" --json',
        'dynamics impact oblique --first-mass "0.6 kg" --first-speed "10 m/s" --first-heading "-30 deg" --second-fixed '
        '--normal "-90 deg" --restitution 0.75',
        'dynamics impact oblique --first-mass "1500 ± 20 kg" --first-velocity "50 ± 3 km/h @ 10 ± 2 deg" '
        '--second-mass "1200 kg" --second-velocity "-20 ± 2, 5 km/h" --normal "0 deg" --restitution "0.15 ± 0.02"',
    ),
    plot=PICTURES + "oblique",
    headline=(
        "first.speed: first speed after v₁′",
        "second.speed: second speed after v₂′",
        "first.heading: first heading after",
        "second.heading: second heading after",
        "first.delta_v.magnitude: first Δv₁",
        "second.delta_v.magnitude: second Δv₂",
        "impulse: impulse p",
        "energy_lost: energy lost E",
    ),
)

# With given masses, and with masses from given weights.
_PLANE_MOMENTUM = (
    "{{first.approach_speed|v₁}} = ({0}·{{first.exit_speed|u₁}}·sin({{second.approach_heading|α₂}} − "
    "{{first.exit_heading|β₁}}) + {1}·{{second.exit_speed|u₂}}·sin({{second.approach_heading|α₂}} − "
    "{{second.exit_heading|β₂}}))/({0}·sin({{second.approach_heading|α₂}} − {{first.approach_heading|α₁}})); "
    "{{angle_condition|κ}} = (1 + |cos({{second.approach_heading|α₂}} − {{first.approach_heading|α₁}})|)"
    "/|sin({{second.approach_heading|α₂}} − {{first.approach_heading|α₁}})|"
)

MOMENTUM = Task(
    "momentum",
    "Speeds before an impact from the vehicles' motion after it: 360° momentum, up to two unknowns.",
    Model(
        "collinear momentum and energy",
        "dynamics_cli.impact.reconstruction.momentum:momentum_and_energy",
        source=BOOK + "10.10; conservation of momentum along the line",
        formula="u² = w² + 2·E/m_r; {first.approach_speed|v₁} = V + u·m_r/m₁; "
        "{second.approach_speed|v₂} = V − u·m_r/m₂",
        assumptions=(SHORT, "the vehicles met on one line", "all energy lost went into the deformation"),
        suffices="dynamics_cli.impact.reconstruction.momentum:energy_suffices",
    ),
    Model(
        "momentum in the plane",
        "dynamics_cli.impact.reconstruction.momentum:momentum",
        source=BOOK + "9.5; cross products with the approach directions",
        formula=(_PLANE_MOMENTUM.format("{first.mass|m₁}", "{second.mass|m₂}"), _PLANE_MOMENTUM.format("m₁", "m₂")),
        assumptions=(SHORT, "the speeds after are those of the mass centres just after the impact"),
    ),
    examples=(
        'dynamics impact momentum --first-mass "1500 kg" --first-approach-heading "0 deg" --first-exit-speed "8 m/s" '
        '--first-exit-heading "40 deg" --second-mass "1200 kg" --second-approach-heading "90 deg" '
        '--second-exit-speed "9 m/s" --second-exit-heading "37 deg"',
        'dynamics impact momentum --first-weight "3400 lbf" --first-approach-heading "90 deg" --first-exit-speed '
        '"22 mph" --first-exit-heading "40 deg" --second-weight "2900 lbf" --second-approach-heading "0 deg" '
        '--second-exit-speed "20 mph" --second-exit-heading "35 deg" --axes compass --units us',
        'dynamics impact momentum --first-mass "1000 kg" --first-approach-heading "0 deg" --first-exit-speed "5 m/s" '
        '--first-exit-heading "0 deg" --second-mass "1400 kg" --second-approach-heading "0 deg" --second-exit-speed '
        '"6 m/s" --second-exit-heading "0 deg" --first-ees "25 km/h" --second-ees "15 km/h"',
    ),
    plot=PICTURES + "momentum",
    headline=(
        "first.approach_speed: first speed before v₁",
        "second.approach_speed: second speed before v₂",
        "first.delta_v.magnitude: first Δv₁",
        "second.delta_v.magnitude: second Δv₂",
        "first.delta_v.pdof: first PDOF",
        "second.delta_v.pdof: second PDOF",
        "energy_lost: energy lost E",
        "first.determined.verdict: first verdict",
        "first.determined.per_degree: v₁ error per degree",
        "second.determined.verdict: second verdict",
        "second.determined.per_degree: v₂ error per degree",
    ),
)

CRUSH = Task(
    "crush",
    "Energy of deformation, EBS and ΔV from measured crush, or ΔV from a given energy or EES.",
    Model(
        "linear force–deflection, A B G",
        "dynamics_cli.impact.reconstruction.crush:crush",
        source="Campbell, SAE 740565 (1974), and the CRASH3 damage algorithm (NHTSA), as commonly published",
        formula=(
            "{first.energy|E₁} = L·({first.stiffness_g|G} + {first.stiffness_a|A}·{first.mean_crush|C} + "
            "½·{first.stiffness_b|B}·mean(C²))·(1 + tan²α); "
            "p = √(2·m_r·{energy|E}·(1 + e)/(1 − e)); {first.delta_v|ΔV₁} = p/m₁",
            "{first.equivalent_barrier_speed|EES₁} = √(2·{first.energy|E₁}/{first.mass|m₁}); "
            "p = √(2·m_r·{energy|E}·(1 + e)/(1 − e)); {first.delta_v|ΔV₁} = p/{first.mass|m₁}",
        ),
        assumptions=(
            "the force per width grows linearly with depth of crush: A + B·C",
            "crush is linear between stations, which are equally spaced",
            "with the other vehicle the damaged regions reach a common velocity; energies are those that remain lost",
        ),
    ),
    examples=(
        'dynamics impact crush --first-mass "1500 kg" --first-stiffness-a "600 N/cm" --first-stiffness-b "45 N/cm^2" '
        '--first-stations "10,25,30,12 cm" --first-width "150 cm" --second-mass "1200 kg" --second-stiffness-a '
        '"250 N/cm" --second-stiffness-b "40 N/cm^2" --second-stations "5,22,28,10 cm" --second-width "160 cm" '
        '--second-lever-arm "0.4 m" --second-yaw-inertia "1800 kg m^2"',
        'dynamics impact crush --first-mass "1500 kg" --first-energy "62 ± 8 kJ" --second-mass "1200 kg" --second-ees '
        '"30 ± 2 km/h" --restitution 0.15',
        'dynamics impact crush --first-mass "1500 kg" --first-stiffness-a "350 lbf/in" --first-stiffness-b '
        '"60 lbf/in^2" --first-stations "5,12,18,20,14,6 in" --first-width "60 in"',
        'dynamics impact crush --first-weight "3300 lbf" --first-no-damage-speed "5 mph" --first-speed-slope '
        '"1.6 mph/in" --first-test-mass "3300 lb" --first-test-width "66 in" --first-mean-crush "14 in" '
        '--first-width "66 in" --first-force-angle "10 deg" --second-fixed --restitution 0.1 --units us',
    ),
    plot=PICTURES + "crush",
    headline=(
        "first.energy: first energy of deformation E₁",
        "second.energy: second energy of deformation E₂",
        "first.equivalent_barrier_speed: first EBS",
        "second.equivalent_barrier_speed: second EBS",
        "first.delta_v: first Δv₁",
        "second.delta_v: second Δv₂",
        "second_delta_v: second Δv₂",
        "closing_speed: closing speed",
    ),
)

DROP = Task(
    "drop",
    "A body dropped on a floor: restitution from heights or times, and its bounces.",
    Model(
        "bounces with constant restitution",
        "dynamics_cli.impact.particles.drop:drop",
        source=BOOK + "9.10",
        formula="{impact_speed|v} = √(2·{gravity|g}·{drop_height|h}); hₙ = {restitution|e}²ⁿ·h; "
        "{time_to_rest|T} = {fall_time|t₀}·(1 + e)/(1 − e)",
        assumptions=("the floor is fixed and level", "no air drag", "restitution does not depend on speed"),
    ),
    examples=(
        'dynamics impact drop --height "1 m" --rebound-height "0.64 m"',
        'dynamics impact drop --height "6 ft" --restitution 0.82 --bounces 4 --mass "0.13 lb" --units us',
        'dynamics impact drop --flight-time "0.62 s" --next-flight-time "0.53 s"',
    ),
    table="bounces",
    arrays=False,
    plot=PICTURES + "drop",
    headline=(
        "restitution: restitution e",
        "drop_height: drop height h",
        "impact_speed: impact speed v",
        "time_to_rest: time to rest T",
        "energy_lost: energy lost E",
        "bounces",
    ),
)

PENDULUM = Task(
    "pendulum",
    "Ballistic pendulum: speed of a shot from the swing of the body it struck.",
    Model(
        "momentum in the impact, energy in the swing",
        "dynamics_cli.impact.particles.pendulum:pendulum",
        source=BOOK + "9.10 and 10.5",
        formula="{pendulum_speed|V} = √(2·{gravity|g}·{rise|h}); "
        "{speed|v} = V·({shot_mass|m} + {effective_mass|M})/((1 + {restitution|e})·{shot_mass|m})",
        assumptions=(SHORT, "the pendulum hangs at rest and has not moved when the impact is over"),
    ),
    plot=SWINGS + "pendulum",
    examples=(
        'dynamics impact pendulum --shot-mass "10 g" --block-mass "2 kg" --rise "10 cm"',
        'dynamics impact pendulum --shot-mass "8 g" --block-mass "1.5 kg" --swing "18 deg" --length "1.2 m"',
        'dynamics impact pendulum --shot-mass "10 g" --block-mass "3 kg" --swing "20 deg" --inertia "1.1 kg m^2" '
        '--centre-distance "0.55 m" --impact-distance "0.6 m"',
    ),
    headline=(
        "speed: speed of the shot v",
        "pendulum_speed: speed of the pendulum V",
        "rise: rise h",
        "impulse: impulse p",
        "hinge_impulse: impulse on the hinge",
        "energy_lost: energy lost E",
    ),
)

SEIZE = Task(
    "seize",
    "A moving body when a point or an axis of it is suddenly fixed.",
    Model(
        "angular momentum about what is held",
        "dynamics_cli.impact.held.seize:seize",
        source=BOOK + "9.12 and 10.12",
        formula=(
            "ω' = H_O/I_O; {energy_lost|E} = ½·{plate_mass|m}·Δv² + ½·Δω·I_G·Δω",
            "ω' = H_O/I_O; {energy_lost|E} = ½·{mass|m}·Δv² + ½·Δω·I_G·Δω",
        ),
        assumptions=(SHORT, "the support does not move, slip or rebound"),
    ),
    plot=SWINGS + "seize",
    examples=(
        'dynamics impact seize --plate-mass "1 kg" --side "1 m" --spin "10 rad/s" --seized edge',
        'dynamics impact seize --plate-mass "1 kg" --side "1 m" --spin "10 rad/s" --seized corner',
        'dynamics impact seize --mass "2 kg" --inertia "[[0.1, 0, 0], [0, 0.2, 0], [0, 0, 0.25]] kg*m^2" '
        '--angular-velocity "1, 2, 3 rad/s" --velocity "0.5, 0, 0 m/s" --point "0.2, -0.1, 0 m"',
    ),
    headline=(
        "angular_velocity: angular velocity after ω′",
        "angular_speed: its magnitude |ω′|",
        "angular_ratio: ratio ω′/ω",
        "centre_velocity: velocity of the mass centre",
        "impulse_size: impulse |p|",
        "couple_size: couple",
        "energy_lost: energy lost E",
    ),
)

STEP = Task(
    "step",
    "A rolling wheel that meets a step: the minimum speed to get over it, and the motion after the impact.",
    Model(
        "impact about the edge, then energy",
        "dynamics_cli.impact.held.step:step",
        source=BOOK + "10.11",
        formula="{least_speed|v} = √(2·{gravity|g}·{height|h}·(κ + 1))/(κ + 1 − {height|h}/{radius|r}); "
        "{angular_ratio|ω'/ω} = (κ + 1 − {height|h}/{radius|r})/(κ + 1)",
        assumptions=("the wheel rolls without slip", "the edge does not give way; no rebound and no slip on it"),
    ),
    plot=SWINGS + "step",
    examples=(
        'dynamics impact step --radius "300 mm" --height "100 mm"',
        'dynamics impact step --radius "13 in" --height "4 in" --speed "6 ft/s" --mass "40 lb" --inertia-factor 0.7 '
        "--units us",
    ),
    headline=(
        "least_speed: minimum speed to get over",
        "gets_over: gets over",
        "speed_on_step: speed on the step",
        "greatest_rise: greatest rise",
        "centre_speed_after: speed after the impact",
        "angular_ratio: ratio ω′/ω",
        "share_lost: share of energy lost",
    ),
)

CHAIN = Task(
    "chain",
    "Several bodies in line that touch, by a named law: sequential pairs, or all contacts at one moment.",
    Model(
        "pairs in sequence and contacts at one moment, side by side",
        "dynamics_cli.impact.particles.chain:chain",
        source=BOOK + "9.10, pair by pair; Moreau (1988) for contacts at one moment",
        formula="pair: p = (1 + {restitution|e})·m_r·u; "
        "at one moment: p = (1 + e)·c, K·c ≥ u, c ≥ 0, one of them an equality",
        assumptions=(SHORT, "all bodies touch; rigid-body theory does not decide which law holds"),
    ),
    examples=(
        'dynamics impact chain --body "mass=1 kg, velocity=1 m/s" --body "mass=1 kg" --body "mass=1 kg" '
        "--restitution 1",
        'dynamics impact chain --body "mass=2 kg, velocity=3 m/s" --body "mass=1 kg" --body "mass=0.5 kg, '
        'restitution=0.5" --body "mass=1 kg, velocity=-1 m/s" --restitution 0.9 --law sequential',
    ),
    table="bodies",
    arrays=False,
    tracked=False,
    plot=PICTURES + "chain",
    scene={"restitution": "0.3", "bodies[0].mass": "2 kg", "bodies[0].velocity": "3 m/s", "bodies[1].mass": "1 kg"},
    headline=("momentum: momentum", "laws", "bodies"),
)

YAW_INERTIA = Task(
    "yaw-inertia",
    "Yaw moment of inertia of a road vehicle, estimated by named rules with their scatter.",
    Model(
        "named rules",
        "dynamics_cli.impact.reconstruction.yaw_inertia:yaw_inertia",
        source="Burg, as commonly used in reconstruction; dynamic index, as commonly published in vehicle dynamics",
        formula="{yaw_inertia|J} from 0.1269·{mass|m}·{length|L}·{wheelbase|R}, m·a·b, m·(L² + {width|B}²)/12",
        assumptions=("a passenger car without unusual load", "an estimate: rules scatter by 10 to 20 %"),
    ),
    examples=(
        'dynamics impact yaw-inertia --mass "1500 kg" --wheelbase "2.7 m" --length "4.6 m" --width "1.8 m"',
        'dynamics impact yaw-inertia --weight "3451 lbf" --wheelbase "107 in" --length "190 in" --rule burg --units us',
    ),
    table="rules",
    plot=PICTURES + "yaw_inertia",
    headline=(
        "yaw_inertia: yaw inertia J_z",
        "lowest: lowest by the rules",
        "highest: highest by the rules",
        "radius_of_gyration: radius of gyration k",
        "rules",
    ),
)

TASKS: "tuple[Task, ...]" = (
    CENTRAL, OBLIQUE, DROP, PENDULUM, SEIZE, STEP, CHAIN, MOMENTUM, CRUSH, YAW_INERTIA,
)  # fmt: skip
