"""The program as a process: `python -m dynamics_cli`, and the `dynamics` command."""

import gc

from dynamics_cli.core import quick_import

quick_import.install()
# What a start makes, stays: to look it through for cycles a dozen times would take a tenth of a plain call.
gc.set_threshold(50_000)

from dynamics_cli.core.termination import leave_quietly  # noqa: E402

# Before anything else is imported, so that Ctrl-C shows no traceback however early it comes.
leave_quietly()

from dynamics_cli.cli import script  # noqa: E402

if __name__ == "__main__":
    script()
