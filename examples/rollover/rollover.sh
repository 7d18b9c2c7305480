#!/bin/sh
# A car left the road in a yaw, tripped in the verge and rolled: its speed from the rolling, and from the mark before.
set -eu

# What others measured: to compare with, nothing takes it by itself.
dynamics skid values roll drag
echo "before the trip:"
dynamics skid rollover --input car.toml -q
echo "on the road:"
dynamics skid yaw --input mark.toml -q
