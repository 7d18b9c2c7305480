"""Tasks of `dynamics cam`: geometry."""

from dynamics_cli.cam.commands.notes import PROGRAM_NOTES, PROGRAM_SCENE, ROLLER_SCENE
from dynamics_cli.core.answering.task import Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 16.4 to 16.8"
RIGID = "cam and follower are rigid and stay in contact"
RADIAL = "a radial (plate) cam at uniform speed; barrel cams are out of scope"
CYCLE = "rise 10 mm in 90 deg ms; dwell 90 deg; return in 90 deg; dwell"
STEEP = "rise 20 mm in 45 deg; dwell 90 deg; return in 45 deg; dwell"
SWING = "rise 15 deg in 120 deg; dwell 60 deg; return in 120 deg; dwell"

PROFILE = Task(
    "profile",
    "Shape of a radial cam: pitch, cam and cutter curves, pressure angle, curvature, and the plate's inertia; "
    "--plot draws it, --drawing turn.svg shows it turning.",
    Model(
        "exact envelope",
        "dynamics_cli.cam.geometry.profile:profile",
        source=BOOK,
        formula="p = centre of the roller, u = p′ − ip, n = iu/|u|: cam = (p − R·n)·e^(−iθ); "
        "φ = angle from the follower's direction of travel to n",
        assumptions=(RADIAL, RIGID),
        method="closed form; extremes by Chebyshev proxies",
    ),
    examples=(
        f'dynamics cam profile --program "{CYCLE}" --follower roller --base-radius "25 mm" --roller-radius "6 mm" '
        '--points 24 --thickness "10 mm" --density "7800 kg/m^3"',
        f'dynamics cam profile --program "{CYCLE}" --follower flat-face --base-radius "45 mm" --points 12 '
        "--rotation clockwise",
        f'dynamics cam profile --program "{SWING}" --follower oscillating-roller --base-radius "30 mm" '
        '--roller-radius "8 mm" --arm "80 mm" --pivot-distance "100 mm" --points 12',
    ),
    headline=(
        "largest_pressure_angle: maximum pressure angle α",
        "least_pressure_angle: minimum pressure angle α",
        "least_convex_radius: minimum convex radius ρ",
        "least_concave_radius: minimum concave radius ρ",
        "face_width: face width touched",
        "smallest_radius: smallest radius of the cam",
        "largest_radius: largest radius of the cam",
        "mass: mass of the plate m",
        "inertia: moment of inertia J",
        "points: cam | cam_angle=θ, x, y, pressure_angle=α, radius_of_curvature=ρ",
    ),
    table="points",
    notes=PROGRAM_NOTES,
    scene=ROLLER_SCENE,
    arrays=False,
    tracked=False,
    writers={"svg": "dynamics_cli.cam.geometry.animation:animation"},
    pointers={"drawing": "the outline for a machine: dynamics cam export … --drawing cam.dxf"},
    plot="dynamics_cli.cam.geometry.pictures:profile_picture",
    sheet="dynamics_cli.cam.export.sheet:cam_sheet",
)

SIZE = Task(
    "size",
    "Smallest base circle, best offset or nearest pair, for limits of pressure angle and curvature.",
    Model(
        "extremes of closed forms",
        "dynamics_cli.cam.sizing.size:size",
        source="Flocke's construction of the smallest cam",
        formula="A = max(s′·cot φ₁ − s), B = max(−s′·cot φ₂ − s), e = (A − B)/(cot φ₁ + cot φ₂), "
        "d = A − e·cot φ₁, R = √(d² + e²) − R_r",
        assumptions=(RADIAL, RIGID),
    ),
    headline=(
        "base_radius: base circle radius R_b",
        "offset: offset e",
        "arm_start_angle: arm starts at ψ₀",
        "roller_distance: roller distance",
        "arm_angle: angle between the arms",
        "face_width: face width",
        "largest_pressure_angle: maximum pressure angle α",
        "least_pressure_angle: minimum pressure angle α",
        "least_convex_radius: minimum convex radius ρ",
        "least_concave_radius: minimum concave radius ρ",
        "in_line_base_radius: R_b without offset",
        "binding: decided by",
    ),
    plot="dynamics_cli.cam.geometry.pictures:size_picture",
    examples=(
        f'dynamics cam size --program "{CYCLE}" --follower roller --roller-radius "6 mm" --rise-limit "25 deg" '
        '--return-limit "35 deg"',
        f'dynamics cam size --program "{CYCLE}" --follower flat-face --least-radius "4 mm"',
        f'dynamics cam size --program "{SWING}" --follower oscillating-roller --roller-radius "8 mm" --arm "80 mm" '
        '--pivot-distance "100 mm" --rise-limit "40 deg" --return-limit "40 deg"',
        f'dynamics cam size --program "{SWING}" --follower oscillating-flat --pivot-distance "90 mm" '
        '--face-offset "4 mm" --least-radius "5 mm"',
        f'dynamics cam size --program "{CYCLE}" --follower conjugate-roller --roller-radius "6 mm" '
        '--least-radius "10 mm"',
    ),
    notes=PROGRAM_NOTES,
    scene={**PROGRAM_SCENE, "follower": "roller", "roller_radius": "8 mm"},
    arrays=False,
    cost=8e-3,
    tracked=False,
)

CHECK = Task(
    "check",
    "Certified verdicts: undercut and the lift lost to it, pressure angle, curvature, face width, jump.",
    Model(
        "extremes of every piece of every law",
        "dynamics_cli.cam.forces.check:check",
        source=BOOK,
        formula="undercut where w·(1 − R_r·κ) ≤ 0 or the curve crosses itself; "
        "lift lost = s − (lift resting on the corner left); ω² = min k·(s + δ)/(−m·s″)",
        assumptions=(RADIAL, RIGID),
        method="Chebyshev proxies; crossings of the envelope by halving and Newton",
    ),
    headline=(
        "fits: within all limits",
        "binding: limits exceeded",
        "undercut",
        "lift_lost: lift lost to undercut",
        "swing_lost: swing lost to undercut",
        "largest_pressure_angle: maximum pressure angle α",
        "least_pressure_angle: minimum pressure angle α",
        "least_convex_radius: minimum convex radius ρ",
        "least_concave_radius: minimum concave radius ρ",
        "face_width: face width touched",
        "jump_speed: jump speed n",
    ),
    plot="dynamics_cli.cam.geometry.pictures:check_picture",
    examples=(
        f'dynamics cam check --program "{CYCLE}" --follower roller --base-radius "25 mm" --roller-radius "6 mm" '
        '--least-radius "10 mm"',
        f'dynamics cam check --program "{STEEP}" --follower roller --base-radius "15 mm" --roller-radius "15 mm"',
        f'dynamics cam check --program "{CYCLE}" --follower flat-face --base-radius "45 mm" --face-width "25 mm" '
        '--mass "0.2 kg" --spring-rate "20 N/mm" --preload "100 N" --shaft-speed "1500 rpm"',
    ),
    notes=PROGRAM_NOTES,
    scene=ROLLER_SCENE,
    arrays=False,
    cost=5e-3,
    tracked=False,
)

EXPORT = Task(
    "export",
    "The cam as arcs, splines or points for a machine, with a proved deviation from the exact curve.",
    Model(
        "fewest pieces within a proved tolerance",
        "dynamics_cli.cam.export.export:export",
        source="curve and pieces paired on cells, interval arithmetic on the exact envelope",
        formula="|e| ≤ max(|e₀|, |e₁|) + w²/8·(max|z″| + max|b″|·(Δt/w)²) on every cell",
        assumptions=(RADIAL, "pieces end at every joint of the laws"),
        method="biarcs or cubics, equal errors; deviation proved by interval arithmetic",
    ),
    examples=(
        f'dynamics cam export --program "{CYCLE}" --follower roller --base-radius "25 mm" --roller-radius "6 mm" '
        '--tolerance "1 um" --points 12',
        f'dynamics cam export --program "{CYCLE}" --follower roller --base-radius "25 mm" --roller-radius "6 mm" '
        '--form cubics --curve cutter --cutter-radius "10 mm" --points 12',
    ),
    headline=(
        "deviation: proved deviation",
        "tolerance",
        "pieces: pieces of the curve",
    ),
    table="points",
    notes=PROGRAM_NOTES,
    scene=ROLLER_SCENE,
    arrays=False,
    unspread=("deviation", "pieces"),
    tracked=False,
    writers={
        "polar": "dynamics_cli.cam.export.writers:polar",
        "st": "dynamics_cli.cam.export.writers:codesys",
        "mc": "dynamics_cli.cam.export.writers:twincat",
    },
    sheet="dynamics_cli.cam.export.sheet:cam_sheet",
)

TASKS: "tuple[Task, ...]" = (PROFILE, SIZE, CHECK, EXPORT)
