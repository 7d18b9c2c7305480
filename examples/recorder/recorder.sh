#!/bin/sh
# A recorder read out after a crash: five seconds before it, the pulse, and what it says of the other vehicle.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

echo "the five seconds before"
dynamics skid record --speeds "78, 78, 78, 78, 77, 76, 74, 66, 54, 41, 29 km/h" -q

echo "the pulse"
dynamics impact pulse --longitudinal "0, -1, -4, -9, -16, -22, -29, -35, -40, -43, -44, -45, -45, -45 km/h" \
    --lateral "0, 0, 1, 1, 3, 4, 5, 6, 6, 7, 7, 7, 7, 7 km/h" \
    --yaw-rate "0, 1, 4, 17, 33, 49, 64, 80, 93, 103, 107, 109, 109, 109 deg/s" \
    --friction 0.7 --output "$work/pulse.json"
dynamics impact pulse --longitudinal "0, -1, -4, -9, -16, -22, -29, -35, -40, -43, -44, -45, -45, -45 km/h" \
    --lateral "0, 0, 1, 1, 3, 4, 5, 6, 6, 7, 7, 7, 7, 7 km/h" \
    --yaw-rate "0, 1, 4, 17, 33, 49, 64, 80, 93, 103, 107, 109, 109, 109 deg/s" --friction 0.7 -q

echo "the other vehicle, which came at 140 deg and left at 82 deg"
dynamics impact record --first-mass "1500 kg" --first-nose "12 deg" --first-approach-speed "29 km/h" \
    --first-delta-v-longitudinal "@$work/pulse.json:delta_v_longitudinal" \
    --first-delta-v-lateral "@$work/pulse.json:delta_v_lateral" \
    --second-mass "1200 kg" --second-approach-heading "140 deg" --second-exit-heading "82 deg" -q
