#!/bin/sh
# A sleigh on a knife edge: a condition on rates that no formula of coordinates keeps. Its equations in generalized
# speeds by Kane's method, the force of the edge beside Lagrange's multiplier.
set -eu

echo "the equations, in the speed along the edge and the turn"
dynamics motion equations sleigh.toml

echo "the force of the edge"
dynamics motion equations sleigh.toml --only conditions
