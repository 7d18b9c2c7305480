"""Rollovers: where a vehicle tips, what trips it, and how it comes to rest."""
