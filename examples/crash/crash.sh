#!/bin/sh
# A two-car crash from what was measured on the road, backwards in time: skids after the impact, momentum in it, the
# skid before it, the limit. Every measurement has its uncertainty, and each step hands it on to the next.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# 1. After the impact: how fast was each car, to slide as far as it did?
dynamics skid speed --input first_after.toml --json > "$work/1_first_after.json"
dynamics skid speed --input second_after.toml --json > "$work/2_second_after.json"

# 2. The impact: the first car drove east, the second north; momentum gives their speeds just before.
dynamics impact momentum --axes compass \
    --first-mass "1500 ± 30 kg" --first-approach-heading "90 deg" \
    --first-exit-speed "@$work/1_first_after.json:speed" --first-exit-heading "48 ± 2 deg" \
    --second-mass "1150 ± 30 kg" --second-approach-heading "0 deg" \
    --second-exit-speed "@$work/2_second_after.json:speed" --second-exit-heading "53 ± 2 deg" \
    --json > "$work/3_impact.json"

# 3. Before the impact: the first car had braked over 12.4 m. How fast was it, and was that above 70 km/h?
dynamics skid speed --distance "12.4 ± 0.3 m" --friction "0.72 ± 0.04" \
    --end-speed "@$work/3_impact.json:first.approach_speed" --limit "70 km/h" --json > "$work/4_before.json"

show() {
    jq -r --arg words "$1" "$2"' as $speed | "\($words): \($speed.value * 10 | round / 10) \($speed.unit), 95 % within " +
        ($speed.interval | map(. * 10 | round / 10 | tostring) | join(" to "))' "$work/$3.json"
}
show "first car after the impact" .results.speed 1_first_after
show "second car after the impact" .results.speed 2_second_after
show "first car into the impact" .results.first.approach_speed 3_impact
show "second car into the impact" .results.second.approach_speed 3_impact
show "first car when it began to skid" .results.speed 4_before
jq -r '.limits[0].message' "$work/4_before.json"
echo "what drives that speed:"
jq -r '.sensitivity.speed.inputs[] | "  \(.input): \(.share * 100 | round) % of the variance"' "$work/4_before.json"

# 4. For the file: one report of all four, each calculated again while it is written.
dynamics report "$work"/[1-4]_*.json --title "Two-car crash" --case "example" --output "$work/report.md"
grep -o "[0-9] of [0-9] calculations gave the same results" "$work/report.md"
