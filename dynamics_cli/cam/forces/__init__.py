"""Forces on a cam: loads, contact stress, and the speed at which the follower jumps."""
