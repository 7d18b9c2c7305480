"""Uncertain inputs propagated through any model: methods, variance shares, and what they add to a document."""
