#!/bin/sh
# A position loop with a PI controller: a motor with a lag of 0.05 s turns a load (plant 20/(s(0.05s + 1))).
# How far may the proportional gain K be raised, how robust is K = 0.4, and how much delay does it bear?
set -eu

echo "characteristic polynomial with an integral time of 0.8 s: stable gains"
dynamics stability gain "s^2(0.05s + 1) + 20K(s + 1/0.8)" -q

echo "with a sensor lag of 0.01 s beside it"
dynamics stability gain "s^2(0.05s + 1)(0.01s + 1) + 20K(s + 1/0.8)" -q

echo "K = 0.4: roots of the closed loop"
dynamics stability routh "s^2(0.05s + 1)(0.01s + 1) + 8(s + 1/0.8)" --only roots

echo "friction and inertia within ranges: lag and loop gain by 20 per cent either way"
dynamics stability interval "0.0004..0.0006, 0.048..0.072, 1, 6.4..9.6, 8..12" -q

echo "how much delay the loop bears"
dynamics stability delay "s^2(0.05s + 1)(0.01s + 1)" --delayed "8(s + 1/0.8)" -q
