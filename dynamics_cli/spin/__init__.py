"""Spinning bodies: gyroscopes, free bodies, tops, skewed rotors, disks, rods on turning shafts."""
