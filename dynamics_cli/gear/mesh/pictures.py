"""A mesh of two exact profiles: the teeth about the pitch point, and the results."""

from math import cos

from dynamics_cli.errors import worded
from dynamics_cli.gear.section import contact_panel, contact_points, meshing, sizes
from dynamics_cli.numerics.number import over_plain
from dynamics_cli.pictures import Panel, Picture
from dynamics_cli.quantities import Angle, Coordinate, Module, Ratio, Size

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.gear.mesh.mesh import MeshProof

# An error below this is rounding: an angle [rad], or a share of the centre distance.
EXACT = 1e-12


def mesh_picture(result: "MeshProof", **inputs: "Any") -> Picture:
    """Both profiles about the pitch point with the path of contact, and the results."""
    from dynamics_cli.gear.mesh.mesh import NOT_OF_GEARS, forms_of, mesh

    every = {**(mesh.__kwdefaults__ or {}), **inputs}
    forms = forms_of(**{name: every[name] for name in every if name not in NOT_OF_GEARS})
    first, second = (over_plain(form) for form in forms)
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
    return Picture(
        (panel, _table(result)),
        title,
        columns=2,
        subtitle="Exact profiles in the transverse section; pitch circles dash-dotted, base circles dotted",
    )


def _table(result: "MeshProof") -> Panel:
    """The results, what is only rounding as zero."""
    noise = EXACT * float(result.centre_distance)

    def gap(value: "float | None") -> "float | None":
        return 0.0 if value is not None and abs(value) <= noise else value

    error = float(result.transmission_error)
    return sizes(
        ("centre distance", "a_w", result.centre_distance, Size),
        ("working pressure angle", "α_wt", result.working_pressure_angle, Angle),
        ("contact ratio", "ε_α", result.contact_ratio, Ratio),
        ("transmission error", "", 0.0 if error < EXACT else error, Angle),
        ("normal backlash", "j_bn", gap(result.backlash), Coordinate),
        ("tip of gear 1 to root of gear 2", "", gap(result.first_in_second), Coordinate),
        ("tip of gear 2 to root of gear 1", "", gap(result.second_in_first), Coordinate),
        ("runs freely", "", "yes" if result.runs else "no", None),
        wide=True,
    )
