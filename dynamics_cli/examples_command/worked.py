"""The worked examples that ship with the program, and how each is run."""


class Example:
    """One worked example: its name, a line, how to run it, and its files, relative to the folder of all examples."""

    def __init__(self, name: str, line: str, run: str, *files: str) -> None:
        self.name = name
        self.line = line
        self.run = run
        self.files = files


GATE = ("tailgate/tailgate.sh", "tailgate/tailgate.toml")
CRANE = ("swing_crane/swing_crane.sh", "swing_crane/swing_crane.toml", "swing_crane/four_bar.toml")
SLEIGH = ("sleigh/sleigh.sh", "sleigh/sleigh.toml")
ROD = ("sliding_rod/sliding_rod.sh", "sliding_rod/sliding_rod.toml")
WORKED = (
    Example(
        "crash",
        "Two cars at a crossing: from skids after the impact back to the speed before it; report.",
        "cd crash && sh crash.sh",
        "crash/crash.sh",
        "crash/first_after.toml",
        "crash/second_after.toml",
    ),
    Example(
        "crash_scene",
        "The same crash as one scene file: one road, one friction, one model.",
        "dynamics impact crash crash_scene/crash.toml",
        "crash_scene/crash.toml",
    ),
    Example(
        "slide",
        "A car that turned to rest on a jammed wheel: its motion at the separation, and the crash with it.",
        "cd slide && sh slide.sh",
        "slide/slide.sh",
        "slide/turned.toml",
    ),
    Example(
        "recorder",
        "A recorder's five seconds and pulse: speed, ΔV with the turn taken out, the other vehicle.",
        "cd recorder && sh recorder.sh",
        "recorder/recorder.sh",
    ),
    Example(
        "exit_motion",
        "Approach speeds from exit motion with spins, and from rest positions alone.",
        "cd exit_motion && sh exit_motion.sh",
        "exit_motion/exit_motion.sh",
        "exit_motion/cars.toml",
        "exit_motion/rests.toml",
    ),
    Example("crash_momentum", "The same in two steps, in a few lines.", "sh crash_momentum.sh", "crash_momentum.sh"),
    Example(
        "skid_chain",
        "One skid over two surfaces that ends at a wall, against a limit.",
        "sh skid_chain.sh",
        "skid_chain.sh",
        "approach.toml",
    ),
    Example("cases", "Skids in a CSV file, answered row by row; one bad row.", "sh cases.sh", "cases.sh", "cases.csv"),
    Example(
        "friction_log",
        "100,000 test skids to coefficients of friction, summarised in SQL.",
        "cd friction_log && sh friction_log.sh",
        "friction_log/friction_log.sh",
    ),
    Example(
        "lifting",
        "A worker lifts a box: mass centre, joint moments, compression of the back and how sure it is.",
        "cd lifting && sh lifting.sh",
        "lifting/lifting.sh",
        "lifting/worker.toml",
        "lifting/centres.csv",
    ),
    Example(
        "stride",
        "Joint moments of a leg at one instant, and over the stance of a stride with a force plate.",
        "dynamics human limb --input stride/stance.toml",
        "stride/stance.toml",
        "stride/stride.csv",
    ),
    Example(
        "pump_balance",
        "A pump balanced in two planes from trial weights; corrections split between holes; its grade.",
        "cd pump_balance && sh pump_balance.sh",
        "pump_balance/pump_balance.sh",
    ),
    Example(
        "three_cylinders",
        "An in-line engine of three cylinders: couples by order, its counterweights and balance shaft.",
        "cd three_cylinders && sh three_cylinders.sh",
        "three_cylinders/three_cylinders.sh",
    ),
    Example(
        "engine_torque",
        "A four-cylinder engine: forces by order, turning moment from a pressure diagram, its flywheel.",
        "cd engine_torque && sh engine_torque.sh",
        "engine_torque/engine_torque.sh",
        "engine_torque/diagram.csv",
    ),
    Example(
        "tumbling_phone",
        "Why a tossed phone turns over: free turning about its three axes, the growth of a wobble.",
        "cd tumbling_phone && sh tumbling_phone.sh",
        "tumbling_phone/tumbling_phone.sh",
        "tumbling_phone/phone.toml",
    ),
    Example(
        "machine_mounts",
        "A fan on mounts: isolation, unbalance, a shock of the floor, the block below.",
        "cd machine_mounts && sh machine_mounts.sh",
        "machine_mounts/machine_mounts.sh",
    ),
    Example(
        "shaft_line",
        "Motor, gearbox and drum: torsional frequencies, critical speeds; inertias from shapes.",
        "cd shaft_line && sh shaft_line.sh",
        "shaft_line/shaft_line.sh",
    ),
    Example(
        "pid_loop",
        "A position loop with a PI controller: stable gains, ranges of its coefficients, and the delay it bears.",
        "cd pid_loop && sh pid_loop.sh",
        "pid_loop/pid_loop.sh",
    ),
    Example(
        "bracket_loads",
        "A wall bracket with three loads: their resultant, the moment on the bolts, and a stay in place of the bolts.",
        "cd bracket_loads && sh bracket_loads.sh",
        "bracket_loads/bracket_loads.sh",
        "bracket_loads/bracket.toml",
        "bracket_loads/loads.csv",
    ),
    Example(
        "catapult",
        "A shot at a wall: both angles, what drag and wind do to it, and the swing of the arm.",
        "cd catapult && sh catapult.sh",
        "catapult/catapult.sh",
    ),
    Example(
        "triple_pendulum",
        "Three rods let go: a swing that can be followed, a small one, and one with its horizon.",
        "cd triple_pendulum && sh triple_pendulum.sh",
        "triple_pendulum/triple_pendulum.sh",
    ),
    Example("tailgate", "Where a tailgate rests, and how it opens.", "cd tailgate && sh tailgate.sh", *GATE),
    Example(
        "swing_crane",
        "A crane slews with a load: joint forces in space.",
        "cd swing_crane && sh swing_crane.sh",
        *CRANE,
    ),
    Example("sleigh", "A sleigh on a knife edge: equations of motion.", "cd sleigh && sh sleigh.sh", *SLEIGH),
    Example("sliding_rod", "A rod on a sliding pin: equations of motion.", "cd sliding_rod && sh sliding_rod.sh", *ROD),
    Example(
        "pedestrian",
        "A child runs out from behind a van: time and distance, sight, and what would have sufficed.",
        "cd pedestrian && sh pedestrian.sh",
        "pedestrian/pedestrian.sh",
        "pedestrian/car.toml",
        "pedestrian/parties.toml",
    ),
    Example(
        "rollover",
        "A car yaws off the road, trips in the verge and rolls: speeds from the surveyed mark and from the rolling.",
        "cd rollover && sh rollover.sh",
        "rollover/rollover.sh",
        "rollover/car.toml",
        "rollover/mark.toml",
    ),
    Example(
        "near_miss",
        "Two recorded tracks: how close they came, when, and the closing speed.",
        "cd near_miss && dynamics path relative --first-track car.csv --second-track van.csv",
        "near_miss/car.csv",
        "near_miss/van.csv",
    ),
    Example(
        "gps_track",
        "A GPS track of a car to its accelerations, with their noise; the radius of a bend.",
        "cd gps_track && sh gps_track.sh",
        "gps_track/gps_track.sh",
        "gps_track/track.csv",
    ),
    Example(
        "corner_strike",
        "A car strikes the corner of another: a scene for impact solve.",
        "dynamics impact solve corner_strike.toml",
        "corner_strike.toml",
    ),
    Example(
        "thrown_block",
        "A block hits the floor with a corner: an impact in space.",
        "dynamics impact solve thrown_block.toml",
        "thrown_block.toml",
    ),
    Example(
        "wiper",
        "A windscreen wiper: a four-bar for its swing, the motor's torque.",
        "cd wiper && sh wiper.sh",
        "wiper/wiper.sh",
    ),
    Example(
        "six_bar",
        "A six-bar linkage: every pin's motion from a scene.",
        "dynamics linkage solve six_bar.toml",
        "six_bar.toml",
    ),
    Example(
        "scara",
        "A SCARA arm: both postures that bring its gripper to a place.",
        'dynamics robot inverse scara.toml --position "300, 350, 320 mm" --hand-angle "45 deg"',
        "scara.toml",
    ),
    Example(
        "peaucellier",
        "Peaucellier's cell: a linkage that draws an exact straight line.",
        "dynamics linkage solve peaucellier.toml --follow Q --steps 12",
        "peaucellier.toml",
    ),
    Example(
        "oldham",
        "An Oldham coupling: a disc sliding in slots that turn with their shafts.",
        "dynamics linkage solve oldham.toml --follow C --steps 8",
        "oldham.toml",
    ),
    Example(
        "flywheel",
        "A flywheel with holes and a keyway: an assembly of shapes.",
        "dynamics inertia body flywheel.toml --about hub",
        "flywheel.toml",
    ),
    Example(
        "payload",
        "Weighed, measured and computed parts with standard uncertainties.",
        "dynamics inertia body payload.toml --about origin",
        "payload.toml",
    ),
    Example(
        "rotor",
        "A flywheel and a rod with a mesh, written as URDF for a simulator.",
        "cd rotor && sh rotor.sh",
        "rotor/rotor.sh",
        "rotor/rod.toml",
        "flywheel.toml",
        "bracket.stl",
    ),
    Example(
        "bracket",
        "A bracket as triangles (STL).",
        "dynamics inertia mesh bracket.stl --length-unit mm --material aluminium",
        "bracket.stl",
    ),
    Example(
        "channel",
        "A channel section with a stiffener and a hole.",
        "dynamics inertia section channel.toml",
        "channel.toml",
    ),
    Example(
        "compare_plates",
        "A plate before and after two bores.",
        "dynamics inertia compare compare_plates.toml",
        "compare_plates.toml",
    ),
    Example(
        "crane",
        "A crane's hoist rope: wrap, fleet angle, force on the sheave, clearance.",
        "cd crane && sh crane.sh",
        "crane/crane.sh",
    ),
    Example(
        "cam",
        "A cam that rises, dwells and returns in three steps.",
        'dynamics cam motion cam.toml --shaft-speed "1000 rpm"',
        "cam.toml",
    ),
    Example(
        "lifts",
        "A cam from a table of angles and lifts, one row every five degrees.",
        "dynamics cam motion --lifts lifts.csv",
        "lifts.csv",
    ),
    Example(
        "valve",
        "A valve cam: smallest size, check, forces at speed, DXF.",
        "cd valve && sh valve.sh",
        "valve/valve.sh",
        "valve/valve.toml",
    ),
    Example(
        "gearbox",
        "Two stages: tooth numbers, shifts, forces, spans to measure, DXF.",
        "cd gearbox && sh gearbox.sh",
        "gearbox/gearbox.sh",
    ),
    Example(
        "ravigneaux",
        "A Ravigneaux planetary set in first gear, as meshes.",
        "dynamics gear train --input ravigneaux.toml",
        "ravigneaux.toml",
    ),
    Example(
        "imu",
        "An IMU's quaternion log to roll, pitch, yaw; the turn between two readings.",
        "cd imu && sh imu.sh",
        "imu/imu.sh",
        "imu/log.csv",
    ),
    Example("units", "A drawing's dimensions in the units of another trade.", "sh units.sh", "units.sh"),
    Example(
        "cleaning",
        "Units as people wrote them, to one unit for each quantity.",
        "cd cleaning && sh cleaning.sh",
        "cleaning/cleaning.sh",
        "cleaning/messy.csv",
    ),
    Example(
        "partitions",
        "A data set in partitions, answered by dask (extra `dask`).",
        "python partitions/dask_rows.py",
        "partitions/dask_rows.py",
    ),
)
