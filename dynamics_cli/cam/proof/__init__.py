"""Proofs behind the cam results: enclosures of laws, their rounding, certified extremes, deviation of drawings."""
