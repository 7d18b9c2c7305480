#!/bin/sh
# Why a phone that is tossed up end over end comes down on its other side: turning about the axis of middle moment is
# unstable. Then the same body spun about its length and its thickness, which hold.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

dynamics inertia body phone.toml --output "$work/phone.json"
moments=$(jq -r '[.results.principal_moments[].value] | map(tostring) | join(", ")' "$work/phone.json")
unit=$(jq -r '.results.principal_moments.first.unit' "$work/phone.json")

# two turns a second; a wobble of 0.2 rad/s is what a good toss has
for axis in "12.6, 0.2, 0.2" "0.2, 12.6, 0.2" "0.2, 0.2, 12.6"; do
    echo "tossed with $axis rad/s about length, width and thickness"
    dynamics spin free --moments "$moments $unit" --angular-velocity "$axis rad/s" -q | head -6
done

echo "the middle axis: how fast a wobble grows, in which time it is ten times as large, when it turns over"
dynamics spin free --moments "$moments $unit" --angular-velocity "0.2, 12.6, 0.2 rad/s" --json |
    jq -r '"\(.results.growth.value * 100 | round / 100) 1/s, \(2.302585 / .results.growth.value * 100 | round / 100) s, half a period \(.results.period.value * 50 | round / 100) s"'
