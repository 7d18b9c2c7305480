#!/bin/sh
# A worker lifts a box: where the mass centre is, what his joints carry, what his back carries, and how sure that is.
set -e
bend="--ankle-flexion 10deg --knee-flexion 40deg --hip-flexion 80deg --shoulder-flexion 50deg --elbow-flexion 10deg"

# standing straight: height of the mass centre, moment of inertia about the ankles
dynamics human posture --input worker.toml -q

# the lift, with one muscle of the back at 5 cm
dynamics human moments --input worker.toml $bend --load "15 kg" --muscle "joint=back, lever=5 cm"

# the lever of the muscle is not known well: what that does to the compression
dynamics human moments --input worker.toml $bend --load "15 ± 0.5 kg" --muscle "joint=back, lever=4.5..6 cm" \
  --limit "compression=3400 N" -q
