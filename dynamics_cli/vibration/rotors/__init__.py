"""Stepped shafts with disks on several bearings: critical speeds, whirl, response to unbalance, stability."""
