#!/bin/sh
# Two skids after the impact give the speeds after; momentum gives the speeds before.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
dynamics skid speed --distance "9.2 m" --friction "0.70 ± 0.04" --json > "$work/first.json"
dynamics skid speed --distance "11.6 m" --friction "0.70 ± 0.04" --braking "80 %" --json > "$work/second.json"
dynamics impact momentum \
    --first-mass "1500 kg" --first-approach-heading "90 deg" \
    --first-exit-speed "@$work/first.json:speed" --first-exit-heading "48 ± 2 deg" \
    --second-mass "1150 kg" --second-approach-heading "0 deg" \
    --second-exit-speed "@$work/second.json:speed" --second-exit-heading "53 ± 2 deg" \
    --axes compass --json |
    jq -r '.results | [.first, .second][] | .approach_speed | "\(.value|floor) km/h, 95 % within \(.interval|map(floor)|join(" to "))"'
