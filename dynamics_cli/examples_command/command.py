"""`dynamics examples`: lists the worked examples, shows one, copies one."""

import os
from pathlib import Path

from dynamics_cli.core.output.files import Files
from dynamics_cli.core.output.wrapping import wrapped
from dynamics_cli.core.units.near_names import nearest_words
from dynamics_cli.errors import OutputError, UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from dynamics_cli.core.answering.task import Family
    from dynamics_cli.core.terminal import Terminal


class Example:
    """One worked example: its name, a line, how to run it, and its files, relative to the folder of all examples."""

    def __init__(self, name: str, line: str, run: str, *files: str) -> None:
        self.name = name
        self.line = line
        self.run = run
        self.files = files


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
        "pump_balance",
        "A pump balanced in two planes from trial weights; corrections split between holes; its grade.",
        "cd pump_balance && sh pump_balance.sh",
        "pump_balance/pump_balance.sh",
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


def names() -> "list[str]":
    """The names, for completion."""
    return [example.name for example in WORKED]


def carry_out(
    words: "Sequence[str]",
    options: "Mapping[str, str]",
    families: "Mapping[str, tuple[str, str]]",
    find: "Callable[[str], Family]",
    terminal: "Terminal",
) -> None:
    """List the examples, show one, or copy one."""
    if len(words) > 1:
        raise UsageError(f"unexpected word {words[1]!r}", code="unexpected", hint="name one example")
    if not words:
        if options.get("copy"):
            raise UsageError("the name of the example is missing", code="missing", hint="see: dynamics examples")
        terminal.write(_listed(min(terminal.columns or 80, 80)))
        return
    example = _named(words[0])
    if options.get("copy"):
        _copy(example, terminal)
    else:
        files = wrapped(", ".join(example.files), 72, 0)
        lines = [example.line, "", f"files  {files[0]}", *(f"       {line}" for line in files[1:])]
        terminal.write("\n".join([*lines, f"copy   dynamics examples {example.name} --copy", _run(example), ""]))


def _run(example: Example) -> str:
    return f"run    {example.run}"


def _listed(width: int) -> str:
    column = max(len(name) for name in names()) + 2
    lines = []
    for example in WORKED:
        first, *others = wrapped(example.line, width - column, 0)
        lines += [f"{example.name:<{column}}{first}", *(" " * column + line for line in others)]
    return "\n".join([*lines, "", "One of them: dynamics examples crash; copy it: dynamics examples crash --copy", ""])


def _named(word: str) -> Example:
    wanted = os.path.basename(word)
    for example in WORKED:
        if word == example.name:
            return example
    # By the name of a file, the smallest example that holds it.
    holders = [example for example in WORKED if wanted in map(os.path.basename, example.files)]
    if holders:
        return min(holders, key=lambda example: len(example.files))
    near = nearest_words(word, names())
    hint = f"did you mean {' or '.join(near)}?" if near else "see: dynamics examples"
    raise UsageError(f"there is no example {word!r}", code="unknown-example", hint=hint)


def folder() -> Path:
    """Where the examples are: in the package, or beside it in a checkout."""
    package = Path(__file__).resolve().parents[1]
    return next((path for path in (package / "examples", package.parent / "examples") if path.is_dir()), package)


def _copy(example: Example, terminal: "Terminal") -> None:
    """Write the files of an example, all or none."""
    there = [name for name in example.files if os.path.lexists(name)]
    if there:
        hint = "move it away, or copy the example in another folder"
        raise OutputError(f"{', '.join(there)} exists: nothing is written", code="exists", hint=hint)
    try:
        contents = [(name, (folder() / name).read_bytes(), "copy") for name in example.files]
        for name in example.files:
            os.makedirs(os.path.dirname(name) or ".", exist_ok=True)
    except OSError as error:
        raise OutputError(f"cannot copy {example.name}: {error.strerror or error}") from None
    with Files(contents):
        pass
    terminal.write("".join(f"{name}\n" for name in example.files))
    terminal.tell(f"{_run(example)}\n")
