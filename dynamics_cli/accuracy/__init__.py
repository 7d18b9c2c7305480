"""Error and speed of every calculation beside its alternatives, against references that ship with the program."""
