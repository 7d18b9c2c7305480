"""The command line: calls gathered, carried out, explained in help and completed."""
