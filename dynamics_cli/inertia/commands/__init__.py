"""The tasks of `dynamics inertia`."""

from dynamics_cli.core.answering.task import Family
from dynamics_cli.inertia.commands import bodies, surfaces

FAMILIES = {
    "inertia": Family(
        "inertia",
        "Mass properties and principal axes of shapes, assemblies, sections and meshes.",
        *bodies.TASKS,
        *surfaces.TASKS,
    )
}
