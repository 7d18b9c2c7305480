"""Rise laws: normalised functions of one rise, their peaks, and custom laws."""
