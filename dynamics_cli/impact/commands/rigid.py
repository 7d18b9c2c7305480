"""Tasks of `dynamics impact`: rigid."""

from dynamics_cli.core.task import Task  # noqa: TC001

TASKS: "tuple[Task, ...]" = ()
