"""Chebyshev proxies of smooth functions, with proved remainders and maxima."""
