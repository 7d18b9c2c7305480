#!/bin/sh
# A four-cylinder engine of two litres with a pressure diagram: what shakes it, what turns it, and the flywheel that
# keeps its speed within 1 % at 3000 rpm. The cylinders are offset by 8 mm.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

echo "inertia forces by order: the offset adds odd ones, but they cancel in four cylinders"
dynamics balance engine --preset inline-4 --reciprocating-mass "0.5 kg" --crank-radius "43 mm" --rod-length "150 mm" \
    --spacing "96 mm" --offset "8 mm" --speed "3000 rpm" -q

echo "turning moment over the cycle and by order"
dynamics balance turning --diagram @diagram.csv --preset inline-4 --firing-order 1-3-4-2 \
    --bore "86 mm" --reciprocating-mass "0.5 kg" --crank-radius "43 mm" --rod-length "150 mm" --offset "8 mm" \
    --speed "3000 rpm" --step "1 deg" --output "$work/turning.json"
jq -r '.results | "mean \(.mean_torque.value | round) \(.mean_torque.unit), firing \(.firing_order), \(.evenness)",
    (.orders[] | "order \(.order.value): \(.torque.value | round) \(.torque.unit)")' "$work/turning.json"

echo "the flywheel for it"
dynamics balance flywheel --point "@$work/turning.json:torque" --speed "3000 rpm" --fluctuation "1 %" \
    --rim-radius "140 mm" -q
