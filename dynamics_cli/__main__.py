"""The program as a process: `python -m dynamics_cli`, and the `dynamics` command."""

from dynamics_cli.core.termination import leave_quietly

# Before anything else is imported, so that Ctrl-C shows no traceback however early it comes.
leave_quietly()

import gc  # noqa: E402

# Objects created during a start stay: searching them for cycles a dozen times takes a tenth of a plain call.
gc.set_threshold(50_000)

from dynamics_cli.cli import script  # noqa: E402

if __name__ == "__main__":
    script()
