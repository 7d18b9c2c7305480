"""Proof that triangles form a closed surface, in constant memory: every directed edge must have an opposite one.

Each vertex v gets a 64-bit number h(v) of the bits of its coordinates, whose upper half is g(v). The sum of
h_u g_v − h_v g_u over the directed edges u → v vanishes, modulo 2⁶⁴, when the boundary of the triangles is empty, and
otherwise with a probability of 2⁻⁵⁸ at most: that of a boundary of three edges, of a triangle in the plane of h and g
whose area is zero. The divergence theorem requires an empty boundary.
"""

import numpy as np

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Array = np.ndarray[Any, np.dtype[Any]]

# Odd numbers without structure: the fractional parts of √2, √3, √5 in 64 bits, made odd.
_FIRST, _SECOND, _THIRD = (np.uint64(k) for k in (0x6A09E667F3BCC909, 0xBB67AE8584CAA73B, 0x3C6EF372FE94F82B))
_HALF = np.uint64(32)


def edge_sum(corners: "Array", h: "Array", spare: "Array") -> int:
    """The sum over the directed edges of a block of corner coordinates, contiguous doubles without minus zeros.

    The other arrays are room to work in, three rows of 64-bit numbers each.
    """
    vertex_hashes(corners, h, spare)
    # over the edges of one triangle the sum is (h_c − h_b)(g_a − g_b) − (h_a − h_b)(g_c − g_b)
    np.subtract(h[::2], h[1], out=h[::2])
    np.subtract(spare[::2], spare[1], out=spare[::2])
    np.multiply(h[::2], spare[::-2], out=h[::2])
    np.subtract(h[2], h[0], out=h[0])
    return int(np.add.reduce(h[0]))


def vertex_hashes(corners: "Array", h: "Array", spare: "Array") -> None:
    """Put the numbers of corners, each of three rows of coordinates, into the rows of `h`.

    Their upper halves come into `spare`.
    """
    x, y, z = (corners.view(np.uint64)[k::3] for k in range(3))
    np.multiply(x, _FIRST, out=h)
    _fold(h, spare)
    np.add(h, y, out=h)
    np.multiply(h, _SECOND, out=h)
    _fold(h, spare)
    np.add(h, z, out=h)
    np.multiply(h, _THIRD, out=h)
    _fold(h, spare)
    # once more, for the last bits of numbers that differ in their topmost bits only, as whole coordinates do
    np.multiply(h, _FIRST, out=h)
    _fold(h, spare)


def _fold(h: "Array", spare: "Array") -> None:
    """The upper half of each number joins the lower: a product moves bits upward only."""
    np.right_shift(h, _HALF, out=spare)
    np.bitwise_xor(h, spare, out=h)
