#!/bin/sh
# An IMU's quaternion log to roll, pitch, yaw; how far the body turned; its inertia tensor in fixed axes at the end.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# A drop-out of the sensor costs only its own row: it is reported there, and the others are answered.
dynamics orient convert --rows log.csv --sequence rpy > "$work/angles.csv" || echo "exit status $?"
awk -F, -v OFS=, '{ print $1, $10, $11, $12, $NF }' "$work/angles.csv"

# The turn from the first to the last reading, and its part about the body's own vertical axis.
dynamics orient between --first-quaternion "0.93949, 0.00712, -0.01955, 0.34195" \
    --second-quaternion "0.68081, -0.04523, -0.16160, 0.71298" --about "0, 0, 1"

# The last reading as a turn of the body's inertia tensor: turned back by it, body axes become fixed ones.
dynamics orient convert --quaternion "0.68081, 0.04523, 0.16160, -0.71298" --json > "$work/turn.json"
dynamics inertia tensor --moments "0.8, 1.1, 1.5 kg*m^2" --quaternion "@$work/turn.json:quaternion" --only tensor
