#!/bin/sh
# A crane that slews while its trolley runs: what the motors must hold for that motion, and how crane and load move when
# they hold less.
set -eu

echo "how it hangs together"
dynamics multibody topology swing_crane.toml

echo "what a steady motion takes"
dynamics multibody efforts swing_crane.toml

echo "what happens with the motors as they are"
dynamics multibody accelerations swing_crane.toml
