#!/bin/sh
# A two-stage gearbox: tooth numbers for a ratio, profile shifts for whole centre distances, forces, sizes to measure
# in the workshop, and the last pinion as a DXF.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# 1. Which teeth? Every pair of stages within the limits is looked at; coprime teeth wear evenly.
dynamics gear ratio --target 11.3 --stages 2 --teeth 17..75 --coprime --largest-stage 4 --count 1 --json > "$work/ratio.json"
jq -r '.results.best[0] | "stages \(.stages), ratio \(.ratio), off by \(.error)"' "$work/ratio.json"
stages=$(jq -r '.results.best[0].stages' "$work/ratio.json")

# 2. Each stage in turn: power and speed go from one to the next, and the slower shaft has the larger module.
power="7.5 kW" speed="1450 rpm" module=2
for stage in $(printf '%s' "$stages" | tr -d ' ' | tr ',' ' '); do
    first=${stage%%:*} second=${stage##*:}
    # The next whole millimetre above the distance without shifts; the shifts take up the rest, shared so that both
    # gears slide alike.
    distance=$(((first + second) * module / 2 + 1))
    dynamics gear pair --first-teeth "$first" --second-teeth "$second" --module "$module mm" \
        --centre-distance "$distance mm" --split balanced-sliding --power "$power" --speed "$speed" --json > "$work/pair.json"
    jq -r --arg pair "$first/$second, module $module mm" 'def to($n): . * pow(10; $n) | round / pow(10; $n);
        .results | "\($pair): centre distance \(.centre_distance.value) \(.centre_distance.unit), " +
        "contact ratio \(.transverse_contact_ratio.value | to(3)), shifts \(.first_profile_shift.value | to(4)) and " +
        "\(.second_profile_shift.value | to(4))",
        "  on the teeth \(.forces.tangential.value | round) \(.forces.tangential.unit) along and " +
        "\(.forces.radial.value | round) \(.forces.radial.unit) apart; efficiency \(.efficiency.value | to(2)) \(.efficiency.unit)"' \
        "$work/pair.json"
    for wheel in first second; do
        teeth=$(jq -r ".inputs.$wheel.teeth.value // .inputs.$wheel.teeth" "$work/pair.json")
        # 3. What the workshop measures: the span over some teeth, with the shift of the step before.
        shift=$(jq -r ".results.${wheel}_profile_shift.value" "$work/pair.json")
        dynamics gear measure --teeth "$teeth" --module "$module mm" --profile-shift "$shift" --json |
            jq -r --arg teeth "$teeth" '.results.span | "  \($teeth) teeth: span over \(.over.value // .over) is \(.span.value * 1000 | round / 1000) \(.span.unit)"'
    done
    speed=$(jq -r --argjson first "$first" --argjson second "$second" '"\(.inputs.speed.value * $first / $second) rpm"' "$work/pair.json")
    power=$(jq -r '"\(.inputs.power.value * .results.efficiency.value / 100) kW"' "$work/pair.json")
    last=$first pinion=$(jq -r '.results.first_profile_shift.value' "$work/pair.json") size="$module mm" module=3
done

# 4. The last pinion for the machine: exact root fillets and involutes, and how far the drawing may be off, proved.
dynamics gear profile --teeth "$last" --module "$size" --profile-shift "$pinion" --drawing "$work/pinion.dxf" --json |
    jq -r '.files[] | select(.written) | "pinion drawn within \(.deviation.value * 1e6 | round / 1000) um"'
