"""Several masses: modes from springs and masses or from matrices, and their response."""
