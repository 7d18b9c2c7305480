#!/bin/sh
# A child runs out from behind a van: when could the driver see it, where was the car, and what speed would have sufficed?
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# 14 m of skid marks end at the impact, where the car still had 24 km/h by its damage.
dynamics skid timeline --input car.toml --table phases
dynamics skid meet --input parties.toml --clear-distance "2.1 m" --json |
    jq -r '"the driver needed to react " + (.results.earlier.value * 100 | round / 100 | tostring) + " s earlier to stop short,",
        "or to travel at no more than " + (.results.sufficient_speed.value * 10 | round / 10 | tostring) + " km/h"'
dynamics skid sight --input parties.toml --corner-before "1.5 m" --corner-aside "1.4 m" --eye-behind "2.1 m" -q
