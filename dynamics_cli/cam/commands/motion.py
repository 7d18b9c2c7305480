"""Tasks of `dynamics cam`: motion."""

from dynamics_cli.core.task import Task  # noqa: TC001

TASKS: "tuple[Task, ...]" = ()
