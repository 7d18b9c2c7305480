"""Many cases: streams of rows, sweeps, and work spread over processes."""
