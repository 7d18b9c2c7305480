#!/bin/sh
# A wall bracket 1.2 m long carries a hoist, a motor and the pull of a belt. What do they add up to, what must the bolts
# at the wall bear, and what is left for them when a stay to the wall takes its share?
set -eu

HOIST="force=0, -2.4 kN, at=1.2, 0 m"
MOTOR="force=0, -380 N, at=0.5, 0.1 m"
BELT="force=650 N @ 25 deg, at=0.5, 0.25 m"

echo "what the three loads add up to, and where their line crosses the bracket"
dynamics force resultant --load "$HOIST" --load "$MOTOR" --load "$BELT" -q

echo "as force and moment at the bolts"
dynamics force equivalent --load "$HOIST" --load "$MOTOR" --load "$BELT" --about "0, 0 m" -q

echo "what the bolts do when they hold the bracket alone"
dynamics force equilibrium --load "$HOIST" --load "$MOTOR" --load "$BELT" \
    --support "type=fixed, at=0, 0 m, name=bolts" --table reactions

echo "one pin, and a stay from the end of the bracket to the wall, 0.9 m above"
dynamics force equilibrium --load "$HOIST" --load "$MOTOR" --load "$BELT" \
    --support "type=pin, at=0, 0 m, name=pin" \
    --support "type=cable, at=1.2, 0 m, direction=-1.2, 0.9, name=stay" --table reactions
