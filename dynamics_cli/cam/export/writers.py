"""Files of a cam's tables: polar tables for CNC, CODESYS cams, and point lists for TwinCAT."""

from math import degrees

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.cam.export.records import CamExport


def polar(cam: "CamExport") -> str:
    """A polar table: angle in degrees and radius in millimetres, in order of cam angle, for a rotary table or a CMM.

    Returns lines of cam angle, polar angle and radius, separated by spaces.
    """
    arrays = cam.points.arrays
    lines = [
        "; exact points of the curve: cam angle [deg], polar angle [deg], radius [mm]",
        f"; {len(cam.points)} points",
    ]
    turn = 360.0 / len(cam.points)
    for number, (angle, radius) in enumerate(
        zip(arrays["polar_angle"].tolist(), arrays["radius"].tolist(), strict=True)
    ):
        lines.append(f"{number * turn:.9f} {degrees(angle):.9f} {1e3 * radius:.9f}")
    return "\n".join(lines) + "\n"


def _rows(cam: "CamExport") -> "tuple[list[tuple[float, float, float, float]], str]":
    """Master in degrees; slave, velocity and acceleration in millimetres or degrees per degree."""
    if cam.lifts is not None:
        columns, key, scale, unit = cam.lifts.arrays, "lift", 1e3, "mm"
    else:
        columns, key, scale, unit = cam.swings.arrays, "swing", degrees(1.0), "deg"  # type: ignore[union-attr]
    per = degrees(1.0)
    last = len(columns["cam_angle"]) - 1
    rows = [
        (360.0 * number / last, scale * lift, scale * velocity / per, scale * acceleration / (per * per))
        for number, (lift, velocity, acceleration) in enumerate(
            zip(columns[key].tolist(), columns["velocity"].tolist(), columns["acceleration"].tolist(), strict=True)
        )
    ]
    return rows, unit


def codesys(cam: "CamExport") -> str:
    """A CODESYS SoftMotion cam in structured text: an array of SMC_CAMXYVA and its MC_CAM_REF.

    Returns structured text of a global variable list.
    """
    rows, unit = _rows(cam)
    points = ",\n".join(
        f"        (dX := {_number(x)}, dY := {_number(y)}, dV := {_number(v)}, dA := {_number(a)})"
        for x, y, v, a in rows
    )
    return (
        f"(* master in deg, slave in {unit}, velocities and accelerations per deg *)\n"
        "VAR_GLOBAL\n"
        f"    CamPoints : ARRAY[0..{len(rows) - 1}] OF SMC_CAMXYVA := [\n{points}\n    ];\n"
        f"    Cam : MC_CAM_REF := (nElements := {len(rows)}, byType := 3, xStart := {_number(rows[0][0])}, "
        f"xEnd := {_number(rows[-1][0])}, byVarType := 6, pce := ADR(CamPoints));\n"
        "END_VAR\n"
    )


def twincat(cam: "CamExport") -> str:
    """A point list for TwinCAT: master position, slave position, velocity and acceleration, separated by semicolons.

    Returns a header and a line for each point.
    """
    rows, unit = _rows(cam)
    head = f"MasterPos [deg];SlavePos [{unit}];SlaveVelo [{unit}/deg];SlaveAcc [{unit}/deg^2]"
    return "\n".join([head, *(";".join(map(_number, row)) for row in rows)]) + "\n"


def _number(value: float) -> str:
    """The shortest text of a double, always with a point, as controllers read reals."""
    text = repr(value + 0.0)
    return text if "." in text or "e" in text else text + ".0"
