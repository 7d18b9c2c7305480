"""Torsional shaft lines with gears and branches, and whirling rotors."""
