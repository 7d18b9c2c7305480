"""Beside scipy's Rotation, away from lock where it is right, and at lock where it is not."""

import math

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from dynamics_cli.numerics.orientation.rotations import ORDERS, ByMatrix, ByQuaternion, euler
from dynamics_cli.numerics.orientation.sequences import names_of, sequence_of
from dynamics_cli.orient.turns.attitude import RotationVector, YawPitchRoll
from dynamics_cli.orient.turns.average import Reading, Readings, average
from dynamics_cli.orient.turns.between import Oriented, between
from dynamics_cli.orient.turns.compose import About, GeneralTurn, compose
from dynamics_cli.orient.turns.convert import convert, distance_of

# scipy's own error away from lock.
SCIPY = 1e-13


@pytest.mark.parametrize("order", [*ORDERS, *(order.upper() for order in ORDERS)])
def test_angles_agree_under_the_name_that_is_printed(order: str) -> None:
    generator = np.random.default_rng(3)
    named = names_of(sequence_of(order)).partition('scipy "')[2].partition('"')[0]
    quaternions = generator.normal(size=(40, 4))
    columns = tuple(quaternions.T)
    ours = np.transpose(convert(turn=ByQuaternion(quaternion=columns), sequence=order).euler_angles)
    theirs = Rotation.from_quat(quaternions, scalar_first=True).as_euler(named)
    far = np.abs(np.sin(0.5 * (ours - theirs)))
    assert far.max() <= SCIPY


def test_other_notations_agree() -> None:
    for q in np.random.default_rng(5).normal(size=(25, 4)):
        answer = convert(turn=ByQuaternion(quaternion=tuple(q.tolist())))
        peer = Rotation.from_quat(q, scalar_first=True)
        assert np.asarray(answer.rotation_matrix) == pytest.approx(peer.as_matrix(), abs=1e-15)
        assert answer.rotation_vector == pytest.approx(peer.as_rotvec(), abs=SCIPY)


def test_near_lock_scipy_gives_another_rotation_and_we_do_not() -> None:
    matrix = euler((0.7, math.pi / 2 - 9e-8, 0.3), "zyx")
    with pytest.warns(UserWarning, match="Gimbal lock"):
        theirs = Rotation.from_matrix(matrix).as_euler("ZYX")
    ours = convert(turn=ByMatrix(rotation_matrix=matrix)).euler_angles
    assert distance_of(euler(tuple(theirs.tolist()), "zyx"), matrix) > 1e-8
    assert distance_of(euler(ours, "zyx"), matrix) <= 1e-15


@pytest.mark.parametrize(
    "rows", [np.diag([2.0, 1.0, 1.0]), np.array([[1.0, 0.3, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])]
)
def test_what_is_no_rotation_scipy_answers_in_silence(rows: np.ndarray) -> None:
    from dynamics_cli.errors import InadmissibleError

    assert Rotation.from_matrix(rows).magnitude() < 1.0
    with pytest.raises(InadmissibleError, match="not a rotation"):
        convert(turn=ByMatrix(rotation_matrix=tuple(map(tuple, rows.tolist()))))


def test_a_mean_and_its_scatter_are_scipys() -> None:
    random = np.random.default_rng(4)
    rotations = Rotation.from_rotvec(random.normal(0.0, 0.4, (30, 3)))
    quaternions = rotations.as_quat()[:, [3, 0, 1, 2]] * random.choice([-1.0, 1.0], 30)[:, None]
    weights = random.uniform(0.5, 2.0, 30)
    readings = tuple(
        Reading(ByQuaternion(tuple(q)), weight)
        for q, weight in zip(quaternions.tolist(), weights.tolist(), strict=True)
    )
    result = average(source=Readings(readings))
    mean = rotations.mean(weights)
    off = (mean.inv() * rotations).magnitude()
    assert np.allclose(result.rotation_matrix, mean.as_matrix(), atol=1e-14)
    assert result.scatter == pytest.approx(math.sqrt(np.average(off**2, weights=weights)), rel=1e-9)
    assert result.largest_deviation == pytest.approx(off.max(), rel=1e-9)


def test_a_chain_of_any_turns_and_a_mean_angular_velocity_are_scipys() -> None:
    robot, tool = Rotation.from_euler("ZYX", [0.5, 0.2, -0.1]), Rotation.from_rotvec([0.3, 0.1, -0.2])
    chain = (GeneralTurn(YawPitchRoll(0.5, 0.2, -0.1)), GeneralTurn(RotationVector((0.3, 0.1, -0.2))))
    assert np.allclose(compose(general_turns=chain).rotation_matrix, (robot * tool).as_matrix(), atol=1e-15)
    fixed = compose(general_turns=chain, about=About("fixed"))
    assert np.allclose(fixed.rotation_matrix, (tool * robot).as_matrix(), atol=1e-15)
    result = between(first=Oriented(chain[0].turn), second=Oriented(chain[1].turn), time=0.01)
    vector = (robot.inv() * tool).as_rotvec() / 0.01
    assert np.allclose(result.body_angular_velocity, vector, rtol=1e-13)
    assert np.allclose(result.angular_velocity, robot.apply(vector), rtol=1e-13)
