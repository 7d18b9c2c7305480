"""Uncertain inputs propagated through any model: methods, variance shares, and their entries in a document."""
