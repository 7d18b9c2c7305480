#!/bin/sh
# A throwing arm: how fast it must release a 4 kg ball to hit a wall 90 m away and 6 m up, what air does to the shot,
# and how long the arm swings when it is left alone.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

echo "without drag: both angles at 34 m/s, and the least speed"
dynamics particle projectile --speed "34 m/s" --target "90, 6 m" -q

echo "with the drag of a ball of 180 mm, the same aim"
ball() {
    dynamics particle projectile --speed "34 m/s" --mass "4 kg" --area "254 cm^2" --drag-coefficient 0.47 "$@"
}
ball --target "90, 6 m" -q
ball --target "90, 6 m" --output "$work/shot.json"

echo "at that angle on level ground: in still air, and in a head wind of 6 m/s"
ball --elevation "@$work/shot.json:elevation" --only range
ball --elevation "@$work/shot.json:elevation" --wind "-6 m/s" --only range

echo "the arm, 2.4 m of uniform beam, let go at 70 degrees: its period, and the force on its bearing at the bottom"
dynamics pendulum rod --length "2.4 m" --mass "35 kg" --amplitude "70 deg" --angle "0 deg" -q
