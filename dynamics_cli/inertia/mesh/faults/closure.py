"""Proof that triangles form a closed surface, in constant memory: every directed edge must have an opposite one.

Each vertex v gets two 64-bit numbers h(v), m(v) of the bits of its coordinates. The sum of h_u m_v − h_v m_u over the
directed edges u → v vanishes, modulo 2⁶⁴, when the boundary of the triangles is empty, and with a probability of about
2⁻⁶⁴ otherwise. The divergence theorem requires an empty boundary.
"""

import numpy as np

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Array = np.ndarray[Any, np.dtype[Any]]

# Odd numbers without structure: the fractional parts of √2, √3, √5 … in 64 bits, made odd.
_MIX = np.array([[0x6A09E667F3BCC909], [0xBB67AE8584CAA73B], [0x3C6EF372FE94F82B]] * 3, dtype=np.uint64)
_FIRST = np.uint64(0xA54FF53A5F1D36F1)
_SECOND = np.uint64(0x510E527FADE682D1)
_SINGLE = np.uint64(29)
_HALF = np.uint64(32)
_THIRD = np.uint64(29)


class Boundary:
    """The running sum over directed edges."""

    def __init__(self) -> None:
        self.total = 0

    def add(self, edges: int) -> None:
        """Add the sum over the edges of a block."""
        self.total = (self.total + edges) % (1 << 64)

    @property
    def empty(self) -> bool:
        """Whether every directed edge has an opposite one."""
        return self.total == 0


def edge_sum(corners: "Array", words: "Array", h: "Array", m: "Array", *, single: bool) -> int:
    """The sum over the directed edges of a block of corner coordinates, contiguous doubles without minus zeros.

    The other arrays are room to work in, nine rows and twice three rows of 64-bit numbers.
    """
    vertex_hashes(corners, words, h, m, single=single)
    other = words[0:3]
    np.multiply(h, _SECOND, out=m)
    np.right_shift(m, _HALF, out=other)
    np.bitwise_xor(m, other, out=m)
    np.subtract(m[1], m[2], out=other[0])
    np.subtract(m[2], m[0], out=other[1])
    np.subtract(m[0], m[1], out=other[2])
    np.multiply(other, h, out=other)
    return int(other.sum(dtype=np.uint64))


def vertex_hashes(corners: "Array", words: "Array", h: "Array", spare: "Array", *, single: bool) -> None:
    """Put the 64-bit numbers of the three corners of each triangle into the rows of `h`."""
    bits = corners.view(np.uint64)
    if single:
        # a single-precision number leaves the lower 29 bits of a double empty
        np.right_shift(bits, _SINGLE, out=words)
        np.multiply(words, _MIX, out=words)
    else:
        # signs and exponents are the topmost bits, which a product would push out: they are folded down first
        np.right_shift(bits, _HALF, out=words)
        np.bitwise_xor(words, bits, out=words)
        np.multiply(words, _MIX, out=words)
    np.add(words[0::3], words[1::3], out=h)
    np.add(h, words[2::3], out=h)
    np.right_shift(h, _HALF, out=spare)
    np.bitwise_xor(h, spare, out=h)
    np.multiply(h, _FIRST, out=h)
    np.right_shift(h, _THIRD, out=spare)
    np.bitwise_xor(h, spare, out=h)
