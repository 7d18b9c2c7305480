"""A car from the separation to rest in three degrees of freedom: sliding, rolling and turning on its four wheels."""
