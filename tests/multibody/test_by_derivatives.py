"""The branched tree without any recursion: places as functions of the speeds, differentiated in mpmath at 40 digits.

With p(s), R(s) the place of a mass centre and the rotation of its body after all speeds have acted for a time s, the
velocities are first derivatives, the accelerations without rates of the speeds second ones; Kane's equations are sums
of them over bodies, solved by elimination.
"""

import pytest
from mpmath import mp

from dynamics_cli.numerics.trees.articulated import forward
from dynamics_cli.numerics.trees.newton_euler import inverse
from dynamics_cli.numerics.trees.tree import BALL, PRISMATIC, REVOLUTE, Link, Tree, poses

GRAVITY = 9.81
ROUNDING = 4e-14
# Name, parent, joint, axis, position, mass, centroid, tensor; then coordinates, speeds and efforts.
LINKS = (
    ("b1", -1, REVOLUTE, (0, 0, 1), (0, 0, 0), 4.0, (0.1, 0.0, 0.2), ((0.3, 0, 0.02), (0, 0.25, 0), (0.02, 0, 0.2))),
    ("b2", 0, REVOLUTE, (0, 1, 0), (0.3, 0, 0.4), 2.0, (0.0, 0.0, -0.25), ((0.05, 0, 0), (0, 0.06, 0), (0, 0, 0.02))),
    ("b3", 0, PRISMATIC, (1, 0, 0), (-0.2, 0, 0.1), 1.5, (0.1, 0.05, 0.0), ((0.01, 0, 0), (0, 0.02, 0), (0, 0, 0.03))),
    ("b4", 1, BALL, (0, 0, 1), (0, 0, -0.5), 1.0, (0.02, 0.03, -0.2), ((0.02, 0, 0), (0, 0.015, 0), (0, 0, 0.01))),
)
STATE = (0.4, -0.7, 0.15, (0.8, 0.4, -0.2, 0.4))
SPEEDS = (1.2, -0.8, 0.5, 0.3, -1.1, 0.6)
EFFORTS = (2.0, 1.0, -3.0, 0.1, 0.2, -0.1)
FIRST = (0, 1, 2, 3)


def skew(v):
    return mp.matrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def exponential(v):
    """The rotation by a vector, as the power series of its matrix."""
    return mp.expm(skew(v), method="taylor")


def quaternion_matrix(q):
    w, v = q[0], mp.matrix(q[1:])
    return (w * w - (v.T * v)[0]) * mp.eye(3) + 2 * v * v.T + 2 * w * skew(v)


def places(y, s):
    """Mass centre and rotation of every body after speeds y have acted for a time s."""
    frames, out = [], []
    for k, (_, parent, joint, axis, position, _, centroid, _) in enumerate(LINKS):
        carrier, origin = frames[parent] if parent >= 0 else (mp.eye(3), mp.zeros(3, 1))
        origin, turn = origin + carrier * mp.matrix(position), carrier
        rate = y[FIRST[k] : FIRST[k] + 3] if joint == BALL else y[FIRST[k]]
        if joint == BALL:
            turn = carrier * quaternion_matrix(STATE[k]) * exponential([s * x for x in rate])
        elif joint == REVOLUTE:
            turn = carrier * exponential([(STATE[k] + s * rate) * x for x in axis])
        else:
            origin = origin + carrier * mp.matrix(axis) * (STATE[k] + s * rate)
        frames.append((turn, origin))
        out.append((origin + turn * mp.matrix(centroid), turn))
    return out


def derivatives(y):
    """Of every body: velocity, acceleration, ω and its rate in body axes, for constant speeds y."""
    step = mp.mpf(10) ** -8
    # central differences of eighth order
    first = [mp.mpf(x) for x in (mp.mpf(1) / 280, -mp.mpf(4) / 105, mp.mpf(1) / 5, -mp.mpf(4) / 5)]
    second = [mp.mpf(x) for x in (-mp.mpf(1) / 560, mp.mpf(8) / 315, -mp.mpf(1) / 5, mp.mpf(8) / 5)]
    samples = {n: places(y, n * step) for n in range(-4, 5)}
    out = []
    for k in range(len(LINKS)):
        turn = samples[0][k][1]

        def d(part, weights, sign, middle, k=k):
            total = middle * samples[0][k][part]
            for weight, n in zip(weights, (4, 3, 2, 1), strict=True):
                total += weight * (samples[-n][k][part] + sign * samples[n][k][part])
            return total

        velocity, acceleration = d(0, first, -1, 0) / step, d(0, second, 1, -mp.mpf(205) / 72) / step**2
        r1, r2 = d(1, first, -1, 0) / step, d(1, second, 1, -mp.mpf(205) / 72) / step**2
        spin, swift = turn.T * r1, turn.T * r2 + r1.T * r1
        out.append([velocity, acceleration, *(mp.matrix([m[2, 1], m[0, 2], m[1, 0]]) for m in (spin, swift))])
    return out


def equations():
    """Mass matrix and bias of Kane's equations."""
    units = [derivatives([mp.mpf(k == n) for k in range(6)]) for n in range(6)]
    moving = derivatives([mp.mpf(x) for x in SPEEDS])
    matrix, bias = mp.zeros(6, 6), mp.zeros(6, 1)
    for k, link in enumerate(LINKS):
        mass, tensor = mp.mpf(link[5]), mp.matrix(link[7])
        _, acceleration, omega, alpha = moving[k]
        force = mass * (acceleration + mp.matrix([0, 0, mp.mpf(GRAVITY)]))
        moment = tensor * alpha + skew(omega) * tensor * omega
        for i in range(6):
            v, _, w, _ = units[i][k]
            bias[i] += (v.T * force)[0] + (w.T * moment)[0]
            for j in range(6):
                matrix[i, j] += mass * (v.T * units[j][k][0])[0] + (w.T * tensor * units[j][k][2])[0]
    return matrix, bias


@pytest.fixture(scope="module")
def kane():
    with mp.workdps(120):
        return equations()


def test_accelerations_and_bias_are_those_of_derivatives(kane):
    matrix, bias = kane
    with mp.workdps(60):
        expected = [float(x) for x in mp.lu_solve(matrix, mp.matrix([mp.mpf(x) for x in EFFORTS]) - bias)]
    tree = Tree([
        Link(name, parent, joint, axis=tuple(map(float, axis)), position=tuple(map(float, position)), mass=mass,
             centroid=centroid, tensor=tuple(tuple(map(float, row)) for row in tensor))
        for name, parent, joint, axis, position, mass, centroid, tensor in LINKS
    ])  # fmt: skip
    frames = poses(tree, [*STATE[:3], *STATE[3]])
    found = forward(tree, frames, SPEEDS, EFFORTS, ground=(0.0, 0.0, GRAVITY))
    assert found == pytest.approx(expected, rel=ROUNDING)
    assert inverse(tree, frames, SPEEDS, ground=(0.0, 0.0, GRAVITY))[0] == pytest.approx(
        [float(x) for x in bias], rel=ROUNDING
    )
