"""The smallest cam that keeps its limits, for each kind of follower."""
