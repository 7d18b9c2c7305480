#!/bin/sh
# Speed at a wall, back through gravel and asphalt, against the limit: each step takes the one before as JSON.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

dynamics skid speed --distance "6 m" --friction 0.55 --end-speed "15 km/h" --json > "$work/gravel.json"
dynamics skid speed --distance "22.5 m" --friction 0.72 --end-speed "@$work/gravel.json:speed" --limit "50 km/h" --json |
    jq -r '.results.speed | "\(.value * 10 | round / 10) \(.unit) where the marks begin"'
dynamics skid speed --input approach.toml --limit "50 km/h" --json |
    jq -r '.limits[0].message'
