#!/bin/sh
# A rod on a pin that slides along a rail, held by a spring and a damper: its equations of motion at an instant by Kane's
# method and by Lagrange's, what makes up the equation of the angle.
set -eu

echo "the equations, by both methods"
dynamics motion equations sliding_rod.toml

echo "what makes up the equation of theta"
dynamics motion equations sliding_rod.toml --terms theta

echo "energies on a level table, where no gravity acts"
dynamics motion equations sliding_rod.toml --up none --only potential_energy,kinetic_energy
