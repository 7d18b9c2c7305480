"""Speed against error: every calculation beside its rivals, measured against references that ship with the program."""
