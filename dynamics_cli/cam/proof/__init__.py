"""Proofs of what cam answers state: enclosures of laws, their rounding, certified extremes, deviation of drawings."""
