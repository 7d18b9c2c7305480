"""The normal distribution and Student's t."""
