"""Bodies in plane motion, their instant centres, and open chains."""
