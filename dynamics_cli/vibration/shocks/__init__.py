"""Pulses, steps and records that strike one mass, and shock spectra."""
