"""The families: the one list that the command line, help, accuracy, import contracts and documents read."""

# The trades that families are listed by in `dynamics --help`, in this order.
GROUPS = (
    "Units and coordinates", "Crash reconstruction", "Bodies", "Kinematics", "Machine parts", "Machine dynamics",
    "About the program",
)  # fmt: skip


class Entry:
    """One family: the module of its tasks, its trade, a line of help, and where its accuracy is judged.

    `references` are files of reference cases under `accuracy/data`, whose cases bear the names of the tasks' functions:
    that is enough to judge the program's own methods. `questions` is the module of alternatives to them.
    """

    __slots__ = ("group", "module", "questions", "references", "summary")

    def __init__(
        self, module: str, group: str, summary: str, *, references: "tuple[str, ...]" = (), questions: str = ""
    ) -> None:
        self.module = module
        self.group = group
        self.summary = summary
        self.references = references
        self.questions = questions


FAMILIES: "dict[str, Entry]" = {
    "convert": Entry(
        "dynamics_cli.convert.commands",
        GROUPS[0],
        "Convert a quantity to other units, exactly.",
        questions="dynamics_cli.accuracy.alternatives.convert",
    ),
    "units": Entry("dynamics_cli.convert.commands", GROUPS[0], "List, show and search units; the book's table."),
    "coords": Entry(
        "dynamics_cli.convert.commands",
        GROUPS[0],
        "Cartesian, cylindrical and spherical coordinates.",
        questions="dynamics_cli.accuracy.alternatives.coords",
    ),
    "skid": Entry(
        "dynamics_cli.skid.commands",
        GROUPS[1],
        "Speeds and distances from skids, yaw marks, vaults, braking.",
        references=("skid.json",),
        questions="dynamics_cli.accuracy.alternatives.skid",
    ),
    "impact": Entry(
        "dynamics_cli.impact.commands",
        GROUPS[1],
        "Impacts, from two balls to a two-car crash with friction.",
        references=("impact_particles.json", "impact_rigid.json", "impact_spatial.json"),
        questions="dynamics_cli.accuracy.alternatives.impact.questions",
    ),
    "inertia": Entry(
        "dynamics_cli.inertia.commands",
        GROUPS[2],
        "Mass properties of shapes, assemblies, sections, meshes.",
        references=("inertia_bodies.json",),
        questions="dynamics_cli.accuracy.alternatives.inertia.questions",
    ),
    "vec": Entry(
        "dynamics_cli.vec.commands",
        GROUPS[3],
        "Vectors: sums, angles, products, components, frames, lines.",
        references=("vec.json",),
        questions="dynamics_cli.accuracy.alternatives.vec",
    ),
    "path": Entry(
        "dynamics_cli.path.commands",
        GROUPS[3],
        "Motion of a point: straight, on circles and curves, tracks.",
        references=("path.json",),
        questions="dynamics_cli.accuracy.alternatives.path",
    ),
    "orient": Entry(
        "dynamics_cli.orient.commands",
        GROUPS[3],
        "Orientation in every notation, turning motion, rolling.",
        references=("orient.json",),
        questions="dynamics_cli.accuracy.alternatives.orient",
    ),
    "linkage": Entry(
        "dynamics_cli.linkage.commands",
        GROUPS[3],
        "Four-bars, slider-cranks, coupler curves, linkages from scenes.",
        references=("linkage.json",),
        questions="dynamics_cli.accuracy.alternatives.linkage",
    ),
    "cam": Entry(
        "dynamics_cli.cam.commands",
        GROUPS[4],
        "Cam motions, profiles, sizes, forces, files for machines.",
        questions="dynamics_cli.accuracy.alternatives.cam.questions",
    ),
    "gear": Entry(
        "dynamics_cli.gear.commands",
        GROUPS[4],
        "Gear geometry, measurement, pairs, trains and ratios.",
        references=("gear_geometry.json", "gear_trains.json", "gear_meshes.json"),
        questions="dynamics_cli.accuracy.alternatives.gear.questions",
    ),
    "balance": Entry(
        "dynamics_cli.balance.commands",
        GROUPS[5],
        "Balancing of rotors and engines, balance grades, flywheels.",
        references=("rotor_balance.json",),
    ),
    "vibration": Entry(
        "dynamics_cli.vibration.commands",
        GROUPS[5],
        "Vibration of machines, rotors, shafts, beams; shocks, isolation.",
        references=("vibration.json",),
        questions="dynamics_cli.accuracy.alternatives.vibration",
    ),
    "force": Entry(
        "dynamics_cli.force.commands",
        GROUPS[5],
        "Forces: resultants, moments, reactions, springs, friction.",
        references=("force_systems.json",),
    ),
    "energy": Entry(
        "dynamics_cli.energy.commands",
        GROUPS[5],
        "Work, power, kinetic energy, impulse and momentum.",
        references=("energy.json",),
    ),
    "pendulum": Entry(
        "dynamics_cli.pendulum.commands",
        GROUPS[5],
        "Pendulums: periods, forces, turning round, running down.",
        references=("pendulum.json",),
    ),
    "particle": Entry(
        "dynamics_cli.particle.commands",
        GROUPS[5],
        "A particle: flights, falls, tubes, inclines, bends.",
        references=("particle.json",),
    ),
    "motion": Entry(
        "dynamics_cli.motion.commands",
        GROUPS[5],
        "Motion of bodies and chains, how long it is known; equilibrium.",
        references=("motion.json",),
        questions="dynamics_cli.accuracy.alternatives.motion",
    ),
    "multibody": Entry(
        "dynamics_cli.multibody.commands",
        GROUPS[5],
        "Bodies in space on joints: trees, loops, motion, forces.",
        references=("multibody.json",),
    ),
    "spin": Entry(
        "dynamics_cli.spin.commands",
        GROUPS[5],
        "Spinning bodies: gyroscopes, free bodies, tops, disks.",
        references=("spin.json",),
    ),
    "robot": Entry(
        "dynamics_cli.robot.commands",
        GROUPS[5],
        "Robot arms: pose, Jacobian, every inverse, torques.",
        references=("robot.json",),
    ),
    "stability": Entry(
        "dynamics_cli.stability.commands",
        GROUPS[5],
        "Stability: root counts, gains, delays, equilibria.",
        references=("stability_roots.json",),
        questions="dynamics_cli.accuracy.alternatives.stability",
    ),
    "human": Entry(
        "dynamics_cli.human.commands",
        GROUPS[2],
        "The human body: segments, postures, joint moments, gait, falls.",
        references=("human.json",),
    ),
    "accuracy": Entry(
        "dynamics_cli.accuracy.commands", GROUPS[6], "Speed against error of every method, measured here and now."
    ),
}
