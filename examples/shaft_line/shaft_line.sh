#!/bin/sh
# A motor drives a mill drum through a gearbox: torsional frequencies and critical speeds. Inertias come from shapes, the
# ratio from the gears.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

shape() {
    dynamics inertia shape cylinder --radius "$2" --length "$3" --material steel --output "$work/$1.json"
}
shape pinion "38 mm" "70 mm"
shape wheel "124 mm" "65 mm"
shape drum "450 mm" "900 mm"
dynamics gear train --stages "19:62" --speed "1480 rpm" --output "$work/gear.json"

line() {
    dynamics vibration shaft --rotor "name=motor, inertia=0.32 kg*m^2" \
        --rotor "name=pinion, inertia=@$work/pinion.json:moments.zz" \
        --rotor "name=wheel, inertia=@$work/wheel.json:moments.zz" \
        --rotor "name=drum, inertia=@$work/drum.json:moments.zz" \
        --shaft "from=motor, to=pinion, stiffness=6200 N*m/rad, damping=1.5 N*m*s/rad" \
        --shaft "from=wheel, to=drum, diameter=90 mm, length=700 mm" \
        --gear "driver=pinion, driven=wheel, ratio=@$work/gear.json:ratio_value" "$@"
}

echo "frequencies and shapes; orders 1 and 2 of the motor, which runs from 300 to 1480 rpm"
line --orders 1,2 --lowest-speed "300 rpm" --highest-speed "1480 rpm"

echo "how many modes lie below twice the mains' frequency"
line --below "100 Hz" --only modes_below
