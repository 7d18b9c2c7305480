"""Inputs: from text, JSON and files to a tree of SI numbers, as a signature specifies them."""
