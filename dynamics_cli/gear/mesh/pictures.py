"""A mesh of two exact profiles: the teeth about the pitch point, and the results."""

from math import cos

from dynamics_cli.errors import worded
from dynamics_cli.gear.rounding import bare
from dynamics_cli.gear.section import contact_panel, contact_points, meshing
from dynamics_cli.pictures import Axis, Panel, Picture, Rows
from dynamics_cli.quantities import Angle, Coordinate, Module, Ratio, Size

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.gear.mesh.mesh import MeshProof

# An error below this is rounding: an angle [rad], or a share of the centre distance.
EXACT = 1e-12


def mesh_picture(result: "MeshProof", **inputs: "Any") -> Picture:
    """Both profiles about the pitch point with the path of contact, and the results."""
    from dynamics_cli.gear.mesh.mesh import forms_of, mesh

    every = {**(mesh.__kwdefaults__ or {}), **inputs}
    forms = forms_of(**{name: every[name] for name in every if name not in ("centre_distance", "points", "shown")})
    first, second = (bare(form) for form in forms)
    angle = float(result.working_pressure_angle)
    radii = first.base / cos(angle), second.base / cos(angle)
    along = result.path.arrays["along"]
    points = [("A", float(along[0])), ("C", 0.0), ("E", float(along[-1]))]
    gears = meshing([first, second], float(result.centre_distance), radii)
    panel = contact_panel(gears, contact_points(points, radii[0], angle), first.module, wide=True)
    title = worded(
        "Mesh of {first} and {second} teeth, module {module:6}",
        first=first.teeth,
        second=second.teeth,
        module=(first.module, Module),
    )
    rows = Panel(Axis(""), Axis(""), (Rows(_rows(result)),), wide=True)
    return Picture(
        (panel, rows),
        title,
        columns=2,
        subtitle="Exact profiles in the transverse section; pitch circles dash-dotted, base circles dotted",
    )


def _rows(result: "MeshProof") -> "tuple[tuple[str, str, str], ...]":
    def row(name: str, symbol: str, value: "Any", kind: "Any") -> "tuple[str, str, str]":
        return name, symbol, worded("{value:5}", value=(float(value), kind))

    error = float(result.transmission_error)
    noise = EXACT * float(result.centre_distance)
    rows = [
        row("centre distance", "a_w", result.centre_distance, Size),
        row("working pressure angle", "α_wt", result.working_pressure_angle, Angle),
        row("contact ratio", "ε_α", result.contact_ratio, Ratio),
        row("transmission error", "", 0.0 if error < EXACT else error, Angle),
        row("normal backlash", "j_bn", _without_noise(result.backlash, noise), Coordinate),
    ]
    gaps = (("1", "2", result.first_in_second), ("2", "1", result.second_in_first))
    rows += [
        row(f"tip of gear {a} to root of gear {b}", "", _without_noise(gap, noise), Coordinate)
        for a, b, gap in gaps
        if gap is not None
    ]
    return (*rows, ("runs freely", "", "yes" if result.runs else "no"))


def _without_noise(value: float, noise: float) -> float:
    return 0.0 if abs(value) <= noise else float(value)
