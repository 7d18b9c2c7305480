#!/bin/sh
# A fan of 420 kg at 1480 rpm on four mounts: how soft they must be, what the fan then does, what a shock through the
# floor does to it, and whether the concrete block below joins in.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

echo "mounts that keep 90 % of the vibration from the floor"
dynamics vibration isolator --speed "1480 rpm" --isolation "90 %" --damping-ratio 0.06 --mass "420 kg" --mounts 4 -q
dynamics vibration isolator --speed "1480 rpm" --isolation "90 %" --damping-ratio 0.06 --mass "420 kg" --mounts 4 \
    --output "$work/mounts.json"

echo "the fan on these mounts with the unbalance that G 6.3 leaves"
dynamics balance grade --grade "6.3 mm/s" --speed "1480 rpm" --mass "120 kg" --output "$work/grade.json"
dynamics vibration unbalance --mass "420 kg" --unbalance "@$work/grade.json:unbalance" \
    --stiffness "@$work/mounts.json:stiffness" --damping-ratio 0.06 --speed "1480 rpm" -q

echo "a shock of the floor: half-sine, 5 g, 11 ms"
dynamics vibration transient --mass "420 kg" --stiffness "@$work/mounts.json:stiffness" --damping-ratio 0.06 \
    --base-acceleration "5 g" --shape half-sine --duration "11 ms" -q

echo "with a block of 1.5 t on soil: modes, and the block's motion under the fan's force"
set -- --body "name=fan, mass=420 kg" --body "name=block, mass=1500 kg" \
    --coupling "from=fan, to=block, stiffness=@$work/mounts.json:stiffness, damping=2.3 kN*s/m" \
    --coupling "from=block, to=ground, stiffness=30 kN/mm, damping=90 kN*s/m"
dynamics vibration modes "$@"
dynamics vibration response "$@" --force-at fan --read-at block --force "40 N" --speed "1480 rpm" -q
