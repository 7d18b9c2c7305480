"""Inertia of a body, or of all that a joint carries, as the block matrix of n = I·α + H·a and f = Hᵀ·α + M·a."""

from dynamics_cli.numerics.trees.newton_euler import back
from dynamics_cli.numerics.vectors import add, times

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.numerics.trees.tree import Link
    from dynamics_cli.numerics.vectors import Tensor, Vector

    # I by xx, yy, zz, xy, yz, zx; H by rows; M as I.
    Block = tuple[tuple[float, ...], Tensor, tuple[float, ...]]


def block_of(link: "Link") -> "Block":
    """The block of one link about its origin, in its own axes."""
    (xx, xy, zx), (_, yy, yz), (_, _, zz) = link.tensor
    mass = link.mass
    x, y, z = link.centroid
    a, b, c = mass * x, mass * y, mass * z
    inertia = (xx + b * y + c * z, yy + c * z + a * x, zz + a * x + b * y, xy - a * y, yz - b * z, zx - c * x)
    return inertia, ((0.0, -c, b), (c, 0.0, -a), (-b, a, 0.0)), (mass, mass, mass, 0.0, 0.0, 0.0)


def symmetric(m: "tuple[float, ...]", v: "Vector") -> "Vector":
    """A symmetric matrix by xx, yy, zz, xy, yz, zx, applied to a vector."""
    xx, yy, zz, xy, yz, zx = m
    x, y, z = v
    return xx * x + xy * y + zx * z, xy * x + yy * y + yz * z, zx * x + yz * y + zz * z


def less(block: "Block", n: "Vector", f: "Vector", over: float) -> "Block":
    """The block less U·Uᵀ·over."""
    (a, b, c, d, e, g), (p, q, r), m = block
    x, y, z = n
    u, v, w = f
    i, j, k = x * over, y * over, z * over
    s, t, o = u * over, v * over, w * over
    return (
        (a - i * x, b - j * y, c - k * z, d - i * y, e - j * z, g - k * x),
        (
            (p[0] - i * u, p[1] - i * v, p[2] - i * w),
            (q[0] - j * u, q[1] - j * v, q[2] - j * w),
            (r[0] - k * u, r[1] - k * v, r[2] - k * w),
        ),
        (m[0] - s * u, m[1] - t * v, m[2] - o * w, m[3] - s * v, m[4] - t * w, m[5] - o * u),
    )


def moved_block(block: "Block", rotation: "Tensor", r: "Vector") -> "Block":
    """A block in the axes and about the origin of the parent's frame."""
    inertia, mixed, mass = block
    inertia, mass = _turned_six(rotation, inertia), _turned_six(rotation, mass)
    (a, b, c), (d, e, f), (g, h, i) = _turned_nine(rotation, mixed)
    xx, yy, zz, xy, yz, zx = mass
    x, y, z = r
    # H + [r×]·M, then I + [r×]·Hᵀ − (H + [r×]·M)·[r×]
    p, q, s = a + y * zx - z * xy, b + y * yz - z * yy, c + y * zz - z * yz
    t, u, v = d + z * xx - x * zx, e + z * xy - x * yz, f + z * zx - x * zz
    k, m, w = g + x * xy - y * xx, h + x * yy - y * xy, i + x * yz - y * zx
    return (
        (
            inertia[0] + (y * c - z * b) - (q * z - s * y),
            inertia[1] + (z * d - x * f) - (v * x - t * z),
            inertia[2] + (x * h - y * g) - (k * y - m * x),
            inertia[3] + (y * f - z * e) - (s * x - p * z),
            inertia[4] + (z * g - x * i) - (t * y - u * x),
            inertia[5] + (x * b - y * a) - (m * z - w * y),
        ),
        ((p, q, s), (t, u, v), (k, m, w)),
        mass,
    )


def _turned_six(rotation: "Tensor", m: "tuple[float, ...]") -> "tuple[float, ...]":
    """R·M·Rᵀ of a symmetric matrix by xx, yy, zz, xy, yz, zx."""
    xx, yy, zz, xy, yz, zx = m
    (a, b, c), (d, e, f), (g, h, i) = rotation
    p, q, r = a * xx + b * xy + c * zx, a * xy + b * yy + c * yz, a * zx + b * yz + c * zz
    s, t, u = d * xx + e * xy + f * zx, d * xy + e * yy + f * yz, d * zx + e * yz + f * zz
    v, w, x = g * xx + h * xy + i * zx, g * xy + h * yy + i * yz, g * zx + h * yz + i * zz
    return (p * a + q * b + r * c, s * d + t * e + u * f, v * g + w * h + x * i, p * d + q * e + r * f,
            s * g + t * h + u * i, v * a + w * b + x * c)  # fmt: skip


def _turned_nine(rotation: "Tensor", m: "Tensor") -> "Tensor":
    first, second, third = (back(m, row) for row in rotation)
    return times(rotation, first), times(rotation, second), times(rotation, third)


def joined(a: "Block", b: "Block") -> "Block":
    """The sum of two blocks about one origin."""
    (a_1, a_2, a_3), (b_1, b_2, b_3) = a, b
    return (
        tuple([x + y for x, y in zip(a_1, b_1, strict=True)]),
        (add(a_2[0], b_2[0]), add(a_2[1], b_2[1]), add(a_2[2], b_2[2])),
        tuple([x + y for x, y in zip(a_3, b_3, strict=True)]),
    )
