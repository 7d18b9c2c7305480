"""The program as a process: `python -m dynamics_cli`, and the `dynamics` command."""

import gc

from dynamics_cli.core.termination import leave_quietly

# Objects created during a start stay: searching them for cycles a dozen times takes a tenth of a plain call.
gc.set_threshold(50_000)

# Before anything else is imported, so that Ctrl-C shows no traceback however early it comes.
leave_quietly()

from dynamics_cli.cli import script  # noqa: E402

if __name__ == "__main__":
    script()
