#!/bin/sh
# Both cars turned after the impact: approach speeds from the motion after, and from the rest positions alone.
set -eu

echo "from the motion just after, with spins"
dynamics impact inverse --input cars.toml -q

echo "from the rest positions, impact and slides driven forward"
dynamics impact inverse --input rests.toml -q
