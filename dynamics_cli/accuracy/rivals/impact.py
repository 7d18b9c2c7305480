"""Impacts: the questions asked of them."""

QUESTIONS = ()
