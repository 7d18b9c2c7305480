"""What the manifest says of each file of references: what made it, how, and where its cases come from."""

import re
from typing import Any

SOURCES = {
    "drawn": "drawn at random among ordinary sizes, by the generator, whose seed is fixed",
    "chosen": "chosen by hand among ordinary sizes",
    "published": "a published example, whose source and printed digits stand in tests/validation",
    "limit": "made up for a limit, which the reason names: where a textbook formula loses digits, or a branch changes",
    "search, nearest to its bound": "found by search: the error that comes nearest to the bound that is stated",
    "search, largest error": "found by search: the largest error in units of the last place",
    "search, loosest bound": "found by search: the bound that exceeds its error most",
    "search, nearest to a tie": "found by search: the exact result nearest to the middle between two doubles",
}


class Origin:
    """A file of references.

    `commands` gives the task of the command line where its name is not that of the cases ("" for a family that is one
    task), and is none where no task asks them;
    `drawn` matches the names of ordinary cases that were drawn at random, the others were chosen.
    """

    def __init__(
        self, family: str, commands: "dict[str, str] | None", method: str, working: str, search: str, drawn: str = "",
    ) -> None:  # fmt: skip
        self.family = family
        self.commands = commands
        self.method = method
        self.working = working
        self.search = search
        self.drawn = drawn

    def command(self, task: str) -> str:
        """The task of the command line that cases ask."""
        return "" if self.commands is None else self.commands.get(task, task.replace("_", "-"))

    def source(self, case: dict[str, Any]) -> str:
        """Where a case comes from."""
        why = case.get("why", "")
        if case["name"].startswith("published"):
            return "published"
        if case["kind"] == "ordinary":
            return "drawn" if self.drawn and re.match(self.drawn, case["name"]) else "chosen"
        if not (why.startswith("found by search") or re.search(r"\bfound\b", case["name"])):
            return "limit"
        why = why.partition("nearby:")[0]
        if "from a tie" in why:
            return "search, nearest to a tie"
        if re.search(r"bound of \S+ is [\d.e+]+ times|what it need be", why):
            return "search, loosest bound"
        return "search, nearest to its bound" if "bound" in why else "search, largest error"


BOUNDS = "tests/accuracy/bound_search.py"
INDEPENDENT = "tests/accuracy/independent_search.py"
CAMS, IMPACTS = "tests/accuracy/cam_search.py", "tests/accuracy/impact_search.py"
GEARS, MESHES = "tests/accuracy/gear_search.py", "tests/accuracy/mesh_search.py"
SYSTEMS = ("cartesian", "cylindrical", "spherical")
FILES: dict[str, Origin] = {
    "convert": Origin(
        "convert", {"convert": ""},
        "exact rationals of the units' legal definitions, written down by hand, and π to 60 digits",
        "exact", INDEPENDENT, ".",
    ),
    "coords": Origin(
        "coords", {f"{a}_to_{b}": "" for a in SYSTEMS for b in SYSTEMS if a != b},
        "angles by arc cosines and by the argument of a complex exponential; no arc tangent",
        "up to 1,400 digits", INDEPENDENT, ".",
    ),
    "skid": Origin(
        "skid",
        {"vault_least_speed": "vault", "vault_known_angle": "vault", "pedestrian": "throw"},
        "laws of motion: work and energy marched from surface to surface, angles for slopes, forces for drag factors",
        "60 digits", BOUNDS, ".",
    ),
    "path": Origin(
        "path",
        {"rectilinear_law": "rectilinear", "moving_frame": "moving-frame"},
        "positions as functions of time in fixed axes, differentiated; Gram determinants; roots of polynomials",
        "90 digits", BOUNDS, "drawn|motion",
    ),
    "pendulum": Origin(
        "pendulum", {},
        "periods by hypergeometric series, speeds by energies, forces by Newton's law, cones by the polygon of forces",
        "90 digits", "", "swing|by speed|rod|body",
    ),
    "particle": Origin(
        "particle",
        {"rotating_frame": "rotating-frame"},
        "flights and targets by roots of polynomials, tubes by the exponential of their matrix, slopes by polygons, "
        "turning frames by matrices",
        "90 digits", "", ".",
    ),
    "energy": Origin(
        "energy",
        {"draw_in": "draw-in"},
        "speeds and compressions by roots of polynomials, works by integrals, energies by pairs of bodies",
        "90 digits", "", ".",
    ),
    "rotor_balance": Origin(
        "balance",
        {},
        "unbalances as complex exponentials, corrections by linear equations of forces and moments, orders of engines "
        "by means of the pistons' exact acceleration over a turn",
        "90 digits", "", ".",
    ),
    "stability_roots": Origin(
        "stability", {},
        "roots of the factors one by one, gains by the real axis of p(iω)/q(iω), delays by Newton's method on the "
        "loop, eigenvalues by QR, equilibria with slopes derived by hand",
        "110 digits", "", "drawn",
    ),
    "force_systems": Origin(
        "force",
        {},
        "moments about a far point brought back, axes and reactions by linear equations, tips by moments about edges",
        "90 digits", "", ".",
    ),
    "spin": Origin(
        "spin", {},
        "torques by products of vectors, periods by Legendre's integral, precession by roots of polynomials",
        "90 digits", "", ".",
    ),
    "multibody": Origin(
        "multibody", {"matrix": "mass-matrix"},
        "bodies as seven points with masses, efforts by difference quotients of their places over time and ways, loops "
        "by Lagrange's multipliers",
        "110 digits", "", "tree|.* \\d$",
    ),
    "robot": Origin(
        "robot", {},
        "poses by products of elementary motions, Jacobians by difference quotients, inverses by Newton's method, "
        "torques by Lagrange's equations of energies",
        "130 digits", "", "drawn",
    ),
    "human": Origin(
        "human", {},
        "figures as chains of complex numbers, moments by the change of potential energy, limbs by one sum, falls and "
        "solids by quadrature",
        "60 digits", "", "de Leva 2|leg [123]",
    ),
    "linkage": Origin(
        "linkage",
        {"classify": "class"},
        "angles by the cosine rule, rates by linear loop equations; of double sliders by differentiation over time",
        "60 digits", "", "drawn|\\d links",
    ),
    "inertia_bodies": Origin(
        "inertia", {},
        "shapes by quadrature of patches, assemblies from the origin by the parallel axis theorem, principal moments "
        "by QR",
        "90 digits", BOUNDS, ".",
    ),
    "orient": Origin(
        "orient",
        {"moving_frame": "moving-point"},
        "turns as exponentials of matrices, angles by arc sines and arc cosines, velocities and accelerations as "
        "derivatives of motions, contacts as linear equations",
        "130 digits", "", r"angles|quaternion to|any|matrix in|two dir|Rodrigues|\d+ |apart|turn of|two rates|from",
    ),
    "inertia_mesh": Origin(
        "inertia", {"mesh": "mesh", "large mesh": "mesh", "overlapping mesh": "mesh"},
        "exact rational sums over triangles about the file's origin, areas by square roots, principal moments by QR",
        "exact, then 80 digits", MESHES,
    ),
    "inertia_sections": Origin(
        "inertia", {},
        "triangles from the first corner, each by its corners and centroid; moments by the roots of the matrix",
        "90 digits", INDEPENDENT, "star",
    ),
    "eigen": Origin(
        "inertia", {"eigen": "tensor"},
        "roots of the characteristic cubic, axes across the rows of A − λ·1",
        "400 digits", INDEPENDENT, ".",
    ),
    "impact_particles": Origin(
        "impact", {"momentum_and_energy": "momentum", "approach": "momentum"},
        "linear equations of momentum and restitution, kinetic energies as differences, constraints by multipliers",
        "300 digits", BOUNDS, ".",
    ),
    "impact_rigid": Origin(
        "impact", {"planar": "planar", "path": "planar"},
        "unit impulses give the contact's matrix, the path is followed event by event, energies are differences",
        "120 digits", BOUNDS, ".",
    ),
    "impact_spatial": Origin(
        "impact", {"spatial": "spatial", "keller": "spatial"},
        "Keller's equations by series of the slip's direction and speed, unit impulses give the contact's matrix",
        "63 digits", IMPACTS, ".",
    ),
    "vibration": Origin(
        "vibration",
        {},
        "exponentials of the state matrix, complex steady states, roots of definitions, eigenvalues",
        "120 digits", "", r"drawn",
    ),
    "motion": Origin(
        "motion", {},
        "Lagrange's energies by differences of 150 digits, chains by partial velocities in the plane and extrapolated "
        "midpoints, frequencies by eigenvalues",
        "46 to 150 digits", "", r"drawn",
    ),
    "vec": Origin(
        "vec", {},
        "sums in ratios, angles by arc cosines, the law of cosines, projection by normal equations, Gram–Schmidt, "
        "Cramer's rule",
        "exact, then 400 digits", "", r"drawn",
    ),
    "cam_motion": Origin(
        "cam", {"rise": "rise", "polynomial": "rise", "motion": "motion"},
        "accelerations integrated piece by piece over the whole rise, polynomials from their boundary conditions",
        "200 digits", INDEPENDENT, ".",
    ),
    "cam_geometry": Origin(
        "cam", {"profile": "profile", "size": "size"},
        "envelopes by their definition, by Taylor arithmetic; extremes as roots of derivatives",
        "90 digits", CAMS,
    ),
    "cam_forces": Origin(
        "cam", {},
        "statics of the follower at the envelope's point, by Taylor arithmetic; extremes as roots of derivatives",
        "90 digits", CAMS,
    ),
    "cam_design": Origin(
        "cam", {},
        "corners, losses and smallest sizes as roots of the conditions that define them, all at once",
        "90 digits", CAMS,
    ),
    "cam_found": Origin(
        "cam", {"force": "force", "profile": "profile", "motion": "motion"},
        "the exact side of the search: laws integrated from their accelerations, followers carried round the cam, "
        "statics, extremes climbed from fine samples, plates by Gauss's rule of 40 nodes",
        "70 digits", CAMS,
    ),
    "gear_geometry": Origin(
        "gear",
        {"inv": "involute", "inverse": "involute"},
        "involutes by Newton's method, paths of contact as intersections of circles and a line, cones as "
        "intersections of unit vectors, friction as a balance of forces",
        "80 digits", BOUNDS, r"\w+ [\d.]",
    ),
    "gear_trains": Origin(
        "gear", {"measure": "measure", "root": "profile"},
        "a ball between two helicoids in space, base circles unrolled, envelopes of the rack's corner",
        "60 digits", BOUNDS, ".",
    ),
    "gear_meshes": Origin(
        "gear", {"mesh": "mesh", "identify": "identify", "data_block": "data-block", "profile": "profile"},
        "involutes as roots, roots as envelopes of the rolled rack, distances where curves run along one another, "
        "standard sizes as fractions",
        "72 digits", GEARS, r"\w+ \d",
    ),
    "uncertainty": Origin(
        "uncertainty", None,
        "distribution functions in closed form or as one-dimensional integrals, their roots as quantiles; every number "
        "twice, by rules of other fineness in 48 and 60 digits",
        "48 and 60 digits", "",
    ),
}  # fmt: skip
