#!/bin/sh
# An in-line engine of three cylinders: its forces cancel, its couples rock it. Counterweights on the crank and one shaft
# that turns against it take the first order away. What are their weights, and what is left?
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

engine() {
    dynamics balance engine --preset inline-3 --reciprocating-mass "0.42 kg" --crank-radius "41 mm" \
        --rod-length "138 mm" --spacing "82 mm" --speed "6000 rpm" "$@"
}

echo "forces and couples by order"
engine --highest-order 4
echo "weights on the crank and on a shaft, for each order and sense"
engine --highest-order 2 --table shafts
engine --output "$work/engine.json"

echo "first order, in two planes 260 mm apart with weights at 35 mm: each weighs"
jq -r '.results.shafts[] | select(.order.value == 1) |
    "\(.turns): \(.couple.value / 0.260 / 35 | round) g, at \(.couple_angle.value | round) deg and opposite at the other end"' "$work/engine.json"
echo "left with counterweights alone, and with counterweights and shaft"
jq -r '.results.orders | "\(.[0].backward_couple.value | round) N·m of order 1, \(.[1].couple.value | round) N·m of order 2",
    "\(.[1].couple.value | round) N·m of order 2"' "$work/engine.json"
