#!/bin/sh
# A car's tailgate on a gas strut: where it stays by itself, how it opens from a push, and a stronger damper.
set -eu

echo "where it stands still"
dynamics motion equilibrium tailgate.toml --only places

echo "let go at -60 degrees: three seconds"
dynamics motion scene tailgate.toml --duration "3 s" -q

echo "its angle on the way"
dynamics motion scene tailgate.toml --duration "3 s" --follow gate --steps 6 --table motion
