"""Runs shell lines with `dynamics` on the path, as a user would."""

import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]


def shell(command: str, folder: Path, bin_folder: Path, package: Path = ROOT) -> subprocess.CompletedProcess[str]:
    """One line of sh, in `folder`; `package` is where dynamics_cli is."""
    program = bin_folder / "dynamics"
    if not program.exists():
        program.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m dynamics_cli "$@"\n')
        program.chmod(0o755)
    env = {
        **os.environ,
        "PATH": f"{bin_folder}{os.pathsep}{os.environ['PATH']}",
        "PYTHONPATH": f"{package}{os.pathsep}{os.environ.get('PYTHONPATH', '')}",
    }
    for name in ("DYNAMICS_FORMAT", "DYNAMICS_GRAVITY", "DYNAMICS_UNITS", "DYNAMICS_DIGITS", "DYNAMICS_ROUTE"):
        env.pop(name, None)
    return subprocess.run(["sh", "-c", command], cwd=folder, env=env, capture_output=True, text=True, check=False)
