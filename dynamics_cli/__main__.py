"""`python -m dynamics_cli`."""

from dynamics_cli.cli import script

script()
