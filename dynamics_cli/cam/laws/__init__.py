"""Rise laws: normalised functions of one rise, their peaks, and laws made to measure."""
