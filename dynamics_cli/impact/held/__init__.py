"""Bodies suddenly held or stopped: a seized point or axis, a wheel at a step."""
