"""Further ways to answer the questions of `dynamics accuracy`, by question: `--peers` measures them in a checkout."""

from dynamics_cli.accuracy.questions import Method

LIBRARIES = (
    Method("uncertainties, first order", "peers.uncertainty.libraries:by_uncertainties", needs="uncertainties"),
    Method("GTC, first order", "peers.uncertainty.libraries:by_gtc", needs="GTC"),
    Method("mcerp, Latin hypercube of 1e4", "peers.uncertainty.libraries:by_mcerp", needs="mcerp"),
)
MESHES = (
    Method("one pass by edges, Jacobi", "peers.inertia.mesh:once"),
    Method("integrals over faces about the mean, LAPACK", "peers.inertia.mesh:by_faces"),
)
MESH_LIBRARIES = (
    Method("trimesh, from arrays", "peers.inertia.mesh:by_trimesh", needs="trimesh"),
    Method("MuJoCo, corners in single precision", "peers.inertia.mesh:by_mujoco", needs="mujoco"),
)
DIFFERENCES = (Method("central differences of the lift", "peers.cam.laws:differences"),)


METHODS: dict[str, tuple[Method, ...]] = {
    "convert": (Method("pint", "peers.convert:by_pint", needs="pint"),),
    "coords, cartesian to spherical": (Method("asin(r/rho)", "peers.coords:arc_sine_spherical"),),
    "skid vault, least speed over all angles": (
        Method("golden sections over the angle", "peers.skid:least_vault_by_search"),
    ),
    "skid spin": (Method("mean sine by degrees", "peers.skid:spin_by_degrees"),),
    "impact drop": (Method("bounce by bounce until it rests", "peers.impact.lines:drop_by_bounces"),),
    "impact planar": (
        Method("the same velocities, then differences", "peers.impact.bodies:planar"),
        Method("pycrash, Kudlich–Slibar without spin before", "peers.impact.bodies:planar_by_pycrash", needs="pycrash"),
    ),
    "mesh moments": MESHES + MESH_LIBRARIES,
    "mesh moments, 32,768 triangles": MESHES + MESH_LIBRARIES,
    "mesh moments, faces that overlap": MESHES,
    "shell moments": MESHES[:1],
    "cam law": (
        *DIFFERENCES,
        Method("mechanism, a table of the turn", "peers.cam.laws:by_mechanism", needs="mechanism"),
    ),
    "cam motion": (Method("angles turned into degrees", "peers.cam.motions:by_degrees"),),
    "cam points": (Method("along the radius", "peers.cam.points:by_radius"),),
    "inverse involute": (
        Method("halving", "peers.gear.involute:bisection"),
        Method("Ridders, bracketed", "peers.gear.involute:ridders"),
        Method("Brent, bracketed", "peers.gear.involute:brent_inverse"),
        Method("scipy brentq", "peers.gear.involute:by_brentq", needs="scipy"),
    ),
    "involute function": (Method("power series, five terms", "peers.gear.involute:power_series"),),
    "gear ratio": (Method("greedy, stage by stage", "peers.gear.ratio:greedy"),),
    "gear pair": (
        Method("py_gearworks, distance only", "peers.gear.geometry:pair_by_py_gearworks", needs="py_gearworks"),
    ),
    "gear mesh": (Method("distances between points, external only", "peers.gear.meshes:mesh_by_polygons"),),
    "uncertainty, smooth": LIBRARIES,
    "uncertainty, bounded": LIBRARIES,
    "uncertainty, kinked or folded": LIBRARIES,
}
