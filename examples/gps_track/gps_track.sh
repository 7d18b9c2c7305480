#!/bin/sh
# A GPS track of a car (10 a second, noise 3 cm) to its accelerations: how hard it braked, and how fast it took the bend.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Speed and accelerations at every point, each with its noise.
dynamics path table track.csv --json > "$work/track.json"
jq -r '.results | "top speed \(.top_speed.value * 3.6 * 10 | round / 10) km/h at \(.top_speed_time.value) s",
    "braked with \(.hardest_braking.value * 100 | round / 100) m/s² at \(.hardest_braking_time.value) s, ± \(.acceleration_noise.value * 100 | round / 100)",
    "\(.strongest_lateral.value * 100 | round / 100) m/s² across the path at \(.strongest_lateral_time.value) s",
    "raw second differences would have had ± \(.raw_noise.value * 10 | round / 10) m/s²"' "$work/track.json"

# The tightest radius in the bend, where the curvature is known to better than a tenth.
jq -r '[.results.points[] | select(.curvature and .curvature_noise.value < 0.1 * .curvature.value)]
    | max_by(.curvature.value) | "radius \(1 / .curvature.value * 10 | round / 10) m at \(.time.value) s"' "$work/track.json"

# Braking of that size from the top speed: distance and time to 25 km/h.
dynamics path rectilinear --start-speed @"$work/track.json":top_speed --end-speed "25 km/h" --acceleration "-5 m/s^2" \
    --only time,distance
