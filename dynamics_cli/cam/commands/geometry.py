"""Tasks of `dynamics cam`: geometry."""

from dynamics_cli.core.task import Task  # noqa: TC001

TASKS: "tuple[Task, ...]" = ()
