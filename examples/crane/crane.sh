#!/bin/sh
# The hoist rope of a crane: from the drum over the sheave at the boom's tip down to the hook. x forward, y to the left.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
foot="0, 0, 2 m" tip="14, 0, 17 m" drum="-1.5, 0.15, 2.5 m"

echo "rope from the tip to the drum"
dynamics vec direction "$tip" "$drum" -q
dynamics vec direction "$tip" "$drum" --output "$work/rope.json"
dynamics vec direction "$foot" "$tip" --output "$work/boom.json"

echo "angle of wrap on the sheave"
dynamics vec angle "0, 0, -1" "@$work/rope.json:vector" --only supplement

echo "fleet angle at the drum, whose axis is across; 2 degrees is the limit for a smooth drum"
dynamics vec resolve "@$work/rope.json:vector" --normal "0, 1, 0" --only angle

echo "force on the pin of the sheave: both parts of the rope have the same pull"
dynamics vec resultant "25 ± 0.5 kN from $tip to $drum" "25 ± 0.5 kN along 0, 0, -1" \
    --correlate "vectors[0].magnitude,vectors[1].magnitude=1" --output "$work/pin.json"
dynamics vec direction "@$work/pin.json:resultant" -q

echo "what of it presses the boom (below zero: towards its foot), and what bends it"
dynamics vec resolve "@$work/pin.json:resultant" --along "@$work/boom.json:vector" --only component,across

echo "where the luffing rope passes the hoist rope, and how near"
dynamics vec lines --first-point "$tip" --first-to "$drum" --second-point "-3, 0.6, 9 m" --second-to "11, 0.6, 14.5 m" -q
