#!/bin/sh
# A drawing's dimensions and a spec sheet's figures, in the units of another trade.
set -eu
dynamics convert "5 ft 6 in" mm --format csv
dynamics convert "30 lbf*ft" "N*m" --format csv
dynamics convert "1750 rpm" rad/s --format csv
printf '%s\n' "60 mph ft/s" "32 degF degC" "1 hp W" "2 furlong m" | dynamics convert --rows -
