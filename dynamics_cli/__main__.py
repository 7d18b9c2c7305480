"""The program as a process: `python -m dynamics_cli`, and the `dynamics` command."""

from dynamics_cli.core.termination import leave_quietly

# Before anything else is imported, so that Ctrl-C shows no traceback however early it comes.
leave_quietly()

from dynamics_cli.cli import script  # noqa: E402

if __name__ == "__main__":
    script()
