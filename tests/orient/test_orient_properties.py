"""Invariants of turns: round trips of all 24 sequences, chains, rates, rigid motions; both sides of every switch."""

import math
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dynamics_cli.numerics.orientation import quaternions, rotations, sequences
from dynamics_cli.numerics.orientation.rotations import ORDERS, AxisAngle, ByMatrix, ByQuaternion, Euler
from dynamics_cli.numerics.vectors import times
from dynamics_cli.orient.contact.joint import joint
from dynamics_cli.orient.motion.points import BodyPoint, points
from dynamics_cli.orient.motion.rates import ByBody, ByRates, rates
from dynamics_cli.orient.turns.align import LEAST_SQUARES, Method, Pair, align
from dynamics_cli.orient.turns.attitude import RotationVector
from dynamics_cli.orient.turns.between import Oriented, between
from dynamics_cli.orient.turns.compose import AxisName, SimpleTurn, compose
from dynamics_cli.orient.turns.convert import Zeroed, convert, distance_of

ALL = (*ORDERS, *(order.upper() for order in ORDERS))
# Rounding of three turns multiplied, and of reading them back.
ROUNDING = 2e-15
ANGLE = st.floats(-3.1, 3.1)
FEW = settings(max_examples=40, deadline=None)


def matrix_of(angles: Any, order: str) -> Any:
    return rotations.euler(tuple(angles), order)


@pytest.mark.parametrize("order", ALL)
@FEW
@given(a=ANGLE, b=ANGLE, c=ANGLE)
def test_every_sequence_gives_its_rotation_back(order: str, a: float, b: float, c: float) -> None:
    matrix = matrix_of((a, b, c), order)
    for turn in (
        Euler(euler_angles=(a, b, c), euler_order=order),
        ByMatrix(rotation_matrix=matrix),
        ByQuaternion(quaternion=quaternions.of_rotation(matrix)),
    ):
        answer = convert(turn=turn, sequence=order)
        assert distance_of(matrix_of(answer.euler_angles, order), matrix) <= ROUNDING
        assert distance_of(matrix_of(answer.alternative_angles, order), matrix) <= ROUNDING
        assert all(check.passed for check in answer.checks)


@pytest.mark.parametrize("order", ALL)
@pytest.mark.parametrize("off", [0.0, 5e-324, 1e-300, 1e-17, 1e-16, 1e-12, 9e-8, 1.1e-7, 1e-3])
def test_near_lock_the_rotation_is_right(order: str, off: float) -> None:
    for lock in (0.0, math.pi) if order[0] == order[2] else (math.pi / 2, -math.pi / 2):
        for angle in (lock + off, lock - off):
            matrix = matrix_of((0.7, angle, 0.3), order)
            sequence = sequences.sequence_of(order)
            quaternion = quaternions.upright(quaternions.of_rotation(matrix))
            for found in (
                sequences.angles_of_rotation(matrix, sequence),
                sequences.angles_of_quaternion(quaternion, sequence),
                sequences.angles_of_rotation(matrix, sequence, zero_third=True),
                sequences.angles_of_quaternion(quaternion, sequence, zero_third=True),
            ):
                assert distance_of(matrix_of(found.angles, order), matrix) <= ROUNDING
                assert distance_of(matrix_of(found.alternative, order), matrix) <= ROUNDING


@pytest.mark.parametrize("order", ALL)
@pytest.mark.parametrize("zero", ["first", "third"])
def test_at_lock_the_angle_asked_for_is_zero(order: str, zero: str) -> None:
    lock = 0.0 if order[0] == order[2] else math.pi / 2
    answer = convert(turn=Euler(euler_angles=(0.7, lock, 0.3), euler_order=order), sequence=order, zero=Zeroed(zero))
    assert answer.euler_angles[0 if zero == "first" else 2] == 0.0
    assert answer.lock == "locked"
    assert [advice.code for advice in answer.advice] == ["lock"]


def test_a_middle_angle_near_lock_is_read_to_the_digits_that_are_left() -> None:
    matrix = matrix_of((0.7, math.pi / 2 - 5e-8, 0.3), "zyx")
    answer = convert(turn=ByMatrix(rotation_matrix=matrix))
    assert answer.euler_angles == pytest.approx((0.7, math.pi / 2 - 5e-8, 0.3), abs=1e-8)
    assert answer.lock_distance == pytest.approx(5e-8, rel=1e-8)
    assert answer.lock == "near"


@pytest.mark.parametrize("angle", [5e-324, 1e-310, 1e-170, 1e-155, 1e-20, 1e-8, 0.5, 3.0, math.pi - 1e-12, math.pi])
def test_rotation_vectors_keep_their_digits_at_any_size(angle: float) -> None:
    answer = convert(turn=RotationVector(rotation_vector=(0.0, -angle, 0.0)))
    back = convert(turn=ByQuaternion(quaternion=answer.quaternion))
    assert answer.rotation_vector == pytest.approx((0.0, -angle, 0.0), rel=1e-15, abs=5e-324)
    assert back.rotation_vector == pytest.approx(answer.rotation_vector, rel=1e-15, abs=5e-324)
    assert answer.rotation_angle == pytest.approx(angle, rel=1e-15, abs=5e-324)


@FEW
@given(st.lists(st.tuples(st.sampled_from("xyz"), ANGLE), min_size=1, max_size=6))
def test_a_chain_is_the_product_of_its_parts(chain: list[tuple[str, float]]) -> None:
    turns = tuple(SimpleTurn(axis=AxisName(axis), angle=angle) for axis, angle in chain)
    whole = compose(turns=turns)
    one, two = (compose(turns=part).rotation_matrix for part in (turns[:1], turns[1:] or turns[:1]))
    if len(turns) > 1:
        assert distance_of(rotations.product(one, two), whole.rotation_matrix) <= ROUNDING
    assert len(whole.cosines) == 3 * (len(turns) + 1) * len(turns) // 2
    assert all(check.passed for check in whole.checks)


@FEW
@given(ANGLE, st.floats(-1.3, 1.3), ANGLE, st.sampled_from(ALL))
def test_rates_and_angular_velocity_give_each_other(a: float, b: float, c: float, order: str) -> None:
    middle = b if order[0] != order[2] else 0.2 + abs(b)
    motion = ByRates(angle_rates=(0.3, -0.2, 0.5), angle_accelerations=(1.0, 2.0, -0.5))
    there = rates(euler_angles=(a, middle, c), euler_order=order, motion=motion)
    body = ByBody(
        body_angular_velocity=there.body_angular_velocity, body_angular_acceleration=there.body_angular_acceleration
    )
    back = rates(euler_angles=(a, middle, c), euler_order=order, motion=body)
    assert back.angle_rates == pytest.approx(motion.angle_rates, abs=1e-13)
    assert back.angle_accelerations == pytest.approx(motion.angle_accelerations, abs=1e-12)


def test_angular_velocity_is_the_difference_of_orientations() -> None:
    step = 1e-5
    ends = [(0.4 + s * 0.3 * step, 0.5 - s * 0.2 * step, -0.7 + s * 0.5 * step) for s in (-0.5, 0.5)]
    first, second = (Oriented(turn=Euler(euler_angles=end, euler_order="zxz")) for end in ends)
    apart = between(first=first, second=second)
    there = rates(euler_angles=(0.4, 0.5, -0.7), euler_order="zxz", motion=ByRates(angle_rates=(0.3, -0.2, 0.5)))
    found = [apart.rotation_angle / step * part for part in apart.rotation_axis]
    assert found == pytest.approx(list(there.angular_velocity), abs=1e-8)


@FEW
@given(st.tuples(*[st.floats(-3, 3)] * 3), st.tuples(*[st.floats(-3, 3)] * 3))
def test_velocities_of_points_tell_the_motion(omega: Any, base: Any) -> None:
    places = ((0.0, 0.0, 0.0), (1.0, 0.0, 0.5), (0.0, 2.0, 0.0), (-1.0, 1.0, 1.0))
    moved = points(angular_velocity=omega, base_velocity=base, points=tuple(BodyPoint(position=p) for p in places))
    measured = tuple(BodyPoint(position=p.position, velocity=p.velocity) for p in moved.points)
    found = points(points=measured)
    assert found.angular_velocity == pytest.approx(omega, abs=1e-14)
    assert found.misfit == pytest.approx(0.0, abs=1e-14)


@FEW
@given(st.tuples(*[ANGLE] * 3), st.sampled_from(["least-squares", "triad"]))
def test_exact_directions_are_aligned_exactly(angles: Any, fit: str) -> None:
    matrix = matrix_of(angles, "zyx")
    before = ((1.0, 0.2, -0.3), (-0.1, 1.0, 0.5))
    answer = align(
        pairs=tuple(Pair(before=b, after=times(matrix, b)) for b in before),
        fit=LEAST_SQUARES if fit == "least-squares" else Method(fit),
    )
    assert distance_of(answer.rotation_matrix, matrix) <= 4e-15
    assert answer.largest_residual <= 4e-15


def test_the_steps_on_the_way_are_equally_far_apart() -> None:
    one = Oriented(turn=ByQuaternion(quaternion=(1.0, 0.2, 0.0, 0.1)))
    two = Oriented(turn=AxisAngle(rotation_axis=(1.0, -1.0, 0.3), rotation_angle=2.2))
    answer = between(first=one, second=two, count=4)
    assert answer.steps is not None
    way = [one, *(Oriented(turn=ByQuaternion(quaternion=step.quaternion)) for step in answer.steps), two]
    apart = [between(first=a, second=b).rotation_angle for a, b in pairwise(way)]
    assert apart == pytest.approx([answer.rotation_angle / 5] * 5, rel=1e-13)


@pytest.mark.parametrize("at", [0.0, 0.3, math.pi / 2, 2.0, -3.0, 7.5])
def test_two_equal_joints_with_forks_in_line_turn_evenly(at: float) -> None:
    answer = joint(joint_angle=0.5, second_joint_angle=0.5, input_angle=at)
    assert answer.ratio == pytest.approx(1.0, rel=1e-14)
    assert answer.output_angle == pytest.approx(at, abs=2e-15)
    crossed = joint(joint_angle=0.5, second_joint_angle=0.5, input_angle=0.0, fork_angle=math.pi / 2)
    assert crossed.ratio == pytest.approx(1.0 / math.cos(0.5) ** 2, rel=1e-14)


def test_near_gives_the_same_rotation_by_the_nearest_angles() -> None:
    turn = Euler(euler_angles=(3.5, 0.2, -9.0), euler_order="zyx")
    assert convert(turn=turn, near=(3.5, 0.2, -9.0)).euler_angles == pytest.approx((3.5, 0.2, -9.0), abs=4e-15)
    rows = ByQuaternion(quaternion=tuple(np.array([1.0, -0.5]) for _ in range(4)))  # type: ignore[arg-type]
    assert np.asarray(convert(turn=rows).euler_angles).shape == (3, 2)
