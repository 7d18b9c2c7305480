"""Vibration: one mass on a spring, chains and shafts, shocks, absorbers, beams, rotors, nonlinear oscillators."""
