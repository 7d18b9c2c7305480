#!/bin/sh
# A flywheel from a scene and a connecting rod from a scene and an STL file, to a simulator's URDF; what both weigh.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
dynamics inertia body ../flywheel.toml --about hub --shaft-direction 0,0,1 \
    --drawing "$work/flywheel.urdf" --json > "$work/flywheel.json"
dynamics inertia body rod.toml --drawing "$work/rod.urdf" --json > "$work/rod.json"
for part in flywheel rod; do
    jq -r --arg part "$part" '"\($part): \(.results.mass.value * 1000 | round / 1000) \(.results.mass.unit), " +
        "moments \(.results.principal_moments | [.first, .second, .third] | map(.value | tostring | .[0:9]) | join(", ")) kg·m²"' "$work/$part.json"
done
jq -r '"the flywheel about its shaft: WR² \(.results.shaft.wr2.value * 100 | round / 100) \(.results.shaft.wr2.unit)"' "$work/flywheel.json"
cat "$work/rod.urdf"
