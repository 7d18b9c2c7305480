#!/bin/sh
# A two-car crash from what was measured on the road: skids after the impact, momentum, the skid before it, the limit.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
dynamics skid speed --input first_after.toml --json > "$work/first.json"
dynamics skid speed --input second_after.toml --json > "$work/second.json"
dynamics impact momentum --axes compass \
    --first-mass "1500 ± 30 kg" --first-approach-heading "90 deg" \
    --first-exit-speed "@$work/first.json:speed" --first-exit-heading "48 ± 2 deg" \
    --second-mass "1150 ± 30 kg" --second-approach-heading "0 deg" \
    --second-exit-speed "@$work/second.json:speed" --second-exit-heading "53 ± 2 deg" \
    --json > "$work/impact.json"
dynamics skid speed --distance "12.4 ± 0.3 m" --friction "0.72 ± 0.04" \
    --end-speed "@$work/impact.json:first.approach_speed" --limit "70 km/h" --json > "$work/before.json"
for step in first second impact before; do
    jq -r --arg step "$step" '
        [.results | .. | objects | select(.interval)][0] as $speed
        | "\($step): \($speed.value * 10 | round / 10) \($speed.unit), 95 % within " +
          ($speed.interval | map(. * 10 | round / 10 | tostring) | join(" to "))' "$work/$step.json"
done
jq -r '.limits[0].message' "$work/before.json"
jq -r '.sensitivity.speed.inputs[] | "  \(.input): \(.share * 100 | round) % of the variance"' "$work/before.json"
dynamics report "$work/first.json" "$work/second.json" "$work/impact.json" "$work/before.json" \
    --title "Two-car crash" | grep -c "every result is the same to the last digit"
