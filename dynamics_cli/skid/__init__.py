"""Skid-speed reconstruction: what marks on the road say of speeds, times and distances."""
