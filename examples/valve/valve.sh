#!/bin/sh
# A valve cam: the smallest base circle, a verdict on the cam chosen, its forces, and a file that a machine can cut.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# 1. How small may the cam be, if the roller is never pushed at more than 30 degrees?
dynamics cam size valve.toml --follower roller --roller-radius "9 mm" --rise-limit "30 deg" --return-limit "30 deg" --json |
    jq -r '.results | "smallest base circle: \(.base_radius.value * 1000 | round / 1000) \(.base_radius.unit)"'

# 2. A cam of 28 mm leaves room for the shaft: does the roller fit everywhere?
dynamics cam check valve.toml --follower roller --base-radius "28 mm" --roller-radius "9 mm" --json |
    jq -r '.results | "fits: \(.fits), undercut: \(.undercut), pressure angle to \(.largest_pressure_angle.value * 100 | round / 100) deg, " +
        "least radius \(.least_convex_radius.value * 100 | round / 100) mm"'

# 3. At 3000 turns of the camshaft a minute: does the spring keep the valve on the cam?
dynamics cam force valve.toml --mass "0.12 kg" --spring-rate "30 N/mm" --preload "300 N" --shaft-speed "3000 rpm" --json |
    jq -r '.results | "jump speed \(.jump_speed.value | round) \(.jump_speed.unit), contact force \(.least_force.value | round) to \(.greatest_force.value | round) \(.greatest_force.unit)"'

# 4. The file for the machine, and the deviation that is proved of it.
dynamics cam export valve.toml --follower roller --base-radius "28 mm" --roller-radius "9 mm" --tolerance "1 um" \
    --drawing "$work/valve.dxf" --json > "$work/valve.json"
jq -r '.files[] | select(.written) | "DXF within \(.deviation.value * 1e6 | round / 1000) um of the exact cam, proved"' "$work/valve.json"
printf 'outlines in the DXF: '
grep -c '^LWPOLYLINE' "$work/valve.dxf"
