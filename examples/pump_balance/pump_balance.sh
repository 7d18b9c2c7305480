#!/bin/sh
# A pump of 85 kg at 2970 rpm, balanced in two planes from trial weights; the balancing discs have holes at 120 mm.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

echo "residual unbalance permitted by G 6.3, by plane"
dynamics balance grade --grade "6.3 mm/s" --speed "2970 rpm" --mass "85 kg" --first-distance "180 mm" \
    --second-distance "260 mm" -q

run() {
    dynamics balance trial \
        --sensor "initial=7.2 mm/s @ 63 deg, first=4.9 mm/s @ 128 deg, second=7.9 mm/s @ 32 deg" \
        --sensor "initial=5.4 mm/s @ 206 deg, first=6.5 mm/s @ 221 deg, second=8.1 mm/s @ 238 deg" \
        --first-trial-mass "8 g" --first-trial-angle "0 deg" --second-trial-mass "8 g" --second-trial-angle "0 deg" "$@"
}

echo "two accelerometers, three runs: corrections"
run -q
run --output "$work/run.json"

for plane in first second; do
    echo "$plane plane: screws in steps of 0.5 g in 16 holes"
    dynamics balance split --mass "@$work/run.json:${plane}_mass" --angle "@$work/run.json:${plane}_angle" \
        --holes 16 --stock "0.5 g" -q
done
