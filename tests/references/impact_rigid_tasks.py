"""The rigid-body tasks of impact that carry tracked numbers, and the records their inputs are made of."""

from references.impact_particles_tasks import CLASSES

from dynamics_cli.impact import bodies, laws, planar, springs

TASKS = {"planar": planar.planar}
# both halves of the family build their inputs from one table of classes
CLASSES.update(
    {name: one for module in (bodies, laws, springs) for name, one in vars(module).items() if isinstance(one, type)}
)
