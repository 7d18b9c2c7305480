"""`python -m dynamics_cli`."""

import sys

from dynamics_cli.cli import main

sys.exit(main())
