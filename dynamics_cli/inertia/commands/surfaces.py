"""Tasks of `dynamics inertia`: surfaces."""

from dynamics_cli.core.task import Task  # noqa: TC001

TASKS: "tuple[Task, ...]" = ()
