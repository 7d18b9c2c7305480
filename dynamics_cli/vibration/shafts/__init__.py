"""Torsional shaft lines with gears and branches, a whirling disk, beams, absorbers."""
