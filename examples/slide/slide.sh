#!/bin/sh
# A car was struck at the front, its left front wheel jammed, and turned to rest: what had it just after the impact?
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

car="--front-axle 1.2m --rear-axle 1.5m --track 1.5m --radius-of-gyration 1.35m --friction 0.72 --axes compass"
wheels="--braking 5% --left-front 100%"

echo "back from rest"
# shellcheck disable=SC2086 # one word for each option
dynamics impact slide --rest "7.9, 7.2 m" --nose "90 deg" --rest-nose "230 deg" $car $wheels \
    --output "$work/back.json"
jq -r '.results | .speed, .course, .spin | "\(.value * 100 | round / 100) \(.unit)"' "$work/back.json"

echo "forward again: it must end there"
# shellcheck disable=SC2086
dynamics impact slide --speed "@$work/back.json:speed" --course "@$work/back.json:course" \
    --spin "@$work/back.json:spin" --nose "90 deg" $car $wheels -q

echo "in the scene of the whole crash"
dynamics impact crash turned.toml -q
