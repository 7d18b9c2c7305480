"""Arms against 40-digit references, and against numbers of published arms."""

from collections.abc import Callable
from itertools import pairwise
from math import hypot, pi, radians, remainder, sin
from typing import Any

import pytest
from mpmath import mp, mpf
from references.comparison import cases, flat

from dynamics_cli.accuracy.cases import build, leaves
from dynamics_cli.errors import InadmissibleError
from dynamics_cli.numerics.orientation.rotations import ByMatrix, Euler
from dynamics_cli.numerics.tracked import Tracked
from dynamics_cli.robot.arms.chain import chain_of, limits
from dynamics_cli.robot.arms.records import STANDARD, Arm, Convention, Joint
from dynamics_cli.robot.inverse.task import inverse
from dynamics_cli.robot.jacobian import jacobian
from dynamics_cli.robot.pose import pose
from dynamics_cli.robot.rates import rates
from dynamics_cli.robot.torque import torque

FILE = "robot.json"
GROUPS: dict[str, type] = {"Arm": Arm, "Joint": Joint, "Euler": Euler}
MODIFIED = Convention("modified")
PUMA = Arm(robot="puma-560")
Q = (0.3, 0.4, -0.5, 0.7, 1.1, -0.2)
# All eight postures of the pose of Q, by another program in 50 digits.
EIGHT = (
    Q,
    (0.3, 0.4, -0.5, -2.441592653589793238463, -1.1, 2.941592653589793238463),
    (0.3, 1.424438638665350007755, -2.547636820893627178717, 0.6584356770352158847425, 1.923891284433396226919,
     0.4263380975838707870981),
    (0.3, 1.424438638665350007755, -2.547636820893627178717, -2.48315697655457735372, -1.923891284433396226919,
     -2.715254556005922451365),
    (2.8122726434340160403, 1.717154014924443230708, -0.5, -2.150161215894404156432, 1.553931126592559832158,
     0.8893173902714104502571),
    (2.8122726434340160403, 1.717154014924443230708, -0.5, 0.9914314376953890820304, -1.553931126592559832158,
     -2.252275263318382788206),
    (2.8122726434340160403, 2.741592653589793238463, -2.547636820893627178717, -1.88360254163900227159,
     1.074524301962192497918, -0.05904597770343275097575),
    (2.8122726434340160403, 2.741592653589793238463, -2.547636820893627178717, 1.257990111950790966872,
     -1.074524301962192497918, 3.082546675886360487487),
)  # fmt: skip
UR5 = Arm(
    convention=STANDARD,
    joints=tuple(
        Joint(a=a, alpha=radians(alpha), d=d)
        for a, alpha, d in (
            (0.0, 90, 0.089159), (-0.425, 0, 0.0), (-0.39225, 0, 0.0), (0.0, 90, 0.10915), (0.0, -90, 0.09465),
            (0.0, 0, 0.0823),
        )
    ),
)  # fmt: skip


def asked(function: Callable[..., Any], case: dict[str, Any], numbers: list[Any]) -> Any:
    arguments = build(case["inputs"], iter(numbers), GROUPS)
    return function(arguments.pop("arm"), **arguments)


@pytest.mark.parametrize("case", cases(FILE, "pose"), ids=lambda case: case["name"])
def test_poses_are_within_their_bounds(case: dict[str, Any]) -> None:
    mp.dps = 50
    numbers = list(leaves(case["inputs"]))
    plain, tracked = flat(asked(pose, case, numbers)), flat(asked(pose, case, Tracked.inputs(numbers)))
    for name, text in case["results"].items():
        assert tracked[name].value == plain[name]
        error = abs(mpf(plain[name]) - mpf(text))
        assert error <= tracked[name].error
        assert tracked[name].error < 1e-14


@pytest.mark.parametrize("case", cases(FILE, "jacobian"), ids=lambda case: case["name"])
def test_jacobians(case: dict[str, Any]) -> None:
    results = flat(asked(jacobian, case, list(leaves(case["inputs"]))))
    for name, text in case["results"].items():
        # absolute: the largest are of order one
        assert results[name] == pytest.approx(float(text), abs=2e-15), name


@pytest.mark.parametrize("case", cases(FILE, "inverse"), ids=lambda case: case["name"])
def test_inverses_are_within_their_estimate(case: dict[str, Any]) -> None:
    mp.dps = 50
    answer = asked(inverse, case, list(leaves(case["inputs"])))
    results = flat(answer)
    stated = answer.solutions[0].angle_error
    worst = max(abs(mpf(results[name]) - mpf(text)) for name, text in case["results"].items())
    # an estimate: three roundings of the pose, and the amplifications of shoulder, elbow and wrist as one product
    assert worst <= 10.0 * stated
    # the two links are given in doubles that are exact, which are not rounded poses
    assert "two links" in case["name"] or stated <= 1e3 * max(worst, 1e-16)


@pytest.mark.parametrize("case", cases(FILE, "torque"), ids=lambda case: case["name"])
def test_torques_are_within_their_bounds(case: dict[str, Any]) -> None:
    mp.dps = 50
    numbers = list(leaves(case["inputs"]))
    answer = asked(torque, case, numbers)
    assert all(check.passed for check in answer.checks)
    plain, tracked = flat(answer), flat(asked(torque, case, Tracked.inputs(numbers)))
    for name, text in case["results"].items():
        assert tracked[name].value == plain[name]
        assert abs(mpf(plain[name]) - mpf(text)) <= tracked[name].error
        assert tracked[name].error < 1e-12


def test_torques_of_a_published_arm() -> None:
    """Puma 560 with the masses and motors of roboticstoolbox, whose answer adds rotors and friction."""
    qn = (0.0, pi / 4, -pi, 0.0, pi / 4, 0.0)
    still = torque(PUMA, angles=qn, gravity=9.81)
    assert still.torques == pytest.approx((0, 31.63988037835712104842058, 6.03513802301051223024175, 0, 0.0282528, 0),
                                          abs=1e-14)  # fmt: skip
    answer = torque(PUMA, angles=qn, speeds=(0.5,) * 6, accelerations=(0.3,) * 6, gravity=9.81)
    assert answer.torques == pytest.approx(
        (0.4229556740555265443812939, 32.69695483187659552235968, 6.091317150991502220949384,
         0.00008149298688000575386236482, 0.03019222145919236237571097, 0.00005755634918610404553681858), abs=1e-14,
    )  # fmt: skip
    assert answer.drives is not None
    assert [round(each, 2) for each in answer.drives] == [28.29, 51.73, 15.34, 1.11, 0.96, 0.47]
    assert answer.joints is not None
    assert answer.joints[0].torque + (answer.joints[0].rotor or 0.0) == pytest.approx(0.658, abs=5e-4)
    assert [advice.code for advice in answer.advice] == ["impossible-body"]


def test_torques_of_a_force_and_a_payload_are_those_of_statics() -> None:
    """A payload is a weight in the hand; a force of the hand acts by the transposed Jacobian."""
    arm = Arm(lengths=(0.5, 0.4), masses=(0.0, 0.0))
    carried = torque(arm, angles=(0.3, 0.8), payload=2.0, up=(0.0, 1.0, 0.0), gravity=10.0)
    pushed = torque(arm, angles=(0.3, 0.8), force=(0.0, 20.0, 0.0), up=(0.0, 1.0, 0.0), gravity=10.0)
    static = jacobian(arm, angles=(0.3, 0.8), force=(0.0, 20.0, 0.0))
    assert carried.torques == pytest.approx(static.torques, rel=1e-14)
    assert pushed.torques == pytest.approx(static.torques, rel=1e-14)
    assert carried.base_force == pytest.approx((0.0, 20.0, 0.0))
    assert pushed.base_moment[2] == pytest.approx(static.torques[0] if static.torques else 0.0)


def test_the_pose_of_a_published_arm() -> None:
    """Puma 560 with the lengths of roboticstoolbox; the other convention makes another arm of the same table."""
    answer = pose(PUMA, angles=Q)
    expected = (0.4847727909677826282526105, -0.007107280740026030231614188, 1.267597020417996196609749)
    assert answer.position == pytest.approx(expected, abs=4e-16)
    assert answer.rotation_matrix[0] == pytest.approx(
        (0.4884387689595608040168501, -0.7564368976418350612435209, -0.4350066538149327292096705), abs=4e-16
    )
    assert answer.rotation_matrix[2] == pytest.approx(
        (0.8223569084390395516758334, 0.232322532574331905464308, 0.5193797801232096579489599), abs=4e-16
    )
    table = chain_of(PUMA).joints
    other = pose(Arm(convention=MODIFIED, joints=table), angles=Q)
    assert other.position == pytest.approx(
        (0.1730411982946257992548729, -1.05077015022426293881901, 0.1220844795249187857063749), abs=4e-16
    )


def test_all_eight_postures_of_a_pose() -> None:
    at = pose(PUMA, angles=Q)
    answer = inverse(PUMA, position=at.position, turn=ByMatrix(at.rotation_matrix))
    assert (answer.count, answer.at_most, answer.within) == (8, 8, 1)
    assert answer.solutions[0].angles == pytest.approx(Q, abs=1e-14)
    for expected in EIGHT:
        off = min(
            max(abs(remainder(a - b, 2 * pi)) for a, b in zip(row.angles, expected, strict=True))
            for row in answer.solutions
        )
        assert off < 1e-14
    assert max(row.position_error for row in answer.solutions) < 1e-15
    assert max(row.turn_error for row in answer.solutions) < 1e-15
    names = {row.configuration for row in answer.solutions}
    assert names == {
        f"{shoulder} {elbow}{flip}"
        for shoulder in ("front", "back") for elbow in ("up", "down") for flip in ("", " flip")
    }  # fmt: skip


def test_three_parallel_axes() -> None:
    """UR5, and its other seven postures by another program in 50 digits."""
    q = (0.5, -1.2, 1.4, -0.6, 0.9, 0.25)
    at = pose(UR5, angles=q)
    assert at.position == pytest.approx(
        (-0.4801196751727201686893996, -0.44496113666125002566042, 0.3452740890732224292291899), abs=4e-16
    )
    determinant = jacobian(UR5, angles=q).determinant
    assert determinant is not None
    assert determinant.value == pytest.approx(-0.07403165210537562943074624, rel=1e-14)
    answer = inverse(UR5, position=at.position, turn=ByMatrix(at.rotation_matrix), near=q)
    back = -2.266590228547658796742
    expected = (
        q,
        (0.5, 0.1325188721619657625185, -1.4, 0.8674811278380342374815, 0.9, 0.25),
        (0.5, -0.8909849428629372857379, 1.387016378777383019591, 2.24556121767534750461, -0.9,
         -2.891592653589793238463),
        (0.5, 0.4294339133707104325003, -1.387016378777383019591, -2.584010188183120651372, -0.9,
         -2.891592653589793238463),
        (back, 2.698568625867922685516, 1.413041240939204461913, -0.6429063672083436412402, 1.890355397267598159213,
         -3.042403854079214137665),
        (back, -2.239953849324470075367, -1.413041240939204461913, 0.8385132826828715665432, 1.890355397267598159213,
         -3.042403854079214137665),
        (back, 3.019386139515310034538, 1.373914104973870203533, 2.216995908699396506579, -1.890355397267598159213,
         0.09918879951057910079767),
        (back, -1.955600494165514012668, -1.373914104973870203533, -2.626559862031211992999, -1.890355397267598159213,
         0.09918879951057910079767),
    )  # fmt: skip
    assert answer.count == 8
    assert answer.solutions[0].angles == pytest.approx(q, abs=1e-14)
    for posture in expected:
        assert any(
            all(abs(remainder(a - b, 2 * pi)) < 1e-14 for a, b in zip(row.angles, posture, strict=True))
            for row in answer.solutions
        )


def test_singular_values_and_the_factors_of_the_determinant() -> None:
    answer: Any = jacobian(PUMA, angles=Q)
    assert answer.determinant.value == pytest.approx(0.06550173375897276441959385, rel=1e-14)
    a2, a3, d4 = 0.4318, 0.0203, 0.4318
    product = a2 * hypot(a3, d4) * sin(answer.elbow_factor) * answer.shoulder_factor * sin(answer.wrist_factor)
    assert product == pytest.approx(answer.determinant.value, rel=1e-14)


@pytest.mark.parametrize("bend", [1e-3, 1e-6, 1e-9])
def test_near_the_wrist_singularity_the_sum_stays(bend: float) -> None:
    q = (*Q[:4], bend, Q[5])
    at = pose(PUMA, angles=q)
    answer = inverse(PUMA, position=at.position, turn=ByMatrix(at.rotation_matrix), near=q)
    row = answer.solutions[0]
    assert row.angles[3] + row.angles[5] == pytest.approx(0.5, abs=1e-15)
    assert abs(row.angles[3] - q[3]) < 4e-16 / bend
    assert row.wrist_margin == pytest.approx(bend, rel=1e-6)
    assert [advice.code for advice in answer.advice if "posture 1 " in str(advice.message)] == ["wrist-singular"]


def test_at_the_wrist_singularity_the_sum_alone_is_determined() -> None:
    at = pose(PUMA, angles=(*Q[:4], 0.0, Q[5]))
    given: dict[str, Any] = {"position": at.position, "turn": ByMatrix(at.rotation_matrix)}
    answer = inverse(PUMA, **given)
    (row,) = (row for row in answer.solutions if row.wrist_sum is not None)
    assert row.wrist_sum == pytest.approx(0.5, abs=1e-15)
    assert row.angles[3] == 0.0
    near = inverse(PUMA, **given, near=(0.3, 0.4, -0.5, 0.7, 0.0, 0.0)).solutions[0]
    assert near.angles[3] == 0.7
    assert near.angles[5] == pytest.approx(-0.2, abs=1e-15)


def test_the_edges_of_the_reach() -> None:
    for lengths, distance, bend in (
        ((1.0, 1.0), 2.0 - 2.0**-40, 0.000001907348632812572280144832),
        ((1.0, 0.5), 0.5 + 2.0**-40, 3.141591304890640889138089),
        ((1.0, 0.5), 1.5 - 2.0**-40, 0.000002336015455993045566583516),
    ):
        answer = inverse(Arm(lengths=lengths), position=(distance, 0.0, 0.0))
        assert [abs(row.angles[1]) for row in answer.solutions] == pytest.approx([bend, bend], rel=1e-15)
    assert inverse(Arm(lengths=(1.0, 1.0)), position=(2.0, 0.0, 0.0)).count == 1
    with pytest.raises(InadmissibleError, match=r"1e-12 m beyond the reach"):
        inverse(Arm(lengths=(1.0, 1.0)), position=(2.000000000001, 0.0, 0.0))


def test_both_postures_of_three_links() -> None:
    answer = inverse(Arm(lengths=(0.5, 0.4, 0.2)), position=(0.55, 0.35, 0.0), hand_angle=1.0)
    first = (-0.4516283444229119241899102, 2.042249166658477287559566, -0.5906208222355653633696555)
    second = (1.231800163139933860814824, -2.042249166658477287559566, 1.810449003518543426744741)
    assert answer.solutions[0].angles == pytest.approx(first, abs=4e-16)
    assert answer.solutions[1].angles == pytest.approx(second, abs=4e-16)


def test_speeds_of_a_redundant_arm() -> None:
    arm, q, v = Arm(lengths=(1.0, 0.8, 0.5)), (0.3, 0.7, -0.4), (0.2, -0.1, 0.0)
    least = rates(arm, angles=q, velocity=v)
    assert least.solution == "least norm"
    assert least.speeds == pytest.approx(
        (0.1039930935800455284736508, -0.3539518354906446332035114, 0.02870143139672594955459508), abs=1e-15
    )
    way = (-0.2286559398988511097308437, 0.01175407861051640301261419, 0.9734363373045978449284973)
    assert least.idle == pytest.approx([part / way[2] for part in way], abs=1e-14)
    weighted = rates(arm, angles=q, velocity=v, weights=(4.0, 2.0, 1.0))
    assert weighted.speeds == pytest.approx(
        (0.08907274491930865541879768, -0.3531848536613853815072896, 0.09222048783602136232528933), abs=1e-15
    )


def test_speeds_give_the_hand_its_velocity() -> None:
    v, w = (0.1, -0.2, 0.05), (0.3, 0.1, -0.4)
    answer = rates(PUMA, angles=Q, velocity=v, angular_velocity=w)
    assert answer.solution == "the only one"
    assert answer.speeds is not None
    back = jacobian(PUMA, angles=Q, speeds=answer.speeds)
    assert back.velocity == pytest.approx(v, abs=1e-15)
    assert back.angular_velocity == pytest.approx(w, abs=1e-14)


def test_damping_holds_back_at_a_singular_posture() -> None:
    flat = (*Q[:4], 0.0, Q[5])
    with pytest.raises(InadmissibleError, match="cannot"):
        rates(PUMA, angles=flat, velocity=(0.1, 0.0, 0.0), angular_velocity=(0.0, 0.0, 0.0))
    damped = rates(PUMA, angles=flat, velocity=(0.1, 0.0, 0.0), angular_velocity=(0.0, 0.0, 0.0), damping=0.02)
    assert damped.speeds is not None
    assert max(map(abs, damped.speeds)) < 1.0
    assert damped.missing_velocity is not None
    assert 0.0 < damped.missing_velocity < 0.1


def test_a_redundant_arm() -> None:
    answer = jacobian(Arm(lengths=(1.0, 0.8, 0.5)), angles=(0.3, 0.7, -0.4))
    assert answer.manipulability is not None
    assert answer.manipulability.value == pytest.approx(0.681230222982030896459401, rel=1e-15)


@pytest.mark.parametrize("seed", range(60))
def test_random_postures_are_among_the_answers(seed: int) -> None:
    import random

    draw = random.Random(seed)
    mirrored = [draw.choice((-1, 1)) for _ in range(4)]
    lengths = [draw.uniform(0.05, 0.6) for _ in range(8)]
    kind = seed % 4
    if kind == 0:  # a spherical wrist
        rows = [(lengths[0], 90 * mirrored[0], lengths[1]), (lengths[2], 0, 0.0), (lengths[3], 90 * mirrored[1], 0.1),
                (0.0, 90 * mirrored[2], lengths[4]), (0.0, 90 * mirrored[3], 0.0), (0.0, 0, lengths[5])]  # fmt: skip
    elif kind == 1:  # three parallel axes
        rows = [
            (0.0, 90 * mirrored[0], lengths[0]),
            (lengths[1], 0, 0.0),
            (lengths[2], 180 * (mirrored[1] > 0), 0),
            (0.0, 90 * mirrored[2], lengths[3]),
            (0.0, 90 * mirrored[3], lengths[4]),
            (0, 0, lengths[5]),
        ]
    elif kind == 2:  # three joints in space
        rows = [(lengths[0], 90 * mirrored[0], lengths[1]), (lengths[2], 0, lengths[3]), (lengths[4], 0, 0.0)]
    else:  # a wrist whose axes are not at right angles
        rows = [(0.0, 90 * mirrored[0], lengths[1]), (lengths[2], 0, 0.0), (lengths[3], 90 * mirrored[1], 0.0),
                (0.0, 60 * mirrored[2], lengths[4]), (0.0, -60 * mirrored[2], 0.0), (0.0, 0, lengths[5])]  # fmt: skip
    convention = STANDARD if seed % 3 else MODIFIED
    tool = (0.0, 0.0, 0.0)
    if convention == MODIFIED:
        # the same arm, its twists and lengths a row later
        tool = (rows[-1][0], 0.0, 0.0)
        shifted = [(0.0, 0, rows[0][2])]
        shifted += [(a, alpha, row[2]) for (a, alpha, _), row in pairwise(rows)]
        rows = shifted
    arm = Arm(convention=convention, joints=tuple(Joint(a=a, alpha=radians(al), d=d) for a, al, d in rows), tool=tool)
    q = tuple(draw.uniform(-3, 3) for _ in rows)
    at = pose(arm, angles=q)
    turn = ByMatrix(at.rotation_matrix) if len(rows) == 6 else None
    answer = inverse(arm, position=at.position, turn=turn, near=q)
    assert all(check.passed for check in answer.checks)
    row = answer.solutions[0]
    assert row.angles == pytest.approx(q, abs=max(1e-12, 100.0 * row.angle_error)), (seed, kind)


def test_published_limits() -> None:
    table = [tuple(round(limit * 180 / pi, 9) for limit in limits(joint)) for joint in chain_of(PUMA).joints]
    assert table == [(-160, 160), (-45, 225), (-225, 45), (-110, 170), (-100, 100), (-266, 266)]
