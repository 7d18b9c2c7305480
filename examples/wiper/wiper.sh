#!/bin/sh
# A windscreen wiper: a crank-rocker for a swing of 95 degrees, checked, and the torque its motor needs in every position.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# 1. Which links? The wiper arm's lever is 60 mm, both strokes take the same time.
dynamics linkage synthesize --swing "95 deg" --time-ratio 1 --rocker "60 mm" --json > "$work/links.json"
jq -r '.results | "links: crank \(.crank.value * 100 | round / 100), coupler \(.coupler.value * 100 | round / 100), " +
    "rocker \(.rocker.value), ground \(.ground.value * 100 | round / 100) mm, smallest transmission angle " +
    "\(.least_transmission_angle.value * 10 | round / 10) deg"' "$work/links.json"

# 2. Lengths as they are made, in half millimetres: what is left of the swing?
links=$(jq -r '.results | [.crank, .coupler, .rocker, .ground] | map(.value * 2 | round / 2) |
    "--crank \(.[0])mm --coupler \(.[1])mm --rocker \(.[2])mm --ground \(.[3])mm"' "$work/links.json")
echo "made: $links"
# shellcheck disable=SC2086
dynamics linkage class $links --json |
    jq -r '.results | "\(.kind): swings through \(.swing.value * 100 | round / 100) deg, time ratio " +
        "\(.time_ratio.value * 10000 | round / 10000)"'

# 3. The blade needs 8 N·m at the arm. What does that ask of the motor, all the way round?
# shellcheck disable=SC2086
dynamics linkage four-bar $links --load-torque "8 N*m" --speed "45 rpm" --sweep "crank_angle=0 deg:330 deg:12" \
    --format csv > "$work/turn.csv"
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i ~ /^crank_torque/) torque = i }
    NR > 1 { t = $torque < 0 ? -$torque : $torque; if (t > most) { most = t; at = $1 } }
    END { printf "largest motor torque of the turn: %.2f N·m at a crank angle of %d deg, ratio %.3f\n", most, at, most / 8 }' \
    "$work/turn.csv"

# 4. Holes are drilled to ± 0.1 mm: how sure is the end of the wiped field?
crank=$(printf '%s' "$links" | sed 's/--crank \([0-9.]*\)mm.*/\1/')
# shellcheck disable=SC2086
dynamics linkage four-bar ${links#--crank *mm } --crank "$crank ± 0.1 mm" --crank-angle "30 deg" --json |
    jq -r '.results.rocker_angle | "arm at \(.value * 100 | round / 100) deg ± \(.std * 100 | round / 100) deg"'

# 5. A picture that moves, for the meeting.
# shellcheck disable=SC2086
dynamics linkage four-bar $links --crank-angle "30 deg" --drawing "$work/wiper.svg" --json |
    jq -r '.files[] | select(.written) | "moving picture written"'
