"""Tasks of `dynamics gear`: trains."""

from dynamics_cli.core.task import Task  # noqa: TC001

TASKS: "tuple[Task, ...]" = ()
