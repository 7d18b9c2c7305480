"""Alternatives to the program's methods: what textbooks print, and the best of the others, measured beside our own."""
