#!/bin/sh
# A triple pendulum of three half-metre rods: a swing that can be followed, the forces in its pins, and the same rods let
# go from high up, where after some seconds nobody can tell where they are.
set -eu

rods() {
    dynamics motion chain --lengths "0.5, 0.5, 0.5 m" --masses "1 kg" "$@"
}

echo "let go from 30, -20 and 45 degrees: two seconds"
rods --angles "30, -20, 45 deg" --duration "2 s" -q

echo "a small swing: beside its small oscillations"
rods --angles "1, 1.5, 2 deg" --duration "5 s" --only frequencies

echo "let go from 120 degrees: two seconds tell how long it could be followed"
rods --angles "120 deg" --duration "2 s" --only verdict

echo "let go from 120 degrees: twenty seconds are too many"
rods --angles "120 deg" --duration "20 s" --only verdict,top_force
