"""A hand that moves along a line or an arc: the joints in time."""
