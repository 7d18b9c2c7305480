"""Orient beside scipy's Rotation: arrays a second, and how right the rotation of the angles is near gimbal lock.

Run: python tests/benchmarks/orient_peers.py
"""

import math
import time
import warnings
from collections.abc import Callable
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from dynamics_cli.numerics.orientation import quaternions, sequences
from dynamics_cli.numerics.orientation.rotations import ByMatrix, ByQuaternion, euler, from_quaternion
from dynamics_cli.orient.turns.convert import convert, distance_of

ROWS, BLOCK = 200_000, 2048


def rate(call: Callable[[Any], Any], columns: Any) -> float:
    """Rows a second of processor time in blocks, the best of three runs."""
    best = math.inf
    for _ in range(3):
        start = time.process_time()
        for first in range(0, ROWS, BLOCK):
            call(columns[:, first : first + BLOCK])
        best = min(best, time.process_time() - start)
    return ROWS / best


def speeds() -> None:
    q = np.random.default_rng(1).normal(size=(4, ROWS))
    q /= np.linalg.norm(q, axis=0)
    zyx = sequences.sequence_of("zyx")
    ways: dict[str, tuple[Callable[[Any], Any], Callable[[Any], Any]]] = {
        "quaternion to all notations": (
            lambda c: convert(turn=ByQuaternion(quaternion=tuple(c))),
            lambda c: (
                (r := Rotation.from_quat(c.T, scalar_first=True)).as_euler("ZYX"), r.as_matrix(), r.as_rotvec(),
                r.magnitude(),
            ),
        ),
        "quaternion to angles": (
            lambda c: sequences.angles_of_quaternion(tuple(c), zyx),
            lambda c: Rotation.from_quat(c.T, scalar_first=True).as_euler("ZYX"),
        ),
        "quaternion to matrix": (
            lambda c: from_quaternion(tuple(c)),
            lambda c: Rotation.from_quat(c.T, scalar_first=True).as_matrix(),
        ),
        "quaternion to rotation vector": (
            lambda c: quaternions.axis_angle_and_vector(quaternions.upright(tuple(c)))[2],
            lambda c: Rotation.from_quat(c.T, scalar_first=True).as_rotvec(),
        ),
    }  # fmt: skip
    for name, (ours, theirs) in ways.items():
        print(f"{name:32} {rate(ours, q):12,.0f} rows/s, scipy {rate(theirs, q):12,.0f}")


def errors() -> None:
    print("largest element of the difference between the rotation given and that of its angles, zyx")
    for off in (1e-3, 1e-6, 1.1e-7, 9e-8, 1e-8, 1e-10, 1e-14, 0.0):
        matrix = euler((0.7, math.pi / 2 - off, 0.3), "zyx")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            theirs = tuple(Rotation.from_matrix(matrix).as_euler("ZYX").tolist())
        ours = convert(turn=ByMatrix(rotation_matrix=matrix)).euler_angles
        both = [distance_of(euler(angles, "zyx"), matrix) for angles in (ours, theirs)]
        print(f"{off:8.1e} rad from lock {both[0]:10.1e}, scipy {both[1]:10.1e}")


if __name__ == "__main__":
    speeds()
    errors()
