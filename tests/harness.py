"""Runs the program in this process, with standard streams of its own."""

import io
import json
import os
from dataclasses import dataclass
from typing import Any

from dynamics_cli import cli
from dynamics_cli.core.terminal import Terminal

# As the program starts itself: sums depend on it in their last bits, and threads on busy cores cost what they save.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")


@dataclass
class Outcome:
    status: int
    out: str
    err: str

    @property
    def document(self) -> dict[str, Any]:
        return json.loads(self.out)

    @property
    def error(self) -> dict[str, Any]:
        return json.loads(self.err)["error"]


def run(*argv: str, stdin: bytes | str = b"", route: str = "", env: dict[str, str] | None = None) -> Outcome:
    """One call; `route="tree"` forces it through typer."""
    data = stdin.encode() if isinstance(stdin, str) else stdin
    environ = dict(env or {})
    if route:
        environ[cli.ROUTE_VARIABLE] = route
    out, err = io.BytesIO(), io.BytesIO()
    status = cli.run_argv(list(argv), Terminal(io.BytesIO(data), out, err, environ))
    return Outcome(status, out.getvalue().decode(), err.getvalue().decode())


def answer(*argv: str, **more: Any) -> dict[str, Any]:
    """The document of a call that must succeed."""
    outcome = run(*argv, "--json", **more)
    assert outcome.status == 0, outcome.err
    return outcome.document
