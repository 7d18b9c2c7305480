"""Rollovers: tipping, tripping and rolling to rest."""
