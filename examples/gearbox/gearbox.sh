#!/bin/sh
# A two-stage gearbox: tooth numbers for a ratio, profile shifts for a centre distance, forces, sizes to measure, a DXF.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
dynamics gear ratio --target 11.3 --stages 2 --teeth 17..75 --coprime --largest-stage 4 --count 1 --json > "$work/ratio.json"
jq -r '.results.best[0] | "stages \(.stages), ratio \(.ratio), off by \(.error)"' "$work/ratio.json"
stages=$(jq -r '.results.best[0].stages' "$work/ratio.json")
nth=0
for stage in $(printf '%s' "$stages" | tr -d ' ' | tr ',' ' '); do
    nth=$((nth + 1))
    first=${stage%%:*} second=${stage##*:}
    case $nth in 1) module="2 mm" power="7.5 kW" speed="1450 rpm" ;; *) module="3 mm" power="7.3 kW" speed="430 rpm" ;; esac
    dynamics gear pair --first-teeth "$first" --second-teeth "$second" --module "$module" \
        --first-profile-shift 0.3 --second-profile-shift 0.1 --power "$power" --speed "$speed" --json > "$work/pair.json"
    jq -r --arg pair "$first/$second" '.results | "pair \($pair): centre distance \(.centre_distance.value * 1000 | round / 1000) \(.centre_distance.unit), contact ratio \(.transverse_contact_ratio.value * 1000 | round / 1000)"' "$work/pair.json"
    dynamics gear measure --teeth "$first" --module "$module" --profile-shift 0.3 --json |
        jq -r '.results.span | "  span over \(.over.value) teeth: \(.span.value * 1000 | round / 1000) \(.span.unit)"'
done
dynamics gear profile --teeth "$first" --module "$module" --profile-shift 0.3 --drawing "$work/pinion.dxf" --json |
    jq -r '.files[] | select(.written) | "pinion drawn within \(.deviation.value * 1e6 | round / 1000) um"'
