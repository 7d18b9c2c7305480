"""A whole crash as one model of all its measurements: before, impact and after."""
