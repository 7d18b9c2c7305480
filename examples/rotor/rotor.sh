#!/bin/sh
# A flywheel from a scene and a connecting rod from a scene and an STL file, to a simulator's URDF; what both weigh.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The flywheel's inertia is wanted about its shaft, the rod's about its mass centre.
dynamics inertia body ../flywheel.toml --about hub --shaft-direction 0,0,1 \
    --drawing "$work/flywheel.urdf" --json > "$work/flywheel.json"
dynamics inertia body rod.toml --drawing "$work/rod.urdf" --json > "$work/rod.json"

for part in flywheel rod; do
    # kg·m² are large for small parts: shown in kg·cm².
    jq -r --arg part "$part" '"\($part): \(.results.mass.value * 1000 | round / 1000) \(.results.mass.unit), " +
        "principal moments \(.results.principal_moments | [.first, .second, .third] | map(.value * 1e7 | round / 1000 | tostring) | join(", ")) kg·cm²"' "$work/$part.json"
done
jq -r '"the flywheel about its shaft: WR² \(.results.shaft.wr2.value * 100 | round / 100) \(.results.shaft.wr2.unit)"' "$work/flywheel.json"

# What goes into the simulator's model of the rod.
cat "$work/rod.urdf"
