"""Skid-speed reconstruction: speeds, times and distances from marks on the road."""
